#include "app/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace similitude::app {
namespace {

/// Characters, not bytes: a ± is one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

void print_table(const Table& table, std::ostream& out) {
  std::vector<std::size_t> widths(table.front().size(), 0);
  for (const auto& cells : table)
    for (std::size_t c = 0; c < cells.size(); ++c) widths[c] = std::max(widths[c], width_of(cells[c]));
  for (const auto& cells : table) {
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::string blank(widths[c] - width_of(cells[c]), ' ');
      line += c == 0 ? cells[c] + blank : "  " + blank + cells[c];
    }
    out << line << "\n";
  }
}

std::string seconds_text(double seconds) {
  if (seconds < 120) return fmt::format("{:.3g} s", seconds);
  if (seconds < 7200) return fmt::format("{:.3g} min", seconds / 60);
  return seconds < 172800 ? fmt::format("{:.3g} h", seconds / 3600) : fmt::format("{:.3g} d", seconds / 86400);
}

}  // namespace similitude::app
