#pragma once
/// Tables of words for the terminal.

#include <ostream>
#include <string>
#include <vector>

namespace similitude::app {

/// The first row heads it; the first column stands left, all others right.
using Table = std::vector<std::vector<std::string>>;
void print_table(const Table& table, std::ostream& out);

/// "41.2 s", "12.3 min", "3.4 h", "2.1 d".
std::string seconds_text(double seconds);

}  // namespace similitude::app
