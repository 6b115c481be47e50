#include "bed_states.h"

#include <numbers>
#include <numeric>
#include <random>

#include "bench_bed.h"
#include "particles/particle_file.h"

namespace similitude::bench {

namespace {

/// Soft and damped until all lies, then the target stiffness until all is quiet.
void settle(ParticleStore& bed, double fall, std::int64_t quiet_steps) {
  ModelScene scene = box_around(bed);
  constexpr double soft_dt = 1e-5, stiff_dt = 5e-6;   // [s]
  const ContactModel soft = contact_law(67, 0.3, k_friction);
  Engine falling(bed, scene, soft, options(soft_dt, 20));
  falling.advance(static_cast<std::int64_t>(fall / soft_dt));
  const ContactModel stiff = contact_law(k_stiffness, 0.3, k_friction);
  Engine resting(bed, scene, stiff, options(stiff_dt, 50));
  resting.advance(quiet_steps);
}

class Agitator {
 public:
  void set(Row& velocity, double deviation, double upward = 0) {
    velocity.x = deviation * normal_(random_);
    velocity.y = deviation * normal_(random_);
    velocity.z = deviation * normal_(random_) + upward;
  }

 private:
  std::mt19937_64 random_{777};
  std::normal_distribution<double> normal_;
};

/// Rows by their distance from the middle plane.
std::vector<std::size_t> from_the_middle(const ParticleStore& bed) {
  std::vector<std::size_t> rows(bed.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  const auto distance = [&](std::size_t row) { return std::abs(bed.position[row].x - 0.5 * k_wide); };
  std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  return rows;
}

/// The core stands on a lattice of its own between annulus particles, none of which it touches.
void open_spout(ParticleStore& bed) {
  const std::vector<std::size_t> rows = from_the_middle(bed);
  const std::size_t core = bed.size() / 20;
  const double pitch = 1.35 * k_diameter;   // solids fraction pi / 6 / 1.35^3 = 0.21
  const double half = std::abs(bed.position[rows[core]].x - 0.5 * k_wide) - k_diameter;   // [m], of the core's centres
  const auto nx = static_cast<std::size_t>(std::max(0.0, 2 * half / pitch)) + 1;
  const auto ny = static_cast<std::size_t>((k_deep - k_diameter) / pitch) + 1;
  Agitator agitator;
  for (std::size_t n = 0; n < core; ++n) {
    Row& p = bed.position[rows[n]];
    p.x = 0.5 * k_wide + (static_cast<double>(n % nx) - 0.5 * static_cast<double>(nx - 1)) * pitch;
    p.y = 0.5 * k_deep + (static_cast<double>(n / nx % ny) - 0.5 * static_cast<double>(ny - 1)) * pitch;
    p.z = 0.5 * k_diameter + static_cast<double>(n / (nx * ny)) * pitch;
    agitator.set(bed.velocity[rows[n]], 0.3, 2);
  }
}

/// [m], the height that half of all columns one diameter wide reach.
double median_top(const ParticleStore& bed) {
  std::map<std::array<int, 2>, double> column_top;
  for (const Row& p : bed.position) {
    double& top = column_top[{static_cast<int>(p.x / k_diameter), static_cast<int>(p.y / k_diameter)}];
    top = std::max(top, p.z);
  }
  std::vector<double> tops;
  for (const auto& [_, top] : column_top) tops.push_back(top);
  std::nth_element(tops.begin(), tops.begin() + static_cast<std::ptrdiff_t>(tops.size() / 2), tops.end());
  return tops[tops.size() / 2] + 0.5 * k_diameter;
}

/// Calls visit(row, row) once for all pairs nearer than one diameter.
template <class Visit>
void for_each_touching_pair(const ParticleStore& bed, Visit&& visit) {
  const auto cell_of = [](double x) { return static_cast<std::int64_t>(std::floor(x / k_diameter)); };
  const auto key = [](std::int64_t i, std::int64_t j, std::int64_t k) { return ((k + 4) << 24) + ((j + 4) << 12) + i + 4; };
  std::vector<std::pair<std::int64_t, std::size_t>> sorted;
  for (std::size_t row = 0; row < bed.size(); ++row) {
    const Row& p = bed.position[row];
    sorted.emplace_back(key(cell_of(p.x), cell_of(p.y), cell_of(p.z)), row);
  }
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [cell, row] : sorted) {
    for (std::int64_t offset = 0; offset < 27; ++offset) {
      const std::int64_t there = cell + ((offset / 9 - 1) << 24) + ((offset / 3 % 3 - 1) << 12) + offset % 3 - 1;
      auto it = std::lower_bound(sorted.begin(), sorted.end(), std::pair{there, std::size_t{0}});
      for (; it != sorted.end() && it->first == there; ++it) {
        if (it->second <= row) continue;
        const Row &a = bed.position[row], &b = bed.position[it->second];
        const double squared = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
        if (squared < k_diameter * k_diameter) visit(row, it->second);
      }
    }
  }
}

}  // namespace

ParticleStore poured_bed(std::size_t count) {
  ParticleStore bed = lattice(count, 1.09 * k_diameter, 0.03 * k_diameter);
  double height = 0;
  for (const Row& p : bed.position) height = std::max(height, p.z);
  settle(bed, std::sqrt(2 * 0.2 * height / k_gravity) + 0.05, 10'000);
  return bed;
}

ParticleStore piled_bed(const ParticleStore& settled, int copies, std::size_t count) {
  const double top = median_top(settled);
  std::vector<Row> places;
  for (int copy = 0; copy < copies; ++copy) {
    for (const Row& p : settled.position) {
      if (copy + 1 < copies && p.z > top - 0.4 * k_diameter) continue;   // would stick out into the next copy
      places.push_back({copy % 2 ? k_wide - p.x : p.x, p.y, p.z + copy * top, p.w});
    }
  }
  std::sort(places.begin(), places.end(), [](const Row& a, const Row& b) { return a.z < b.z; });
  places.resize(std::min(places.size(), count));
  ParticleStore bed = empty_bed();
  for (std::size_t n = 0; n < places.size(); ++n) bed.add(n, 0, places[n].x, places[n].y, places[n].z, places[n].w, k_mass);
  settle(bed, 0.01, 8'000);
  return bed;
}

bool put_into_state(ParticleStore& bed, const std::string& state) {
  Agitator agitator;
  if (state == "settled") return true;
  if (state == "dense") {
    for (Row& v : bed.velocity) agitator.set(v, 0.1);
  } else if (state == "kick") {
    for (Row& p : bed.position) p.z = 0.5 * k_diameter + 1.3 * (p.z - 0.5 * k_diameter);
    for (Row& v : bed.velocity) agitator.set(v, 0.3);
  } else if (state == "spout") {
    open_spout(bed);
  } else {
    return false;
  }
  return true;
}

ParticleStore read_bed(const std::string& file) {
  const std::vector<FileParticle> particles = read_particle_file(file);
  ParticleStore bed = empty_bed();
  bed.reserve(particles.size());
  for (std::size_t n = 0; n < particles.size(); ++n) {
    const auto& [x, v] = std::pair{particles[n].position, particles[n].velocity};
    const std::size_t row = bed.add(n, 0, x[0], x[1], x[2], 0.5 * k_diameter, k_mass);
    bed.velocity[row] = {v[0], v[1], v[2], k_mass};
  }
  return bed;
}

void write_bed(const ParticleStore& bed, const std::string& file) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (!out) {
    std::fprintf(stderr, "%s cannot be written.\n", file.c_str());
    std::exit(2);
  }
  // Two types: LIGGGHTS gives walls a type of their own.
  std::fprintf(out, "bed\n\n%zu atoms\n2 atom types\n\n0 %g xlo xhi\n0 %g ylo yhi\n0 %g zlo zhi\n\nAtoms\n\n", bed.size(), k_wide,
               k_deep, box_around(bed).size[2]);
  for (std::size_t row = 0; row < bed.size(); ++row) {
    const Row& p = bed.position[row];
    std::fprintf(out, "%zu 1 %g %g %.12g %.12g %.12g\n", row + 1, k_diameter, k_density, p.x, p.y, p.z);
  }
  std::fprintf(out, "\nVelocities\n\n");
  for (std::size_t row = 0; row < bed.size(); ++row) {
    const Row& v = bed.velocity[row];
    std::fprintf(out, "%zu %.9g %.9g %.9g 0 0 0\n", row + 1, v.x, v.y, v.z);
  }
  std::fclose(out);
}

Observables observe(const ParticleStore& bed) {
  Observables seen;
  const auto count = static_cast<double>(bed.size());
  std::vector<double> heights;
  for (const Row& p : bed.position) heights.push_back(p.z);
  const auto nearly_all = heights.begin() + static_cast<std::ptrdiff_t>(0.99 * count);
  std::nth_element(heights.begin(), nearly_all, heights.end());
  seen.top = *nearly_all;
  for (const Row& v : bed.velocity) seen.kinetic_energy += 0.5 * k_mass * (v.x * v.x + v.y * v.y + v.z * v.z) / count;

  // The linear law of the case: damping ratio from ln e, F = k overlap - 2 zeta sqrt(k m*) v_n.
  const double log_e = std::log(k_restitution), effective_mass = 0.5 * k_mass;
  const double ratio = -log_e / std::sqrt(std::numbers::pi * std::numbers::pi + log_e * log_e);
  const double damping = 2 * ratio * std::sqrt(k_stiffness * effective_mass);   // [kg/s]
  double force = 0;
  for_each_touching_pair(bed, [&](std::size_t i, std::size_t j) {
    const Row &a = bed.position[i], &b = bed.position[j], &va = bed.velocity[i], &vb = bed.velocity[j];
    const double dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z, distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double parting = ((va.x - vb.x) * dx + (va.y - vb.y) * dy + (va.z - vb.z) * dz) / distance;
    force += std::abs(k_stiffness * (k_diameter - distance) - damping * parting);
    ++seen.pairs;
  });
  seen.coordination = 2 * static_cast<double>(seen.pairs) / count;
  if (seen.pairs > 0) seen.normal_force = force / static_cast<double>(seen.pairs);
  return seen;
}

}  // namespace similitude::bench
