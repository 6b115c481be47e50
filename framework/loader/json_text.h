#pragma once

#include <string>

namespace similitude {

/// JSON as text, `indent` spaces a level; -1: on one line. Paths need not be UTF-8, JSON must: bytes that are not become U+FFFD.
template <class Json>
std::string json_text(const Json& page, int indent = 2) {
  return page.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace similitude
