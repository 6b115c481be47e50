#pragma once
/// Spoils text and bytes the way hands, editors and disks do. The same number gives the same damage everywhere.

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace similitude::fuzz {

class Damage {
 public:
  explicit Damage(std::uint64_t number) : random_(number * 0x9e3779b97f4a7c15ull + 1) {}

  std::size_t below(std::size_t end) { return end == 0 ? 0 : static_cast<std::size_t>(random_() % end); }

  /// One to four mishaps to a text.
  std::string to_text(std::string text) {
    for (std::size_t n = 1 + below(4); n > 0; --n) one(text);
    return text;
  }
  /// Flipped bits, a stretch of noise, a cut, in a file of bytes.
  std::string to_bytes(std::string bytes) {
    if (bytes.empty()) return bytes;
    switch (below(4)) {
      case 0: bytes.resize(below(bytes.size())); break;
      case 1: bytes.insert(below(bytes.size()), std::string(1 + below(64), static_cast<char>(random_()))); break;
      default:
        for (std::size_t n = 1 + below(8); n > 0; --n) bytes[below(bytes.size())] ^= static_cast<char>(1u << below(8));
    }
    return bytes;
  }

 private:
  static constexpr std::array<const char*, 28> k_numbers{
      "0", "-1", "1", "-0", "1e308", "-1e308", "1e309", "1e-308", "5e-324", "nan", "inf", "-inf", "99999999999999999999",
      "9223372036854775807", "-9223372036854775808", "4294967296", "0x10", "1e", "1.", ".", "+1", "1,5", "1_000", "1e3", "0.5", "1e9",
      "1e-9", "2147483648"};
  static constexpr std::array<const char*, 26> k_words{
      "{", "}", "[", "]", ":", "- ", "&a ", "*a", "!!binary ", "|", ">", "~", "null", "true", "\"", "'", "#", "\t", "%", "...", "---",
      "auto", "none", "exact", "m/s", "<<: *a"};

  static bool in_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e'; }

  void one(std::string& text) {
    if (text.empty()) return;
    const std::size_t at = below(text.size());
    switch (below(10)) {
      case 0: text[at] = static_cast<char>(random_()); break;
      case 1: text.erase(at, 1 + below(20)); break;
      case 2: text.insert(at, k_words[below(k_words.size())]); break;
      case 3: text.insert(at, text.substr(below(text.size()), below(60))); break;   // pasted twice
      case 4: lines(text); break;
      case 5: if (below(8) == 0) text.resize(at); else text.insert(at, k_numbers[below(k_numbers.size())]); break;
      default: number(text, at);
    }
  }

  /// The next number after `at` becomes another one.
  void number(std::string& text, std::size_t at) {
    const std::size_t from = text.find_first_of("0123456789", at);
    if (from == std::string::npos) return;
    std::size_t to = from;
    while (to < text.size() && in_number(text[to])) ++to;
    text.replace(from, to - from, k_numbers[below(k_numbers.size())]);
  }

  /// A line is lost, doubled or moved.
  void lines(std::string& text) {
    std::vector<std::string> all;
    std::size_t from = 0;
    for (std::size_t end; (end = text.find('\n', from)) != std::string::npos; from = end + 1) all.push_back(text.substr(from, end + 1 - from));
    all.push_back(text.substr(from));
    const std::size_t one = below(all.size());
    const std::string taken = all[one];
    if (below(3) != 0) all.erase(all.begin() + static_cast<std::ptrdiff_t>(one));
    if (below(3) != 0) all.insert(all.begin() + static_cast<std::ptrdiff_t>(below(all.size() + 1)), taken);
    text.clear();
    for (const std::string& line : all) text += line;
  }

  std::mt19937_64 random_;
};

}  // namespace similitude::fuzz
