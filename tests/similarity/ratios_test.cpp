#include <gtest/gtest.h>

#include "beds.h"
#include "scene/messages.h"

namespace similitude {
namespace {

using testing::exact_quarter;
using testing::similar;
using testing::spouted_bed;
using testing::terminal_velocity_law;

/// Every number of a scene that scaling touches, with a name, so that two beds can be compared in one loop.
template <class Bed>
std::vector<std::pair<std::string, double>> numbers(const Scene<Bed>& scene) {
  std::vector<std::pair<std::string, double>> all;
  const auto add = [&](const std::string& name, double value) { all.emplace_back(name, value); };
  for (int a = 0; a < 3; ++a) {
    const auto i = static_cast<std::size_t>(a);
    add("size", scene.size[i]);
    add("cell", scene.cell[i]);
    add("gravity", scene.gravity[i]);
  }
  add("gas_density", scene.gas_density);
  add("gas_viscosity", scene.gas_viscosity);
  for (const ParticleClass& p : scene.particles) {
    add("diameter", p.diameter);
    add("drag_diameter", p.drag_diameter);
    add("material_diameter", p.material_diameter);
    add("density", p.density);
    add("weight", p.weight);
    add("count", static_cast<double>(p.count.value_or(0)));
  }
  add("height", scene.bed.height.value_or(0));
  for (const Patch& p : scene.patches) {
    for (const Interval& e : p.extent) {
      add("patch low", e.low);
      add("patch high", e.high);
    }
    add("velocity", p.velocity);
    add("ramp", p.ramp);
    add("pressure", p.pressure);
  }
  for (const Baffle& b : scene.baffles) {
    for (const Interval& e : b.extent) {
      add("baffle low", e.low);
      add("baffle high", e.high);
    }
    add("position", b.position);
    add("thickness", b.thickness);
  }
  add("smoothing", scene.smoothing_length.value_or(0));
  for (const ModelChoice* m : {&scene.models.drag, &scene.models.contact, &scene.models.fluid, &scene.models.scaling})
    for (const ModelParameter& p : m->parameters) add(p.name, std::isnan(p.real) ? -1 : p.real);
  add("end", scene.time.end);
  add("dt", scene.time.dt.value_or(0));
  add("gas_dt", scene.time.gas_dt.value_or(0));
  add("vtk", scene.output.vtk_every);
  add("monitors", scene.output.monitor_every);
  add("from", scene.output.profiles.from);
  for (const double z : scene.output.profiles.z) add("profile z", z);
  return all;
}

RealScene full_bed() {
  return spouted_bed({"time.dt=1.3 us", "time.gas_dt=13 us", "coupling.smoothing=8.5 mm",
                      "scene.patches.outlet.pressure=7 Pa", "models.contact.youngs_modulus=70 GPa"});
}

TEST(SimulatedBed, OfTheIdentityIsTheRealBedBitForBit) {
  const RealScene real = full_bed();
  const auto before = numbers(real), after = numbers(simulated_bed(real, identity_ratios()));
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].second, after[i].second) << before[i].first;
}

// Ratios that are powers of two change exponents only; with them a scaled run can repeat the real one's bits.
TEST(SimulatedBed, AtPowersOfTwoKeepsEveryMantissa) {
  const RealScene real = full_bed();
  const auto before = numbers(real), after = numbers(simulated_bed(real, exact_quarter()));
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    int unused;
    EXPECT_EQ(std::frexp(before[i].second, &unused), std::frexp(after[i].second, &unused)) << before[i].first;
  }
}

TEST(SimulatedBed, ScalesEachQuantityByItsOwnRatio) {
  const RealScene real = full_bed();
  similitude_ratios ratios = identity_ratios();  // all different, so that no two can be mixed up
  ratios.length = 0.5;
  ratios.diameter = 0.625;
  ratios.drag_diameter = 0.75;
  ratios.particle_density = 1.25;
  ratios.gas_density = 1.5;
  ratios.gas_viscosity = 1.75;
  ratios.velocity = 0.875;
  ratios.time = 0.375;
  ratios.stiffness = 3;
  ratios.modulus = 5;
  ratios.parcel_weight = 7;
  const ModelScene bed = simulated_bed(real, ratios);
  const double pressure = result_ratios(real, ratios).pressure;

  EXPECT_EQ(bed.size[2], 0.5);
  EXPECT_EQ(bed.cell[0], 0.0025);
  EXPECT_EQ(bed.gravity, real.gravity);
  EXPECT_EQ(bed.gas_density, 1.5 * 1.225);
  EXPECT_EQ(bed.gas_viscosity, 1.75 * 1.79e-5);
  EXPECT_EQ(bed.particles[0].diameter, 0.625e-3);
  EXPECT_EQ(bed.particles[0].drag_diameter, 0.75e-3);
  EXPECT_EQ(bed.particles[0].material_diameter, 0.5e-3);  // shown as 1 mm once divided by the length ratio
  EXPECT_EQ(bed.particles[0].density, 1300);
  EXPECT_EQ(bed.particles[0].weight, 7);
  EXPECT_EQ(bed.particles[0].count, std::llround(461000 * 0.512));
  EXPECT_EQ(bed.patches[0].extent[0].high, 0.04);
  EXPECT_EQ(bed.patches[0].velocity, 13.2 * 0.875);
  EXPECT_EQ(bed.patches[0].ramp, 0.05 * 0.375);
  EXPECT_EQ(bed.patches[2].extent[2].low, 0.5);
  EXPECT_EQ(bed.patches[2].pressure, 7 * pressure);
  EXPECT_EQ(bed.baffles[1].position, 0.045);
  EXPECT_EQ(bed.baffles[1].thickness, 0.001);
  EXPECT_EQ(bed.smoothing_length, 0.0085 * 0.5);
  EXPECT_EQ(bed.time.end, 5 * 0.375);
  EXPECT_EQ(bed.time.dt, 1.3e-6 * 0.375);
  EXPECT_EQ(bed.time.gas_dt, 13e-6 * 0.375);
  EXPECT_EQ(bed.output.vtk_every, 0.05 * 0.375);
  EXPECT_EQ(bed.output.monitor_every, 0.01 * 0.375);
  EXPECT_EQ(bed.output.profiles.from, 0.375);
  EXPECT_EQ(bed.output.profiles.z[1], 0.15);

  const std::vector<ModelParameter>& contact = bed.models.contact.parameters;
  EXPECT_EQ(contact[0].real, 1500);          // stiffness
  EXPECT_EQ(contact[1].real, 0.74);          // restitution: a pure number
  EXPECT_EQ(contact[3].real, 0.875);         // a speed
  EXPECT_EQ(contact[4].real, 350e9);         // a modulus
  EXPECT_EQ(contact[5].real, 2e-6 * 0.625);  // a length of particle size
  EXPECT_EQ(contact[6].real, 5e-3 * 0.5);    // a length of the bed
  EXPECT_EQ(contact[7].real, 0.25 * 0.375);  // a time
}

TEST(SimulatedBed, ScalesTheParametersOfEachPairOfMaterials) {
  const RealScene real = spouted_bed({"models.contact.pair={alumina-alumina: {glide_speed: 2 m/s}, alumina-wall: {stiffness: 800 N/m}}"});
  similitude_ratios ratios = identity_ratios();
  ratios.stiffness = 3;
  ratios.velocity = 0.875;
  const ModelScene bed = simulated_bed(real, ratios);
  ASSERT_EQ(bed.models.contact_pairs.size(), 2u);
  const std::vector<ModelParameter>&grain = bed.models.contact_pairs[0].parameters, &wall = bed.models.contact_pairs[1].parameters;
  EXPECT_EQ(grain[0].real, 1500);       // stiffness, common
  EXPECT_EQ(wall[0].real, 2400);        // its own
  EXPECT_EQ(grain[1].real, 0.74);       // restitution: a pure number
  EXPECT_EQ(grain[3].real, 1.75);       // a speed, its own
  EXPECT_EQ(wall[3].real, 0.875);       // the default
}

TEST(SimulatedBed, LeavesOutWhatWasLeftOut) {
  const ModelScene bed = simulated_bed(spouted_bed(), exact_quarter());
  EXPECT_FALSE(bed.smoothing_length);
  EXPECT_FALSE(bed.time.dt);
  EXPECT_TRUE(std::isnan(bed.models.contact.parameters[4].real));
}

TEST(SimulatedBed, TakesASimulatedStiffnessAsItIs) {
  const ModelScene bed = simulated_bed(spouted_bed({"models.scaling.stiffness=61 N/m"}), exact_quarter());
  EXPECT_EQ(bed.models.contact.parameters[0].real, 61);
}

// Grains for 8 particles each, in the real gas: molecules of that gas do not diffuse faster for it. In a bed of another size and
// viscosity they do as the viscosity: with n = r and mu* = r^(3/2), as nu* = L^2/t.
TEST(SimulatedBed, ScalesADiffusivityByWhatTheGasMeets) {
  RealScene real = spouted_bed();
  real.models.effects.push_back({"effect", "carrier", {{"diffusivity", 2e-5, "", SIMILITUDE_SCALES_AS_DIFFUSIVITY, true}}, {}});
  similitude_ratios parcels = identity_ratios();
  parcels.diameter = 2;
  parcels.parcel_weight = 8;
  EXPECT_EQ(simulated_bed(real, parcels).models.effects[0].parameters[0].real, 2e-5);
  EXPECT_EQ(simulated_bed(real, exact_quarter()).models.effects[0].parameters[0].real, 2e-5 / 8);
}

// Table 1 of the u_t law, recomputed: n = 0.70787, rho_f = 3.4611 (printed 0.708, 3.461); N = 461 000 (r/n)^3 = 20 308,
// and 20 297 with n rounded to 0.708.
TEST(SimulatedBed, OfTheTerminalVelocityLawHasTheKnownNumbers) {
  const RealScene real = spouted_bed();
  const ModelScene bed = simulated_bed(real, terminal_velocity_law(0.25, 1040, 1.225));
  EXPECT_NEAR(bed.particles[0].diameter * 1e3, 0.70787, 5e-6);  // half of the last digit given
  EXPECT_NEAR(bed.gas_density, 3.4611, 5e-5);
  EXPECT_EQ(bed.particles[0].count, 20308);
  EXPECT_EQ(simulated_bed(real, similar(0.25, 0.708, 1 / (0.708 * 0.5), 1, 1)).particles[0].count, 20297);
  EXPECT_EQ(bed.patches[0].velocity, 6.6);
  EXPECT_EQ(bed.patches[1].velocity, 0.23);
  EXPECT_EQ(bed.size[0], 0.0375);
}

TEST(SimulatedBed, RefusesRatiosThatMeanNothing) {
  similitude_ratios ratios = identity_ratios();
  ratios.velocity = 0;
  try {
    simulated_bed(spouted_bed(), ratios);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what())
            .find(
                "models.scaling: terminal_velocity gives the ratio of velocity as 0.000000, which is not above zero."),
        std::string::npos)
        << error.what();
  }
}

double restitution_of(const ModelScene& bed) {
  for (const ModelParameter& parameter : bed.models.contact.parameters)
    if (parameter.scales_as == SIMILITUDE_SCALES_AS_RESTITUTION) return parameter.real;
  ADD_FAILURE() << "no restitution";
  return 0;
}

similitude_ratios losing(double energy_loss) {
  similitude_ratios ratios = identity_ratios();
  ratios.energy_loss = energy_loss;
  return ratios;
}

// 1 - e_c^2 = l (1 - e^2): 0.74 becomes 0.5669 for l = 1.5 and 0.3085 for l = 2.
TEST(SimulatedBed, LosesMoreEnergyPerCollisionWhereALawWantsIt) {
  const RealScene real = spouted_bed();
  EXPECT_EQ(restitution_of(simulated_bed(real, losing(1))), 0.74);
  EXPECT_NEAR(restitution_of(simulated_bed(real, losing(1.5))), 0.5669, 5e-5);
  EXPECT_NEAR(restitution_of(simulated_bed(real, losing(2))), 0.3085, 5e-5);
  const RealScene glass = spouted_bed({"models.contact.restitution=0.97"});
  EXPECT_NEAR(restitution_of(simulated_bed(glass, losing(2))), 0.93904, 5e-6);
  EXPECT_NEAR(restitution_of(simulated_bed(glass, losing(4))), 0.87384, 5e-6);
  const RealScene elastic = spouted_bed({"models.contact.restitution=1"});
  EXPECT_EQ(restitution_of(simulated_bed(elastic, losing(8))), 1);
}

// With e = 0.74 a collision can lose no more than 1/(1 - e^2) = 2.21 times its real loss.
TEST(SimulatedBed, RefusesToLoseMoreEnergyThanThereIs) {
  try {
    simulated_bed(spouted_bed(), losing(2.22));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("models.scaling: terminal_velocity wants grains to lose 2.22 times as much energy per collision, but with "
                        "restitution: 0.74 nothing is left beyond 2.21 times.\n"
                        "  Choose grains of less than 2.21 diameters, or leave the restitution as it is."),
              std::string::npos)
        << error.what();
  }
}

TEST(SimulatedBed, RefusesAnotherRestitutionWithoutOne) {
  RealScene real = spouted_bed();
  for (ModelParameter& parameter : real.models.contact.parameters) parameter.scales_as = SIMILITUDE_SCALES_NOT;
  try {
    simulated_bed(real, losing(2));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("terminal_velocity wants 1 - e^2 of the restitution e changed, but the contact model linear_spring "
                        "declares none.\n"
                        "  Choose a contact model that scales a parameter as_restitution, or parameters of terminal_velocity "
                        "that leave restitution alone."),
              std::string::npos)
        << error.what();
  }
}

TEST(ScalingWarnings, SpeakWhenTheGasSeesAnotherVolumeThanMoves) {
  similitude_ratios ratios = identity_ratios();
  ratios.diameter = 2;
  ratios.parcel_weight = 6;
  const std::vector<std::string> warnings = scaling_warnings(spouted_bed(), ratios);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "models.scaling: with terminal_velocity the gas sees 0.75 times the volume of particles that moves (parcel_weight "
            "drag_diameter^3 / diameter^3).");
  ratios.parcel_weight = 8;
  EXPECT_TRUE(scaling_warnings(spouted_bed(), ratios).empty());
}

TEST(ScalingWarnings, SpeakWhenHardlyAnyEnergyIsLeft) {
  const RealScene real = spouted_bed();
  EXPECT_TRUE(scaling_warnings(real, losing(1)).empty());
  EXPECT_TRUE(scaling_warnings(real, losing(1.5)).empty());
  const std::vector<std::string> warnings = scaling_warnings(real, losing(2));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "models.scaling: terminal_velocity takes restitution from 0.74 to 0.3085: 90 % of a collision's energy is lost, and "
            "beyond 2.21 times the real loss nothing would be left.");
}

TEST(ResultRatios, MapPressureAndForceByBedWeight) {
  const RealScene real = spouted_bed();
  const similitude_ratios ratios = terminal_velocity_law(0.25, 1040, 1.225);
  const ResultRatios results = result_ratios(real, ratios);
  const double n = ratios.diameter, weight = (1040 - 1.225 * ratios.gas_density) / (1040 - 1.225);
  EXPECT_EQ(results.length, 0.25);
  EXPECT_EQ(results.time, 0.5);
  EXPECT_EQ(results.velocity, 0.5);
  EXPECT_EQ(results.angular_velocity, 2);
  EXPECT_EQ(results.diameter, n);
  EXPECT_DOUBLE_EQ(results.pressure, weight * 0.25);
  EXPECT_DOUBLE_EQ(results.force, weight * n * n * n);
  EXPECT_EQ(results.mass, 1.0 / 64);
  // The law keeps Ar at mu* = 1: p* is also rho_f* r^2 / n (the similarity family's own form).
  EXPECT_NEAR(results.pressure / (ratios.gas_density * 0.0625 / n), 1, 1e-12);
}

TEST(ResultRatios, AreExactPowersOfTwoForTheExactQuarter) {
  const ResultRatios results = result_ratios(spouted_bed(), exact_quarter());
  EXPECT_EQ(results.pressure, 0.25);
  EXPECT_EQ(results.force, 1.0 / 64);
  EXPECT_EQ(results.mass, 1.0 / 64);
}

// A parcel of 8 of twice the diameter weighs 8 particles: the force on one physical particle is the real one.
TEST(ResultRatios, CountForcesPerPhysicalParticle) {
  similitude_ratios ratios = identity_ratios();
  ratios.diameter = 2;
  ratios.parcel_weight = 8;
  EXPECT_EQ(result_ratios(spouted_bed(), ratios).force, 1);
  EXPECT_EQ(simulated_bed(spouted_bed(), ratios).particles[0].count, 57625);  // 461 000 / 8
}

TEST(ResultRatios, OfAGasAloneGoByItsDynamicPressure) {
  RealScene empty = spouted_bed();
  empty.particles.clear();
  similitude_ratios ratios = identity_ratios();
  ratios.gas_density = 3;
  ratios.velocity = 0.5;
  EXPECT_EQ(result_ratios(empty, ratios).pressure, 0.75);
}

TEST(Describe, SumsWhatAPluginNeedsToKnow) {
  const similitude_bed bed = describe(spouted_bed());
  EXPECT_EQ(bed.struct_size, sizeof(similitude_bed));
  EXPECT_EQ(bed.gravity, 9.81);
  EXPECT_EQ(bed.particle_diameter, 1e-3);
  EXPECT_EQ(bed.drag_diameter, 1e-3);
  EXPECT_EQ(bed.particle_density, 1040);
  EXPECT_EQ(bed.particle_count, 461000);
  EXPECT_EQ(bed.bed_width, 0.15);
  EXPECT_EQ(bed.bed_depth, 0.02);
  EXPECT_EQ(bed.largest_inlet_velocity, 13.2);
  // 13.2 m/s through 10 mm and 0.46 m/s through 140 mm of 150 mm.
  EXPECT_NEAR(bed.superficial_velocity, (13.2 * 10 + 0.46 * 140) / 150, 1e-12);
  // 461 000 spheres are 2.4138e-4 m^3; at a solids fraction of 0.58 on 150 mm x 20 mm.
  EXPECT_NEAR(bed.bed_height, 2.4138e-4 / (0.58 * 0.003), 1e-5);
}

TEST(Describe, CountsTheGrainsOfAGivenHeight) {
  RealScene scene = spouted_bed();
  const double height = describe(scene).bed_height;
  scene.particles[0].count.reset();
  scene.bed.height = height;
  EXPECT_EQ(describe(scene).bed_height, height);
  EXPECT_EQ(describe(scene).particle_count, 461000);
}

TEST(Describe, TheSimulatedBedIsTheRealOneScaled) {
  const RealScene real = spouted_bed();
  const similitude_bed whole = describe(real), quarter = describe(simulated_bed(real, exact_quarter()));
  EXPECT_EQ(quarter.bed_height, whole.bed_height / 4);
  EXPECT_EQ(quarter.superficial_velocity, whole.superficial_velocity / 2);
  EXPECT_EQ(quarter.particle_count, whole.particle_count);
}

}  // namespace
}  // namespace similitude
