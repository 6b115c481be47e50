#include "output/checkpoint_file.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "loader/json_text.h"
#include "output/whole_file.h"

namespace similitude {
namespace {

using Json = nlohmann::ordered_json;
using Type = Hdf5Column::Type;

template <class Number>
constexpr Type type_of() {
  if constexpr (std::is_same_v<Number, double>) return Type::f64;
  if constexpr (std::is_same_v<Number, std::uint64_t>) return Type::u64;
  if constexpr (std::is_same_v<Number, std::uint32_t>) return Type::u32;
  if constexpr (std::is_same_v<Number, std::uint8_t>) return Type::u8;
}

// What is in a file stands once, in the functions transfer_… below. They go through it with one of these two, which write
// or fill what they are shown.

class Into {
 public:
  explicit Into(Hdf5Writer& file) : file_(file) {}

  void group(const std::string& path) { file_.group(path); }
  void rows(const std::string& path, const Column<Row>& rows, const char* columns) {
    file_.dataset(path, rows.data(), {Type::f64, rows.size(), 4}, columns);
  }
  template <class Numbers>
  void column(const std::string& path, const Numbers& numbers, const char* columns) {
    file_.dataset(path, numbers.data(), {type_of<typename Numbers::value_type>(), numbers.size(), 1}, columns);
  }
  template <class Number>
  void value(const std::string& group, const char* name, const Number& number) {
    if constexpr (std::is_same_v<Number, std::int64_t> || std::is_same_v<Number, bool> || std::is_same_v<Number, std::int32_t>) {
      const auto whole = static_cast<std::uint64_t>(number);
      file_.attribute(group, name, &whole, {Type::u64, 1, 1});
    } else {
      file_.attribute(group, name, &number, {type_of<Number>(), 1, 1});
    }
  }
  void vector(const std::string& group, const char* name, const double* xyz) { file_.attribute(group, name, xyz, {Type::f64, 3, 1}); }

 private:
  Hdf5Writer& file_;
};

class OutOf {
 public:
  explicit OutOf(Hdf5Reader& file) : file_(file) {}

  void group(const std::string&) {}
  void rows(const std::string& path, Column<Row>& rows, const char*) {
    rows.resize(file_.rows(path));
    file_.dataset(path, rows.data(), {Type::f64, rows.size(), 4});
  }
  template <class Numbers>
  void column(const std::string& path, Numbers& numbers, const char*) {
    numbers.resize(file_.rows(path));
    file_.dataset(path, numbers.data(), {type_of<typename Numbers::value_type>(), numbers.size(), 1});
  }
  template <class Number>
  void value(const std::string& group, const char* name, Number& number) {
    if constexpr (std::is_same_v<Number, std::int64_t> || std::is_same_v<Number, bool> || std::is_same_v<Number, std::int32_t>) {
      std::uint64_t whole = 0;
      file_.attribute(group, name, &whole, {Type::u64, 1, 1});
      number = static_cast<Number>(whole);
    } else {
      file_.attribute(group, name, &number, {type_of<Number>(), 1, 1});
    }
  }
  void vector(const std::string& group, const char* name, double* xyz) { file_.attribute(group, name, xyz, {Type::f64, 3, 1}); }

 private:
  Hdf5Reader& file_;
};

/// Columns that effects declared, by their names.
template <class File, class Scalars>
void transfer_scalars(File& file, const std::string& at, Scalars& scalars) {
  auto count = static_cast<std::uint64_t>(scalars.size());
  file.value(at, "scalars", count);
  if constexpr (!std::is_const_v<Scalars>) scalars.resize(count);
  for (std::uint64_t s = 0; s < count; ++s) file.column(at + "/scalar_" + std::to_string(s), scalars[s].value, "in the order of the case's effects");
}

template <class File, class Store>
void transfer_particles(File& file, Store& store) {
  const std::string at = "/particles";
  file.group(at);
  file.value(at, "rotation", store.fields.rotation);
  file.value(at, "coupling", store.fields.coupling);
  transfer_scalars(file, at, store.scalars);
  file.column(at + "/id", store.id, "id");
  file.column(at + "/species", store.species, "index of the class in the case");
  file.rows(at + "/position", store.position, "x [m], y [m], z [m], radius [m]");
  file.rows(at + "/velocity", store.velocity, "x [m/s], y [m/s], z [m/s], mass [kg]");
  file.rows(at + "/force", store.force, "x [N], y [N], z [N], 0");
  if (store.fields.rotation) {
    file.rows(at + "/angular_velocity", store.angular_velocity, "x [rad/s], y [rad/s], z [rad/s], moment of inertia [kg m^2]");
    file.rows(at + "/torque", store.torque, "x [N m], y [N m], z [N m], 0");
  }
  if (store.fields.coupling) {
    file.rows(at + "/gas", store.gas, "x [m/s], y [m/s], z [m/s] of the gas there, exchange coefficient [kg/s]");
    file.rows(at + "/stress_force", store.stress_force, "x [N], y [N], z [N], 0");
    file.rows(at + "/drag_impulse", store.drag_impulse, "x [N s], y [N s], z [N s], 0");
  }
}

template <class File, class Budget>
void transfer_budget(File& file, Budget& budget) {
  const std::string at = "/engine/budget";
  file.group(at);
  file.vector(at, "gravity_impulse [N s]", budget.gravity_impulse.data());
  file.vector(at, "drag_impulse [N s]", budget.drag_impulse.data());
  file.vector(at, "stress_impulse [N s]", budget.stress_impulse.data());
  file.vector(at, "wall_impulse [N s]", budget.wall_impulse.data());
  file.vector(at, "removed_momentum [N s]", budget.removed_momentum.data());
  file.value(at, "gravity_work [J]", budget.gravity_work);
  file.value(at, "drag_work [J]", budget.drag_work);
  file.value(at, "stress_work [J]", budget.stress_work);
  file.value(at, "contact_work [J]", budget.contact_work);
  file.value(at, "removed_energy [J]", budget.removed_energy);
}

template <class File, class Report>
void transfer_report(File& file, Report& report) {
  const std::string at = "/engine/report";
  file.group(at);
  file.value(at, "particle_steps", report.particle_steps);
  file.value(at, "rebuilds", report.rebuilds);
  file.value(at, "removed", report.removed);
  file.value(at, "removed_mass [kg]", report.removed_mass);
  file.value(at, "removed_volume [m^3]", report.removed_volume);
  file.value(at, "contacts", report.contacts);
  file.value(at, "largest_speed [m/s]", report.largest_speed);
  file.value(at, "largest_overlap [1]", report.largest_overlap.overlap_ratio);
  file.value(at, "largest_overlap_particle", report.largest_overlap.particle);
  file.value(at, "largest_overlap_partner", report.largest_overlap.partner);
  file.vector(at, "largest_overlap_place [m]", report.largest_overlap.place.data());
}

template <class File, class State>
void transfer_engine(File& file, State& engine) {
  const std::string at = "/engine";
  file.group(at);
  file.value(at, "listed", engine.listed);
  file.value(at, "stale", engine.stale);
  file.value(at, "cut_off [m]", engine.cut_off);
  file.value(at, "reach [m]", engine.reach);
  file.value(at, "skin [m]", engine.skin);
  file.value(at, "skin_in_diameters [1]", engine.skin_in_diameters);
  file.value(at, "listed_at", engine.listed_at);
  file.value(at, "sub_steps", engine.steps);
  file.rows(at + "/listed_position", engine.reference, "x [m], y [m], z [m], radius [m]; when contact lists were built");
  file.column(at + "/contact_place", engine.touching.place, "number in the lists");
  file.column(at + "/contact_owner", engine.touching.owner, "row of /particles");
  file.column(at + "/contact_partner", engine.touching.partner, "row of /particles, or a wall + 2^31");
  file.rows(at + "/contact_history", engine.touching.history, "four values of the contact law to a row, filled up with zeros");
  transfer_report(file, engine.report);
  transfer_budget(file, engine.report.budget);
}

template <class File, class State>
void transfer_gas(File& file, State& state) {
  const std::string at = "/gas";
  file.group(at);
  file.column(at + "/velocity", state.gas.velocity, "[m/s], x of all cells, then y, then z");
  file.column(at + "/pressure", state.gas.pressure, "[Pa]");
  file.column(at + "/stress_force", state.gas.stress_force, "[N/m^3], x of all cells, then y, then z");
  transfer_scalars(file, at, state.gas.scalars);
  file.column(at + "/plugin", state.fluid, "as the fluid plugin orders them");
  file.value(at, "iterations", state.gas_report.iterations);
  file.value(at, "mass_residual [1]", state.gas_report.mass_residual);
  file.value(at, "inflow [kg/s]", state.gas_report.inflow);
  file.value(at, "outflow [kg/s]", state.gas_report.outflow);
  file.value(at, "courant [1]", state.gas_report.courant);
  file.vector(at, "momentum [kg m/s]", state.gas_report.momentum);
}

template <class File, class State>
void transfer_coupling(File& file, State& coupling) {
  const std::string at = "/coupling";
  file.group(at);
  file.column(at + "/gas_fraction", coupling.fields.gas_fraction, "[1]");
  file.column(at + "/gas_fraction_old", coupling.fields.gas_fraction_old, "[1], a gas step ago");
  file.column(at + "/exchange", coupling.fields.exchange, "[kg/(m^3 s)]");
  file.column(at + "/exchange_velocity", coupling.fields.exchange_velocity, "[kg/(m^2 s^2)], x of all cells, then y, then z");
  file.column(at + "/remainder", coupling.fields.remainder, "[N/m^3], x of all cells, then y, then z");
  file.vector(at, "pending [kg m/s]", coupling.pending.data());
  file.value(at, "accounts_opened", coupling.accounts_opened);
  file.value(at, "accounts_left", coupling.accounts_left);
}

template <class File, class State>
void transfer_accounts(File& file, State& accounts) {
  const std::string at = "/accounts";
  file.group(at);
  file.vector(at, "momentum_at_start [kg m/s]", accounts.momentum.data());
  file.value(at, "energy_at_start [J]", accounts.energy);
  file.value(at, "gas_mass_at_start [kg]", accounts.gas_mass);
  file.value(at, "gas_in [kg]", accounts.gas_in);
  file.value(at, "gas_out [kg]", accounts.gas_out);
  file.vector(at, "boundary_impulse [N s]", accounts.boundary_impulse.data());
  file.vector(at, "buoyancy [N s]", accounts.buoyancy.data());
  file.value(at, "pumping_work [J]", accounts.pumping_work);
}

/// at_start, in, out, walls, exchanged of every gas scalar, one after the other.
std::vector<double> flat(const std::vector<ScalarTotals>& totals) {
  std::vector<double> numbers;
  for (const ScalarTotals& t : totals) numbers.insert(numbers.end(), {t.at_start, t.in, t.out, t.walls, t.exchanged});
  return numbers;
}

void transfer_totals(Into& file, const SimulationState& state) {
  file.column("/scalar_totals", flat(state.scalar_totals), "at the start, in, out, from walls, from particles, of each gas scalar");
  file.column("/scalars_from_walls", state.scalars_from_walls, "of each particle scalar");
}

void transfer_totals(OutOf& file, SimulationState& state) {
  std::vector<double> numbers;
  file.column("/scalar_totals", numbers, "");
  state.scalar_totals.clear();
  for (std::size_t n = 0; n + 5 <= numbers.size(); n += 5) {
    state.scalar_totals.push_back({numbers[n], numbers[n + 1], numbers[n + 2], numbers[n + 3], numbers[n + 4]});
  }
  file.column("/scalars_from_walls", state.scalars_from_walls, "");
}

/// Averages of bins as plain columns: bins hold different numbers of blocks.
struct FlatBins {
  std::vector<std::uint64_t> seen, in_open, block_length, blocks;   // a value to a bin
  std::vector<double> weighted, weight;                             // bin by bin: total, open block, whole blocks
};

FlatBins flat(const std::vector<ProfileSampler::Bin>& bins) {
  FlatBins out;
  const auto add = [&out](const BlockAverage::Sums& sums) {
    out.weighted.push_back(sums.weighted);
    out.weight.push_back(sums.weight);
  };
  for (const ProfileSampler::Bin& bin : bins) {
    const BlockAverage::State& average = bin.average.state();
    out.seen.push_back(bin.n);
    out.in_open.push_back(average.in_open);
    out.block_length.push_back(average.block_length);
    out.blocks.push_back(average.blocks.size());
    add(average.total);
    add(average.open);
    for (const BlockAverage::Sums& block : average.blocks) add(block);
  }
  return out;
}

std::vector<ProfileSampler::Bin> bins_of(const FlatBins& flat) {
  std::vector<ProfileSampler::Bin> bins(flat.seen.size());
  std::size_t next = 0;
  const auto take = [&] {
    if (next >= flat.weighted.size() || next >= flat.weight.size()) throw Hdf5Error("/profiles");
    const BlockAverage::Sums sums{flat.weighted[next], flat.weight[next]};
    ++next;
    return sums;
  };
  if (flat.in_open.size() != bins.size() || flat.block_length.size() != bins.size() || flat.blocks.size() != bins.size()) {
    throw Hdf5Error("/profiles");
  }
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    BlockAverage::State average;
    average.in_open = flat.in_open[bin];
    average.block_length = flat.block_length[bin];
    average.total = take();
    average.open = take();
    for (std::uint64_t block = 0; block < flat.blocks[bin]; ++block) average.blocks.push_back(take());
    bins[bin].n = flat.seen[bin];
    bins[bin].average.restore(std::move(average));
  }
  return bins;
}

template <class File, class Bins>
void transfer_flat_bins(File& file, const std::string& at, Bins& bins) {
  file.group(at);
  file.column(at + "/seen", bins.seen, "of a bin: what was counted");
  file.column(at + "/in_open", bins.in_open, "of a bin: instants in the block that is being filled");
  file.column(at + "/block_length", bins.block_length, "of a bin: instants to a block");
  file.column(at + "/blocks", bins.blocks, "of a bin: whole blocks");
  file.column(at + "/weighted", bins.weighted, "bin by bin: sum of weight times value of all, of the open block, of each whole one");
  file.column(at + "/weight", bins.weight, "bin by bin: sum of weights of all, of the open block, of each whole one");
}

void transfer_bins(Into& file, const std::string& at, const std::vector<ProfileSampler::Bin>& bins) {
  const FlatBins all = flat(bins);
  transfer_flat_bins(file, at, all);
}

void transfer_bins(OutOf& file, const std::string& at, std::vector<ProfileSampler::Bin>& bins) {
  FlatBins all;
  transfer_flat_bins(file, at, all);
  bins = bins_of(all);
}

template <class File, class Window>
void transfer_window(File& file, const std::string& at, Window& window) {
  file.value(at, "from [s]", window.from);
  file.value(at, "to [s]", window.to);
  file.value(at, "instants", window.instants);
}

template <class File, class State>
void transfer_outputs(File& file, State& outputs) {
  const std::string at = "/outputs";
  file.group(at);
  file.column(at + "/particle_frames", outputs.frames.particles, "time of the real bed [s]");
  file.column(at + "/fluid_frames", outputs.frames.fluid, "time of the real bed [s]");
  file.value(at, "last_frame_time [s]", outputs.last_frame_time);
  file.value(at, "monitors_length [bytes]", outputs.monitors_length);
  file.value(at, "probes_length [bytes]", outputs.probes_length);
  file.value(at, "scalars_length [bytes]", outputs.scalars_length);
  file.value(at, "largest_overlap [1]", outputs.largest_overlap);
  file.value(at, "largest_overlap_of_run [1]", outputs.largest_overlap_of_run);
  file.group("/profiles");
  transfer_bins(file, "/profiles/solids", outputs.profiles.solids);
  transfer_bins(file, "/profiles/gas", outputs.profiles.gas);
  transfer_window(file, "/profiles/solids", outputs.profiles.solids_window);
  transfer_window(file, "/profiles/gas", outputs.profiles.gas_window);
}

template <class File, class State>
void transfer(File& file, State& state) {
  file.value("/", "gas_steps", state.simulation.steps_done);
  transfer_particles(file, state.simulation.particles);
  transfer_engine(file, state.simulation.engine);
  transfer_gas(file, state.simulation);
  transfer_coupling(file, state.simulation.coupling);
  transfer_accounts(file, state.simulation.accounts);
  transfer_totals(file, state.simulation);
  file.column("/warnings_given", state.simulation.warnings_given, "by the guards");
  transfer_outputs(file, state.outputs);
}

// ------------------------------------------------------------------------------------------------- what it belongs to

Json identity_json(const RunIdentity& run, const RunState& state) {
  Json out;
  out["program"] = run.program_version;
  out["started"] = run.started;
  out["particles"] = run.particles;
  out["solids_fraction"] = run.solids_fraction;
  out["height"] = run.height;
  out["dt"] = run.dt;
  out["sub_steps"] = run.sub_steps;
  out["plugins"] = Json::array();
  for (const ManifestPlugin& p : run.plugins) {
    out["plugins"].push_back({{"kind", p.kind}, {"id", p.id}, {"version", p.version}, {"file", p.file}, {"sha256", p.sha256}});
  }
  out["resumed"] = Json::array();
  for (const Resumption& r : run.resumed) {
    out["resumed"].push_back({{"checkpoint", r.checkpoint}, {"simulated_s", r.simulated_s}, {"started", r.started},
                              {"command", r.command}, {"threads", r.threads}});
  }
  out["wall_s"] = state.wall_s;
  out["stages"] = Json::array();
  for (const StageTime& stage : state.stages) out["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}});
  out["bed_sha256"] = run.bed_sha256;
  out["case"] = Json::parse(run.resolved_case);
  return out;
}

void read_identity(const std::string& text, RunIdentity& run, RunState& state) {
  const Json in = Json::parse(text);
  run.program_version = in.at("program");
  run.started = in.at("started");
  run.particles = in.at("particles");
  run.solids_fraction = in.at("solids_fraction");
  run.height = in.at("height");
  run.dt = in.at("dt");
  run.sub_steps = in.at("sub_steps");
  for (const Json& p : in.at("plugins")) run.plugins.push_back({p.at("kind"), p.at("id"), p.at("version"), p.at("file"), p.at("sha256")});
  for (const Json& r : in.at("resumed")) {
    run.resumed.push_back({r.at("checkpoint"), r.at("simulated_s"), r.at("started"), r.at("command"), r.at("threads")});
  }
  state.wall_s = in.at("wall_s");
  for (const Json& stage : in.at("stages")) state.stages.push_back({stage.at("name"), stage.at("seconds")});
  run.bed_sha256 = in.value("bed_sha256", "");   // older ones do not tell
  run.resolved_case = in.at("case").dump(2);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const RunIdentity& run, const RunState& state) {
  Hdf5Writer file;
  file.attribute("/", "format", &k_checkpoint_format, {Type::u64, 1, 1});
  file.text("/run", json_text(identity_json(run, state)));
  Into into(file);
  transfer(into, state);
  write_whole_file(path, file.bytes());
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  Checkpoint checkpoint;
  Hdf5Reader file(path);
  std::uint64_t format = 0;
  file.attribute("/", "format", &format, {Type::u64, 1, 1});
  if (format != k_checkpoint_format) {
    throw CheckpointFormatError("format " + std::to_string(format) + "; this program reads format " + std::to_string(k_checkpoint_format));
  }
  try {
    read_identity(file.text("/run"), checkpoint.run, checkpoint.state);
  } catch (const Json::exception&) {
    throw Hdf5Error("/run");
  }
  OutOf out_of(file);
  transfer(out_of, checkpoint.state);
  return checkpoint;
}

namespace {

constexpr const char* k_prefix = "checkpoint_";
constexpr const char* k_extension = ".h5";

}  // namespace

std::string checkpoint_name(std::int64_t steps_done) {
  std::array<char, 48> name{};
  std::snprintf(name.data(), name.size(), "%s%09" PRId64 "%s", k_prefix, steps_done, k_extension);
  return name.data();
}

std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(k_prefix) && entry.path().extension() == k_extension) found.push_back(entry.path());
  }
  // Nine digits hold ten thousand times a long run; beyond, a longer name is a later one.
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    const std::string x = a.filename().string(), y = b.filename().string();
    return x.size() != y.size() ? x.size() > y.size() : x > y;
  });
  return found;
}

}  // namespace similitude
