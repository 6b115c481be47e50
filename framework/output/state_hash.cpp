#include "output/state_hash.h"

#include "output/id_order.h"
#include "output/sha256.h"

namespace similitude {
namespace {

void add_field(Sha256& hash, const Column<double>& field) {
  const std::uint64_t size = field.size();  // so that values cannot move from one field to the next unseen
  hash.add(&size, sizeof size);
  hash.add(field.data(), field.size() * sizeof(double));
}

}  // namespace

std::string state_hash(const ParticleStore& particles, const GasFields* gas, const Column<double>* gas_fraction) {
  Sha256 hash;
  const std::uint64_t shape[4] = {particles.size(), particles.fields.rotation, gas != nullptr, gas_fraction != nullptr};
  hash.add(shape, sizeof shape);
  for (const std::uint32_t row : rows_by_id(particles)) {
    const std::uint64_t names[2] = {particles.id[row], particles.species[row]};
    hash.add(names, sizeof names);
    hash.add(&particles.position[row], sizeof(Row));
    hash.add(&particles.velocity[row], sizeof(Row));
    for (const NamedColumn& scalar : particles.scalars) hash.add(&scalar.value[row], sizeof(double));
    if (particles.fields.rotation) hash.add(&particles.angular_velocity[row], sizeof(Row));
  }
  if (gas) {
    add_field(hash, gas->velocity);
    add_field(hash, gas->pressure);
    for (const NamedColumn& scalar : gas->scalars) add_field(hash, scalar.value);
  }
  if (gas_fraction) add_field(hash, *gas_fraction);
  return hash.hex().substr(0, 32);
}

}  // namespace similitude
