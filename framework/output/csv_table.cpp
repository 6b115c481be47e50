#include "output/csv_table.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "scene/input_file.h"
#include "scene/messages.h"
#include "scene/section.h"

namespace similitude {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (quoted && c == '"' && k + 1 < line.size() && line[k + 1] == '"') {
      fields.back() += '"';
      ++k;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
}

std::string place(const std::filesystem::path& file, std::size_t row) {
  return file.string() + ":" + std::to_string(row + 2);  // the names are line 1
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file) : file_(file) {
  refuse_folder(file, {"table", {".csv"}, ""});
  std::ifstream stream(file);
  std::string line;
  if (!std::filesystem::is_regular_file(file) || !stream.is_open())
    throw InputError(file.string() + ": there is no such file.");
  if (!std::getline(stream, line))
    throw InputError(file.string() + ": this table is empty.", "Its first row must name the columns.");
  columns_ = fields_of(line);
  while (std::getline(stream, line)) {
    if (line.empty() || line == "\r") continue;
    rows_.push_back(fields_of(line));
    if (rows_.back().size() != columns_.size())
      throw InputError(place(file, rows_.size() - 1) + ": this row has " + std::to_string(rows_.back().size()) +
                       " fields, but there are " + std::to_string(columns_.size()) + " columns.");
  }
}

bool CsvTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::size_t CsvTable::index(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end())
    throw InputError(file_.string() + ": the column " + column + " is missing.",
                     "Columns of this file: " + listed(columns_) + ".");
  return static_cast<std::size_t>(found - columns_.begin());
}

std::vector<std::string> CsvTable::texts(const std::string& column) const {
  const std::size_t at = index(column);
  std::vector<std::string> values;
  for (const auto& row : rows_) values.push_back(row[at]);
  return values;
}

std::vector<double> CsvTable::numbers(const std::string& column) const {
  const std::size_t at = index(column);
  std::vector<double> values;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const std::string& text = rows_[row][at];
    char* end = nullptr;
    const double value = text.empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(text.c_str(), &end);
    if (!text.empty() && (end == text.c_str() || *end != '\0'))
      throw InputError(place(file_, row) + ": \"" + text + "\" in column " + column + " is no number.");
    values.push_back(value);
  }
  return values;
}

}  // namespace similitude
