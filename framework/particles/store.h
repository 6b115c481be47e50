#pragma once
/// Particles as packed rows: what a contact touches lies in one cache line. Optional rows exist only if a law or the
/// coupling asked for them at construction.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace similitude {

/// 64-byte aligned storage, so that rows and columns meet the vector width. Large columns lie on large pages where the system
/// has them: contacts reach from row to row, and every small page costs a look-up.
template <class T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::size_t k_cache_line = 64, k_large_page = std::size_t{1} << 21, k_worth_large_pages = k_large_page / 2;

  CacheAligned() = default;
  template <class U>
  CacheAligned(const CacheAligned<U>&) {}
  T* allocate(std::size_t n) {
    if (n > std::numeric_limits<std::size_t>::max() / 4 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = n * sizeof(T);
    if (bytes < k_worth_large_pages) return static_cast<T*>(::operator new(bytes, std::align_val_t{k_cache_line}));
    const std::size_t whole = (bytes + k_large_page - 1) / k_large_page * k_large_page;
    void* const at = ::operator new(whole, std::align_val_t{k_large_page});
#if defined(__linux__)
    madvise(at, whole, MADV_HUGEPAGE);   // a wish: without it all is the same but slower
#endif
    return static_cast<T*>(at);
  }
  void deallocate(T* p, std::size_t n) {
    ::operator delete(p, std::align_val_t{n * sizeof(T) < k_worth_large_pages ? k_cache_line : k_large_page});
  }
  template <class U>
  bool operator==(const CacheAligned<U>&) const { return true; }
};
template <class T>
using Column = std::vector<T, CacheAligned<T>>;

/// Four doubles that belong together. The fourth is named by each column below.
struct alignas(32) Row {
  double x = 0, y = 0, z = 0, w = 0;
};

/// What the particles carry beyond position, velocity and force.
struct StoreFields {
  bool rotation = false;    // angular velocity and torque
  bool coupling = false;    // gas velocity, stress force, drag impulse
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
  Column<std::uint64_t> id;       // for ever
  Column<std::uint32_t> species;  // index into the scene's particle classes

  std::size_t size() const { return position.size(); }
  void reserve(std::size_t n);
  /// Adds a particle at rest; the row is valid until the next sort. `drag` rows start at zero.
  std::size_t add(std::uint64_t new_id, std::uint32_t new_species, double x, double y, double z, double radius, double mass);
  /// Row k of the result is row order[k] of before; order.size() may be smaller (rows left out are removed).
  void reorder(const std::vector<std::uint32_t>& order);
  /// All rows of `other`, without its working memory.
  void copy_rows(const ParticleStore& other);
  /// Bytes of one particle's rows, as allocated.
  std::size_t bytes_per_particle() const;

 private:
  // The sorted copy of a column is made here and swapped in, so that a sort allocates only while the bed grows.
  Column<Row> spare_rows_;
  Column<std::uint64_t> spare_ids_;
  Column<std::uint32_t> spare_species_;
};

}  // namespace similitude
