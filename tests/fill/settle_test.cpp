/// Beds that settle: dense, level, at rest, the same every time.

#include <gtest/gtest.h>
#include <omp.h>

#include "bed_of_springs.h"
#include "particles/engine.h"
#include "particles/errors.h"
#include "particles/lattice.h"
#include "particles/settle.h"
#include "scene/messages.h"

namespace similitude::test {
namespace {

/// Two plates across the depth that leave channels of 3, 2 and 3 mm.
ModelScene bed_with_plates(std::int64_t count) {
  ModelScene scene = small_bed(count);
  scene.size = {16e-3, 5e-3, 60e-3};
  for (const double x : {6e-3, 10e-3}) {
    Baffle plate;
    plate.name = "plate";
    plate.normal = Axis::x;
    plate.position = x;
    plate.thickness = 0.4e-3;
    plate.extent = {Interval{x, x}, Interval{0, scene.size[1]}, Interval{4e-3, 40e-3}};
    scene.baffles.push_back(plate);
  }
  return scene;
}

TEST(Settle, GivesADenseBedAtRestOfTheWantedCount) {
  const ModelScene scene = small_bed(800);
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  const FilledBed bed = fill_bed(particles, scene, law, options_for(scene));
  EXPECT_EQ(particles.size(), 800u);
  EXPECT_FALSE(bed.from_cache);
  // Walls 5 and 8 diameters apart loosen the packing: slow pouring gives 0.55 to 0.60 here, 0.56 to 0.62 in wide beds.
  EXPECT_GT(bed.solids_fraction, 0.54);
  EXPECT_LT(bed.solids_fraction, 0.62);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    EXPECT_EQ(particles.id[p], p);
    EXPECT_EQ(particles.velocity[p].z, 0);
    EXPECT_GT(particles.position[p].z, 0.4e-3);
  }
}

// A bed at rest stays at rest: released under its own law without any brake, friction forgotten.
TEST(Settle, LeavesABedThatStaysAtRest) {
  const ModelScene scene = small_bed(400);
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  const FillOptions options = options_for(scene);
  const FilledBed before = fill_bed(particles, scene, law, options);
  Engine engine(particles, scene, law, EngineOptions{.dt = options.dt, .gravity = scene.gravity});
  engine.advance(400);   // 20 contact times; particles in free fall would reach 20 times this agitation
  EXPECT_LT(agitation(particles, scene), 2e-3);
  EXPECT_NEAR(bed_height(particles, scene), before.height, 0.05e-3);
}

TEST(Settle, ReachesOneLevelInAllChannelsBetweenPlates) {
  const ModelScene scene = bed_with_plates(1500);
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  const FilledBed bed = fill_bed(particles, scene, law, options_for(scene));
  const double d = 1e-3;
  for (const Interval channel : {Interval{0, 6e-3}, Interval{6e-3, 10e-3}, Interval{10e-3, 16e-3}}) {
    EXPECT_NEAR(bed_height(particles, scene, channel), bed.height, 0.8 * d);   // a heap of one layer is no step
  }
  EXPECT_GT(bed.solids_fraction, 0.52);
}

TEST(Settle, StopsBelowAWantedHeight) {
  ModelScene scene = small_bed(0);
  scene.particles[0].count.reset();
  scene.bed.height = 9e-3;
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  const FilledBed bed = fill_bed(particles, scene, law, options_for(scene));
  double top = 0;
  for (const Row& p : particles.position) top = std::max(top, p.z + p.w);
  EXPECT_LE(top, 9e-3);
  EXPECT_GT(bed.height, 9e-3 - 0.7e-3);   // the last layer is where it is
  EXPECT_EQ(particles.id.back(), particles.size() - 1);
}

TEST(Settle, IsTheSameBitsForOneAndTwoThreads) {
  const ModelScene scene = small_bed(200);
  const ContactModel law = spring_law(k_stiffness);
  const int before = omp_get_max_threads();
  ParticleStore one = empty_store(), two = empty_store();
  omp_set_num_threads(1);
  fill_bed(one, scene, law, options_for(scene));
  omp_set_num_threads(2);
  fill_bed(two, scene, law, options_for(scene));
  omp_set_num_threads(before);
  for (std::size_t p = 0; p < one.size(); ++p) {
    ASSERT_EQ(one.position[p].x, two.position[p].x);
    ASSERT_EQ(one.position[p].z, two.position[p].z);
  }
}

TEST(Settle, DependsOnTheSeed) {
  ModelScene scene = small_bed(60);
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore a = empty_store(), b = empty_store();
  fill_bed(a, scene, law, options_for(scene));
  scene.bed.seed = 2;
  fill_bed(b, scene, law, options_for(scene));
  EXPECT_NE(a.position[0].x, b.position[0].x);
}

TEST(Settle, MixesClassesOfTheWantedCounts) {
  ModelScene scene = small_bed(150);
  scene.particles.push_back(scene.particles[0]);
  scene.particles[1].diameter = 1.5e-3;
  scene.particles[1].count = 40;
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  fill_bed(particles, scene, law, options_for(scene));
  int large = 0, large_in_lower_half = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    large += particles.species[p] == 1;
    large_in_lower_half += particles.species[p] == 1 && p < particles.size() / 2;
    EXPECT_EQ(particles.position[p].w, particles.species[p] == 1 ? 0.75e-3 : 0.5e-3);
  }
  EXPECT_EQ(large, 40);
  EXPECT_GT(large_in_lower_half, 10);
  EXPECT_LT(large_in_lower_half, 30);
}

TEST(Settle, ReportsProgressThatEndsAtOne) {
  const ModelScene scene = small_bed(60);
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  FillOptions options = options_for(scene);
  double last = -1;
  std::vector<std::string> stages;
  options.progress = [&](double fraction, const std::string& stage) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    last = fraction;
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
  };
  fill_bed(particles, scene, law, options);
  EXPECT_EQ(last, 1);
  EXPECT_EQ(stages.front(), "parting neighbours");
  EXPECT_EQ(stages.back(), "coming to rest");
}

template <class Action>
std::string refusal(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Settle, RefusesMoreParticlesThanTheDomainHolds) {
  ModelScene scene = small_bed(20000);
  scene.bed.mark = {"case.yaml", 9, 3};
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  const std::string text = refusal([&] { fill_bed(particles, scene, law, options_for(scene)); });
  EXPECT_EQ(text.rfind("case.yaml:9:3: scene.bed: the particles do not fit: they need a height of about ", 0), 0u) << text;
  EXPECT_NE(text.find(" mm, the simulated domain has 60 mm.\n  Fewer particles, or a higher domain."), std::string::npos) << text;
}

TEST(Settle, RefusesParticlesLargerThanTheDomain) {
  ModelScene scene = small_bed(20);
  scene.particles[0].diameter = 6e-3;
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  EXPECT_EQ(refusal([&] { fill_bed(particles, scene, law, options_for(scene)); }),
            "scene.bed: particles alumina of 6 mm do not fit into a domain that is 5 mm wide along y (simulated bed).\n"
            "  Smaller particles, a milder scaling, or a larger domain.");
}

TEST(Settle, RefusesABedWithoutGravity) {
  ModelScene scene = small_bed(20);
  scene.gravity = {0, 0, 0};
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  EXPECT_EQ(refusal([&] { fill_bed(particles, scene, law, options_for(scene)); }),
            "scene.bed: a bed settles under gravity, but gravity does not point down.\n"
            "  Write bed: {fill: lattice}, or give scene.gravity a negative third value.");
}

// All lengths, times and masses in powers of two: the settled bed must be the same to the bit, or a constant has crept in.
TEST(Settle, ABedScaledByPowersOfTwoHasTheSameBits) {
  const double length = 0.25, time = 0.5, density = 2;   // lengths over times squared: gravity stays
  const ModelScene real = bed_with_plates(300);
  ModelScene scaled = real;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    scaled.size[axis] *= length;
    for (Baffle& plate : scaled.baffles) {
      plate.extent[axis].low *= length;
      plate.extent[axis].high *= length;
    }
  }
  for (Baffle& plate : scaled.baffles) plate.position *= length, plate.thickness *= length;
  scaled.particles[0].diameter *= length;
  scaled.particles[0].density *= density;
  const double stiffness = density * length * length * length / (time * time);
  FillOptions options = options_for(real);
  const ContactModel law = spring_law(k_stiffness), scaled_law = spring_law(k_stiffness * stiffness);
  ParticleStore a = empty_store(), b = empty_store();
  fill_bed(a, real, law, options);
  options.dt *= time;
  options.softer_law = [&](double factor) { return spring_law(k_stiffness * stiffness * factor); };
  fill_bed(b, scaled, scaled_law, options);
  for (std::size_t p = 0; p < a.size(); ++p) {
    ASSERT_EQ(a.position[p].x * length, b.position[p].x);
    ASSERT_EQ(a.position[p].z * length, b.position[p].z);
  }
}

TEST(Lattice, HasNoOverlapsAndIsClearOfPlates) {
  ModelScene scene = bed_with_plates(900);
  scene.bed.kind = FillKind::lattice;
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  fill_bed(particles, scene, law, options_for(scene));
  ASSERT_EQ(particles.size(), 900u);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Row& a = particles.position[p];
    for (std::size_t q = 0; q < p; ++q) {
      const Row& b = particles.position[q];
      ASSERT_GT(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z), 1e-3);
    }
    ASSERT_GE(std::min({a.x, a.y, a.z, 16e-3 - a.x, 5e-3 - a.y}), 0.5e-3);
    if (a.z > 4e-3) {
      ASSERT_GE(std::min(std::abs(a.x - 6e-3), std::abs(a.x - 10e-3)), 0.5e-3 + 0.2e-3 - 1e-12);
    }
  }
}

TEST(Lattice, SaysHowManyPlacesThereAre) {
  ModelScene scene = small_bed(50000);
  scene.bed.kind = FillKind::lattice;
  const ContactModel law = spring_law(k_stiffness);
  ParticleStore particles = empty_store();
  const std::string text = refusal([&] { fill_bed(particles, scene, law, options_for(scene)); });
  EXPECT_EQ(text.rfind("scene.bed: the lattice of the simulated domain has ", 0), 0u) << text;
  EXPECT_NE(text.find(" places for 50000 particles.\n  Fewer particles, a higher domain, or bed: {fill: settle}, which packs "
                      "more densely."),
            std::string::npos)
      << text;
}

TEST(Lattice, CounterRandomIsUniformAndHasNoState) {
  double sum = 0, squares = 0;
  const int count = 20000;
  for (std::uint64_t n = 0; n < count; ++n) {
    const double u = counter_random(5, n, 1);
    EXPECT_GE(u, 0);
    EXPECT_LT(u, 1);
    sum += u;
    squares += u * u;
  }
  // Four standard errors: 4 sqrt(1/12/n) and 4 sqrt(4/45/n).
  EXPECT_NEAR(sum / count, 0.5, 0.0082);
  EXPECT_NEAR(squares / count, 1.0 / 3, 0.0085);
  EXPECT_EQ(counter_random(5, 17, 1), counter_random(5, 17, 1));
  EXPECT_NE(counter_random(5, 17, 1), counter_random(6, 17, 1));
}

TEST(BedLevel, SolidsFractionCountsTheCapsBelowAPlane) {
  const ModelScene scene = small_bed(1);
  ParticleStore particles = empty_store();
  particles.add(0, 0, 4e-3, 2e-3, 1e-3, 0.5e-3, 1e-6);
  const double half_sphere = 2.0 / 3 * 3.141592653589793 * std::pow(0.5e-3, 3);
  EXPECT_NEAR(solids_fraction_below(particles, scene, 1e-3), half_sphere / (8e-3 * 5e-3 * 1e-3), 1e-12);
  EXPECT_EQ(solids_fraction_below(particles, scene, 0), 0);
  EXPECT_EQ(bed_height(empty_store(), scene), 0);
}

}  // namespace
}  // namespace similitude::test
