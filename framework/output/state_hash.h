#pragma once
#include <string>

#include "coupling/coupling.h"
#include "particles/store.h"

namespace similitude {

/// 32 hexadecimal digits (the first half of a SHA-256) over the particles in the order of id (id, class, position,
/// radius, velocity, mass, and rotation and scalars if there are any) and the gas fields, bit by bit. Two runs with the same
/// hash ended in the same state; row order and thread count do not enter. Null gas or gas_fraction: the run has none.
std::string state_hash(const ParticleStore& particles, const GasFields* gas, const Column<double>* gas_fraction);

}  // namespace similitude
