#pragma once
/// audit.json: what the scaling law of this run keeps and gives up.

#include <similitude/abi.h>

#include <string>
#include <vector>

#include "output/directory.h"
#include "similarity/audit.h"

namespace similitude {

inline constexpr const char* k_audit_file = "audit.json";

/// Throws OutputError.
void write_audit(const OutputDirectory& directory, const std::string& law, const std::vector<GroupComparison>& groups,
                 const std::vector<std::string>& warnings);

}  // namespace similitude
