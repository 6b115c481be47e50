#include "output/csv.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include "output/number.h"
#include "output/whole_file.h"

namespace similitude {

std::string csv_number(double value) { return std::isnan(value) ? "" : round_trip(value); }

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

CsvWriter::CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& columns)
    : file_(file),
      descriptor_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666)),
      columns_(columns.size()) {
  if (descriptor_ < 0) throw_output_error(file_, "written", errno);
  try {
    row_of_text(columns);
  } catch (...) {
    ::close(descriptor_);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file_, ignored)) std::filesystem::remove(file_, ignored);
    throw;
  }
}

CsvWriter::CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& columns, std::uint64_t length)
    : file_(file), descriptor_(::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)), columns_(columns.size()) {
  if (descriptor_ < 0) throw_output_error(file_, "continued", errno);
  const std::uint64_t there = this->length();
  if (there >= length && ::ftruncate(descriptor_, static_cast<off_t>(length)) == 0) return;
  const int error = errno;
  ::close(descriptor_);
  if (there >= length) throw_output_error(file_, "cut back to its last whole row", error);
  throw OutputError(file_.string() + " has " + std::to_string(there) + " bytes, but had " + std::to_string(length) +
                        " when the checkpoint was written: rows are missing.",
                    "Put the file back as it was, or start the run anew with --force.");
}

std::uint64_t CsvWriter::length() const {
  const off_t end = ::lseek(descriptor_, 0, SEEK_END);
  return end < 0 ? 0 : static_cast<std::uint64_t>(end);
}

CsvWriter::~CsvWriter() { ::close(descriptor_); }

void CsvWriter::row(const std::vector<double>& values) {
  std::vector<std::string> fields;
  fields.reserve(values.size());
  for (const double value : values) fields.push_back(csv_number(value));
  row_of_text(fields);
}

void CsvWriter::row_of_text(const std::vector<std::string>& fields) {
  if (fields.size() != columns_) throw std::logic_error(file_.string() + ": a row of another width than the header");
  std::string line;
  for (const std::string& field : fields) {
    if (&field != fields.data()) line += ',';
    line += csv_field(field);
  }
  line += '\n';

  const off_t whole = ::lseek(descriptor_, 0, SEEK_END);
  std::size_t written = 0;
  while (written < line.size()) {
    const ssize_t n = ::write(descriptor_, line.data() + written, line.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int error = errno;
      if (written > 0 && whole >= 0 && ::ftruncate(descriptor_, whole) != 0)
        throw_output_error(file_, "cut back to its last whole row", errno);
      throw_output_error(file_, "written", error);
    }
    written += static_cast<std::size_t>(n);
  }
}

}  // namespace similitude
