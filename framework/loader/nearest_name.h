#pragma once
#include <string>
#include <vector>

namespace similitude {

/// The nearest of `candidates` within a third of the word's length (at least 2 edits), or "".
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace similitude
