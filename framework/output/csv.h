#pragma once
/// A table that grows row by row and can be read while it does.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace similitude {

class CsvWriter {
 public:
  /// Starts the file anew with a row of column names. Throws OutputError.
  CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& columns);
  /// Goes on after the first `length` bytes of a table that is there: what follows them is cut off. Throws OutputError if the
  /// file has fewer.
  CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& columns, std::uint64_t length);
  ~CsvWriter();
  CsvWriter(const CsvWriter&) = delete;
  CsvWriter& operator=(const CsvWriter&) = delete;

  /// One row; handed to the system before this returns. Reals read back as the same double; a NaN
  /// stands for "does not exist here" and is an empty field. On failure the partial row is cut off and OutputError
  /// thrown.
  void row(const std::vector<double>& values);
  void row_of_text(const std::vector<std::string>& fields);
  /// [bytes], whole rows only.
  std::uint64_t length() const;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::size_t columns_ = 0;
};

/// round_trip(value) of output/number.h; NaN is "".
std::string csv_number(double value);
/// With quotes where commas, quotes or line ends need them (RFC 4180).
std::string csv_field(const std::string& text);

}  // namespace similitude
