#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <omp.h>

#include "output/checkpoint_file.h"
#include "output/state_hash.h"
#include "small_bed.h"

// A user mixes models freely. In these runs of a small bed every pair of (drag, contact, fluid, scaling) that is installed occurs,
// and every run must end, with its particles, its mass and its momentum.
namespace similitude::test {
namespace {

constexpr std::array<const char*, 4> k_kinds{"drag", "contact", "fluid", "scaling"};
using Combination = std::array<std::string, 4>;   // ids in the order of k_kinds

/// What a model must be told beyond its id, for the bed below.
const std::map<std::string, std::string>& parameters() {
  static const std::map<std::string, std::string> table{
      {"linear_spring", "stiffness: 200 N/m, restitution: 0.8, friction: 0.3"},
      {"fluent_dem", "stiffness: 200 N/m, restitution: 0.8"},
      {"hertz_mindlin", "youngs_modulus: 1 MPa, poisson_ratio: 0.25, restitution: 0.8, friction: 0.3"},
      {"hertz_thornton", "youngs_modulus: 1 MPa, poisson_ratio: 0.25, restitution: 0.8, friction: 0.3"},
      {"haider_levenspiel", "sphericity: 0.8"},
      {"prescribed", "velocity_z: 0.8 m/s"},
      {"parcel", "n: 1.5"},
      {"coarse_grain", "n: 1.5"},
      {"bierwisch", "n: 1.5"},
      {"link", "n: 1.5"},
      {"terminal_velocity", "geometry: 0.5"},
      {"glicksman", "geometry: 0.5"},
      {"glicksman_full", "geometry: 0.5"},
      {"similarity", "geometry: 0.5, n: 0.7"},
      {"custom", "length: 0.5, diameter: 0.6, velocity: 0.7, time: 0.7"},
  };
  return table;
}

std::string model(const std::string& id) {
  const auto found = parameters().find(id);
  return found == parameters().end() ? id : fmt::format("{{id: {}, {}}}", id, found->second);
}

using Meeting = std::pair<std::string, std::string>;   // "drag ergun" with "scaling exact"

std::vector<Meeting> meetings_of(const Combination& c) {
  std::vector<Meeting> meetings;
  for (std::size_t a = 0; a < c.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) meetings.emplace_back(k_kinds[a] + (" " + c[a]), k_kinds[b] + (" " + c[b]));
  }
  return meetings;
}

std::vector<Combination> every_combination() {
  std::vector<Combination> all{{}};
  for (std::size_t kind = 0; kind < k_kinds.size(); ++kind) {
    std::vector<Combination> longer;
    for (const Combination& start : all) {
      for (const std::string& id : built_plugins().ids(k_kinds[kind])) {
        longer.push_back(start);
        longer.back()[kind] = id;
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// Greedily those in which most pairs meet for the first time, until all have met: at least as many as the two kinds with the
/// most models have pairs, and hardly more.
std::vector<Combination> combinations() {
  std::vector<Combination> candidates = every_combination(), chosen;
  std::set<Meeting> met;
  const auto news = [&met](const Combination& c) {
    return std::ranges::count_if(meetings_of(c), [&met](const Meeting& m) { return !met.contains(m); });
  };
  for (long most = static_cast<long>(k_kinds.size() * (k_kinds.size() - 1) / 2); most > 0; --most) {
    for (const Combination& c : candidates) {
      if (news(c) < most) continue;
      chosen.push_back(c);
      for (const Meeting& meeting : meetings_of(c)) met.insert(meeting);
    }
  }
  return chosen;
}

std::string bed_case(const Combination& c) {
  return fmt::format(R"(
similitude: 1
title: a small bed, blown through
scene:
  domain:    {{size: [16 mm, 16 mm, 96 mm], cell: 4 mm}}
  walls:     {{left: slip, right: slip, front: slip, back: slip}}
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{alumina: {{diameter: 2 mm, density: 1040 kg/m^3, count: 1500}}}}
  bed:       {{fill: lattice}}
  patches:
    inlet:  {{face: bottom, velocity: 0.8 m/s}}
    outlet: {{face: top, pressure: 0 Pa}}
models:
  drag: {}
  contact: {}
  fluid: {}
  scaling: {}
time: {{end: 0.2 s}}
)",
                     model(c[0]), model(c[1]), model(c[2]), model(c[3]));
}

std::string name_of(const ::testing::TestParamInfo<Combination>& info) {
  const Combination& c = info.param;
  return fmt::format("{}_{}_{}_{}", c[0], c[1], c[2], c[3]);
}

class AllPairs : public ::testing::TestWithParam<Combination> {};
INSTANTIATE_TEST_SUITE_P(Models, AllPairs, ::testing::ValuesIn(combinations()), name_of);

}  // namespace

TEST_P(AllPairs, RunTogetherAndKeepTheirBooks) {
  const auto bed = small_bed(bed_case(GetParam()));
  const std::size_t particles = bed->simulation->particles().size();
  ASSERT_GT(particles, 20u);
  Simulation& simulation = *bed->simulation;
  while (simulation.time() < bed->assembly->model.time.end) simulation.step();

  EXPECT_EQ(simulation.particles().size(), particles);
  const auto& size = bed->assembly->model.size;
  for (const Row& x : simulation.particles().position) {
    ASSERT_TRUE(x.x > 0 && x.x < size[0] && x.y > 0 && x.y < size[1] && x.z > 0 && x.z < size[2]);
  }
  const Balances balances = simulation.balances();
  EXPECT_LT(balances.momentum, 1e-11);
  EXPECT_LT(balances.energy, 1e-11);
  if (!bed->assembly->coupled()) return;   // a given gas has no mass balance and feels nothing
  // vans leaves at most 1e-7 of the inflow in any cell, and all cells may err to one side; porous may leave 1e-6, but errs to both.
  EXPECT_LT(balances.gas_mass, 1e-7 * static_cast<double>(bed->assembly->grid->cell_count()));
  // What the gas gave to the particles came from its boundary, known at the floor to a part of half a cell of seven.
  EXPECT_LT(balances.gas_momentum, 0.02);
}

// Through the file, into models made anew and with more threads: the same bits as without a break.
TEST_P(AllPairs, GoOnFromACheckpointWithTheSameBits) {
  constexpr int k_before = 40, k_after = 40;   // gas steps
  const auto whole = small_bed(bed_case(GetParam())), broken = small_bed(bed_case(GetParam())), resumed = small_bed(bed_case(GetParam()));
  for (int n = 0; n < k_before + k_after; ++n) whole->simulation->step();
  for (int n = 0; n < k_before; ++n) broken->simulation->step();
  const auto file = std::filesystem::temp_directory_path() / fmt::format("similitude_pairs_{}.h5", ::getpid());
  RunState state;
  broken->simulation->save(state.simulation);
  EXPECT_FALSE(state.simulation.engine.touching.place.empty());   // or contacts would not be tested
  RunIdentity run;
  run.resolved_case = "{}";
  write_checkpoint(file, run, state);
  const Checkpoint read = read_checkpoint(file);
  std::filesystem::remove(file);
  resumed->simulation->restore(read.state.simulation);

  const int threads = omp_get_max_threads();
  omp_set_num_threads(2);
  for (int n = 0; n < k_after; ++n) resumed->simulation->step();
  omp_set_num_threads(threads);
  const auto hash = [](const Simulation& s) { return state_hash(s.particles(), &s.gas(), &s.exchange().gas_fraction); };
  EXPECT_EQ(hash(*resumed->simulation), hash(*whole->simulation));
  EXPECT_EQ(resumed->simulation->balances().momentum, whole->simulation->balances().momentum);
  EXPECT_EQ(resumed->simulation->momentum(), whole->simulation->momentum());
}

}  // namespace similitude::test
