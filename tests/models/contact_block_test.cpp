// What every contact law owes the framework: a row's bits depend on that row alone, partners swap, space has no
// preferred direction, and a bed scaled by powers of two keeps its bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "sphere_on_wall.h"

namespace similitude {
namespace {

using test::ContactColumns;
using test::ContactModel;
using test::Values;

const Values k_linear = {{"stiffness", 500}, {"restitution", 0.74}, {"friction", 0.2}};
const Values k_soft = {{"stiffness", 100}, {"restitution", 0.5}, {"friction", 0.6}, {"attraction", 1}};
const Values k_slippery = {{"stiffness", 300}, {"restitution", 0.9}, {"friction", 0}};
const Values k_fluent = {{"stiffness", 500}, {"restitution", 0.74}};
/// Soft alumina: forces like the springs'.
const Values k_hertz = {{"youngs_modulus", 1e7}, {"poisson_ratio", 0.23}, {"restitution", 0.74}, {"friction", 0.2}};
const Values k_hertz_pair = {{"youngs_modulus", 1e7}, {"poisson_ratio", 0.23}, {"restitution", 0.5}, {"friction", 0.6},
                             {"partner_youngs_modulus", 4e6}, {"partner_poisson_ratio", 0.4}};
constexpr double k_dt = 5e-6;

struct Named {
  const char* file;
  Values values;
};
const Named k_laws[] = {{LINEAR_SPRING, k_linear},   {LINEAR_SPRING, k_soft},       {LINEAR_SPRING, k_slippery}, {FLUENT_DEM, k_fluent},
                        {HERTZ_MINDLIN, k_hertz},    {HERTZ_MINDLIN, k_hertz_pair}, {HERTZ_THORNTON, k_hertz},  {HERTZ_THORNTON, k_hertz_pair}};

void evaluate(const ContactModel& law, ContactColumns& contact, bool with_pairs = false, double dt = k_dt) {
  const similitude_contact_needs needs = test::needs_of(law);
  similitude_contact_block block = contact.block(dt, needs.history_count, needs.rotation != 0, with_pairs);
  similitude_status status{};
  law.functions().forces(law.instance(), &block, &status);
  ASSERT_EQ(status.code, 0) << status.text;
}

/// Contacts of all sorts: sliding and sticking, approaching and parting, walls, fresh and old springs.
ContactColumns contacts(std::size_t rows, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1), share(0, 1);
  ContactColumns c(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    Vec3<double> n = {any(random), any(random), any(random)};
    n = (1 / std::sqrt(dot(n, n))) * n;
    c.normal.set(row, n);
    c.overlap[row] = 2e-5 * share(random);
    const double speed = std::pow(10, -3 * share(random));
    c.velocity.set(row, speed * Vec3<double>{any(random), any(random), any(random)});
    c.angular_i.set(row, {100 * any(random), 100 * any(random), 100 * any(random)});
    c.angular_j.set(row, {100 * any(random), 100 * any(random), 100 * any(random)});
    c.radius_i[row] = 5e-4 * (0.5 + share(random));
    c.radius_j[row] = row % 7 == 0 ? std::numeric_limits<double>::infinity() : 5e-4;
    c.effective_mass[row] = 3e-7 * (0.5 + share(random));
    c.pair[row] = static_cast<std::uint32_t>(random() % 3);
    const double stretch = row % 3 == 0 ? 0 : 1e-6 * share(random);
    for (std::size_t h = 0; h < 3; ++h) c.history[h][row] = stretch * any(random);
    c.history[3][row] = stretch > 0 ? c.overlap[row] * (0.9 + 0.2 * share(random)) : 0;   // of laws that keep the last overlap
  }
  return c;
}

void copy_row(const ContactColumns& from, std::size_t source, ContactColumns& to, std::size_t target) {
  to.normal.set(target, from.normal.get(source));
  to.velocity.set(target, from.velocity.get(source));
  to.angular_i.set(target, from.angular_i.get(source));
  to.angular_j.set(target, from.angular_j.get(source));
  to.overlap[target] = from.overlap[source];
  to.radius_i[target] = from.radius_i[source];
  to.radius_j[target] = from.radius_j[source];
  to.effective_mass[target] = from.effective_mass[source];
  to.pair[target] = from.pair[source];
  for (std::size_t h = 0; h < SIMILITUDE_MAX_HISTORY; ++h) to.history[h][target] = from.history[h][source];
}

/// Same bits of force and history.
void expect_same(const ContactColumns& a, std::size_t row_a, const ContactColumns& b, std::size_t row_b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(a.force.axis[axis][row_a], b.force.axis[axis][row_b]) << row_a;
  }
  for (std::size_t h = 0; h < SIMILITUDE_MAX_HISTORY; ++h) EXPECT_EQ(a.history[h][row_a], b.history[h][row_b]) << row_a;
}

TEST(ContactBlock, GivesARowTheSameBitsInAnyPlace) {
  constexpr std::size_t rows = 256;
  std::vector<std::size_t> order(rows);
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  for (const Named& named : k_laws) {
    const ContactModel law(named.file, {named.values});
    ContactColumns whole = contacts(rows);
    evaluate(law, whole);
    for (std::size_t start = 0; start < rows; start += 32) {
      const ContactColumns given = contacts(rows);
      ContactColumns part(32);
      for (std::size_t k = 0; k < 32; ++k) copy_row(given, order[start + k], part, k);
      evaluate(law, part);
      for (std::size_t k = 0; k < 32; ++k) expect_same(whole, order[start + k], part, k);
    }
  }
}

TEST(ContactBlock, GivesMixedMaterialPairsWhatEachPairGivesAlone) {
  const std::vector<Values> sets = {k_linear, k_soft, k_slippery};
  const ContactModel law(LINEAR_SPRING, sets);
  ContactColumns mixed = contacts(256);
  evaluate(law, mixed, true);
  for (std::uint32_t pair = 0; pair < 3; ++pair) {
    ContactColumns alone = contacts(256);
    std::fill(alone.pair.begin(), alone.pair.end(), pair);
    evaluate(law, alone, true);
    for (std::size_t row = 0; row < 256; ++row) {
      if (mixed.pair[row] == pair) expect_same(mixed, row, alone, row);
    }
  }
}

TEST(ContactBlock, GivesOnePairTheSameBitsWithAndWithoutPairNumbers) {
  const ContactModel law(LINEAR_SPRING, {k_linear});
  ContactColumns plain = contacts(64), numbered = contacts(64);
  std::fill(numbered.pair.begin(), numbered.pair.end(), 0u);
  evaluate(law, plain);
  evaluate(law, numbered, true);
  for (std::size_t row = 0; row < 64; ++row) expect_same(plain, row, numbered, row);
}

TEST(ContactLaw, GivesThePartnersOppositeForces) {
  for (const Named& named : k_laws) {
    const ContactModel law(named.file, {named.values});
    const similitude_contact_needs needs = test::needs_of(law);
    ContactColumns there = contacts(64), back(64);
    for (std::size_t row = 0; row < 64; ++row) {
      copy_row(there, row, back, row);
      back.normal.set(row, -there.normal.get(row));
      back.velocity.set(row, -there.velocity.get(row));
      std::swap(back.radius_i[row], back.radius_j[row]);
      for (std::uint32_t h = 0; h < needs.history_count; ++h) {
        if (needs.history_parity[h] == SIMILITUDE_ODD) back.history[h][row] = -back.history[h][row];
      }
    }
    evaluate(law, there);
    evaluate(law, back);
    for (std::size_t row = 0; row < 64; ++row) {
      for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(there.force.axis[a][row], -back.force.axis[a][row]);
      for (std::uint32_t h = 0; h < needs.history_count; ++h) {
        EXPECT_EQ(there.history[h][row], needs.history_parity[h] == SIMILITUDE_ODD ? -back.history[h][row] : back.history[h][row]);
      }
    }
  }
}

TEST(ContactLaw, HasNoPreferredDirection) {
  // A rotation by 1 rad about (1, 2, 3).
  const Vec3<double> axis = (1 / std::sqrt(14.0)) * Vec3<double>{1, 2, 3};
  const auto turned = [&axis](const Vec3<double>& v) {
    return std::cos(1.0) * v + std::sin(1.0) * cross(axis, v) + ((1 - std::cos(1.0)) * dot(axis, v)) * axis;
  };
  for (const Named& named : k_laws) {
    const ContactModel law(named.file, {named.values});
    ContactColumns straight = contacts(64), oblique(64);
    for (std::size_t row = 0; row < 64; ++row) {
      copy_row(straight, row, oblique, row);
      oblique.normal.set(row, turned(straight.normal.get(row)));
      oblique.velocity.set(row, turned(straight.velocity.get(row)));
      const Vec3<double> spring = turned({straight.history[0][row], straight.history[1][row], straight.history[2][row]});
      oblique.history[0][row] = spring.x, oblique.history[1][row] = spring.y, oblique.history[2][row] = spring.z;
    }
    evaluate(law, straight);
    evaluate(law, oblique);
    for (std::size_t row = 0; row < 64; ++row) {
      const Vec3<double> expected = turned(straight.force.get(row)), difference = oblique.force.get(row) - expected;
      // Spring and dashpot may nearly cancel: a share of the largest spring force, 500 N/m times 2e-5 m.
      EXPECT_LT(std::sqrt(dot(difference, difference)), 1e-12 * 500 * 2e-5) << row;
    }
  }
}

/// A law's parameters in a bed of a quarter the size: stiffness 2^-4, modulus 2^-2, speed 2^-1.
Values quarter(const Named& named) {
  Values small = named.values;
  const std::pair<const char*, double> shrinks[] = {{"stiffness", 16}, {"youngs_modulus", 4}, {"partner_youngs_modulus", 4}};
  for (const auto& [name, factor] : shrinks) {
    if (small.count(name) != 0) small[name] /= factor;
  }
  if (std::string(named.file) == FLUENT_DEM) small["v_glide"] = 0.5;   // 1 m/s unless given
  return small;
}

// r = 1/4 of the exactly similar family: lengths 2^-2, speeds and times 2^-1, masses 2^-6, stiffness 2^-4; force 2^-6.
TEST(ContactLaw, KeepsItsBitsInABedScaledByPowersOfTwo) {
  for (const Named& named : k_laws) {
    const ContactModel law(named.file, {named.values}), scaled_law(named.file, {quarter(named)});
    ContactColumns real = contacts(64), small(64);
    for (std::size_t row = 0; row < 64; ++row) {
      copy_row(real, row, small, row);
      small.velocity.set(row, 0.5 * real.velocity.get(row));
      small.overlap[row] /= 4;
      small.radius_i[row] /= 4;
      small.radius_j[row] /= 4;
      small.effective_mass[row] /= 64;
      for (std::size_t h = 0; h < 4; ++h) small.history[h][row] /= 4;
    }
    evaluate(law, real);
    evaluate(scaled_law, small, false, k_dt / 2);
    for (std::size_t row = 0; row < 64; ++row) {
      for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_EQ(small.force.axis[a][row] * 64, real.force.axis[a][row]);
      }
      for (std::size_t h = 0; h < 4; ++h) EXPECT_EQ(small.history[h][row] * 4, real.history[h][row]);
    }
  }
}

TEST(LinearSpring, AsksForSpringAndSpinOnlyWithFriction) {
  const similitude_contact_needs rough = test::needs_of(ContactModel(LINEAR_SPRING, {k_linear}));
  EXPECT_EQ(rough.rotation, 1);
  EXPECT_EQ(rough.couple, 0);
  ASSERT_EQ(rough.history_count, 3u);
  EXPECT_STREQ(rough.history_name[0], "tangential_spring_x");
  EXPECT_STREQ(rough.history_unit[2], "m");
  EXPECT_EQ(rough.history_parity[1], SIMILITUDE_ODD);
  const similitude_contact_needs slippery = test::needs_of(ContactModel(LINEAR_SPRING, {k_slippery}));
  EXPECT_EQ(slippery.rotation, 0);
  EXPECT_EQ(slippery.history_count, 0u);
  const similitude_contact_needs mixed = test::needs_of(ContactModel(LINEAR_SPRING, {k_slippery, k_linear}));
  EXPECT_EQ(mixed.rotation, 1);
  EXPECT_EQ(mixed.history_count, 3u);
}

TEST(Hertz, AsksForSpringAndSpinOnlyWithFriction) {
  Values slippery = k_hertz;
  slippery["friction"] = 0;
  for (const char* file : {HERTZ_MINDLIN, HERTZ_THORNTON}) {
    const similitude_contact_needs rough = test::needs_of(ContactModel(file, {k_hertz}));
    EXPECT_EQ(rough.rotation, 1);
    ASSERT_EQ(rough.history_count, 4u);
    EXPECT_EQ(rough.history_parity[2], SIMILITUDE_ODD);
    EXPECT_STREQ(rough.history_name[3], "last_overlap");
    EXPECT_EQ(rough.history_parity[3], SIMILITUDE_EVEN);
    const similitude_contact_needs smooth = test::needs_of(ContactModel(file, {slippery}));
    EXPECT_EQ(smooth.rotation, 0);
    EXPECT_EQ(smooth.history_count, 0u);
  }
}

TEST(FluentDem, RemembersNothing) {
  const similitude_contact_needs needs = test::needs_of(ContactModel(FLUENT_DEM, {k_fluent}));
  EXPECT_EQ(needs.history_count, 0u);
  EXPECT_EQ(needs.rotation, 1);
}

/// A contact along z that slides along x.
Vec3<double> sliding_force(const ContactModel& law, double speed, double overlap, double dt, ContactColumns& c) {
  for (std::size_t row = 0; row < 8; ++row) {
    c.normal.set(row, {0, 0, 1});
    c.overlap[row] = overlap;
    c.velocity.set(row, {speed, 0, 0});
    c.radius_i[row] = c.radius_j[row] = 5e-4;
    c.effective_mass[row] = 3e-7;
  }
  evaluate(law, c, false, dt);
  return c.force.get(0);
}

TEST(FluentDem, HasTheTabledFrictionCoefficient) {
  const std::pair<double, double> table[] = {{1e-6, 0.5}, {0.25, 0.3688}, {0.5, 0.275}, {0.75, 0.2188}, {0.999, 0.2}, {1, 0.2}, {5, 0.2}};
  const ContactModel law(FLUENT_DEM, {k_fluent});
  for (const auto& [speed, friction] : table) {
    ContactColumns c(8);
    const Vec3<double> force = sliding_force(law, speed, 1e-5, 1e-13, c);   // so short a step stops nothing
    EXPECT_NEAR(-force.x / force.z, friction, 6e-5) << speed;
    EXPECT_EQ(force.y, 0);
  }
}

TEST(FluentDem, ComesToRestWithoutChangingDirection) {
  const ContactModel law(FLUENT_DEM, {k_fluent});
  ContactColumns c(8);
  double speed = 0.01;   // [m/s], of the surfaces; 2/7 of the mass resists
  const double overlap = 1e-5, dt = 1e-5;
  double before = speed;
  for (int step = 0; step < 60; ++step) {
    speed += sliding_force(law, speed, overlap, dt, c).x / (3e-7 * 2 / 7) * dt;
    EXPECT_GE(speed, 0);
    EXPECT_LT(speed, before);
    before = speed;
  }
  EXPECT_LT(speed, 1e-10);
  EXPECT_EQ(sliding_force(law, 0, overlap, dt, c).x, 0);
  EXPECT_EQ(sliding_force(law, 0, 0, dt, c).x, 0);
}

TEST(LinearSpring, HoldsAContactAtRestUpToTheFrictionForce) {
  const ContactModel law(LINEAR_SPRING, {k_linear});
  const double tangential_stiffness = 2.0 / 7 * 500, overlap = 1e-5;
  ContactColumns c(8);
  for (std::size_t row = 0; row < 8; ++row) c.history[0][row] = 1e-6;
  Vec3<double> force = sliding_force(law, 0, overlap, k_dt, c);
  EXPECT_DOUBLE_EQ(force.x, -tangential_stiffness * 1e-6);
  EXPECT_DOUBLE_EQ(c.history[0][0], 1e-6);
  for (std::size_t row = 0; row < 8; ++row) c.history[0][row] = 1e-4;   // more than friction bears
  force = sliding_force(law, 0, overlap, k_dt, c);
  EXPECT_DOUBLE_EQ(force.x, -0.2 * 500 * overlap);
  EXPECT_DOUBLE_EQ(c.history[0][0], 0.2 * 500 * overlap / tangential_stiffness);
}

TEST(LinearSpring, TurnsItsSpringWithTheContactAndKeepsItsLength) {
  const ContactModel law(LINEAR_SPRING, {k_linear});
  ContactColumns c(8);
  for (std::size_t row = 0; row < 8; ++row) {   // the spring lies along x; the normal has turned by 0.1 rad toward x
    c.normal.set(row, {std::sin(0.1), 0, std::cos(0.1)});
    c.overlap[row] = 1e-4;
    c.radius_i[row] = c.radius_j[row] = 5e-4;
    c.effective_mass[row] = 3e-7;
    c.history[0][row] = 1e-6;
  }
  evaluate(law, c);
  EXPECT_NEAR(c.history[0][0], 1e-6 * std::cos(0.1), 1e-20);
  EXPECT_NEAR(c.history[2][0], -1e-6 * std::sin(0.1), 1e-20);
}

}  // namespace
}  // namespace similitude
