/// What the stages of a step cost, each alone: lists, contacts, interpolation, deposit, smoothing, pressure. One thread unless
/// OMP_NUM_THREADS says otherwise (the contact pass always one).
///
///   stages_bench [--benchmark_filter=…] [--benchmark_format=json] …   (Google Benchmark's options)
///
/// machine_memory and machine_arithmetic say what the machine can do. Counters of the others: seconds per particle or per cell, and of these how many;
/// the pressure solve also tells its iterations, which do not depend on the mesh. What is timed stands in functions called measured_…, never
/// inlined, for callgrind to know them by (tests/performance/roofline).

#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <random>
#include <vector>

#include "bench_bed.h"
#include "boxes.h"
#include "coupling/deposit.h"
#include "coupling/smoothing.h"
#include "fluid/grid.h"
#include "fluid/multigrid_cg.h"
#include "particles/carried_history.h"
#include "particles/contact_pass.h"

namespace {
using namespace similitude;
using namespace similitude::bench;

constexpr double k_skin = 0.1 * k_diameter, k_cell = 2.5e-3;   // [m]

void per_item(benchmark::State& state, const char* name, std::size_t items) {
  state.counters[name] =
      benchmark::Counter(static_cast<double>(items), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["items"] = static_cast<double>(items);
}

/// A settled bed's number of contacts, its rows sorted and its lists built, as the engine holds them.
struct ListedBed {
  explicit ListedBed(std::size_t count)
      : bed(resting_lattice(count)), scene(box_around(bed)), law(contact_law(k_stiffness, k_restitution, k_friction)), surfaces(scene),
        effects(needs_of(law), {}), lists(effects.memory().rows(), false), carried(effects.memory()),
        contacts(bed, law, effects, 1, surfaces, bricks, lists), columns(1) {
    bricks.lay_out(scene.size, scene.periodic, k_diameter + k_skin);
    bricks.sort(bed, std::vector<std::uint8_t>(count, 0));
    bed.reorder(bricks.order());
    build();
    contacts.make_room();
    pass();
  }
  static similitude_contact_needs needs_of(const ContactModel& law) {
    similitude_contact_needs needs{};
    needs.struct_size = sizeof needs;
    law.functions().needs(law.instance(), &needs);
    return needs;
  }
  void build() { lists.build(bed, bricks, surfaces, k_skin, 0.5 * k_diameter, carried); }
  std::size_t pass() {
    std::size_t touching = 0;
    for (std::uint32_t brick = 0; brick < bricks.count(); ++brick) touching += contacts.pairs(brick, k_dt, columns[0], deepest, complaint);
    for (std::uint32_t brick = 0; brick < bricks.count(); ++brick) contacts.collect_shares(brick);
    return touching;
  }

  ParticleStore bed;
  ModelScene scene;
  ContactModel law;
  Surfaces surfaces;
  ContactEffects effects;
  Bricks bricks;
  ContactLists lists;
  CarriedHistory carried;
  ContactPass contacts;
  Column<BlockColumns> columns;
  DeepestContact deepest;
  LawComplaint complaint;
};

/// Sorting, carrying the history over, searching: all that a rebuild does but moving the rows.
[[gnu::noinline]] void measured_list_build(ListedBed& listed, const std::vector<std::uint8_t>& nobody_leaves, const std::vector<std::uint32_t>& same_rows) {
  listed.bricks.sort(listed.bed, nobody_leaves);
  listed.carried.collect(listed.lists, same_rows, listed.bed.size());
  listed.build();
}

void list_build(benchmark::State& state) {
  ListedBed listed(static_cast<std::size_t>(state.range(0)));
  const std::size_t count = listed.bed.size();
  const std::vector<std::uint8_t> nobody_leaves(count, 0);
  std::vector<std::uint32_t> same_rows(count);
  for (std::uint32_t row = 0; row < count; ++row) same_rows[row] = row;
  for (auto _ : state) measured_list_build(listed, nobody_leaves, same_rows);
  per_item(state, "per_particle", count);
}

[[gnu::noinline]] std::size_t measured_contact_pass(ListedBed& listed) { return listed.pass(); }

void contact_pass(benchmark::State& state) {
  ListedBed listed(static_cast<std::size_t>(state.range(0)));
  std::size_t touching = 0;
  for (auto _ : state) touching = measured_contact_pass(listed);
  per_item(state, "per_contact", touching);
  per_item(state, "per_particle", listed.bed.size());
  state.counters["contacts_per_particle"] = static_cast<double>(touching) / static_cast<double>(listed.bed.size());
}

/// A bed in cells of 2.5 particle diameters.
struct CellBed {
  explicit CellBed(std::size_t count) : bed(resting_lattice(count)), scene(cells_around(bed)), grid(scene), map(grid), field(map.cell_count()) {
    for (std::size_t c = 0; c < field.size(); ++c) field[c] = {scatter(), scatter(), scatter(), scatter()};
  }
  static ModelScene cells_around(const ParticleStore& bed) {
    ModelScene scene = box_around(bed);
    scene.size[2] = std::ceil(scene.size[2] / k_cell) * k_cell;
    scene.cell = {k_cell, k_cell, k_cell};
    return scene;
  }
  ParticleStore bed;
  ModelScene scene;
  Grid grid;
  CellMap map;
  CellRows field;
};

[[gnu::noinline]] void measured_interpolation(const CellBed& cells) {
  for (const Row& position : cells.bed.position) benchmark::DoNotOptimize(gather(cells.map.stencil(position), cells.field));
}

void interpolation(benchmark::State& state) {
  const CellBed cells(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) measured_interpolation(cells);
  per_item(state, "per_particle", cells.bed.size());
}

[[gnu::noinline]] void measured_deposit(CellBed& cells, Deposit& to_cells) {
  to_cells.sort(cells.bed.position);
  to_cells.spread(cells.bed.position, [&](std::size_t row) { return cells.bed.velocity[row]; }, cells.field);
  benchmark::ClobberMemory();
}

void deposit(benchmark::State& state) {
  CellBed cells(static_cast<std::size_t>(state.range(0)));
  Deposit to_cells(cells.map);
  for (auto _ : state) measured_deposit(cells, to_cells);
  per_item(state, "per_particle", cells.bed.size());
}

[[gnu::noinline]] void measured_smoothing(CellBed& cells, Smoothing& smooth) {
  smooth.apply(cells.field);
  benchmark::ClobberMemory();
}

/// Over three particle diameters, the default.
void smoothing(benchmark::State& state) {
  CellBed cells(static_cast<std::size_t>(state.range(0)));
  Smoothing smooth(cells.map, 3 * k_diameter);
  for (auto _ : state) measured_smoothing(cells, smooth);
  per_item(state, "per_cell", cells.map.cell_count());
  state.counters["steps"] = smooth.steps();
}

using FaceValues = std::array<std::vector<double>, 3>;

[[gnu::noinline]] SolveReport measured_pressure_solve(MultigridCG& solver, const FaceValues& coefficient, const std::vector<double>& rhs, std::vector<double>& pressure) {
  solver.set_coefficients({coefficient[0].data(), coefficient[1].data(), coefficient[2].data()});
  std::fill(pressure.begin(), pressure.end(), 0);
  return solver.solve(rhs.data(), pressure.data(), {.tolerance = 1e-8});
}

/// A bed that passes a hundredth of what open gas does, in the lower half; an outlet on top; noise on the right-hand side.
void pressure_solve(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  test::Box box({.cells = {n, n, n}});
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  const Staggered mesh = box.mesh();
  FaceValues coefficient;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto layer = mesh.face_extent[axis][0] * mesh.face_extent[axis][1];
    for (Index face = 0; face < mesh.face_count[axis]; ++face) coefficient[axis].push_back(face / layer < n / 2 ? 0.01 : 1.0);
  }
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> both(-1, 1);
  std::vector<double> rhs(static_cast<std::size_t>(mesh.cell_count)), pressure(rhs.size());
  for (double& value : rhs) value = both(random);
  MultigridCG solver(box.table());
  SolveReport report;
  for (auto _ : state) report = measured_pressure_solve(solver, coefficient, rhs, pressure);
  if (!report.converged) state.SkipWithError("the pressure equation did not converge");
  per_item(state, "per_cell", rhs.size());
  state.counters["iterations"] = report.iterations;
}

}  // namespace

/// What the machine can move, beyond its caches: a = b + s c (McCalpin's triad), bytes read and written.
void machine_memory(benchmark::State& state) {
  constexpr std::size_t k_count = 1 << 24;   // 128 MiB an array
  std::vector<double> a(k_count, 1), b(k_count, 2), c(k_count, 3);
  for (auto _ : state) {
    for (std::size_t k = 0; k < k_count; ++k) a[k] = b[k] + 0.5 * c[k];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * 3 * sizeof(double) * k_count));
}

/// What the machine can compute: multiplications with additions on numbers that stay in registers, two operations each.
void machine_arithmetic(benchmark::State& state) {
  constexpr std::size_t k_lanes = 64, k_turns = 1000;
  std::array<double, k_lanes> x;
  x.fill(1);
  double factor = 1 - 1e-9;
  benchmark::DoNotOptimize(factor);
  for (auto _ : state) {
    for (std::size_t turn = 0; turn < k_turns; ++turn)
      for (double& value : x) value = value * factor + 1e-9;
    benchmark::DoNotOptimize(x.data());
  }
  state.counters["operations_per_s"] =
      benchmark::Counter(static_cast<double>(2 * k_lanes * k_turns), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(machine_memory)->Unit(benchmark::kMillisecond);
BENCHMARK(machine_arithmetic)->Unit(benchmark::kMicrosecond);
BENCHMARK(list_build)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
BENCHMARK(contact_pass)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
BENCHMARK(interpolation)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
BENCHMARK(deposit)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
BENCHMARK(smoothing)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
BENCHMARK(pressure_solve)->Arg(10)->Arg(22)->Arg(46)->Arg(80)->Arg(126)->Arg(160)->Unit(benchmark::kMillisecond);   // 1e3 … 4e6 cells
BENCHMARK_MAIN();
