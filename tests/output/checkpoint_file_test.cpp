#include "output/checkpoint_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <fstream>

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
  some.fill(s.accounts.momentum);
  for (double* number : {&s.accounts.energy, &s.accounts.gas_mass, &s.accounts.gas_in, &s.accounts.gas_out}) *number = some();
  s.warnings_given = {0, 1, 0};

  OutputsState& o = state.outputs;
  some.fill_numbers(o.frames.particles, 3);
  some.fill_numbers(o.frames.fluid, 2);
  for (double* number : {&o.last_frame_time, &o.largest_overlap, &o.largest_overlap_of_run}) *number = some();
  o.monitors_length = 4711;
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

TEST(CheckpointFile, BringsBackEveryNumber) {
  const ScratchFolder folder;
  for (const std::size_t rows : {70'000u, 1u, 0u}) {
    const RunState state = some_state(rows, rows / 2);
    write_checkpoint(folder / "a.h5", some_run(), state);
    const Checkpoint read = read_checkpoint(folder / "a.h5");
    EXPECT_TRUE(bytes_of(folder, read.run, read.state) == text_of(folder / "a.h5")) << rows;   // printing would take gigabytes

    // The comparison above cannot see what is never written.
    EXPECT_EQ(read.state.simulation.particles.size(), rows);
    EXPECT_EQ(read.state.simulation.engine.report.largest_overlap.partner, ~std::uint64_t{0});
    EXPECT_EQ(read.state.simulation.engine.report.budget.removed_energy, state.simulation.engine.report.budget.removed_energy);
    EXPECT_EQ(read.state.simulation.gas_report.momentum[2], state.simulation.gas_report.momentum[2]);
    EXPECT_EQ(read.state.simulation.coupling.fields.remainder, state.simulation.coupling.fields.remainder);
    EXPECT_EQ(read.state.simulation.warnings_given, state.simulation.warnings_given);
    EXPECT_EQ(read.state.outputs.profiles.solids[2].average.standard_error(), state.outputs.profiles.solids[2].average.standard_error());
    EXPECT_EQ(read.state.outputs.profiles.gas_window.instants, 53u);
    EXPECT_EQ(read.state.stages[1].seconds, state.stages[1].seconds);
    EXPECT_EQ(read.run.dt, 1.0 / 3);
    EXPECT_EQ(read.run.resolved_case, some_run().resolved_case);
    EXPECT_EQ(read.run.bed_sha256, "def");
    EXPECT_EQ(read.run.plugins[0].sha256, "abc");
    EXPECT_EQ(read.run.resumed[0].threads, 2);
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
