#pragma once
#include <string>
#include <vector>

namespace similitude {

/// RFC 4648, section 4.
std::string base64(const std::vector<char>& bytes);

}  // namespace similitude
