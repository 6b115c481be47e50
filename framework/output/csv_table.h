#pragma once
/// A table as output/csv.h writes it and as spreadsheets do: commas, quotes where needed, one row of names.

#include <filesystem>
#include <string>
#include <vector>

namespace similitude {

class CsvTable {
 public:
  /// Throws InputError: the file cannot be read, is empty, or a row has another width than the names.
  explicit CsvTable(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  const std::vector<std::string>& columns() const { return columns_; }
  bool has(const std::string& column) const;
  std::size_t rows() const { return rows_.size(); }
  /// Throws InputError if there is no such column.
  std::vector<std::string> texts(const std::string& column) const;
  /// An empty field is NaN. Throws InputError for what is no number.
  std::vector<double> numbers(const std::string& column) const;

 private:
  std::size_t index(const std::string& column) const;

  std::filesystem::path file_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace similitude
