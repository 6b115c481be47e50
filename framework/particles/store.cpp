#include "particles/store.h"

#include <sys/mman.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <new>

namespace similitude {

namespace {

constexpr std::size_t k_cache_line = 64, k_large_page = std::size_t{1} << 21;   // [bytes]
constexpr std::size_t k_worth_large_pages = k_large_page / 2;                   // [bytes]

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes < k_worth_large_pages ? k_cache_line : k_large_page};
}

/// The sorted copy is made in `spare` and swapped in.
void reorder_rows(Column<Row>& column, const std::vector<std::uint32_t>& order, Column<Row>& spare) {
  spare.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) spare[k] = column[order[k]];
  column.swap(spare);
}

/// Narrower columns go through the same room and back.
template <class T>
void reorder_column(Column<T>& column, const std::vector<std::uint32_t>& order, Column<Row>& spare) {
  static_assert(sizeof(T) <= sizeof(Row));
  spare.resize(order.size());
  void* const room = spare.data();
  for (std::size_t k = 0; k < order.size(); ++k) std::memcpy(static_cast<std::byte*>(room) + k * sizeof(T), &column[order[k]], sizeof(T));
  column.resize(order.size());
  if (!order.empty()) std::memcpy(column.data(), room, order.size() * sizeof(T));
}

template <class T>
std::size_t bytes_per_row(const Column<T>& column, std::size_t rows) {
  return rows == 0 ? 0 : column.capacity() * sizeof(T) / rows;
}

}  // namespace

void* allocate_column(std::size_t bytes) {
  if (bytes < k_worth_large_pages) return ::operator new(bytes, alignment_of(bytes));
  const std::size_t whole = (bytes + k_large_page - 1) / k_large_page * k_large_page;
  void* const column = ::operator new(whole, alignment_of(bytes));
  madvise(column, whole, MADV_HUGEPAGE);  // a wish: without it all is the same but slower
  return column;
}

void free_column(void* column, std::size_t bytes) noexcept { ::operator delete(column, alignment_of(bytes)); }

void ParticleStore::reserve(std::size_t n) {
  position.reserve(n);
  velocity.reserve(n);
  force.reserve(n);
  if (fields.rotation) {
    angular_velocity.reserve(n);
    torque.reserve(n);
  }
  if (fields.coupling) {
    gas.reserve(n);
    stress_force.reserve(n);
    drag_impulse.reserve(n);
  }
  if (fields.added_mass) added_mass.reserve(n);
  for (NamedColumn& scalar : scalars) scalar.value.reserve(n);
  id.reserve(n);
  species.reserve(n);
}

std::size_t ParticleStore::add(std::uint64_t new_id, std::uint32_t new_species, double x, double y, double z,
                               double radius, double mass) {
  position.push_back({x, y, z, radius});
  velocity.push_back({0, 0, 0, mass});
  force.push_back({});
  if (fields.rotation) {
    angular_velocity.push_back({0, 0, 0, 0.4 * mass * radius * radius});   // solid sphere: 2/5 m r^2
    torque.push_back({});
  }
  if (fields.coupling) {
    gas.push_back({});
    stress_force.push_back({});
    drag_impulse.push_back({});
  }
  if (fields.added_mass) added_mass.push_back(0);
  for (NamedColumn& scalar : scalars) scalar.value.push_back(0);
  id.push_back(new_id);
  species.push_back(new_species);
  return position.size() - 1;
}

void ParticleStore::reorder(const std::vector<std::uint32_t>& order, Column<Row>& spare) {
  for (Column<Row>* column : {&position, &velocity, &force}) reorder_rows(*column, order, spare);
  if (fields.rotation) {
    for (Column<Row>* column : {&angular_velocity, &torque}) reorder_rows(*column, order, spare);
  }
  if (fields.coupling) {
    for (Column<Row>* column : {&gas, &stress_force, &drag_impulse}) reorder_rows(*column, order, spare);
  }
  if (fields.added_mass) reorder_column(added_mass, order, spare);
  for (NamedColumn& scalar : scalars) reorder_column(scalar.value, order, spare);
  reorder_column(id, order, spare);
  reorder_column(species, order, spare);
}

void ParticleStore::reorder(const std::vector<std::uint32_t>& order) {
  Column<Row> spare;
  reorder(order, spare);
}

void ParticleStore::copy_rows(const ParticleStore& other) {
  const bool wants_added_mass = fields.added_mass;
  fields = other.fields;
  fields.added_mass = wants_added_mass;
  position = other.position;
  velocity = other.velocity;
  force = other.force;
  angular_velocity = other.angular_velocity;
  torque = other.torque;
  gas = other.gas;
  stress_force = other.stress_force;
  drag_impulse = other.drag_impulse;
  added_mass.assign(wants_added_mass ? other.size() : 0, 0);
  scalars.resize(other.scalars.size());   // their names stay: a checkpoint does not know them
  for (std::size_t s = 0; s < scalars.size(); ++s) {
    if (scalars[s].name.empty()) scalars[s] = other.scalars[s];
    scalars[s].value = other.scalars[s].value;
  }
  id = other.id;
  species = other.species;
}

std::size_t ParticleStore::bytes_per_particle() const {
  const std::size_t rows = size();
  std::size_t bytes = bytes_per_row(id, rows) + bytes_per_row(species, rows) + bytes_per_row(added_mass, rows);
  for (const NamedColumn& scalar : scalars) bytes += bytes_per_row(scalar.value, rows);
  for (const Column<Row>* column : {&position, &velocity, &force, &angular_velocity, &torque, &gas, &stress_force,
                                    &drag_impulse}) {
    bytes += bytes_per_row(*column, rows);
  }
  return bytes;
}

}  // namespace similitude
