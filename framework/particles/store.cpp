#include "particles/store.h"

#include <sys/mman.h>

#include <cmath>
#include <new>

namespace similitude {

namespace {

constexpr std::size_t k_cache_line = 64, k_large_page = std::size_t{1} << 21;   // [bytes]
constexpr std::size_t k_worth_large_pages = k_large_page / 2;                   // [bytes]

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes < k_worth_large_pages ? k_cache_line : k_large_page};
}

template <class T>
void reorder_column(std::vector<T, CacheAligned<T>>& column, const std::vector<std::uint32_t>& order,
                    std::vector<T, CacheAligned<T>>& spare) {
  spare.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) spare[k] = column[order[k]];
  column.swap(spare);
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
  spare_rows_.reserve(n);
  if (fields.rotation) {
    angular_velocity.reserve(n);
    torque.reserve(n);
  }
  if (fields.coupling) {
    gas.reserve(n);
    stress_force.reserve(n);
    drag_impulse.reserve(n);
  }
  if (fields.added_mass) {
    added_mass.reserve(n);
    spare_numbers_.reserve(n);
  }
  for (NamedColumn& scalar : scalars) scalar.value.reserve(n);
  if (!scalars.empty()) spare_numbers_.reserve(n);
  id.reserve(n);
  spare_ids_.reserve(n);
  species.reserve(n);
  spare_species_.reserve(n);
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

void ParticleStore::reorder(const std::vector<std::uint32_t>& order) {
  for (Column<Row>* column : {&position, &velocity, &force}) reorder_column(*column, order, spare_rows_);
  if (fields.rotation) {
    for (Column<Row>* column : {&angular_velocity, &torque}) reorder_column(*column, order, spare_rows_);
  }
  if (fields.coupling) {
    for (Column<Row>* column : {&gas, &stress_force, &drag_impulse}) reorder_column(*column, order, spare_rows_);
  }
  if (fields.added_mass) reorder_column(added_mass, order, spare_numbers_);
  for (NamedColumn& scalar : scalars) reorder_column(scalar.value, order, spare_numbers_);
  reorder_column(id, order, spare_ids_);
  reorder_column(species, order, spare_species_);
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
  std::size_t bytes = bytes_per_row(id, rows) + bytes_per_row(spare_ids_, rows) + bytes_per_row(species, rows) +
                      bytes_per_row(spare_species_, rows) + bytes_per_row(spare_rows_, rows) +
                      bytes_per_row(added_mass, rows) + bytes_per_row(spare_numbers_, rows);
  for (const NamedColumn& scalar : scalars) bytes += bytes_per_row(scalar.value, rows);
  for (const Column<Row>* column : {&position, &velocity, &force, &angular_velocity, &torque, &gas, &stress_force,
                                    &drag_impulse}) {
    bytes += bytes_per_row(*column, rows);
  }
  return bytes;
}

}  // namespace similitude
