#pragma once
/// Words and numbers of a line of text, for the readers of particle files.

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace similitude {

inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

inline std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> out;
  for (std::size_t at = line.find_first_not_of(" \t\r"); at != std::string_view::npos;) {
    const std::size_t end = line.find_first_of(" \t\r", at);
    out.push_back(line.substr(at, end - at));
    at = end == std::string_view::npos ? end : line.find_first_not_of(" \t\r", end);
  }
  return out;
}

inline std::vector<std::string_view> comma_separated(std::string_view line) {
  std::vector<std::string_view> out;
  std::size_t at = 0;
  for (std::size_t comma; (comma = line.find(',', at)) != std::string_view::npos; at = comma + 1) {
    out.push_back(trimmed(line.substr(at, comma - at)));
  }
  out.push_back(trimmed(line.substr(at)));
  return out;
}

/// The whole word as a number, independent of the locale; empty if it is not one.
template <class Number>
std::optional<Number> number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return {};
  return value;
}

}  // namespace similitude
