#pragma once
#include <cstdint>
#include <vector>

#include "particles/store.h"

namespace similitude {

/// Row numbers in the order of id: files and hashes must not show how the bed happens to be sorted.
std::vector<std::uint32_t> rows_by_id(const ParticleStore& particles);

}  // namespace similitude
