#pragma once
/// One plugin library in this process.

#include <similitude/abi.h>

#include <filesystem>
#include <variant>

#include "loader/refusal.h"

namespace similitude {

/// Checks the file, maps it and checks what it offers. A library is mapped once and stays for ever, whatever comes of
/// it: asking again for the same file gives the same answer. Main thread.
std::variant<const similitude_entry*, Refusal> load_library(const std::filesystem::path& file);

}  // namespace similitude
