// Beds drawn by lot within the ranges that the reference pages give. None may end in a number that is none, or stop with words
// that do not help. SIMILITUDE_SCENES says how many (20), from seed SIMILITUDE_FIRST_SEED (1) on; with SIMILITUDE_JOURNAL, a file, scenes
// that it names are passed over and scenes that are done are added, so that a long scan can be broken off; the file goes when all are done.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "hard_case.h"
#include "particles/errors.h"

namespace similitude::test {
namespace {

class Lot {
 public:
  explicit Lot(std::uint64_t seed) : engine_(seed) {}
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  double over_decades(double low, double high) { return low * std::pow(high / low, unit()); }
  int whole(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }
  bool once_in(int n) { return whole(1, n) == 1; }
  template <std::size_t N>
  std::string one_of(const std::array<const char*, N>& choices) { return choices[static_cast<std::size_t>(whole(0, static_cast<int>(N) - 1))]; }

 private:
  std::mt19937_64 engine_;   // the same numbers everywhere, unlike the standard's distributions
};

constexpr std::array<const char*, 10> k_drags{"gidaspow", "syamlal_obrien", "di_felice", "beetstra", "koch_hill_ladd",
                                              "wen_yu", "ergun", "tang", "rong", "huilin_gidaspow"};
constexpr std::array<const char*, 5> k_scalings{"exact", "exact", "{id: parcel, n: 1.5}", "{id: link, n: 1.5}", "{id: similarity, geometry: 0.5, n: 0.7}"};
constexpr std::array<const char*, 4> k_fluids{"vans", "{id: vans, advection: upwind}", "{id: vans, momentum: model_b}", "porous"};

/// [m/s], Wen & Yu (1966).
double minimum_velocity(double diameter, double density, double gas_density, double viscosity) {
  const double archimedes = gas_density * (density - gas_density) * 9.81 * diameter * diameter * diameter / (viscosity * viscosity);
  return (std::sqrt(33.7 * 33.7 + 0.0408 * archimedes) - 33.7) * viscosity / (gas_density * diameter);
}

std::string random_case(std::uint64_t seed) {
  Lot lot(seed);
  const double d = lot.over_decades(0.2e-3, 5e-3), density = lot.over_decades(300, 8000);                   // [m], [kg/m^3]
  const double gas_density = lot.over_decades(0.2, 20), viscosity = lot.over_decades(1e-5, 5e-5);           // [kg/m^3], [Pa s]
  const double cell = d * lot.over_decades(0.8, 4);
  const auto across = [&] { return std::max(lot.whole(3, 8), static_cast<int>(std::ceil(6 * d / cell))); };
  const int nx = across(), ny = across(), nz = std::max(20, static_cast<int>(std::ceil(20 * d / cell)));
  const double room = nx * ny * (nz / 3) * cell * cell * cell, sphere = std::numbers::pi / 6 * d * d * d;
  const int count = std::clamp(static_cast<int>(0.4 * room / sphere), 1, 1200);
  // Stiff enough that a fall through the box presses a sphere in by a per cent to a tenth: m v^2 = k delta^2.
  const double fall = std::sqrt(2 * 9.81 * nz * cell), overlap = d * lot.over_decades(0.01, 0.08);
  const double stiffness = density * sphere * fall * fall / (overlap * overlap);
  const double restitution = lot.between(0.3, 1), friction = lot.once_in(4) ? 0 : lot.between(0, 1);
  const bool hertz = lot.once_in(3);
  const std::string contact =
      hertz ? fmt::format("{{id: {}, youngs_modulus: {:.6g} Pa, poisson_ratio: 0.25, restitution: {:.4f}, friction: {:.4f}}}",
                          lot.one_of(std::array<const char*, 2>{"hertz_mindlin", "hertz_thornton"}), 3 * stiffness / d, restitution, friction)
            : fmt::format("{{id: linear_spring, stiffness: {:.6g} N/m, restitution: {:.4f}, friction: {:.4f}}}", stiffness, restitution, friction);
  const double blown = lot.between(0, 4) * minimum_velocity(d, density, gas_density, viscosity);            // [m/s]
  const bool jet = lot.once_in(3);
  std::string inlet = fmt::format("face: bottom, velocity: {:.6g} m/s", jet ? 5 * blown : blown);
  if (jet) inlet += fmt::format(", x: [{0:.9g} m, {1:.9g} m]", (nx / 2) * cell, (nx / 2 + 1) * cell);
  if (lot.once_in(2)) inlet += ", ramp: 0 s";
  std::string scene;
  if (!jet && lot.once_in(3)) scene = "  periodic: [x, y]\n";
  else if (lot.once_in(3)) {
    scene = fmt::format("  baffles: {{plate: {{at_x: {0:.9g} m, z: [{1:.9g} m, {2:.9g} m], thickness: {3:.6g} m}}}}\n", (nx / 2) * cell,
                        3 * cell, (nz / 2) * cell, 0.5 * std::min(d, cell));
  }
  return fmt::format(R"(
similitude: 1
title: a bed drawn by lot
scene:
  domain:    {{size: [{:.9g} m, {:.9g} m, {:.9g} m], cell: {:.9g} m}}
  gas:       {{density: {:.6g} kg/m^3, viscosity: {:.6g} Pa s}}
  particles: {{grain: {{diameter: {:.9g} m, density: {:.6g} kg/m^3, count: {}}}}}
  bed:       {{fill: lattice}}
  patches:   {{inlet: {{{}}}, outlet: {{face: top, pressure: 0 Pa}}}}
{}models:
  drag: {}
  contact: {}
  fluid: {}
  scaling: {}
time: {{end: 1000 s}}
)",
                     nx * cell, ny * cell, nz * cell, cell, gas_density, viscosity, d, density, count, inlet, scene,
                     lot.one_of(k_drags), contact, lot.one_of(k_fluids), lot.one_of(k_scalings));
}

std::int64_t number_from(const char* variable, std::int64_t otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atoll(text) : otherwise;
}

}  // namespace

TEST(RandomScenes, RunOrSayHonestlyWhyNot) {
  constexpr int k_gas_steps = 150;
  const auto first = static_cast<std::uint64_t>(number_from("SIMILITUDE_FIRST_SEED", 1));
  const auto scenes = static_cast<std::uint64_t>(number_from("SIMILITUDE_SCENES", 20));
  const char* journal = std::getenv("SIMILITUDE_JOURNAL");
  std::set<std::uint64_t> done;
  if (journal != nullptr) {
    std::ifstream file(journal);
    for (std::uint64_t seed; file >> seed;) done.insert(seed);
  }
  int stopped = 0;
  for (std::uint64_t seed = first; seed < first + scenes; ++seed) {
    if (done.contains(seed)) continue;
    const std::string yaml = random_case(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + yaml);
    try {
      const auto bed = small_bed(yaml);
      Watch watch(*bed);
      watch.steps(k_gas_steps);
      watch.expect_sound(0.30);
    } catch (const SimulationError& stop) {   // a guard: it must say what to change, and not that the program is wrong
      ++stopped;
      const std::string text = stop.what();
      std::printf("  seed %llu: %s\n", static_cast<unsigned long long>(seed), text.c_str());
      EXPECT_NE(text.find("\n  "), std::string::npos) << text;
      EXPECT_EQ(text.find("not a finite number"), std::string::npos) << text;
      EXPECT_EQ(text.find("not finite"), std::string::npos) << text;
      EXPECT_EQ(text.find("is wrong"), std::string::npos) << text;
    } catch (const std::exception& refused) {
      ADD_FAILURE() << refused.what();
    }
    if (journal != nullptr && !HasFailure()) std::ofstream(journal, std::ios::app) << seed << "\n";
  }
  EXPECT_LE(stopped, static_cast<int>(scenes) / 20);   // of seeds 1 to 200 none was: these scenes are ordinary
  if (journal != nullptr && !HasFailure()) std::filesystem::remove(journal);
  std::printf("  seeds %llu to %llu, %d stopped by a guard\n", static_cast<unsigned long long>(first),
              static_cast<unsigned long long>(first + scenes - 1), stopped);
}

}  // namespace similitude::test
