#include "output/checkpoint_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>
#include <type_traits>

#include "output/whole_file.h"
#include "scratch.h"

namespace similitude {
namespace {
using namespace test;

RunIdentity some_run() {
  RunIdentity run;
  run.program_version = "0.1.0";
  run.resolved_case = "{\n  \"title\": \"a bed\"\n}";
  run.bed_sha256 = "def";
  run.plugins = {{"drag", "gidaspow", "1.0.0", "/somewhere/drag_gidaspow.so", "abc"}};
  run.dt = 1.0 / 3;
  run.sub_steps = 27;
  run.particles = 4;
  run.solids_fraction = 0.6;
  run.height = 0.2;
  run.started = "2026-03-01T12:00:00Z";
  run.resumed = {{"checkpoints/checkpoint_000000007.h5", 0.25, "2026-03-02T12:00:00Z", "similitude run", 2}};
  return run;
}

/// Numbers of which no two are alike, so that none can stand in another's place unseen.
struct Numbers {
  double next = 0.1;
  double operator()() { return next += 1.0 / 3; }
  void fill(Column<Row>& rows, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) rows.push_back({(*this)(), (*this)(), (*this)(), (*this)()});
  }
  template <class List>
  void fill_numbers(List& list, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) list.push_back((*this)());
  }
  template <class List>
  void fill_whole(List& list, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) list.push_back(static_cast<typename List::value_type>(next += 1));
  }
  void fill(std::array<double, 3>& xyz) { xyz = {(*this)(), (*this)(), (*this)()}; }
};

/// `rows` large enough for some chunks, or 0.
RunState some_state(std::size_t rows, std::size_t contacts) {
  RunState state;
  Numbers some;
  SimulationState& s = state.simulation;
  s.steps_done = 1234;
  s.particles = ParticleStore({.rotation = true, .coupling = true});
  for (Column<Row>* column : {&s.particles.position, &s.particles.velocity, &s.particles.force, &s.particles.angular_velocity,
                              &s.particles.torque, &s.particles.gas, &s.particles.stress_force, &s.particles.drag_impulse,
                              &s.engine.reference}) {
    some.fill(*column, rows);
  }
  s.particles.scalars.resize(2);
  for (NamedColumn& scalar : s.particles.scalars) some.fill_numbers(scalar.value, rows);
  some.fill_whole(s.particles.id, rows);
  some.fill_whole(s.particles.species, rows);
  s.engine.listed = true;
  s.engine.stale = false;
  for (double* number : {&s.engine.cut_off, &s.engine.reach, &s.engine.skin, &s.engine.skin_in_diameters}) *number = some();
  s.engine.listed_at = 17;
  s.engine.steps = 99;
  for (auto* column : {&s.engine.touching.place, &s.engine.touching.owner, &s.engine.touching.partner}) some.fill_whole(*column, contacts);
  some.fill(s.engine.touching.history, contacts);
  EngineReport& report = s.engine.report;
  report.particle_steps = 1ull << 60;
  report.rebuilds = 3;
  report.removed = 4;
  report.removed_mass = some();
  report.removed_volume = some();
  report.contacts = 5;
  report.largest_overlap = {some(), 6, ~std::uint64_t{0}, {some(), some(), some()}};
  report.largest_speed = some();
  ParticleBudget& b = report.budget;
  for (auto* xyz : {&b.gravity_impulse, &b.drag_impulse, &b.stress_impulse, &b.wall_impulse, &b.removed_momentum}) some.fill(*xyz);
  for (double* work : {&b.gravity_work, &b.drag_work, &b.stress_work, &b.contact_work, &b.removed_energy}) *work = some();
  some.fill_numbers(s.gas.velocity, 24);
  some.fill_numbers(s.gas.pressure, 8);
  some.fill_numbers(s.gas.stress_force, 24);
  s.gas.scalars.resize(3);
  for (NamedColumn& scalar : s.gas.scalars) some.fill_numbers(scalar.value, 8);
  some.fill_numbers(s.fluid, 30);
  ExchangeFields& fields = s.coupling.fields;
  for (auto* column : {&fields.gas_fraction, &fields.gas_fraction_old, &fields.exchange}) some.fill_numbers(*column, 8);
  for (auto* column : {&fields.exchange_velocity, &fields.remainder}) some.fill_numbers(*column, 24);
  some.fill(s.coupling.pending);
  s.coupling.accounts_opened = 40;
  s.coupling.accounts_left = 41;
  s.gas_report.iterations = 12;
  for (double* number : {&s.gas_report.mass_residual, &s.gas_report.inflow, &s.gas_report.outflow, &s.gas_report.courant}) *number = some();
  for (double& number : s.gas_report.momentum) number = some();
  AccountsState& a = s.accounts;
  for (auto* xyz : {&a.momentum, &a.boundary_impulse, &a.buoyancy}) some.fill(*xyz);
  for (double* number : {&a.energy, &a.gas_mass, &a.gas_in, &a.gas_out, &a.pumping_work}) *number = some();
  for (int n = 0; n < 3; ++n) s.scalar_totals.push_back({some(), some(), some(), some(), some()});
  some.fill_numbers(s.scalars_from_walls, 2);
  s.warnings_given = {0, 1, 0};

  OutputsState& o = state.outputs;
  some.fill_numbers(o.frames.particles, 3);
  some.fill_numbers(o.frames.fluid, 2);
  for (double* number : {&o.last_frame_time, &o.largest_overlap, &o.largest_overlap_of_run}) *number = some();
  o.monitors_length = 4711;
  o.probes_length = 815;
  o.scalars_length = 1001;
  for (std::size_t bin = 0; bin < 3; ++bin) {   // 0, 7 and 45 instants: blocks in the making, and joined ones
    ProfileSampler::Bin made;
    for (std::size_t n = 0; n < bin * (bin * 16 - 9); ++n) made.average.add(some(), 1 + some());
    made.n = bin;
    o.profiles.solids.push_back(made);
  }
  o.profiles.gas = {o.profiles.solids[2]};
  o.profiles.solids_window = {some(), some(), 52};
  o.profiles.gas_window = {some(), some(), 53};
  state.wall_s = some();
  state.stages = {{"deposit", some()}, {"fluid: vans", some()}};
  return state;
}

void write_unsynced(const std::filesystem::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

/// All of it as bytes: a checkpoint's own file is the simplest way to compare two states.
std::string bytes_of(const ScratchFolder& folder, const RunIdentity& run, const RunState& state) {
  write_checkpoint(folder / "compared.h5", run, state);
  return text_of(folder / "compared.h5");
}

/// Every number of a state under the name of its field. Structured bindings take a struct apart: a field that is new does not
/// compile here until it is in the book, or is said to be made anew after a restart.
class Book {
 public:
  explicit Book(const RunState& state) {
    const auto& [simulation, outputs, wall_s, stages] = state;
    enter(simulation);
    enter(outputs);
    add("wall_s", wall_s);
    for (const auto& [name, seconds] : stages) add("stages", seconds);
  }

  const std::map<std::string, std::vector<long double>>& entries() const { return entries_; }

 private:
  /// A long double holds any double and any 64-bit number.
  template <class Value>
  static void append(std::vector<long double>& to, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
      to.push_back(static_cast<long double>(value));
    } else if constexpr (std::is_same_v<Value, Row>) {
      for (const double part : {value.x, value.y, value.z, value.w}) to.push_back(part);
    } else {
      for (const auto& part : value) append(to, part);
    }
  }
  template <class Value>
  void add(const std::string& name, const Value& value) { append(entries_[name], value); }

  void enter(const SimulationState& s) {
    const auto& [steps_done, particles, engine, gas, coupling, gas_report, fluid, accounts, totals, from_walls, warnings] = s;
    add("steps_done", steps_done);
    enter(particles);
    enter(engine);
    enter(gas);
    enter(coupling);
    enter(gas_report);
    add("fluid", fluid);
    enter(accounts);
    for (const auto& [at_start, in, out, walls, exchanged] : totals) {
      for (const double total : {at_start, in, out, walls, exchanged}) add("scalar_totals", total);
    }
    add("scalars_from_walls", from_walls);
    add("warnings_given", warnings);
  }

  /// The added mass is made anew in every gas step; scalars have their names from the case.
  void enter(const ParticleStore& particles) {
    const auto& [fields, position, velocity, force, angular_velocity, torque, gas, stress_force, drag_impulse, added_mass, scalars, id,
                 species] = particles;
    add("particles.rotation", fields.rotation);
    add("particles.coupling", fields.coupling);
    add("particles.position", position);
    add("particles.velocity", velocity);
    add("particles.force", force);
    add("particles.angular_velocity", angular_velocity);
    add("particles.torque", torque);
    add("particles.gas", gas);
    add("particles.stress_force", stress_force);
    add("particles.drag_impulse", drag_impulse);
    add("particles.scalars", scalars.size());
    for (const auto& [name, unit, value] : scalars) add("particles.scalars", value);
    add("particles.id", id);
    add("particles.species", species);
  }

  void enter(const EngineState& engine) {
    const auto& [listed, stale, cut_off, reach, skin, skin_in_diameters, listed_at, steps, reference, touching, report] = engine;
    add("engine.listed", listed);
    add("engine.stale", stale);
    add("engine.cut_off", cut_off);
    add("engine.reach", reach);
    add("engine.skin", skin);
    add("engine.skin_in_diameters", skin_in_diameters);
    add("engine.listed_at", listed_at);
    add("engine.steps", steps);
    add("engine.reference", reference);
    const auto& [place, owner, partner, history] = touching;
    add("touching.place", place);
    add("touching.owner", owner);
    add("touching.partner", partner);
    add("touching.history", history);
    enter(report);
  }

  void enter(const EngineReport& report) {
    const auto& [particle_steps, rebuilds, removed, removed_mass, removed_volume, contacts, largest_overlap, largest_speed, budget] = report;
    add("report.particle_steps", particle_steps);
    add("report.rebuilds", rebuilds);
    add("report.removed", removed);
    add("report.removed_mass", removed_mass);
    add("report.removed_volume", removed_volume);
    add("report.contacts", contacts);
    const auto& [overlap_ratio, particle, partner, place] = largest_overlap;
    add("report.largest_overlap.overlap_ratio", overlap_ratio);
    add("report.largest_overlap.particle", particle);
    add("report.largest_overlap.partner", partner);
    add("report.largest_overlap.place", place);
    add("report.largest_speed", largest_speed);
    const auto& [gravity_impulse, drag_impulse, stress_impulse, wall_impulse, removed_momentum, gravity_work, drag_work, stress_work,
                 contact_work, removed_energy] = budget;
    add("budget.gravity_impulse", gravity_impulse);
    add("budget.drag_impulse", drag_impulse);
    add("budget.stress_impulse", stress_impulse);
    add("budget.wall_impulse", wall_impulse);
    add("budget.removed_momentum", removed_momentum);
    add("budget.gravity_work", gravity_work);
    add("budget.drag_work", drag_work);
    add("budget.stress_work", stress_work);
    add("budget.contact_work", contact_work);
    add("budget.removed_energy", removed_energy);
  }

  /// What effects add to the viscosity, and the flux, are made anew in every gas step.
  void enter(const GasFields& gas) {
    const auto& [velocity, pressure, stress_force, scalars, added_viscosity, flux] = gas;
    add("gas.velocity", velocity);
    add("gas.pressure", pressure);
    add("gas.stress_force", stress_force);
    add("gas.scalars", scalars.size());
    for (const auto& [name, unit, value] : scalars) add("gas.scalars", value);
  }

  void enter(const CouplingState& coupling) {
    const auto& [fields, pending, accounts_opened, accounts_left] = coupling;
    const auto& [gas_fraction, gas_fraction_old, exchange, exchange_velocity, remainder] = fields;
    add("coupling.gas_fraction", gas_fraction);
    add("coupling.gas_fraction_old", gas_fraction_old);
    add("coupling.exchange", exchange);
    add("coupling.exchange_velocity", exchange_velocity);
    add("coupling.remainder", remainder);
    add("coupling.pending", pending);
    add("coupling.accounts_opened", accounts_opened);
    add("coupling.accounts_left", accounts_left);
  }

  /// Its size is the boundary's.
  void enter(const similitude_gas_report& report) {
    const auto& [struct_size, iterations, mass_residual, inflow, outflow, courant, momentum] = report;
    add("gas_report.iterations", iterations);
    add("gas_report.mass_residual", mass_residual);
    add("gas_report.inflow", inflow);
    add("gas_report.outflow", outflow);
    add("gas_report.courant", courant);
    add("gas_report.momentum", momentum);
  }

  void enter(const AccountsState& accounts) {
    const auto& [momentum, energy, gas_mass, gas_in, gas_out, boundary_impulse, buoyancy, pumping_work] = accounts;
    add("accounts.momentum", momentum);
    add("accounts.energy", energy);
    add("accounts.gas_mass", gas_mass);
    add("accounts.gas_in", gas_in);
    add("accounts.gas_out", gas_out);
    add("accounts.boundary_impulse", boundary_impulse);
    add("accounts.buoyancy", buoyancy);
    add("accounts.pumping_work", pumping_work);
  }

  void enter(const OutputsState& outputs) {
    const auto& [frames, last_frame_time, monitors_length, probes_length, scalars_length, largest_overlap, largest_overlap_of_run, profiles] =
        outputs;
    const auto& [particle_frames, fluid_frames] = frames;
    add("frames.particles", particle_frames);
    add("frames.fluid", fluid_frames);
    add("last_frame_time", last_frame_time);
    add("monitors_length", monitors_length);
    add("probes_length", probes_length);
    add("scalars_length", scalars_length);
    add("largest_overlap", largest_overlap);
    add("largest_overlap_of_run", largest_overlap_of_run);
    const auto& [solids, gas, solids_window, gas_window] = profiles;
    enter("profiles.solids", solids, solids_window);
    enter("profiles.gas", gas, gas_window);
  }

  void enter(const std::string& name, const std::vector<ProfileSampler::Bin>& bins, const ProfileWindow& window) {
    for (const auto& [average, seen] : bins) {
      add(name + ".seen", seen);
      const auto& [blocks, open, total, in_open, block_length] = average.state();
      add(name + ".in_open", in_open);
      add(name + ".block_length", block_length);
      for (const auto& [weighted, weight] : blocks) {
        add(name + ".blocks", weighted);
        add(name + ".blocks", weight);
      }
      for (const BlockAverage::Sums& sums : {open, total}) {
        add(name + ".sums", sums.weighted);
        add(name + ".sums", sums.weight);
      }
    }
    const auto& [from, to, instants] = window;
    add(name + "_window.from", from);
    add(name + "_window.to", to);
    add(name + "_window.instants", instants);
  }

  std::map<std::string, std::vector<long double>> entries_;
};

/// What a state belongs to, and what its stages are called.
std::string words_of(const RunIdentity& identity, const RunState& state) {
  std::ostringstream words;
  words << std::setprecision(17);
  const auto& [resolved_case, bed_sha256] = static_cast<const CaseIdentity&>(identity);
  words << identity.program_version << '\n' << resolved_case << '\n' << bed_sha256 << '\n' << identity.dt << ' ' << identity.sub_steps << ' '
        << identity.particles << ' ' << identity.solids_fraction << ' ' << identity.height << ' ' << identity.started << '\n';
  for (const auto& [kind, id, version, file, sha256] : identity.plugins) words << kind << ' ' << id << ' ' << version << ' ' << file << ' ' << sha256 << '\n';
  for (const auto& [checkpoint, simulated_s, again, command, threads] : identity.resumed) {
    words << checkpoint << ' ' << simulated_s << ' ' << again << ' ' << command << ' ' << threads << '\n';
  }
  for (const auto& [name, seconds] : state.stages) words << name << '\n';
  return words.str();
}

// The belief below rests on it: what is as in an empty state would come back even if it were never written.
TEST(CheckpointFile, IsTestedWithAStateOfWhichNoNumberIsLeftOut) {
  const RunState nothing_yet;
  const Book some(some_state(3, 2)), empty(nothing_yet);
  for (const auto& [name, numbers] : some.entries()) {
    const auto nothing = empty.entries().find(name);
    EXPECT_TRUE(nothing == empty.entries().end() || numbers != nothing->second) << name;
  }
}

TEST(CheckpointFile, BringsBackEveryNumber) {
  const ScratchFolder folder;
  for (const std::size_t rows : {70'000u, 1u, 0u}) {
    const RunState state = some_state(rows, rows / 2);
    write_checkpoint(folder / "a.h5", some_run(), state);
    const Checkpoint read = read_checkpoint(folder / "a.h5");
    const Book before(state), after(read.state);
    for (const auto& [name, numbers] : before.entries()) {
      const auto found = after.entries().find(name);
      EXPECT_TRUE(found != after.entries().end() && found->second == numbers) << name << " of " << rows << " rows";   // too many to print
    }
    EXPECT_EQ(words_of(read.run, read.state), words_of(some_run(), state));
  }
}

TEST(CheckpointFile, CutShortAnywhereIsRefused) {
  const ScratchFolder folder;
  const std::string whole = bytes_of(folder, some_run(), some_state(100, 50));
  for (std::size_t length = 0; length < whole.size(); length += 997) {
    write_unsynced(folder / "short.h5", whole.substr(0, length));
    EXPECT_THROW(read_checkpoint(folder / "short.h5"), Hdf5Error) << length;
  }
}

// Bytes that belong to nothing may change: then what is read is what was written.
TEST(CheckpointFile, AlteredAnywhereIsRefusedOrReadsTheSame) {
  const ScratchFolder folder;
  const RunState state = some_state(100, 50);
  const std::string whole = bytes_of(folder, some_run(), state);
  std::size_t refused = 0, tried = 0;
  for (std::size_t at = 0; at < whole.size(); at += 101, ++tried) {
    std::string altered = whole;
    altered[at] = static_cast<char>(altered[at] ^ (1 << (at % 8)));
    write_unsynced(folder / "altered.h5", altered);
    try {
      const Checkpoint read = read_checkpoint(folder / "altered.h5");
      EXPECT_TRUE(bytes_of(folder, read.run, read.state) == whole) << "byte " << at;
    } catch (const Hdf5Error&) {
      ++refused;
    } catch (const CheckpointFormatError&) {
      ADD_FAILURE() << "byte " << at << " passed for a format";
    }
  }
  EXPECT_GT(refused, tried / 2);
}

TEST(CheckpointFile, OfAnotherFormatSaysSo) {
  const ScratchFolder folder;
  Hdf5Writer file;
  const std::uint64_t format = 999;
  file.attribute("/", "format", &format, {Hdf5Column::Type::u64, 1, 1});
  write_whole_file(folder / "new.h5", file.bytes());
  EXPECT_EQ(message_of<CheckpointFormatError>([&] { read_checkpoint(folder / "new.h5"); }), "format 999; this program reads format 2");
}

// /dev/full answers every write as a full disk does.
TEST(CheckpointFile, OnAFullDiskLeavesTheLastOneAlone) {
  const ScratchFolder folder;
  const std::string before = bytes_of(folder, some_run(), some_state(10, 5));
  std::filesystem::create_symlink("/dev/full", folder / "compared.h5.part");
  EXPECT_THAT(message_of<OutputError>([&] { write_checkpoint(folder / "compared.h5", some_run(), some_state(20, 5)); }),
              testing::HasSubstr("compared.h5: cannot be written: the disk is full."));
  EXPECT_TRUE(text_of(folder / "compared.h5") == before);
}

// What others see: names, units and plain arrays, with nothing of this program.
TEST(CheckpointFile, IsPlainHdf5ForOthers) {
  const ScratchFolder folder;
  const RunState state = some_state(3, 1);
  write_checkpoint(folder / "a.h5", some_run(), state);
  const hid_t file = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  const hid_t positions = H5Dopen2(file, "/particles/position", H5P_DEFAULT);
  std::array<Row, 3> rows;
  ASSERT_GE(H5Dread(positions, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
  EXPECT_EQ(rows[2].z, state.simulation.particles.position[2].z);
  const hid_t columns = H5Aopen(positions, "columns", H5P_DEFAULT);
  const hid_t type = H5Aget_type(columns);
  std::string text(H5Tget_size(type), ' ');
  ASSERT_GE(H5Aread(columns, type, text.data()), 0);
  EXPECT_EQ(text, "x [m], y [m], z [m], radius [m]");
  H5Tclose(type);
  H5Aclose(columns);
  H5Dclose(positions);
  H5Fclose(file);
}

TEST(CheckpointFile, AreListedNewestFirst) {
  const ScratchFolder folder;
  for (const std::int64_t steps : {7, 1'000'000'000, 42, 999'999'999}) write_whole_file(folder / checkpoint_name(steps), "");
  write_whole_file(folder / "checkpoint_000000050.h5.part", "");
  write_whole_file(folder / "notes.h5", "");
  std::vector<std::string> names;
  for (const auto& file : checkpoints_in(folder.path())) names.push_back(file.filename().string());
  EXPECT_THAT(names, testing::ElementsAre("checkpoint_1000000000.h5", "checkpoint_999999999.h5", "checkpoint_000000042.h5",
                                          "checkpoint_000000007.h5"));
  EXPECT_TRUE(checkpoints_in(folder / "nowhere").empty());
}

}  // namespace
}  // namespace similitude
