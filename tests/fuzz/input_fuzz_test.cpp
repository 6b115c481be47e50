// Spoilt input: cases, studies, particle files, checkpoints. Whatever is read is refused in words (InputError, PluginError, or what
// the reader of checkpoints throws), or makes sense: a case that is accepted is put together, and a small one runs two gas steps
// to finite numbers or a guard's words. Anything else, a crash or a hang, is a fault of the program.
//
// SIMILITUDE_INPUTS says how many (300), from SIMILITUDE_FIRST_INPUT (0) on; with SIMILITUDE_JOURNAL, a file, it goes on after the last
// number that stands there, and takes the file away when all are done, so that the next time begins anew. The input at work lies in fuzz_input.* of the working folder, for whoever looks at a crash.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "mutations.h"
#include "output/checkpoint_file.h"
#include "particles/errors.h"
#include "particles/particle_file.h"
#include "scene/messages.h"
#include "small_bed.h"
#include "study/study_plan.h"

namespace similitude::test {
namespace {

constexpr unsigned k_hung = 120;              // [s], of one input, under sanitizers on a busy machine
constexpr std::size_t k_most_cells = 30'000;  // more than that is not put together here, only read

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const char* const k_small = R"(similitude: 1
title: a small bed
scene:
  domain:    {size: [20 mm, 10 mm, 40 mm], cell: 2.5 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles: {alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 100}, sand: {diameter: 1.5 mm, density: 2000 kg/m^3, count: 20}}
  bed:       {fill: lattice, seed: 3}
  patches:
    spout:  {face: bottom, x: [7.5 mm, 12.5 mm], velocity: 3 m/s, ramp: 10 ms}
    outlet: {face: top, pressure: 0 Pa}
  baffles:   {plate: {at_x: 5 mm, z: [10 mm, 20 mm], thickness: 0.5 mm}}
  gravity:   9.81 m/s^2
models:
  drag: {id: syamlal_obrien, c1: 0.8, d1: 2.65}
  contact: {id: linear_spring, stiffness: 100 N/m, restitution: 0.74, friction: 0.2}
  fluid: {id: vans, advection: tvd, tolerance: 1e-7}
  scaling: exact
coupling: {smoothing: 3 mm}
time: {end: 10 ms, dt: 5e-6 s, gas_dt: 1e-4 s}
output: {vtk: every 5 ms, monitors: every 1 ms, profiles: {z: [5 mm], from: 2 ms}, probes: {low: {at: [5 mm, 5 mm, 5 mm]}}}
)";

const char* const k_csv = "x [m],y [m],z [m],vx,vy,vz,diameter [m],density\n"
                          "0.005,0.005,0.005,0,0,-0.1,0.001,1040\n0.007,0.005,0.006,0.1,0,0,0.001,1040\n# a remark\n0.01,0.005,0.02,0,0,0,0.0015,2000\n";
const char* const k_lammps = "LAMMPS data file\n\n3 atoms\n2 atom types\n\n0 0.02 xlo xhi\n0 0.01 ylo yhi\n0 0.04 zlo zhi\n\nAtoms # sphere\n\n"
                             "1 1 0.001 1040 0.005 0.005 0.005\n2 1 0.001 1040 0.007 0.005 0.006 0 0 0\n3 2 0.0015 2000 0.01 0.005 0.02\n\n"
                             "Velocities\n\n1 0 0 -0.1 0 0 0\n2 0.1 0 0 0 0 0\n3 0 0 0 0 0 0\n";
const char* const k_vtp = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="2" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<PointData><DataArray type="Float64" Name="diameter" format="ascii">0.001 0.0015</DataArray>
<DataArray type="Float64" Name="density" format="ascii">1040 2000</DataArray>
<DataArray type="Float64" Name="velocity" NumberOfComponents="3" format="ascii">0 0 0 0.1 0 0</DataArray></PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0.005 0.005 0.005 0.01 0.005 0.02</DataArray></Points>
</Piece></PolyData></VTKFile>
)";

/// Everything the fuzzer starts from.
struct Seeds {
  std::vector<std::string> cases{k_small}, studies;
  std::string checkpoint;
};

Seeds shipped() {
  Seeds seeds;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SIMILITUDE_SOURCE "/configs")) {
    if (entry.path().extension() != ".yaml") continue;
    std::string text = content_of(entry.path());
    (text.find("similitude_study:") != std::string::npos ? seeds.studies : seeds.cases).push_back(std::move(text));
  }
  std::ranges::sort(seeds.cases);
  std::ranges::sort(seeds.studies);
  const auto bed = small_bed(k_small);
  for (int n = 0; n < 5; ++n) bed->simulation->step();
  RunState state;
  bed->simulation->save(state.simulation);
  RunIdentity run;
  run.resolved_case = "{}";
  write_checkpoint("fuzz_seed.h5", run, state);
  seeds.checkpoint = content_of("fuzz_seed.h5");
  return seeds;
}

void write(const std::filesystem::path& file, const std::string& content) { std::ofstream(file, std::ios::binary) << content; }

bool finite_rows(const Column<Row>& rows) {
  return std::ranges::all_of(rows, [](const Row& r) { return std::isfinite(r.x) && std::isfinite(r.y) && std::isfinite(r.z) && std::isfinite(r.w); });
}

/// An accepted case is put together, and if it is small it runs.
void use(const CaseFile& read, bool run) {
  double cells = 1;
  for (std::size_t a = 0; a < 3; ++a) cells *= read.scene.size[a] / read.scene.cell[a];
  ASSERT_TRUE(std::isfinite(cells) && cells > 0.5);
  if (cells > static_cast<double>(k_most_cells)) return;
  Assembly assembly = assemble(read.scene, built_plugins());
  if (static_cast<double>(assembly.grid->cell_count()) > 2.0 * static_cast<double>(k_most_cells)) return;
  const TimeSteps steps = choose_time_steps(assembly);
  ASSERT_TRUE(std::isfinite(steps.dt) && steps.dt > 0);
  ASSERT_GE(steps.sub_steps, 1);
  std::int64_t particles = 0;
  for (const ParticleClass& type : assembly.model.particles) {
    ASSERT_TRUE(std::isfinite(type.diameter) && type.diameter > 0 && std::isfinite(type.density) && type.density > 0);
    particles += type.count.value_or(0);
  }
  if (!run || particles > 2000 || steps.sub_steps > 1000 || assembly.model.bed.kind == FillKind::settle || assembly.model.bed.height) return;
  StartingBed start = fill_bed(assembly, steps, {});
  Simulation simulation(assembly, steps, std::move(start.particles), [](const std::string&) {});
  for (int n = 0; n < 2; ++n) simulation.step();
  EXPECT_TRUE(finite_rows(simulation.particles().position) && finite_rows(simulation.particles().velocity));
  EXPECT_TRUE(std::ranges::all_of(simulation.gas().velocity, [](double v) { return std::isfinite(v); }));
}

void try_case(const std::string& text, bool run) {
  write("fuzz_input.yaml", text);
  plugin_paths_of("fuzz_input.yaml");
  use(read_case("fuzz_input.yaml", built_plugins()), run);
}

void try_study(const std::string& text, bool plan) {
  // A study of the shipped ones names its case relative to itself.
  static const std::filesystem::path file = std::filesystem::path("fuzz_studies") / "fuzz_input.yaml";
  write(file, text);
  const StudyFile study = read_study(file);
  if (plan && study.axes.size() + study.cases.size() < 6) plan_study(study, built_plugins());
}

void try_particles(const char* name, const std::string& content) {
  write(name, content);
  const std::vector<FileParticle> particles = read_particle_file(name);
  for (const FileParticle& p : particles) {
    for (std::size_t a = 0; a < 3; ++a) ASSERT_TRUE(std::isfinite(p.position[a]) && std::isfinite(p.velocity[a]));
    ASSERT_TRUE(!p.diameter || (std::isfinite(*p.diameter) && *p.diameter > 0));
    ASSERT_TRUE(!p.density || (std::isfinite(*p.density) && *p.density > 0));
  }
  if (particles.size() > 1000) return;
  std::string text = k_small;
  text.replace(text.find("{fill: lattice, seed: 3}"), 24, std::string("{fill: file, file: ") + name + "}");
  for (const char* count : {", count: 100", ", count: 20"}) text.erase(text.find(count), std::string(count).size());
  try_case(text, true);
}

void try_checkpoint(const std::string& bytes) {
  write("fuzz_input.h5", bytes);
  try {
    const Checkpoint read = read_checkpoint("fuzz_input.h5");
    const auto bed = small_bed(k_small);
    bed->simulation->restore(read.state.simulation);   // a byte that nobody checks: the state is as it was
    bed->simulation->step();
  } catch (const Hdf5Error&) {
  } catch (const CheckpointFormatError&) {
  }
}

void try_input(const Seeds& seeds, std::uint64_t number) {
  fuzz::Damage damage(number);
  switch (number % 8) {
    case 0: case 1: try_case(damage.to_text(k_small), true); break;
    case 2: try_case(damage.to_text(seeds.cases[damage.below(seeds.cases.size())]), false); break;
    case 3: try_study(damage.to_text(seeds.studies[damage.below(seeds.studies.size())]), number % 16 == 3); break;
    case 4: try_particles("fuzz_input.csv", damage.to_text(k_csv)); break;
    case 5: try_particles("fuzz_input.data", damage.to_text(k_lammps)); break;
    case 6: try_particles("fuzz_input.vtp", damage.to_text(k_vtp)); break;
    default: try_checkpoint(damage.to_bytes(seeds.checkpoint));
  }
}

std::uint64_t g_number = 0;
void say_hung(int) {
  std::fprintf(stderr, "input %llu hangs\n", static_cast<unsigned long long>(g_number));
  std::abort();
}

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

}  // namespace

TEST(SpoiltInput, IsRefusedInWordsOrMakesSense) {
  const auto folder = std::filesystem::temp_directory_path() / ("similitude_fuzz_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "fuzz_studies");
  std::filesystem::current_path(folder);
  std::filesystem::copy(SIMILITUDE_SOURCE "/configs/studies", "fuzz_studies", std::filesystem::copy_options::overwrite_existing);
  for (const char* name : {"small_bed", "spouted_bed"}) std::filesystem::copy(std::string(SIMILITUDE_SOURCE "/configs/") + name, name);
  const Seeds seeds = shipped();
  std::uint64_t first = number_from("SIMILITUDE_FIRST_INPUT", 0);
  const std::uint64_t end = first + number_from("SIMILITUDE_INPUTS", 300);
  const char* journal = std::getenv("SIMILITUDE_JOURNAL");
  if (journal != nullptr) {
    std::ifstream file(journal);
    for (std::uint64_t number; file >> number;) first = std::max(first, number + 1);
  }
  std::signal(SIGALRM, say_hung);
  std::uint64_t accepted = 0, refused = 0, stopped = 0;
  for (g_number = first; g_number < end && !HasFailure(); ++g_number) {
    SCOPED_TRACE("input " + std::to_string(g_number) + " in " + folder.string());
    ::alarm(k_hung);
    try {
      try_input(seeds, g_number);
      ++accepted;
    } catch (const InputError&) {
      ++refused;
    } catch (const PluginError&) {
      ++refused;
    } catch (const SimulationError&) {
      ++stopped;
    } catch (const std::exception& problem) {
      ADD_FAILURE() << "neither refused nor accepted: " << problem.what();
    }
    ::alarm(0);
    if (journal != nullptr && g_number % 100 == 99 && !HasFailure()) std::ofstream(journal, std::ios::app) << g_number << "\n";
  }
  std::printf("  inputs %llu to %llu: %llu made sense, %llu refused, %llu stopped by a guard\n", static_cast<unsigned long long>(first),
              static_cast<unsigned long long>(g_number - 1), static_cast<unsigned long long>(accepted),
              static_cast<unsigned long long>(refused), static_cast<unsigned long long>(stopped));
  if (HasFailure()) return;   // the input stays to be looked at
  if (journal != nullptr) std::filesystem::remove(journal);
  std::filesystem::current_path(std::filesystem::temp_directory_path());
  std::filesystem::remove_all(folder);
}

}  // namespace similitude::test
