#pragma once
/// The ABI tag of a library file, read as bytes: nothing of the library has run yet.

#include <similitude/abi.h>

#include <filesystem>
#include <optional>
#include <variant>

#include "loader/refusal.h"

namespace similitude {

/// The tag as it lies in the file, or why there is none: not readable, not a library, no tag section, wrong magic, too
/// short.
std::variant<similitude_tag, Refusal> read_tag(const std::filesystem::path& file);

/// Whether this program and this processor can run a library with this tag: major equal, minor at most the program's,
/// layout equal, instruction set present. Empty: they can.
std::optional<Refusal> check_tag(const similitude_tag& tag);

}  // namespace similitude
