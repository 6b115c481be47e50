// Heat, oxygen carriers and eddy viscosity against closed forms, through the framework and the plugins' libraries.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "coupling/cell_pass.h"
#include "coupling/contact_flows.h"
#include "coupling/scalar_exchange.h"
#include "kinetics.h"
#include "loader/catalogue.h"
#include "particles/contact_lists.h"
#include "scene/messages.h"

namespace similitude {
namespace {

constexpr double k_diameter = 1e-3, k_density = 1000, k_heat_capacity = 800, k_conductivity = 2;   // [m] [kg/m^3] [J/(kg K)] [W/(m K)]
constexpr double k_gas_density = 1.2, k_gas_viscosity = 1.8e-5, k_gas_heat_capacity = 1000, k_gas_conductivity = 0.026;

double sphere_mass() { return k_density * std::numbers::pi / 6 * k_diameter * k_diameter * k_diameter; }

similitude_bed air_bed() {
  similitude_bed bed{};
  bed.struct_size = sizeof bed;
  bed.gas_density = k_gas_density;
  bed.gas_viscosity = k_gas_viscosity;
  return bed;
}

/// An effect of a plugin's library; parameters by name, the rest at their defaults.
EffectModel effect_of(const std::string& file, const std::string& id, const std::vector<std::pair<std::string, similitude_value>>& given) {
  static std::vector<Catalogue> kept;   // entries point into them
  kept.push_back(Catalogue::of_file(file));
  const PluginEntry& entry = *kept.back().find("effect", id);
  std::vector<similitude_value> values;
  for (std::uint32_t i = 0; i < entry.descriptor->parameter_count; ++i) {
    const similitude_parameter& row = entry.descriptor->parameters[i];
    similitude_value value{row.default_value, row.default_text};
    for (const auto& [name, wanted] : given) {
      if (name == row.name) value = wanted;
    }
    values.push_back(value);
  }
  return create_model<similitude_effect_functions>(entry, air_bed(), values);
}

GivenValue given(const char* name, double value) { return {name, "", value, 0, {}}; }

ModelScene box_scene() {
  ModelScene scene;
  scene.cell = {2e-3, 2e-3, 2e-3};
  scene.size = {12e-3, 8e-3, 16e-3};
  scene.gas_density = k_gas_density;
  scene.gas_viscosity = k_gas_viscosity;
  ParticleClass type;
  type.name = "beads";
  type.diameter = type.drag_diameter = type.material_diameter = k_diameter;
  type.density = k_density;
  scene.particles = {type};
  return scene;
}

ModelScene hot_scene(double gas_temperature, double particle_temperature) {
  ModelScene scene = box_scene();
  scene.gas_values = {given("temperature", gas_temperature), given("heat_capacity", k_gas_heat_capacity),
                      given("conductivity", k_gas_conductivity)};
  scene.particles[0].values = {given("temperature", particle_temperature), given("heat_capacity", k_heat_capacity),
                               given("conductivity", k_conductivity)};
  return scene;
}

/// Everything around a plan, at rest.
struct Bed {
  Bed(const ModelScene& bed, std::vector<EffectModel> with, bool coupled)
      : scene(bed), grid(scene), effects(std::move(with)), plan(plan_scalars(scene, effects)), exchange(scene, grid, plan, coupled),
        particles(StoreFields{.rotation = false, .coupling = true}) {
    const std::size_t cells = grid.cell_count();
    gas.velocity.assign(3 * cells, 0.0);
    for (int a = 0; a < 3; ++a) gas.flux[static_cast<std::size_t>(a)].assign(grid.face_count(a), 0.0);
    fields.gas_fraction.assign(cells, 1.0);
    fields.gas_fraction_old.assign(cells, 1.0);
  }
  void add(double x, double y, double z) {
    particles.add(particles.size(), 0, x, y, z, k_diameter / 2, sphere_mass());
  }
  void scatter(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.05, 0.95);
    for (int n = 0; n < count; ++n) add(share(random) * scene.size[0], share(random) * scene.size[1], share(random) * scene.size[2]);
  }
  void start() { exchange.start(particles, gas, fields.gas_fraction); }
  void advance(double dt) { exchange.advance(particles, gas, fields, dt); }
  double particle(std::size_t row) const { return particles.scalars[0].value[row]; }

  ModelScene scene;
  Grid grid;
  std::vector<EffectModel> effects;
  ScalarPlan plan;
  ScalarExchange exchange;
  ParticleStore particles;
  GasFields gas;
  ExchangeFields fields;
};

std::vector<EffectModel> heat(const char* transfer = "ranz_marshall") {
  std::vector<EffectModel> effects;
  effects.push_back(effect_of(SIMILITUDE_HEAT_FILE, "heat", {{"transfer", {0, transfer}}}));
  return effects;
}

// A sphere in a gas at rest, Nu = 2: dT/dt = (T_gas - T)/tau, tau = rho c d^2 / (12 k).
TEST(Heat, HeatsASphereExponentially) {
  Bed bed(hot_scene(400, 300), heat(), false);
  bed.add(5e-3, 4e-3, 8e-3);
  bed.start();
  const double tau = k_density * k_heat_capacity * k_diameter * k_diameter / (12 * k_gas_conductivity);
  constexpr int k_steps = 1000;
  for (int n = 0; n < k_steps; ++n) bed.advance(tau / k_steps);
  EXPECT_NEAR(bed.particle(0), 400 - 100 * std::exp(-1.0), 100 * 0.5 / k_steps);          // first order in the step
  EXPECT_NEAR(bed.particle(0), 400 - 100 * std::pow(1 + 1.0 / k_steps, -k_steps), 1e-9);  // and no other error
}

// The same for a row with a diameter and a density of its own: tau = m c / (2 pi d k), and the books count its mass.
TEST(Heat, HeatsASphereThatIsNotLikeItsClass) {
  Bed bed(hot_scene(400, 300), heat(), false);
  const double diameter = 2 * k_diameter, mass = 24 * sphere_mass();   // three times the density
  bed.particles.add(0, 0, 5e-3, 4e-3, 8e-3, diameter / 2, mass);
  bed.start();
  const double tau = mass * k_heat_capacity / (2 * std::numbers::pi * diameter * k_gas_conductivity);
  constexpr int k_steps = 1000;
  for (int n = 0; n < k_steps; ++n) bed.advance(tau / k_steps);
  const double rise = 100 * (1 - std::pow(1 + 1.0 / k_steps, -k_steps));
  EXPECT_NEAR(bed.particle(0) - 300, rise, 1e-9 * rise);
  EXPECT_NEAR(bed.exchange.particle_amount(0, bed.particles), mass * k_heat_capacity * rise, 1e-9 * mass * k_heat_capacity * rise);
}

TEST(Heat, NeverOvershootsHoweverLongTheStep) {
  Bed bed(hot_scene(400, 300), heat(), false);
  bed.add(5e-3, 4e-3, 8e-3);
  bed.start();
  bed.advance(1e6);
  EXPECT_GT(bed.particle(0), 399.9);
  EXPECT_LE(bed.particle(0), 400);
}

// Gunn (1978), eq. 7, by hand at eps 0.4, Re 10, Pr 0.7; 2 of a sphere in a gas at rest.
TEST(Heat, HasGunnsNusseltNumber) {
  const auto nusselt = [](const char* transfer, double fraction, double reynolds) {
    ModelScene scene = hot_scene(400, 300);
    scene.gas_values[2].value = k_gas_viscosity * k_gas_heat_capacity / 0.7;   // Pr = 0.7
    Bed bed(scene, heat(transfer), false);
    bed.add(5e-3, 4e-3, 8e-3);
    bed.start();
    std::fill(bed.fields.gas_fraction.begin(), bed.fields.gas_fraction.end(), fraction);
    bed.particles.gas[0] = {reynolds * k_gas_viscosity / (fraction * k_gas_density * k_diameter), 0, 0, 0};
    const double dt = 1e-6;
    bed.advance(dt);
    const double received = sphere_mass() * k_heat_capacity * (bed.particle(0) - 300);   // [J]
    return received / (dt * 100 * std::numbers::pi * k_diameter * scene.gas_values[2].value);
  };
  const double third = std::cbrt(0.7);
  const double gunn = 3.8 * (1 + 0.7 * std::pow(10, 0.2) * third) + 0.562 * std::pow(10, 0.7) * third;
  EXPECT_NEAR(nusselt("gunn", 0.4, 10), gunn, 1e-5 * gunn);   // the implicit share of a step of 1e-6 s
  EXPECT_NEAR(nusselt("gunn", 1, 0), 2, 2e-5);
  EXPECT_NEAR(nusselt("ranz_marshall", 1, 100), 2 + 0.6 * 10 * third, 1e-4);
}

// Cold beads in a closed box of hot gas: what the gas loses they gain, whatever the step.
TEST(Heat, ClosesTheEnergyOfGasAndParticles) {
  for (const double dt : {1e-5, 1e-2}) {
    Bed bed(hot_scene(900, 300), heat("gunn"), true);
    bed.scatter(300);
    std::fill(bed.fields.gas_fraction.begin(), bed.fields.gas_fraction.end(), 0.6);
    bed.fields.gas_fraction_old = bed.fields.gas_fraction;
    bed.start();
    for (int n = 0; n < 20; ++n) bed.advance(dt);
    const double gas = bed.exchange.gas_amount(0, bed.gas, bed.fields.gas_fraction), solids = bed.exchange.particle_amount(0, bed.particles);
    EXPECT_GT(solids, 0);
    EXPECT_NEAR(gas + solids, 0, 1e-11 * solids) << dt;
    EXPECT_NEAR(bed.exchange.totals()[0].exchanged, gas, 1e-11 * solids);
  }
}

// H = 2 k a, a^2 = delta R*: two spheres of one material approach each other with the rate 2 H / (m c).
TEST(Heat, ConductsBetweenTwoTouchingSpheres) {
  Bed bed(hot_scene(300, 300), heat(), false);
  const double overlap = 1e-3 * k_diameter;
  bed.add(5e-3, 4e-3, 8e-3);
  bed.add(5e-3 + k_diameter - overlap, 4e-3, 8e-3);
  bed.start();
  bed.particles.scalars[0].value[0] = 400;
  ContactFlows flows(bed.scene, bed.plan);
  TouchingContacts touching;
  touching.owner = {0};
  touching.partner = {1};
  const double h = 2 * k_conductivity * std::sqrt(overlap * k_diameter / 4);   // [W/K]
  const double tau = sphere_mass() * k_heat_capacity / (2 * h);
  constexpr int k_steps = 2000;
  for (int n = 0; n < k_steps; ++n) flows.apply(bed.particles, touching, tau / k_steps);
  EXPECT_NEAR(bed.particle(0) - bed.particle(1), 100 * std::exp(-1.0), 100 * 0.5 / k_steps);   // first order in the step
  EXPECT_NEAR(bed.particle(0) + bed.particle(1), 700, 1e-10);
}

TEST(Heat, FlowsFromAHotWallAndNotFromAnInsulatedOne) {
  const auto heated = [](bool hot) {
    ModelScene scene = hot_scene(300, 300);
    if (hot) scene.wall_values = {given("temperature", 500)};
    Bed bed(scene, heat(), false);
    bed.add(0.499 * k_diameter, 4e-3, 8e-3);
    bed.start();
    ContactFlows flows(bed.scene, bed.plan);
    TouchingContacts touching;
    touching.owner = {0};
    touching.partner = {ContactLists::k_surface_key | 0};
    const double dt = 1e-3;
    flows.apply(bed.particles, touching, dt);
    const double received = sphere_mass() * k_heat_capacity * (bed.particle(0) - 300);
    EXPECT_NEAR(received, flows.from_walls()[0], 1e-12 + 1e-6 * received);
    return received / dt;
  };
  const double circle = std::sqrt(1e-3 * k_diameter * k_diameter / 2);
  EXPECT_NEAR(heated(true), 4 * k_conductivity * circle * 200, 1e-6 * 4 * k_conductivity * circle * 200);
  EXPECT_EQ(heated(false), 0);
}

// A plate has no temperature: neither for the gas nor for what lies on it.
TEST(Heat, DoesNotFlowFromABaffle) {
  ModelScene scene = hot_scene(300, 300);
  scene.wall_values = {given("temperature", 500)};
  Baffle plate;
  plate.name = "plate";
  plate.normal = Axis::x;
  plate.position = 6e-3;
  plate.extent = {Interval{6e-3, 6e-3}, Interval{0, scene.size[1]}, Interval{0, scene.size[2]}};
  scene.baffles = {plate};
  Bed bed(scene, heat(), false);
  bed.add(6e-3 + 0.499 * k_diameter, 4e-3, 8e-3);
  bed.start();
  const Surfaces surfaces(scene);
  std::uint32_t baffle = 0;
  while (!surfaces.is_baffle(baffle)) ++baffle;
  SurfaceTouch touch;
  ASSERT_TRUE(surfaces.nearest(baffle, bed.particles.position[0], touch));
  ASSERT_LT(touch.distance, bed.particles.position[0].w);
  ContactFlows flows(bed.scene, bed.plan);
  TouchingContacts touching;
  touching.owner = {0};
  touching.partner = {ContactLists::k_surface_key | baffle};
  flows.apply(bed.particles, touching, 1e-3);
  EXPECT_EQ(bed.particle(0), 300);
  EXPECT_EQ(flows.from_walls()[0], 0);
}

TEST(Heat, SaysWhatACaseMustGive) {
  ModelScene scene = hot_scene(400, 300);
  scene.particles[0].values.erase(scene.particles[0].values.begin() + 1);
  const std::vector<EffectModel> effects = heat();
  try {
    plan_scalars(scene, effects);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "models.effects: heat needs scene.particles.beads.heat_capacity (heat capacity of the particles' material).\n"
                 "  Add scene.particles.beads.heat_capacity, in J/(kg K).");
  }
}

// ------------------------------------------------------------------------------------------------------ oxygen carrier

constexpr double k_hot = 1173, k_oxygen_capacity = 0.084;   // [K] [-]

std::vector<EffectModel> carrier(const char* oxide, const char* gas) {
  std::vector<EffectModel> effects;
  effects.push_back(effect_of(SIMILITUDE_CARRIER_FILE, "oxygen_carrier",
                              {{"carrier", {0, oxide}}, {"gas", {0, gas}}, {"temperature", {k_hot, nullptr}}}));
  return effects;
}

ModelScene carrier_scene(const char* gas, double fraction, double conversion) {
  ModelScene scene = box_scene();
  scene.gas_values = {given(gas, fraction)};
  scene.particles[0].values = {given("conversion", conversion), given("oxygen_capacity", k_oxygen_capacity)};
  return scene;
}

/// [s], tau = rho_m r_g / (b k C^n).
double conversion_time(oxygen_carrier::Carrier oxide, oxygen_carrier::Gas gas, double fraction) {
  const auto kinetics = oxygen_carrier::kinetics(oxide, gas);
  const auto grain = oxygen_carrier::grain(oxide, gas);
  const auto stoichiometry = oxygen_carrier::stoichiometry(oxide, gas);
  const double k = kinetics.k0 * std::exp(-kinetics.activation_energy / (8.314462618 * k_hot));
  const double concentration = fraction * k_gas_density / stoichiometry.molar_mass;
  return grain.molar_density * grain.length / (stoichiometry.solid_per_gas * k * std::pow(concentration, kinetics.order));
}

// t/tau = 1 - (1 - X)^(1/3) of spherical grains, in a gas that stays the same.
TEST(OxygenCarrier, ConvertsSphericalGrainsInTheTimeOfTheShrinkingCore) {
  Bed bed(carrier_scene("fuel", 0.3, 0), carrier("NiO", "CH4"), false);
  bed.add(5e-3, 4e-3, 8e-3);
  bed.start();
  const double tau = conversion_time(oxygen_carrier::Carrier::nickel, oxygen_carrier::Gas::methane, 0.3);
  for (int n = 1; n <= 120; ++n) {
    bed.advance(tau / 100);
    const double core = std::max(0.0, 1 - n / 100.0);
    EXPECT_NEAR(bed.particle(0), 1 - core * core * core, 1e-12) << n;
  }
}

// t/tau = X of plates.
TEST(OxygenCarrier, ConvertsPlatesEvenly) {
  Bed bed(carrier_scene("oxygen", 0.21, 1), carrier("CuO", "O2"), false);
  bed.add(5e-3, 4e-3, 8e-3);
  bed.start();
  const double tau = conversion_time(oxygen_carrier::Carrier::copper, oxygen_carrier::Gas::oxygen, 0.21);
  for (int n = 1; n <= 12; ++n) {
    bed.advance(tau / 10);
    EXPECT_NEAR(bed.particle(0), std::max(0.0, 1 - n / 10.0), 1e-12) << n;
  }
}

// CH4 + 4 O: a kilogram of oxygen given off burns 16.043/(4 15.999) kg of methane.
TEST(OxygenCarrier, ClosesTheBudgetOfTheSpecies) {
  Bed bed(carrier_scene("fuel", 0.3, 0.1), carrier("Fe2O3", "CH4"), true);
  bed.scatter(300);
  std::fill(bed.fields.gas_fraction.begin(), bed.fields.gas_fraction.end(), 0.6);
  bed.fields.gas_fraction_old = bed.fields.gas_fraction;
  bed.start();
  const double tau = conversion_time(oxygen_carrier::Carrier::iron, oxygen_carrier::Gas::methane, 0.3);
  for (int n = 0; n < 50; ++n) bed.advance(tau / 200);
  const double fuel = bed.exchange.gas_amount(0, bed.gas, bed.fields.gas_fraction), given_off = bed.exchange.particle_amount(0, bed.particles);
  EXPECT_GT(given_off, 0);
  EXPECT_NEAR(-fuel, given_off * 16.043 / (4 * 15.999), 1e-11 * given_off);
  for (const double fraction : bed.gas.scalars[0].value) EXPECT_GE(fraction, 0);
}

TEST(OxygenCarrier, CarriesOnlyTheGasThatReacts) {
  Bed bed(carrier_scene("oxygen", 0.21, 1), carrier("NiO", "O2"), true);
  ASSERT_EQ(bed.plan.gas.size(), 1u);
  EXPECT_EQ(bed.plan.gas[0].name, "oxygen");
}

TEST(Scalars, HaveTheSameBitsForAnyNumberOfThreads) {
  const auto run_with = [](int threads) {
    omp_set_num_threads(threads);
    Bed bed(hot_scene(900, 300), heat("gunn"), true);
    bed.scatter(2000);
    bed.start();
    for (int n = 0; n < 5; ++n) bed.advance(1e-3);
    return std::pair(bed.particles.scalars[0].value, bed.gas.scalars[0].value);
  };
  const int threads = omp_get_max_threads();
  const auto one = run_with(1), four = run_with(4);
  omp_set_num_threads(threads);
  EXPECT_EQ(one, four);
}

// ------------------------------------------------------------------------------------------------------------ turbulence

// mu_t = rho (C_s Delta)^2 |du/dy| in a simple shear.
TEST(SubgridTurbulence, HasSmagorinskysViscosityInASimpleShear) {
  ModelScene scene = box_scene();
  scene.cell = {1e-3, 2e-3, 4e-3};
  const Grid grid(scene);
  const EffectModel effect = effect_of(SIMILITUDE_TURBULENCE_FILE, "subgrid_turbulence", {{"smagorinsky", {0.1, nullptr}}});
  const CellPass pass(scene, grid, effect);
  const std::size_t cells = grid.cell_count();
  GasFields gas;
  gas.velocity.assign(3 * cells, 0.0);
  gas.added_viscosity.assign(cells, 0.0);
  const Column<double> fraction(cells, 1.0);
  constexpr double k_rate = 250;   // [1/s]
  for (int k = 0; k < grid.cells(2); ++k) {
    for (int j = 0; j < grid.cells(1); ++j) {
      for (int i = 0; i < grid.cells(0); ++i) gas.velocity[grid.cell(i, j, k)] = k_rate * (j + 0.5) * 2e-3;
    }
  }
  pass.apply(gas, fraction, 0);
  const double length = 0.1 * 2e-3;   // the cube root of 1 x 2 x 4 mm
  EXPECT_NEAR(gas.added_viscosity[grid.cell(5, 2, 2)], k_gas_density * length * length * k_rate, 1e-9 * k_gas_density * length * length * k_rate);
}

}  // namespace
}  // namespace similitude
