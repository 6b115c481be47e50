#include "coupling/coupling.h"

#include <algorithm>

#include <similitude/sphere.h>

#include "coupling/cell_map.h"
#include "coupling/deposit.h"
#include "coupling/exchange_coefficient.h"
#include "coupling/smoothing.h"
#include "fluid/staggered.h"

namespace similitude {

double smoothing_length_of(const ModelScene& scene) {
  if (scene.smoothing_length) return *scene.smoothing_length;
  double largest = 0;
  for (const ParticleClass& type : scene.particles) largest = std::max(largest, type.diameter);
  return 3 * largest;
}

namespace {

std::ptrdiff_t signed_size(std::size_t n) { return static_cast<std::ptrdiff_t>(n); }

/// Sums of rows in blocks of fixed size: the same bits for any number of threads.
class BlockSum {
 public:
  /// visit(n) for all n < count; returns the sum of rows[n], each as visit(n) left it.
  template <class Visit>
  std::array<double, 3> after(const Column<Row>& rows, Visit&& visit) {
    constexpr std::size_t k_block = 1024;
    const std::size_t blocks = (rows.size() + k_block - 1) / k_block;
    partial_.resize(blocks);
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t b = 0; b < signed_size(blocks); ++b) {
      const auto block = static_cast<std::size_t>(b);
      Row sum;
      for (std::size_t p = block * k_block; p < std::min(rows.size(), (block + 1) * k_block); ++p) {
        visit(p);
        sum.x += rows[p].x;
        sum.y += rows[p].y;
        sum.z += rows[p].z;
      }
      partial_[block] = sum;
    }
    std::array<double, 3> total{};
    for (const Row& sum : partial_) {
      total[0] += sum.x;
      total[1] += sum.y;
      total[2] += sum.z;
    }
    return total;
  }
  std::array<double, 3> operator()(const Column<Row>& rows) {
    return after(rows, [](std::size_t) {});
  }

 private:
  std::vector<Row> partial_;
};

/// Three columns of a cell field as the first three of each row; the fourth becomes zero.
void read_columns(const Column<double>& columns, CellRows& rows) {
  const std::size_t cells = rows.size();
#pragma omp parallel for schedule(static) if (signed_size(cells) >= k_worth_threads)
  for (std::ptrdiff_t i = 0; i < signed_size(cells); ++i) {
    const auto c = static_cast<std::size_t>(i);
    rows[c] = {columns[c], columns[cells + c], columns[2 * cells + c], 0};
  }
}

void write_columns(const CellRows& rows, double factor, Column<double>& columns) {
  const std::size_t cells = rows.size();
#pragma omp parallel for schedule(static) if (signed_size(cells) >= k_worth_threads)
  for (std::ptrdiff_t i = 0; i < signed_size(cells); ++i) {
    const auto c = static_cast<std::size_t>(i);
    columns[c] = factor * rows[c].x;
    columns[cells + c] = factor * rows[c].y;
    columns[2 * cells + c] = factor * rows[c].z;
  }
}

}  // namespace

struct Coupling::Parts {
  Parts(const ModelScene& scene, const Grid& grid, const DragModel& law, bool is_coupled, DragForm form)
      : coupled(is_coupled), length(smoothing_length_of(scene)), gas_density(scene.gas_density), gravity(scene.gravity), map(grid),
        smoothing(map, is_coupled ? length : 0), deposit(map), drag(scene, map, law, form), solids(map.cell_count()), at_cells(map.cell_count()),
        sizes(drag.needs_sauter_diameter() ? map.cell_count() : 0) {}

  bool coupled;
  double length;                    // [m]
  double gas_density;               // [kg/m^3]
  std::array<double, 3> gravity;    // [m/s^2]
  CellMap map;
  Smoothing smoothing;
  Deposit deposit;
  ExchangeCoefficient drag;
  CellRows solids;                  // impulse owed [N s] and solids volume [m^3]
  CellRows at_cells;                // gas as particles see it, or K v and K
  bool gas_is_seen = false;         // at_cells holds the smoothed velocity of the gas as it is now
  CellRows sizes;                   // sum d^3, sum d^2; only if the drag law wants the Sauter diameter
  BlockSum sum;
  std::array<double, 3> pending{};  // [kg m/s]
  std::size_t accounts_opened = 0;
  std::uint64_t accounts_left = 0;

  void see(const GasFields& gas);
  void owe(const std::array<double, 3>& received_less_charged) {
    for (std::size_t axis = 0; axis < 3; ++axis) pending[axis] = -received_less_charged[axis];
  }
  void deposit_solids(const ParticleStore& particles, Column<double>& gas_fraction);
  void deposit_sizes(const ParticleStore& particles);
};

/// at_cells = the gas velocity, smoothed.
void Coupling::Parts::see(const GasFields& gas) {
  if (gas_is_seen) return;
  read_columns(gas.velocity, at_cells);
  smoothing.apply(at_cells);
  gas_is_seen = true;
}

/// Solids volume and the impulse owed travel together, since both are known before the drag law is asked.
void Coupling::Parts::deposit_solids(const ParticleStore& particles, Column<double>& gas_fraction) {
  deposit.sort(particles.position);
  deposit.spread(
      particles.position,
      [&](std::size_t p) {
        const Row& received_less_charged = particles.drag_impulse[p];
        return Row{-received_less_charged.x, -received_less_charged.y, -received_less_charged.z,
                   sphere_volume(2 * particles.position[p].w)};
      },
      solids);
  smoothing.apply(solids);
  const double cell_volume = map.cell_volume();
#pragma omp parallel for schedule(static) if (signed_size(solids.size()) >= k_worth_threads)
  for (std::ptrdiff_t i = 0; i < signed_size(solids.size()); ++i) {
    const auto c = static_cast<std::size_t>(i);
    gas_fraction[c] = 1 - solids[c].w / cell_volume;
  }
}

void Coupling::Parts::deposit_sizes(const ParticleStore& particles) {
  if (!drag.needs_sauter_diameter()) return;
  deposit.spread(
      particles.position,
      [&](std::size_t p) {
        const double d = drag.diameter_of(particles, p), solids = drag.displaced_volume(particles, p);
        return Row{solids, solids / d, 0, 0};   // pi/6 of the sums of d^3 and d^2
      },
      sizes);
  smoothing.apply(sizes);
}

similitude_gas_step gas_step(const ExchangeFields& exchange, GasFields& gas, double time, double dt) {
  similitude_gas_step step{};
  step.struct_size = sizeof(step);
  step.time = time;
  step.dt = dt;
  step.gas_fraction = exchange.gas_fraction.data();
  step.gas_fraction_old = exchange.gas_fraction_old.data();
  step.exchange = exchange.exchange.data();
  step.exchange_velocity = exchange.exchange_velocity.data();
  step.remainder = exchange.remainder.data();
  step.velocity = gas.velocity.data();
  step.pressure = gas.pressure.data();
  step.stress_force = gas.stress_force.data();
  step.added_viscosity = gas.added_viscosity.empty() ? nullptr : gas.added_viscosity.data();
  for (std::size_t axis = 0; axis < 3; ++axis) step.flux[axis] = gas.flux[axis].empty() ? nullptr : gas.flux[axis].data();
  return step;
}

Coupling::Coupling(const ModelScene& scene, const Grid& grid, const DragModel& drag, bool coupled, DragForm form)
    : parts_(std::make_unique<Parts>(scene, grid, drag, coupled, form)) {
  const std::size_t cells = grid.cell_count();
  fields_.gas_fraction.assign(cells, 1.0);
  fields_.gas_fraction_old.assign(cells, 1.0);
  fields_.exchange.assign(cells, 0.0);
  fields_.exchange_velocity.assign(3 * cells, 0.0);
  fields_.remainder.assign(3 * cells, 0.0);
}

Coupling::~Coupling() = default;

void Coupling::start(const ParticleStore& particles) {
  parts_->gas_is_seen = false;
  if (parts_->coupled) {
    parts_->deposit_solids(particles, fields_.gas_fraction);
    fields_.gas_fraction_old = fields_.gas_fraction;
  }
  parts_->pending = {};
  parts_->accounts_opened = particles.size();
  parts_->accounts_left = 0;
}

void Coupling::deposit(ParticleStore& particles, const GasFields& gas, double dt) {
  Parts& parts = *parts_;
  const std::size_t cells = parts.map.cell_count();
  if (parts.coupled) {
    fields_.gas_fraction_old.swap(fields_.gas_fraction);
    parts.deposit_solids(particles, fields_.gas_fraction);
    write_columns(parts.solids, 1 / (parts.map.cell_volume() * dt), fields_.remainder);
    parts.deposit_sizes(particles);
  } else if (parts.drag.needs_sauter_diameter()) {
    parts.deposit.sort(particles.position);
    parts.deposit_sizes(particles);
  }

  parts.see(gas);
  // The gas fraction is smooth already, so particles see it through the tent alone.
#pragma omp parallel for schedule(static) if (signed_size(cells) >= k_worth_threads)
  for (std::ptrdiff_t i = 0; i < signed_size(cells); ++i) {
    const auto c = static_cast<std::size_t>(i);
    parts.at_cells[c].w = fields_.gas_fraction[c];
  }
  parts.gas_is_seen = false;   // overwritten below, and the gas step to come changes it
  parts.drag.evaluate(particles, parts.at_cells, parts.sizes);
  if (!parts.coupled) return;

  parts.deposit.spread(
      particles.position,
      [&](std::size_t p) {
        const double k = particles.gas[p].w;
        const Row& v = particles.velocity[p];
        return Row{k * v.x, k * v.y, k * v.z, k};
      },
      parts.at_cells);
  parts.smoothing.apply(parts.at_cells);
  const double per_volume = 1 / parts.map.cell_volume();
  write_columns(parts.at_cells, per_volume, fields_.exchange_velocity);
#pragma omp parallel for schedule(static) if (signed_size(cells) >= k_worth_threads)
  for (std::ptrdiff_t i = 0; i < signed_size(cells); ++i) {
    const auto c = static_cast<std::size_t>(i);
    fields_.exchange[c] = per_volume * parts.at_cells[c].w;
  }
}

void Coupling::interpolate(ParticleStore& particles, const GasFields& gas, double dt) {
  Parts& parts = *parts_;
  parts.gas_is_seen = false;
  parts.see(gas);
  CellRows& stress = parts.solids;   // free between two deposits
  read_columns(gas.stress_force, stress);
  parts.smoothing.apply(stress);
  const CellRows& velocity = parts.at_cells;
  const auto& g = parts.gravity;

  const auto received_less_charged = parts.sum.after(particles.drag_impulse, [&](std::size_t p) {
    const Stencil stencil = parts.map.stencil(particles.position[p]);
    const Row u = gather(stencil, velocity);
    const Row force = gather(stencil, stress);
    const double displaced = parts.drag.displaced_volume(particles, p);
    const double k = particles.gas[p].w;
    const Row& v = particles.velocity[p];
    particles.gas[p] = {u.x, u.y, u.z, k};
    particles.stress_force[p] = {displaced * (force.x - parts.gas_density * g[0]),
                                 displaced * (force.y - parts.gas_density * g[1]),
                                 displaced * (force.z - parts.gas_density * g[2]), 0};
    const double charge = parts.coupled ? -k * dt : 0;
    particles.drag_impulse[p] = {charge * (u.x - v.x), charge * (u.y - v.y), charge * (u.z - v.z), 0};
  });
  parts.accounts_opened = particles.size();
  if (parts.coupled) parts.owe(received_less_charged);
}

void Coupling::settle_accounts(const ParticleStore& particles) {
  if (!parts_->coupled) return;
  parts_->owe(parts_->sum(particles.drag_impulse));
  parts_->accounts_left += parts_->accounts_opened - particles.size();
  parts_->accounts_opened = particles.size();
}

void Coupling::save(CouplingState& state) const {
  state.fields = fields_;
  state.pending = parts_->pending;
  state.accounts_opened = parts_->accounts_opened;
  state.accounts_left = parts_->accounts_left;
}

void Coupling::restore(const CouplingState& state) {
  fields_ = state.fields;
  parts_->gas_is_seen = false;
  parts_->pending = state.pending;
  parts_->accounts_opened = static_cast<std::size_t>(state.accounts_opened);
  parts_->accounts_left = state.accounts_left;
}

std::array<double, 3> Coupling::pending_momentum() const { return parts_->pending; }

std::uint64_t Coupling::accounts_left() const { return parts_->accounts_left; }

double Coupling::smallest_gas_fraction(std::size_t* cell) const {
  const auto smallest = std::min_element(fields_.gas_fraction.begin(), fields_.gas_fraction.end());
  if (cell) *cell = static_cast<std::size_t>(smallest - fields_.gas_fraction.begin());
  return *smallest;
}

double Coupling::smoothing_length() const { return parts_->length; }

int Coupling::smoothing_steps() const { return parts_->smoothing.steps(); }

}  // namespace similitude
