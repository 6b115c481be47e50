#pragma once
/// Whether what a library offers can be used as it stands, so that nobody else needs to ask.

#include <similitude/abi.h>

#include <optional>

#include "loader/refusal.h"

namespace similitude {

/// Every descriptor: kind known, id and version well formed, functions there where the kind requires them, parameter
/// table sound (names unique, units and texts there, defaults inside the ranges). Empty: all is well. Names the first
/// fault.
std::optional<Refusal> check_entry(const similitude_entry& entry);

}  // namespace similitude
