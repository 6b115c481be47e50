#pragma once
/// Errors that carry the fix: where, what was given, why it is wrong in the user's terms, and what to type instead.

#include <stdexcept>
#include <string>
#include <vector>

#include "loader/nearest_name.h"   // for whoever writes messages
#include "scene/scene.h"

namespace similitude {

/// The case or study file, the command line or a data file is wrong. Exit status 2.
class InputError : public std::runtime_error {
 public:
  /// Message "file:line:col: path: what." and, on an indented line, the fix. Position and path are left out if empty.
  InputError(const SourceMark& mark, const std::string& path, const std::string& what, const std::string& fix = "");
  explicit InputError(const std::string& what, const std::string& fix = "");
};

}  // namespace similitude
