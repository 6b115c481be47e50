#include "coupling/scalar_exchange.h"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "coupling/block_failure.h"
#include "coupling/cell_map.h"
#include "coupling/deposit.h"
#include "coupling/seen_by_gas.h"
#include "coupling/smoothing.h"
#include "fluid/scalar_transport.h"

namespace similitude {
namespace {

constexpr std::size_t k_block_rows = 256;
static_assert(k_block_rows % SIMILITUDE_ROW_MULTIPLE == 0);

std::ptrdiff_t signed_size(std::size_t n) { return static_cast<std::ptrdiff_t>(n); }

/// Gas scalars travel through smoothing four to a row, or two with their coefficients.
constexpr std::size_t k_values_to_a_row = 4, k_pairs_to_a_row = 2;

double& part_of(Row& row, std::size_t part) { return part == 0 ? row.x : part == 1 ? row.y : part == 2 ? row.z : row.w; }
double part_of(const Row& row, std::size_t part) { return part == 0 ? row.x : part == 1 ? row.y : part == 2 ? row.z : row.w; }

/// Rows of one effect's pass, a thread's own.
struct Workspace {
  enum : std::size_t { diameter, mass, fraction, slip, density, viscosity, fixed };
  Column<double> columns;

  explicit Workspace(std::size_t quantities) : columns((fixed + 4 * quantities) * k_block_rows) {}
  double* column(std::size_t which) { return columns.data() + which * k_block_rows; }
  double* value(std::size_t quantity) { return column(fixed + 4 * quantity); }
  double* coefficient(std::size_t quantity) { return column(fixed + 4 * quantity + 1); }
  double* level(std::size_t quantity) { return column(fixed + 4 * quantity + 2); }
  double* received(std::size_t quantity) { return column(fixed + 4 * quantity + 3); }
};

/// What one effect asked of the gas for every particle, kept between exchange() and take().
struct Asked {
  std::vector<Column<double>> coefficient, level;   // by quantity; empty but for gas scalars
};

}  // namespace

struct ScalarExchange::Parts {
  Parts(const ModelScene& bed, const Grid& grid, const ScalarPlan& what, bool is_coupled)
      : scene(bed), plan(what), coupled(is_coupled), map(grid), smoothing(map, is_coupled ? smoothing_length_of(bed) : 0), deposit(map),
        transport(grid.table()), rows(map.cell_count()), totals(what.gas.size()), patch_value(what.gas.size()) {
    const std::size_t cells = map.cell_count();
    const auto rows_of = [&](std::size_t per_row) { return (plan.gas.size() + per_row - 1) / per_row; };
    at_cells.assign(rows_of(k_values_to_a_row), CellRows(cells));
    rate.assign(plan.gas.size(), Column<double>(cells));
    source = rate;
    mean = rate;
    diffusivity.resize(cells);
    for (std::size_t s = 0; s < plan.gas.size(); ++s) {
      const similitude_grid& table = grid.table();
      for (std::uint32_t p = 0; p < table.patch_count; ++p) {
        const auto named = std::find_if(scene.patches.begin(), scene.patches.end(),
                                        [&](const Patch& patch) { return patch.name == table.patches[p].name; });
        patch_value[s].push_back(plan.gas[s].patch_value[static_cast<std::size_t>(named - scene.patches.begin())]);
      }
    }
    asked.resize(plan.effects.size());
    for (std::size_t e = 0; e < plan.effects.size(); ++e) {
      asked[e].coefficient.resize(plan.effects[e].kind.size());
      asked[e].level.resize(plan.effects[e].kind.size());
    }
    std::size_t most = 0;
    for (const EffectQuantities& effect : plan.effects) most = std::max(most, effect.kind.size());
    for (int t = 0; t < omp_get_max_threads(); ++t) workspaces.emplace_back(most);
  }

  enum class Phase { exchange, take };

  static bool is_gas(const EffectQuantities& effect, std::size_t q) {
    return effect.kind[q] == SIMILITUDE_GAS_SCALAR && effect.slot[q] >= 0;
  }
  double at_particle(const ParticleStore& particles, std::size_t p, std::size_t scalar) const {
    return part_of(gather(map.stencil(particles.position[p]), at_cells[scalar / k_values_to_a_row]), scalar % k_values_to_a_row);
  }

  void spread_to_particles(const std::vector<const double*>& fields);
  void pass(Phase phase, std::size_t effect, ParticleStore& particles, const Column<double>& gas_fraction, double dt);
  void block(Phase phase, std::size_t effect, std::size_t first, std::size_t count, ParticleStore& particles, double dt,
             Workspace& work, similitude_status& status);
  void collect(const ParticleStore& particles);
  void carry(GasFields& gas, const ExchangeFields& fields, double dt);

  const ModelScene& scene;
  const ScalarPlan& plan;
  bool coupled;
  CellMap map;
  Smoothing smoothing;
  Deposit deposit;
  ScalarTransport transport;
  std::vector<CellRows> at_cells;           // gas scalars as particles see them
  CellRows rows;                            // scratch; w: gas fraction while particles look at it
  std::vector<Column<double>> rate, source, mean;   // by gas scalar: a [1/s], b [unit/s], and what the exchange saw
  Column<double> diffusivity;               // [m^2/s], added by unresolved motion
  std::vector<Asked> asked;
  std::vector<const double*> seen;          // fields on their way to the particles
  std::vector<Workspace> workspaces;        // by thread
  std::vector<ScalarTotals> totals;
  std::vector<std::vector<double>> patch_value;   // by gas scalar, by patch of the grid
};

/// Smoothed and ready for at_particle(). The adjoint of collect().
void ScalarExchange::Parts::spread_to_particles(const std::vector<const double*>& fields) {
  for (std::size_t r = 0; r < at_cells.size(); ++r) {
    CellRows& to = at_cells[r];
    const std::size_t first = r * k_values_to_a_row, last = std::min(fields.size(), first + k_values_to_a_row);
    for (std::size_t c = 0; c < to.size(); ++c) {
      for (std::size_t s = first; s < last; ++s) part_of(to[c], s - first) = fields[s][c];
    }
    smoothing.apply(to);
  }
}

void ScalarExchange::Parts::block(Phase phase, std::size_t number, std::size_t first, std::size_t count, ParticleStore& particles,
                                  double dt, Workspace& work, similitude_status& status) {
  const EffectQuantities& effect = plan.effects[number];
  const std::size_t quantities = effect.kind.size();
  const std::size_t padded = (count + SIMILITUDE_ROW_MULTIPLE - 1) / SIMILITUDE_ROW_MULTIPLE * SIMILITUDE_ROW_MULTIPLE;
  std::array<const double*, SIMILITUDE_MAX_QUANTITIES> value{}, received{};
  std::array<double*, SIMILITUDE_MAX_QUANTITIES> particle{}, coefficient{}, level{};

  for (std::size_t n = 0; n < padded; ++n) {
    const std::size_t p = first + std::min(n, count - 1);   // padding repeats the last particle
    const ParticleClass& type = scene.particles[particles.species[p]];
    const Row &v = particles.velocity[p], &u = particles.gas[p];
    work.column(Workspace::diameter)[n] = drag_diameter(type, particles, p);
    work.column(Workspace::mass)[n] = physical_mass(type, particles, p);
    work.column(Workspace::fraction)[n] = gather(map.stencil(particles.position[p]), rows).w;
    work.column(Workspace::slip)[n] = std::sqrt((u.x - v.x) * (u.x - v.x) + (u.y - v.y) * (u.y - v.y) + (u.z - v.z) * (u.z - v.z));
    work.column(Workspace::density)[n] = scene.gas_density;
    work.column(Workspace::viscosity)[n] = scene.gas_viscosity;
  }
  for (std::size_t q = 0; q < quantities; ++q) {
    const auto slot = static_cast<std::size_t>(effect.slot[q]);
    const auto fill = [&](double* to, auto&& of_row) {
      for (std::size_t n = 0; n < padded; ++n) to[n] = of_row(first + std::min(n, count - 1));
    };
    if (is_gas(effect, q)) {
      fill(work.value(q), [&](std::size_t p) { return at_particle(particles, p, slot); });
      value[q] = work.value(q);
      coefficient[q] = work.coefficient(q);
      level[q] = work.level(q);
      if (phase == Phase::exchange) {
        fill(work.coefficient(q), [](std::size_t) { return 0.0; });
        fill(work.level(q), [](std::size_t) { return 0.0; });
      } else {
        const Column<double>&c = asked[number].coefficient[q], &l = asked[number].level[q];
        fill(work.coefficient(q), [&](std::size_t p) { return c[p]; });
        fill(work.level(q), [&](std::size_t p) { return l[p]; });
        for (std::size_t n = 0; n < padded; ++n) {
          work.received(q)[n] = work.coefficient(q)[n] * (work.value(q)[n] - work.level(q)[n]) * dt;
        }
        received[q] = work.received(q);
      }
    } else if (effect.kind[q] == SIMILITUDE_PARTICLE_SCALAR && effect.slot[q] >= 0) {
      fill(work.value(q), [&](std::size_t p) { return particles.scalars[slot].value[p]; });
      particle[q] = work.value(q);
    } else if (!effect.by_class[q].empty()) {
      fill(work.value(q), [&](std::size_t p) { return effect.by_class[q][particles.species[p]]; });
      value[q] = work.value(q);
    }
  }

  const similitude_scalar_block view{.struct_size = sizeof(similitude_scalar_block),
                                     .rows = static_cast<std::uint32_t>(padded),
                                     .dt = dt,
                                     .diameter = work.column(Workspace::diameter),
                                     .mass = work.column(Workspace::mass),
                                     .gas_fraction = work.column(Workspace::fraction),
                                     .slip_speed = work.column(Workspace::slip),
                                     .gas_density = work.column(Workspace::density),
                                     .gas_viscosity = work.column(Workspace::viscosity),
                                     .value = value.data(),
                                     .particle = particle.data(),
                                     .coefficient = coefficient.data(),
                                     .level = level.data(),
                                     .received = received.data()};
  const auto& functions = effect.effect->functions();
  (phase == Phase::exchange ? functions.exchange : functions.take)(effect.effect->instance(), &view, &status);
  if (status.code != 0) return;

  for (std::size_t q = 0; q < quantities; ++q) {
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t p = first + n;
      if (phase == Phase::exchange && is_gas(effect, q)) {
        asked[number].coefficient[q][p] = work.coefficient(q)[n];
        asked[number].level[q][p] = work.level(q)[n];
      }
      if (phase == Phase::take && particle[q] != nullptr) {
        particles.scalars[static_cast<std::size_t>(effect.slot[q])].value[p] = work.value(q)[n];
      }
    }
  }
}

void ScalarExchange::Parts::pass(Phase phase, std::size_t number, ParticleStore& particles, const Column<double>& gas_fraction, double dt) {
  const EffectQuantities& effect = plan.effects[number];
  const auto& functions = effect.effect->functions();
  if ((phase == Phase::exchange ? functions.exchange : functions.take) == nullptr) return;
  for (std::size_t c = 0; c < rows.size(); ++c) rows[c].w = gas_fraction[c];
  if (phase == Phase::exchange) {
    for (std::size_t q = 0; q < effect.kind.size(); ++q) {
      if (!is_gas(effect, q)) continue;
      asked[number].coefficient[q].resize(particles.size());
      asked[number].level[q].resize(particles.size());
    }
  }
  const std::size_t blocks = (particles.size() + k_block_rows - 1) / k_block_rows;
  BlockFailure failure;
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t b = 0; b < signed_size(blocks); ++b) {
    const auto first = static_cast<std::size_t>(b) * k_block_rows;
    similitude_status status{};
    block(phase, number, first, std::min(k_block_rows, particles.size() - first), particles, dt,
          workspaces[static_cast<std::size_t>(omp_get_thread_num())], status);
    failure.tell(static_cast<std::size_t>(b), status);
  }
  if (failure) throw_failure(*effect.effect, failure.status());
}

/// a and b of every gas scalar, from what the effects asked for.
void ScalarExchange::Parts::collect(const ParticleStore& particles) {
  deposit.sort(particles.position);
  for (std::size_t first = 0; first < plan.gas.size(); first += k_pairs_to_a_row) {
    const std::size_t last = std::min(plan.gas.size(), first + k_pairs_to_a_row);
    deposit.spread(
        particles.position,
        [&](std::size_t p) {
          Row row;
          for (std::size_t e = 0; e < plan.effects.size(); ++e) {
            const EffectQuantities& effect = plan.effects[e];
            for (std::size_t q = 0; q < effect.kind.size(); ++q) {
              if (asked[e].coefficient[q].empty()) continue;
              const auto slot = static_cast<std::size_t>(effect.slot[q]);
              if (slot < first || slot >= last) continue;
              const double c = scene.particles[particles.species[p]].weight * asked[e].coefficient[q][p];
              part_of(row, 2 * (slot - first)) += c;
              part_of(row, 2 * (slot - first) + 1) += c * asked[e].level[q][p];
            }
          }
          return row;
        },
        rows);
    smoothing.apply(rows);
    for (std::size_t s = first; s < last; ++s) {
      const double per_content = 1 / (scene.gas_density * plan.gas[s].capacity * map.cell_volume());
      for (std::size_t c = 0; c < rows.size(); ++c) {
        rate[s][c] = per_content * part_of(rows[c], 2 * (s - first));
        source[s][c] = per_content * part_of(rows[c], 2 * (s - first) + 1);
      }
    }
  }
}

void ScalarExchange::Parts::carry(GasFields& gas, const ExchangeFields& fields, double dt) {
  const ScalarStep step{.dt = dt,
                        .gas_fraction = fields.gas_fraction.data(),
                        .gas_fraction_old = fields.gas_fraction_old.data(),
                        .flux = {gas.flux[0].data(), gas.flux[1].data(), gas.flux[2].data()}};
  for (std::size_t s = 0; s < plan.gas.size(); ++s) {
    const GasScalar& scalar = plan.gas[s];
    const bool mixes = !gas.added_viscosity.empty() && scalar.turbulent_number > 0;
    if (mixes) {
      const double per = 1 / (scene.gas_density * scalar.turbulent_number);
      for (std::size_t c = 0; c < diffusivity.size(); ++c) diffusivity[c] = per * gas.added_viscosity[c];
    }
    const ScalarTerms terms{.diffusivity = scalar.diffusivity,
                            .added_diffusivity = mixes ? diffusivity.data() : nullptr,
                            .reference = scalar.initial,
                            .wall = scalar.wall,
                            .patch_value = patch_value[s].data(),
                            .exchange = rate[s].data(),
                            .exchange_source = source[s].data()};
    const ScalarBudget budget = transport.advance(step, terms, gas.scalars[s].value.data(), mean[s].data());
    const double amount = scene.gas_density * scalar.capacity;
    totals[s].in += amount * budget.in;
    totals[s].out += amount * budget.out;
    totals[s].walls += amount * budget.walls;
    totals[s].exchanged += amount * budget.exchanged;
  }
}

ScalarExchange::ScalarExchange(const ModelScene& scene, const Grid& grid, const ScalarPlan& plan, bool coupled)
    : parts_(std::make_unique<Parts>(scene, grid, plan, coupled)) {}
ScalarExchange::~ScalarExchange() = default;

void ScalarExchange::start(ParticleStore& particles, GasFields& gas, const Column<double>& gas_fraction) {
  const ScalarPlan& plan = parts_->plan;
  particles.scalars.clear();
  for (const ParticleScalar& scalar : plan.particles) {
    NamedColumn column{scalar.name, scalar.unit, Column<double>(particles.size())};
    for (std::size_t p = 0; p < particles.size(); ++p) column.value[p] = scalar.initial[particles.species[p]];
    particles.scalars.push_back(std::move(column));
  }
  gas.scalars.clear();
  for (const GasScalar& scalar : plan.gas) {
    gas.scalars.push_back({scalar.name, scalar.unit, Column<double>(parts_->map.cell_count(), scalar.initial)});
  }
  for (std::size_t s = 0; s < plan.gas.size(); ++s) parts_->totals[s] = {.at_start = gas_amount(s, gas, gas_fraction)};
}

void ScalarExchange::advance(ParticleStore& particles, GasFields& gas, const ExchangeFields& fields, double dt) {
  Parts& parts = *parts_;
  std::vector<const double*>& seen = parts.seen;
  seen.clear();
  for (const NamedColumn& scalar : gas.scalars) seen.push_back(scalar.value.data());
  parts.spread_to_particles(seen);
  for (std::size_t e = 0; e < parts.plan.effects.size(); ++e) parts.pass(Parts::Phase::exchange, e, particles, fields.gas_fraction, dt);
  if (parts.coupled && !parts.plan.gas.empty()) {
    parts.collect(particles);
    parts.carry(gas, fields, dt);
    seen.clear();
    for (const Column<double>& mean : parts.mean) seen.push_back(mean.data());
    parts.spread_to_particles(seen);
  }
  for (std::size_t e = 0; e < parts.plan.effects.size(); ++e) parts.pass(Parts::Phase::take, e, particles, fields.gas_fraction, dt);
}

const std::vector<ScalarTotals>& ScalarExchange::totals() const { return parts_->totals; }
void ScalarExchange::set_totals(const std::vector<ScalarTotals>& totals) { parts_->totals = totals; }

double ScalarExchange::gas_amount(std::size_t scalar, const GasFields& gas, const Column<double>& gas_fraction) const {
  const GasScalar& what = parts_->plan.gas[scalar];
  return parts_->scene.gas_density * what.capacity *
         parts_->transport.amount(gas_fraction.data(), gas.scalars[scalar].value.data(), what.initial);
}

double ScalarExchange::particle_amount(std::size_t scalar, const ParticleStore& particles) const {
  const ParticleScalar& what = parts_->plan.particles[scalar];
  double sum = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::uint32_t type = particles.species[p];
    sum += particles.velocity[p].w * what.capacity[type] * (particles.scalars[scalar].value[p] - what.initial[type]);
  }
  return sum;
}

}  // namespace similitude
