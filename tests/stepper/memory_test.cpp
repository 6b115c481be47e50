// What `check` foretells of a bed's memory, against what its engine takes.
#include <gtest/gtest.h>

#include "small_bed.h"
#include "stepper/inspection.h"

namespace similitude::test {
namespace {

// Settled, so that contacts and candidates are those of a bed at rest.
constexpr const char* k_bed = R"(
similitude: 1
title: memory
scene:
  domain:    {size: [15 mm, 15 mm, 60 mm], cell: 5 mm}
  gas:       {density: 1.2 kg/m^3, viscosity: 1.8e-5 Pa s}
  particles: {ball: {diameter: 1 mm, density: 2500 kg/m^3, count: 4000}}
  bed:       {fill: settle}
models: {drag: wen_yu, fluid: prescribed, scaling: exact, effects: [],
         contact: {id: linear_spring, stiffness: 200 N/m, restitution: 0.5, friction: 0.3}}
time: {end: 1 s, dt: auto}
)";

TEST(FieldUses, SayWhatListsAndHistoryTake) {
  const Assembly settled = assemble(case_of(k_bed).scene, built_plugins());
  ParticleStore particles = fill_bed(settled, choose_time_steps(settled), {}).particles;
  for (Row& v : particles.velocity) v.z = 0.05;   // [m/s], a hop of an eighth of a diameter: lists are built again, touching contacts carried over
  const auto bed = small_bed(k_bed, &particles);
  while (bed->simulation->engine().report().rebuilds < 3) bed->simulation->step();
  double lists = 0, history = 0;
  for (const FieldUse& field : field_uses(*bed->assembly)) {
    const double bytes = static_cast<double>(field.bytes_per_item) * static_cast<double>(field.items);
    if (field.name == "particle.listed_position_order" || field.name == "pair.list" || field.name == "pair.share_across_bricks") {
      lists += bytes;
    } else if (field.name.starts_with("pair.") || field.name == "contact.carried_history") {
      history += bytes;
    }
  }
  const Engine& engine = bed->simulation->engine();
  // Rounding of pieces, cells, and what threads gather in are in the engine's bytes only: a fifth of a bed as small as this.
  EXPECT_NEAR(lists / static_cast<double>(engine.list_bytes()), 1, 0.25) << lists / 4000;
  EXPECT_NEAR(history / static_cast<double>(engine.history_bytes()), 1, 0.25) << history / 4000;
}

}  // namespace
}  // namespace similitude::test
