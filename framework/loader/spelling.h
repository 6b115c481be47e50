#pragma once
#include <string_view>

namespace similitude {

/// A letter a-z, then letters, digits and underscores: "my_law".
bool is_lower_snake(std::string_view text);

/// "gidaspow", or an address read backwards: "org.example.my_law", where words after the first may hold hyphens.
bool is_model_id(std::string_view text);

/// Three numbers, and after a hyphen or plus whatever the author likes: "1.0.0", "1.2.0-rc.1".
bool is_version(std::string_view text);

}  // namespace similitude
