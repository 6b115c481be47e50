#include "loader/nearest_name.h"

#include <algorithm>
#include <numeric>

namespace similitude {
namespace {

/// Levenshtein distance, a swap of neighbours counted as one edit.
std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates) {
  std::size_t allowed = std::max<std::size_t>(2, word.size() / 3) + 1;
  std::string nearest;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edits(word, candidate);
    // A word of two letters is two edits from every other: sharing nothing is no likeness.
    if (distance < allowed && distance < std::max(word.size(), candidate.size())) {
      allowed = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace similitude
