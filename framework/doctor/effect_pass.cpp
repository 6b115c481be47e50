#include "doctor/effect_pass.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <similitude/sphere.h>

#include "doctor/suites.h"
#include "doctor/trial_values.h"

namespace similitude::doctor {
namespace {

/// The columns of a block between the doctor and the effect.
class Columns {
 public:
  Columns(std::size_t rows, const PassOptions& options)
      : asked_(rows), rows_((rows + SIMILITUDE_ROW_MULTIPLE - 1) / SIMILITUDE_ROW_MULTIPLE * SIMILITUDE_ROW_MULTIPLE), options_(options) {
    columns_.reserve(k_most_columns);
  }

  std::uint32_t rows() const { return static_cast<std::uint32_t>(rows_); }

  /// Null if it was neither asked for nor is given all the same.
  const double* input(const std::string& name, const std::function<double(std::size_t)>& value, bool declared = true) {
    if (!declared && !options_.undeclared_too) return nullptr;
    GuardedColumn& column = columns_.emplace_back(name, rows_, options_.edge);
    for (std::size_t row = 0; row < rows_; ++row) column[row] = value(std::min(row, asked_ - 1)) * (declared ? 1 : options_.undeclared);
    if (options_.edge != Edge::far) column.forbid_writing();
    return column.data();
  }
  void input(const double* (&to)[3], const std::string& name, const std::function<Vec3<double>(std::size_t)>& value, bool declared = true) {
    const auto seen = [&](std::size_t row) { return options_.turned ? turned(value(row)) : value(row); };
    to[0] = input(name + "[0]", [&](std::size_t row) { return seen(row).x; }, declared);
    to[1] = input(name + "[1]", [&](std::size_t row) { return seen(row).y; }, declared);
    to[2] = input(name + "[2]", [&](std::size_t row) { return seen(row).z; }, declared);
  }
  /// A column that the effect adds to; `usual` is the size of what may be there before.
  double* output(const std::string& name, double usual, bool declared = true) {
    if (!declared && !options_.undeclared_too) return nullptr;
    return noted(name, [&](std::size_t) { return options_.already * usual; }, declared, true);
  }
  void output(double* (&to)[3], const std::string& name, double usual, bool declared = true) {
    for (std::size_t a = 0; a < 3; ++a) to[a] = output(name + "[" + std::to_string(a) + "]", usual, declared);
  }
  /// A column that the effect writes, and may read first.
  double* written(const std::string& name, const std::function<double(std::size_t)>& value) { return noted(name, value, true, false); }
  /// Memory, or another column that is not added to.
  double* kept(const std::string& name, const std::function<double(std::size_t)>& value) {
    GuardedColumn& column = columns_.emplace_back(name, rows_, options_.edge);
    for (std::size_t row = 0; row < rows_; ++row) column[row] = value(std::min(row, asked_ - 1));
    return column.data();
  }

  PassResult result() const {
    PassResult result;
    for (const Output& output : outputs_) {
      result.names.push_back(output.name);
      result.declared.push_back(output.declared);
      result.before.push_back(output.before);
      result.adds.push_back(output.adds);
      std::vector<double>& added = result.added.emplace_back();
      for (std::size_t row = 0; row < asked_; ++row) added.push_back((*output.column)[row] - output.before[row]);
    }
    return result;
  }

 private:
  static constexpr std::size_t k_most_columns = 160;
  struct Output {
    std::string name;
    bool declared, adds;
    std::vector<double> before;
    const GuardedColumn* column;   // columns_ never grows beyond what is reserved
  };

  double* noted(const std::string& name, const std::function<double(std::size_t)>& value, bool declared, bool adds) {
    double* const first = kept(name, value);
    outputs_.push_back({name, declared, adds, {first, first + asked_}, &columns_.back()});
    return first;
  }

  std::size_t asked_, rows_;
  PassOptions options_;
  std::vector<GuardedColumn> columns_;
  std::vector<Output> outputs_;
};

/// Numbers between -1 and 1 of a situation: the same for the same situation and purpose.
class Chance {
 public:
  Chance(std::size_t situation, unsigned purpose) : random_(static_cast<unsigned>(situation) * 64 + purpose) { random_.discard(8); }
  double any() { return 2.0 * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max()) - 1; }
  double share() { return 0.5 + 0.5 * any(); }
  Vec3<double> vector(double size) { return {size * any(), size * any(), size * any()}; }

 private:
  std::mt19937 random_;
};

enum Purpose : unsigned { k_velocity, k_gas_velocity, k_fraction, k_spin, k_vorticity, k_acceleration, k_normal, k_overlap, k_spin_j, k_radius, k_law, k_strain, k_quantity };

constexpr std::size_t k_walls_every = 7;   // of the contacts

double sphere_mass() {
  const similitude_bed bed = trial_bed();
  return bed.particle_density * sphere_volume(bed.particle_diameter);
}

void check(const similitude_status& status) {
  if (status.code != 0) throw Complaint(status);
}

double fraction_of(std::size_t s) { return s % 5 == 0 ? 1 : 0.4 + 0.6 * Chance(s, k_fraction).share(); }

PassResult run_particles(const EffectModel& effect, const std::vector<std::size_t>& situations, const PassOptions& options) {
  const similitude_bed bed = trial_bed();
  const similitude_effect_needs needs = needs_of(effect);
  Columns columns(situations.size(), options);
  similitude_particle_block block{};
  block.struct_size = sizeof block;
  block.rows = columns.rows();
  block.dt = 1e-4;
  const auto reads = [&](std::uint32_t what) { return (needs.reads & what) != 0; };
  const auto vector = [&](Purpose purpose, double size) {
    return [&situations, purpose, size](std::size_t row) { return Chance(situations[row], purpose).vector(situations[row] % 7 == 0 ? 0 : size); };
  };
  block.diameter = columns.input("diameter", [&](std::size_t) { return bed.particle_diameter; });
  block.mass = columns.input("mass", [&](std::size_t) { return sphere_mass(); });
  columns.input(block.velocity, "velocity", vector(k_velocity, 1));
  columns.input(block.gas_velocity, "gas_velocity", vector(k_gas_velocity, 5));
  block.gas_fraction = columns.input("gas_fraction", [&](std::size_t row) { return fraction_of(situations[row]); });
  block.gas_density = columns.input("gas_density", [&](std::size_t) { return bed.gas_density; });
  block.gas_viscosity = columns.input("gas_viscosity", [&](std::size_t) { return bed.gas_viscosity; });
  columns.input(block.angular_velocity, "angular_velocity", vector(k_spin, 100), reads(SIMILITUDE_READS_ANGULAR_VELOCITY));
  columns.input(block.gas_vorticity, "gas_vorticity", vector(k_vorticity, 200), reads(SIMILITUDE_READS_GAS_VORTICITY));
  columns.input(block.gas_acceleration, "gas_acceleration", vector(k_acceleration, 50), reads(SIMILITUDE_READS_GAS_ACCELERATION));
  const double weight = sphere_mass() * bed.gravity;
  columns.output(block.force, "force", weight);
  block.linear_coefficient = columns.output("linear_coefficient", weight);
  block.added_mass = columns.output("added_mass", sphere_mass(), (needs.adds & SIMILITUDE_ADDS_ADDED_MASS) != 0);
  similitude_status status{};
  effect.functions().particles(effect.instance(), &block, &status);
  check(status);
  return columns.result();
}

/// What `value_j` holds at a wall: the wall property of the same name, or not a number.
double wall_value(const similitude_effect_functions& functions, const std::vector<double>& usual, std::size_t q) {
  for (std::size_t w = 0; w < usual.size(); ++w)
    if (functions.quantities[w].kind == SIMILITUDE_WALL_PROPERTY && std::strcmp(functions.quantities[w].name, functions.quantities[q].name) == 0)
      return usual[w];
  return std::numeric_limits<double>::quiet_NaN();
}

/// For forces, or for flows of scalars.
PassResult run_contacts(const EffectModel& effect, const std::vector<std::size_t>& situations, const PassOptions& options, bool for_flows) {
  const similitude_bed bed = trial_bed();
  const similitude_effect_functions& functions = effect.functions();
  const similitude_effect_needs needs = needs_of(effect);
  const double radius = bed.particle_diameter / 2;
  const double reach = functions.reach != nullptr ? functions.reach(effect.instance(), bed.particle_diameter) : 0;
  const double sign = options.swapped ? -1 : 1;
  Columns columns(situations.size(), options);
  similitude_contact_effect_block block{};
  block.struct_size = sizeof block;
  block.rows = columns.rows();
  block.dt = 5e-6;
  const auto normal = [&](std::size_t row) {
    const Vec3<double> v = Chance(situations[row], k_normal).vector(1);
    return sign / std::sqrt(dot(v, v)) * v;
  };
  /// Every third contact is a gap within reach, unknown to the law.
  const auto overlap = [&](std::size_t row) {
    const double share = Chance(situations[row], k_overlap).share();
    return situations[row] % 3 == 0 ? -0.99 * share * reach : 0.02 * radius * share;
  };
  const auto vector = [&](Purpose purpose, double size) {
    return [&situations, purpose, size](std::size_t row) { return Chance(situations[row], purpose).vector(size); };
  };
  const auto radius_i = [&](std::size_t row) { return radius * (0.5 + Chance(situations[row], k_radius).share()); };
  const auto radius_j = [&](std::size_t row) { return is_wall(situations[row]) ? std::numeric_limits<double>::infinity() : radius; };
  const std::function<double(std::size_t)> radii[2] = {radius_i, radius_j};
  const Purpose spins[2] = {k_spin, k_spin_j};
  const int first = options.swapped ? 1 : 0;
  const bool rotation = (needs.reads & SIMILITUDE_READS_ANGULAR_VELOCITY) != 0;
  columns.input(block.normal, "normal", normal);
  block.overlap = columns.input("overlap", overlap);
  columns.input(block.velocity, "velocity", [&](std::size_t row) { return sign * Chance(situations[row], k_velocity).vector(0.3); });
  columns.input(block.angular_velocity_i, "angular_velocity_i", vector(spins[first], 100), rotation);
  columns.input(block.angular_velocity_j, "angular_velocity_j", vector(spins[1 - first], 100), rotation);
  block.radius_i = columns.input("radius_i", radii[first]);
  block.radius_j = columns.input("radius_j", radii[1 - first]);
  block.effective_mass = columns.input("effective_mass", [&](std::size_t) { return sphere_mass() / 2; });
  columns.input(block.law_force, "law_force", [&](std::size_t row) {
    const double depth = std::max(overlap(row), 0.0);
    const Vec3<double> along = 500 * depth * normal(row);   // [N], of a spring of 500 N/m
    return along + sign * Chance(situations[row], k_law).vector(20 * depth);
  });
  const std::vector<double> usual = quantity_values(functions);
  std::vector<const double*> value_i(usual.size(), nullptr), value_j(usual.size(), nullptr);
  std::vector<double*> flow(usual.size(), nullptr);
  for (std::size_t q = 0; q < usual.size(); ++q) {
    const similitude_quantity& quantity = functions.quantities[q];
    const bool of_particles = quantity.kind == SIMILITUDE_PARTICLE_SCALAR || quantity.kind == SIMILITUDE_PARTICLE_PROPERTY;
    if (!of_particles) continue;
    const auto value = [&, q](bool of_j) {
      return [&, q, of_j](std::size_t row) {
        const bool varies = functions.quantities[q].kind == SIMILITUDE_PARTICLE_SCALAR;
        Chance chance(situations[row], k_quantity + static_cast<unsigned>(q));
        const double i = chance.any(), j = chance.any();
        if (of_j && is_wall(situations[row])) return wall_value(functions, usual, q);
        return usual[q] * (varies ? 1 + 0.05 * (of_j ? j : i) : 1);
      };
    };
    value_i[q] = columns.input(std::string("value_i ") + quantity.name, value(options.swapped));
    value_j[q] = columns.input(std::string("value_j ") + quantity.name, value(!options.swapped));
    if (quantity.kind == SIMILITUDE_PARTICLE_SCALAR && for_flows) flow[q] = columns.written(std::string("flow ") + quantity.name, [](std::size_t) { return 0.0; });
  }
  block.value_i = usual.empty() ? nullptr : value_i.data();
  block.value_j = usual.empty() ? nullptr : value_j.data();
  if (for_flows) {
    block.flow = flow.data();
  } else {
    for (std::uint32_t h = 0; h < needs.history_count; ++h)
      block.history[h] = columns.kept("history[" + std::to_string(h) + "]", [](std::size_t) { return 0.0; });
    columns.output(block.force, "force", 1e-3);
    columns.output(block.couple, "couple", 1e-6, (needs.adds & SIMILITUDE_ADDS_COUPLE) != 0);
  }
  similitude_status status{};
  functions.contacts(effect.instance(), &block, &status);
  check(status);
  return columns.result();
}

/// Exchange of scalars with the gas, and what the particles take of it.
PassResult run_exchange(const EffectModel& effect, const std::vector<std::size_t>& situations, const PassOptions& options) {
  const similitude_bed bed = trial_bed();
  const similitude_effect_functions& functions = effect.functions();
  const std::vector<double> usual = quantity_values(functions);
  Columns columns(situations.size(), options);
  similitude_scalar_block block{};
  block.struct_size = sizeof block;
  block.rows = columns.rows();
  block.dt = 1e-4;
  block.diameter = columns.input("diameter", [&](std::size_t) { return bed.particle_diameter; });
  block.mass = columns.input("mass", [&](std::size_t) { return sphere_mass(); });
  block.gas_fraction = columns.input("gas_fraction", [&](std::size_t row) { return fraction_of(situations[row]); });
  block.slip_speed = columns.input("slip_speed", [&](std::size_t row) { return situations[row] % 5 == 0 ? 0 : 5 * Chance(situations[row], k_velocity).share(); });
  block.gas_density = columns.input("gas_density", [&](std::size_t) { return bed.gas_density; });
  block.gas_viscosity = columns.input("gas_viscosity", [&](std::size_t) { return bed.gas_viscosity; });
  std::vector<const double*> value(usual.size(), nullptr), received(usual.size(), nullptr);
  std::vector<double*> particle(usual.size(), nullptr), coefficient(usual.size(), nullptr), level(usual.size(), nullptr);
  for (std::size_t q = 0; q < usual.size(); ++q) {
    const int kind = functions.quantities[q].kind;
    const std::string name = functions.quantities[q].name;
    const auto varied = [&, q](std::size_t row) { return usual[q] * (1 - 0.05 * Chance(situations[row], k_quantity + static_cast<unsigned>(q)).share()); };
    if (kind == SIMILITUDE_GAS_SCALAR) {
      value[q] = columns.input("value " + name, varied);
      coefficient[q] = columns.written("coefficient " + name, [](std::size_t) { return 0.0; });
      level[q] = columns.written("level " + name, [](std::size_t) { return 0.0; });
      received[q] = columns.input("received " + name, [&, q](std::size_t) { return 1e-3 * usual[q] * sphere_mass(); });
    } else if (kind == SIMILITUDE_PARTICLE_PROPERTY) {
      value[q] = columns.input("value " + name, [&, q](std::size_t) { return usual[q]; });
    } else if (kind == SIMILITUDE_PARTICLE_SCALAR) {
      particle[q] = columns.written("particle " + name, varied);
    }
  }
  block.value = value.data();
  block.particle = particle.data();
  block.coefficient = coefficient.data();
  block.level = level.data();
  block.received = received.data();
  similitude_status status{};
  functions.exchange(effect.instance(), &block, &status);
  check(status);
  if (functions.take != nullptr) functions.take(effect.instance(), &block, &status);
  check(status);
  return columns.result();
}

PassResult run_cells(const EffectModel& effect, const std::vector<std::size_t>& situations, const PassOptions& options) {
  const similitude_bed bed = trial_bed();
  Columns columns(situations.size(), options);
  similitude_cell_block block{};
  block.struct_size = sizeof block;
  block.rows = columns.rows();
  block.gas_fraction = columns.input("gas_fraction", [&](std::size_t row) { return fraction_of(situations[row]); });
  block.gas_density = columns.input("gas_density", [&](std::size_t) { return bed.gas_density; });
  block.gas_viscosity = columns.input("gas_viscosity", [&](std::size_t) { return bed.gas_viscosity; });
  block.strain_rate = columns.input("strain_rate", [&](std::size_t row) { return situations[row] % 7 == 0 ? 0 : 500 * Chance(situations[row], k_strain).share(); });
  block.cell_size = columns.input("cell_size", [&](std::size_t) { return 5e-3; });
  block.added_viscosity = columns.output("added_viscosity", bed.gas_viscosity);
  similitude_status status{};
  effect.functions().cells(effect.instance(), &block, &status);
  check(status);
  return columns.result();
}

}  // namespace

bool is_wall(std::size_t situation) { return situation % k_walls_every == 0; }

/// By 0.7 about z, then a third of a turn about the diagonal.
Vec3<double> turned(const Vec3<double>& v) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  return {v.z, c * v.x - s * v.y, s * v.x + c * v.y};
}

std::vector<double> quantity_values(const similitude_effect_functions& functions) {
  std::vector<double> values;
  for (std::uint32_t q = 0; q < functions.quantity_count; ++q) {
    const similitude_quantity& quantity = functions.quantities[q];
    double value = quantity.default_value;
    if (std::isnan(value)) value = std::strcmp(quantity.unit, "K") == 0 ? 300 : 1;
    values.push_back(std::clamp(value, quantity.minimum, quantity.maximum));
  }
  return values;
}

similitude_effect_needs needs_of(const EffectModel& effect) {
  similitude_effect_needs needs{};
  needs.struct_size = sizeof needs;
  if (effect.functions().needs != nullptr) effect.functions().needs(effect.instance(), &needs);
  return needs;
}

EffectModel made_effect(const PluginEntry& plugin) {
  EffectModel effect = create_model<similitude_effect_functions>(plugin, trial_bed(), trial_values(*plugin.descriptor));
  const similitude_effect_functions& functions = effect.functions();
  if (functions.configure == nullptr) return effect;
  std::vector<double> properties = quantity_values(functions);
  for (std::uint32_t q = 0; q < functions.quantity_count; ++q) {
    const int kind = functions.quantities[q].kind;
    if (kind != SIMILITUDE_GAS_PROPERTY && kind != SIMILITUDE_WALL_PROPERTY) properties[q] = std::numeric_limits<double>::quiet_NaN();
  }
  std::vector<similitude_gas_scalar_law> laws(functions.quantity_count);
  for (similitude_gas_scalar_law& law : laws) law.struct_size = sizeof law;
  similitude_status status{};
  functions.configure(effect.instance(), properties.data(), laws.data(), &status);
  check(status);
  return effect;
}

std::vector<Pass> effect_passes() {
  const auto adds = [](const EffectModel& effect, std::uint32_t what) { return (needs_of(effect).adds & what) != 0; };
  const auto forces = [](const EffectModel& e, const std::vector<std::size_t>& rows, const PassOptions& options) { return run_contacts(e, rows, options, false); };
  const auto flows = [](const EffectModel& e, const std::vector<std::size_t>& rows, const PassOptions& options) { return run_contacts(e, rows, options, true); };
  return {{"particle pass", [](const EffectModel& e) { return e.functions().particles != nullptr; }, run_particles, false},
          {"contact pass", [adds](const EffectModel& e) { return e.functions().contacts != nullptr && !adds(e, SIMILITUDE_ADDS_FLOW_ALONE); }, forces, true},
          {"contact pass for flows", [adds](const EffectModel& e) { return e.functions().contacts != nullptr && adds(e, SIMILITUDE_ADDS_FLOW); }, flows, true},
          {"cell pass", [](const EffectModel& e) { return e.functions().cells != nullptr; }, run_cells, false},
          {"exchange of scalars", [](const EffectModel& e) { return e.functions().exchange != nullptr; }, run_exchange, false}};
}

}  // namespace similitude::doctor
