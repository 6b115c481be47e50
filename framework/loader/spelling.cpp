#include "loader/spelling.h"

#include <algorithm>

namespace similitude {
namespace {

bool letter(char c) { return 'a' <= c && c <= 'z'; }
bool digit(char c) { return '0' <= c && c <= '9'; }

/// Takes the text up to the next `end` off the front; false if there is no further one.
bool take(std::string_view& rest, char end, std::string_view& word) {
  const std::size_t place = rest.find(end);
  word = rest.substr(0, place);
  if (place == std::string_view::npos) return false;
  rest.remove_prefix(place + 1);
  return true;
}

bool is_word_of_address(std::string_view word) {
  return !word.empty() && (letter(word[0]) || digit(word[0])) &&
         std::all_of(word.begin(), word.end(), [](char c) { return letter(c) || digit(c) || c == '_' || c == '-'; });
}

bool is_number(std::string_view word) { return !word.empty() && std::all_of(word.begin(), word.end(), digit); }

}  // namespace

bool is_lower_snake(std::string_view text) {
  return !text.empty() && letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [](char c) { return letter(c) || digit(c) || c == '_'; });
}

bool is_model_id(std::string_view text) {
  if (text.find('.') == std::string_view::npos) return is_lower_snake(text);
  std::string_view word;
  for (bool more = true; more;) {
    more = take(text, '.', word);
    if (!is_word_of_address(word)) return false;
  }
  return true;
}

bool is_version(std::string_view text) {
  const std::string_view numbers = text.substr(0, text.find_first_of("-+"));
  std::string_view rest = numbers, major, minor, patch;
  return take(rest, '.', major) && take(rest, '.', minor) && !take(rest, '.', patch) && is_number(major) &&
         is_number(minor) && is_number(patch);
}

}  // namespace similitude
