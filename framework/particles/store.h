#pragma once
/// Particles as packed rows: what a contact touches lies in one cache line. Optional rows exist only if a law or the
/// coupling asked for them at construction.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace similitude {

/// Memory of a column, 64-byte aligned, so that rows and columns meet the vector width. Large columns lie on large pages where
/// the system has them: contacts reach from row to row, and every small page costs a look-up. Throws std::bad_alloc.
void* allocate_column(std::size_t bytes);
void free_column(void* column, std::size_t bytes) noexcept;

template <class T>
struct CacheAligned {
  using value_type = T;

  CacheAligned() = default;
  template <class U>
  CacheAligned(const CacheAligned<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocate_column(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { free_column(p, n * sizeof(T)); }
  template <class U>
  bool operator==(const CacheAligned<U>&) const { return true; }
};
template <class T>
using Column = std::vector<T, CacheAligned<T>>;

/// Four doubles that belong together. The fourth is named by each column below.
struct alignas(32) Row {
  double x = 0, y = 0, z = 0, w = 0;
};

/// Something that effects declared, a value per row: a temperature, a mass fraction.
struct NamedColumn {
  std::string name, unit;
  Column<double> value;
};

/// What the particles carry beyond position, velocity and force.
struct StoreFields {
  bool rotation = false;    // angular velocity and torque
  bool coupling = false;    // gas velocity, stress force, drag impulse
  bool added_mass = false;  // of effects; only with coupling
};

/// Particle rows. Row numbers change when the bed is sorted; `id` never does. Pointers into columns do not outlive a sort.
struct ParticleStore {
  explicit ParticleStore(StoreFields wanted = {}) : fields(wanted) {}

  StoreFields fields;
  Column<Row> position;           // x y z [m], w: radius [m]
  Column<Row> velocity;           // vx vy vz [m/s], w: mass [kg]
  Column<Row> force;              // of contacts in the last sub-step [N], w: 0
  Column<Row> angular_velocity;   // [rad/s], w: moment of inertia [kg m^2]; rotation only
  Column<Row> torque;             // [N m], w: 0; rotation only
  Column<Row> gas;                // u of the gas at the particle [m/s], w: K [kg/s], parcel weight included; coupling only
  Column<Row> stress_force;       // [N], V_p (-grad p + div tau) and all else held over a gas step; coupling only
  Column<Row> drag_impulse;       // [N s], received less what the gas was charged: see Coupling::interpolate; coupling only
  Column<double> added_mass;      // [kg], of the gas moved along, parcel weight included; effects that add it make it anew in every
                                  // gas step, so it is no part of a checkpoint
  std::vector<NamedColumn> scalars;   // what effects declared; none without them. Whoever adds one fills it
  Column<std::uint64_t> id;       // for ever
  Column<std::uint32_t> species;  // index into the scene's particle classes

  std::size_t size() const { return position.size(); }
  void reserve(std::size_t n);
  /// Adds a particle at rest; the row is valid until the next sort. `drag` rows and scalars start at zero.
  std::size_t add(std::uint64_t new_id, std::uint32_t new_species, double x, double y, double z, double radius, double mass);
  /// Row k of the result is row order[k] of before; order.size() may be smaller (rows left out are removed). `spare` is working
  /// memory: what it held is lost, and its room may come from a column. A sort allocates only while the bed grows.
  void reorder(const std::vector<std::uint32_t>& order, Column<Row>& spare);
  void reorder(const std::vector<std::uint32_t>& order);
  /// All rows of `other`, without its working memory. Added mass, if this store has it, becomes zero.
  void copy_rows(const ParticleStore& other);
  /// Bytes of one particle's rows, as allocated.
  std::size_t bytes_per_particle() const;
};

}  // namespace similitude
