#include "output/monitors.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace similitude {
namespace {

/// A column of monitors.csv: its name with the unit, and where its value lies. Order and names are the file's contract.
struct MonitorColumn {
  const char* name;
  double (*value)(const Monitors&);
};
constexpr MonitorColumn k_columns[] = {
    {"time [s]", [](const Monitors& m) { return m.time; }},
    {"particles [1]", [](const Monitors& m) { return m.particles; }},
    {"removed_particles [1]", [](const Monitors& m) { return m.removed_particles; }},
    {"solids_mass [kg]", [](const Monitors& m) { return m.solids_mass; }},
    {"solids_momentum_x [kg m/s]", [](const Monitors& m) { return m.solids_momentum[0]; }},
    {"solids_momentum_y [kg m/s]", [](const Monitors& m) { return m.solids_momentum[1]; }},
    {"solids_momentum_z [kg m/s]", [](const Monitors& m) { return m.solids_momentum[2]; }},
    {"kinetic_energy [J]", [](const Monitors& m) { return m.kinetic_energy; }},
    {"rotational_energy [J]", [](const Monitors& m) { return m.rotational_energy; }},
    {"bed_height [m]", [](const Monitors& m) { return m.bed_height; }},
    {"mean_height [m]", [](const Monitors& m) { return m.mean_height; }},
    {"largest_speed [m/s]", [](const Monitors& m) { return m.largest_speed; }},
    {"largest_overlap [% of d]", [](const Monitors& m) { return m.largest_overlap; }},
    {"contacts [1]", [](const Monitors& m) { return m.contacts; }},
    {"gas_mass [kg]", [](const Monitors& m) { return m.gas_mass; }},
    {"gas_momentum_x [kg m/s]", [](const Monitors& m) { return m.gas_momentum[0]; }},
    {"gas_momentum_y [kg m/s]", [](const Monitors& m) { return m.gas_momentum[1]; }},
    {"gas_momentum_z [kg m/s]", [](const Monitors& m) { return m.gas_momentum[2]; }},
    {"pressure_drop [Pa]", [](const Monitors& m) { return m.pressure_drop; }},
    {"smallest_gas_fraction [1]", [](const Monitors& m) { return m.smallest_gas_fraction; }},
    {"courant [1]", [](const Monitors& m) { return m.courant; }},
    {"gas_mass_residual [1]", [](const Monitors& m) { return m.gas_mass_residual; }},
    {"pressure_iterations [1]", [](const Monitors& m) { return m.pressure_iterations; }},
    {"inflow [kg/s]", [](const Monitors& m) { return m.inflow; }},
    {"outflow [kg/s]", [](const Monitors& m) { return m.outflow; }},
    {"gravity_impulse_z [kg m/s]", [](const Monitors& m) { return m.gravity_impulse; }},
    {"drag_impulse_z [kg m/s]", [](const Monitors& m) { return m.drag_impulse; }},
    {"stress_impulse_z [kg m/s]", [](const Monitors& m) { return m.stress_impulse; }},
    {"wall_impulse_z [kg m/s]", [](const Monitors& m) { return m.wall_impulse; }},
    {"gravity_work [J]", [](const Monitors& m) { return m.gravity_work; }},
    {"drag_work [J]", [](const Monitors& m) { return m.drag_work; }},
    {"stress_work [J]", [](const Monitors& m) { return m.stress_work; }},
    {"contact_work [J]", [](const Monitors& m) { return m.contact_work; }},
    {"gas_in [kg]", [](const Monitors& m) { return m.gas_in; }},
    {"gas_out [kg]", [](const Monitors& m) { return m.gas_out; }},
    {"momentum_residual [1]", [](const Monitors& m) { return m.residual.momentum; }},
    {"energy_residual [1]", [](const Monitors& m) { return m.residual.energy; }},
    {"gas_balance_residual [1]", [](const Monitors& m) { return m.residual.gas_mass; }},
    {"boundary_impulse_z [kg m/s]", [](const Monitors& m) { return m.boundary_impulse; }},
    {"pumping_work [J]", [](const Monitors& m) { return m.pumping_work; }},
    {"gas_momentum_residual [1]", [](const Monitors& m) { return m.residual.gas_momentum; }},
};

/// [Pa], simulated: area mean of what the pressure patches hold; without such a patch the
/// mean over the highest layer of cells.
double outlet_pressure(const Grid& grid, const GasFields& gas) {
  const similitude_grid& table = grid.table();
  double area_sum = 0, sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double area = grid.cell_volume() / grid.spacing(axis);
    for (std::size_t f = 0; f < grid.face_count(axis); ++f) {
      const int patch = grid.face_kind(axis, f) - SIMILITUDE_FACE_PATCH;
      if (patch < 0 || table.patches[patch].kind != SIMILITUDE_PATCH_PRESSURE) continue;
      area_sum += area;
      sum += area * table.patches[patch].pressure;
    }
  }
  if (area_sum > 0) return sum / area_sum;
  const std::size_t layer = grid.cell_count() / static_cast<std::size_t>(grid.cells(2));
  for (std::size_t c = grid.cell_count() - layer; c < grid.cell_count(); ++c) sum += gas.pressure[c];
  return sum / static_cast<double>(layer);
}

/// [Pa], simulated: mean over the bottom face, to which the lowest cells' pressure is carried with the gradient above
/// them: half a cell of a packed bed is not to be left out.
double bottom_pressure(const Grid& grid, const GasFields& gas) {
  const std::size_t layer = grid.cell_count() / static_cast<std::size_t>(grid.cells(2));
  double sum = 0;
  for (std::size_t c = 0; c < layer; ++c) {
    const double above = grid.cells(2) > 1 ? gas.pressure[c + layer] : gas.pressure[c];
    sum += gas.pressure[c] + (gas.pressure[c] - above) / 2;
  }
  return sum / static_cast<double>(layer);
}

void observe_solids(const ParticleStore& store, const MapBack& map, Monitors& m) {
  double mass = 0, energy = 0, spin_energy = 0, height = 0, largest = 0;
  const std::array<double, 3> momentum = momentum_of(store);
  for (std::size_t k = 0; k < store.size(); ++k) {
    const Row& v = store.velocity[k];
    const double square = v.x * v.x + v.y * v.y + v.z * v.z;
    mass += v.w;
    energy += 0.5 * v.w * square;
    height += v.w * store.position[k].z;
    largest = std::max(largest, square);
    if (store.fields.rotation) {
      const Row& w = store.angular_velocity[k];
      spin_energy += 0.5 * w.w * (w.x * w.x + w.y * w.y + w.z * w.z);
    }
  }
  m.particles = static_cast<double>(store.size());
  m.solids_mass = map.solids_mass(mass);
  for (std::size_t a = 0; a < 3; ++a) m.solids_momentum[a] = map.solids_mass(map.velocity(momentum[a]));
  m.kinetic_energy = map.solids_mass(map.velocity(map.velocity(energy)));
  if (store.fields.rotation) {
    // I = 2/5 m (d/2)^2 turns with the diameter that touches, not with the bed's length.
    const double per_mass_ratio = map.ratios.diameter * map.ratios.angular_velocity;
    m.rotational_energy = map.solids_mass(spin_energy) / (per_mass_ratio * per_mass_ratio);
  }
  m.bed_height = map.length(expanded_bed_height(store));
  if (mass > 0) m.mean_height = map.length(height / mass);
  m.largest_speed = map.velocity(std::sqrt(largest));
}

void observe_gas(const Observed& o, const MapBack& map, Monitors& m) {
  const Grid& grid = *o.grid;
  double sum = static_cast<double>(grid.cell_count());
  m.smallest_gas_fraction = 1;
  if (o.gas_fraction) {
    sum = 0;
    for (const double eps : *o.gas_fraction) {
      sum += eps;
      m.smallest_gas_fraction = std::min(m.smallest_gas_fraction, eps);
    }
  }
  m.gas_mass = map.gas_mass(o.gas_density * sum * grid.cell_volume());
  m.pressure_drop = map.pressure(bottom_pressure(grid, *o.gas) - outlet_pressure(grid, *o.gas));
  if (!o.gas_report) return;
  for (std::size_t a = 0; a < 3; ++a) m.gas_momentum[a] = map.gas_mass(map.velocity(o.gas_report->momentum[a]));
  m.courant = o.gas_report->courant;
  m.gas_mass_residual = o.gas_report->mass_residual;
  m.pressure_iterations = o.gas_report->iterations;
  m.inflow = map.gas_mass_flow(o.gas_report->inflow);
  m.outflow = map.gas_mass_flow(o.gas_report->outflow);
}

void observe_budget(const ParticleBudget& budget, const MapBack& map, Monitors& m) {
  const auto impulse = [&](const ParticleBudget::Vector& sum) { return map.solids_mass(map.velocity(sum[2])); };
  const auto work = [&](double sum) { return map.solids_mass(map.velocity(map.velocity(sum))); };
  m.gravity_impulse = impulse(budget.gravity_impulse);
  m.drag_impulse = impulse(budget.drag_impulse);
  m.stress_impulse = impulse(budget.stress_impulse);
  m.wall_impulse = impulse(budget.wall_impulse);
  m.gravity_work = work(budget.gravity_work);
  m.drag_work = work(budget.drag_work);
  m.stress_work = work(budget.stress_work);
  m.contact_work = work(budget.contact_work);
}

}  // namespace

double expanded_bed_height(const ParticleStore& particles) {
  struct Layer {
    double z, mass;
  };
  std::vector<Layer> layers(particles.size());
  double total = 0;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    layers[k] = {particles.position[k].z, particles.velocity[k].w};
    total += layers[k].mass;
  }
  if (!(total > 0)) return Monitors::k_none;
  std::sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.z < b.z; });

  // Half a particle's mass lies below its centre; between two centres the mass grows linearly.
  constexpr double k_share = 0.95;
  const double wanted = k_share * total;
  double below = 0, last_z = 0, last_below = 0;
  for (const Layer& layer : layers) {
    const double here = below + 0.5 * layer.mass;
    if (here >= wanted) return (last_z + (layer.z - last_z) * (wanted - last_below) / (here - last_below)) / k_share;
    below += layer.mass;
    last_z = layer.z, last_below = here;
  }
  return last_z / k_share;  // a few particles only: the highest one's centre is as far as mass is seen
}

Monitors observe(const Observed& simulated, const MapBack& map) {
  Monitors m;
  m.time = map.time(simulated.time);
  if (simulated.particles) observe_solids(*simulated.particles, map, m);
  if (simulated.engine) {
    m.removed_particles = static_cast<double>(simulated.engine->removed);
    m.contacts = static_cast<double>(simulated.engine->contacts);
    observe_budget(simulated.engine->budget, map, m);
  }
  m.largest_overlap = 100 * simulated.largest_overlap_ratio;
  if (simulated.grid && simulated.gas) observe_gas(simulated, map, m);
  if (simulated.accounts) {
    m.gas_in = map.gas_mass(simulated.accounts->gas_in());
    m.gas_out = map.gas_mass(simulated.accounts->gas_out());
    // By what they push and lift: the solids, so that these columns add up with theirs.
    m.boundary_impulse = map.solids_mass(map.velocity(simulated.accounts->boundary_impulse()));
    m.pumping_work = map.solids_mass(map.velocity(map.velocity(simulated.accounts->pumping_work())));
    m.residual = simulated.balances;
  }
  return m;
}

namespace {

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const MonitorColumn& column : k_columns) names.emplace_back(column.name);
  return names;
}

}  // namespace

MonitorFile::MonitorFile(const OutputDirectory& directory) : csv_(directory.file(k_monitors_file), column_names()) {}

MonitorFile::MonitorFile(const OutputDirectory& directory, std::uint64_t length)
    : csv_(directory.file(k_monitors_file), column_names(), length) {}

void MonitorFile::write(const Monitors& monitors) {
  std::vector<double> values;
  for (const MonitorColumn& column : k_columns) values.push_back(column.value(monitors));
  csv_.row(values);
}

}  // namespace similitude
