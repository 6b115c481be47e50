/// Four small scenes for an instruction counter (tests/performance/instructions). Everything is compiled into this program for one
/// instruction set, so that counts do not depend on the machine. One thread.
///
///   instruction_scenes SCENE        prints how many items were advanced inside measured_steps(): particle-steps or cell-steps

#include <functional>
#include <memory>
#include <string_view>

#include "bench_bed.h"
#include "coupling/coupling.h"
#include "fluid/grid.h"
#include "solver.h"

extern "C" {
extern const similitude_entry similitude_drag_plugin;
}

/// What is counted: the counter is switched on by this function's name.
__attribute__((noinline)) void measured_steps(const std::function<void()>& step, int count) {
  for (int n = 0; n < count; ++n) step();
}

namespace {
using namespace similitude;
using namespace similitude::bench;

constexpr std::size_t k_particles = 4000;
constexpr double k_cell = 5e-3;   // [m]

/// A box in whole cells with an inlet below and an outlet above, and the case's particles.
ModelScene gas_scene(double height) {
  ModelScene scene;
  scene.size = {k_wide, k_deep, height};
  scene.cell = {k_cell, k_cell, k_cell};
  scene.gas_density = 1.225;
  scene.gas_viscosity = 1.79e-5;
  ParticleClass grain;
  grain.name = "grain";
  grain.diameter = grain.drag_diameter = grain.material_diameter = k_diameter;
  grain.density = k_density;
  scene.particles = {grain};
  Patch inlet, outlet;
  inlet.name = "inlet";
  inlet.face = {Axis::z, Side::low};
  inlet.rest = true;
  inlet.velocity = 0.3;   // [m/s]
  outlet.name = "outlet";
  outlet.face = {Axis::z, Side::high};
  outlet.rest = true;
  outlet.kind = PatchKind::pressure;
  scene.patches = {inlet, outlet};
  return scene;
}

/// Gas solver, coupling and what passes between them.
struct Gas {
  explicit Gas(const ModelScene& scene, const DragModel& drag)
      : grid(scene), coupling(scene, grid, drag, true),
        solver(grid.table(), {.density = scene.gas_density, .viscosity = scene.gas_viscosity}) {
    fields.velocity.assign(3 * grid.cell_count(), 0);
    fields.pressure.assign(grid.cell_count(), 0);
    fields.stress_force.assign(3 * grid.cell_count(), 0);
  }

  similitude_gas_step step(double dt) { return gas_step(coupling.fields(), fields, time += dt, dt); }
  void advance(double dt) {
    similitude_gas_report report{};
    report.struct_size = sizeof report;
    solver.advance(step(dt), report);
  }

  Grid grid;
  Coupling coupling;
  vans::GasSolver solver;
  GasFields fields;
  double time = 0;
};

double dem(ParticleStore bed) {
  constexpr int k_steps = 100;
  const ModelScene scene = box_around(bed);
  const ContactModel law = contact_law(k_stiffness, k_restitution, k_friction);
  Engine engine(bed, scene, law, options(k_dt));
  engine.advance(5);
  measured_steps([&] { engine.advance(1); }, k_steps);
  std::fprintf(stderr, "%.2f contacts per particle, %llu rebuilds\n", static_cast<double>(engine.report().contacts) / k_particles,
               static_cast<unsigned long long>(engine.report().rebuilds));
  return k_steps * static_cast<double>(k_particles);
}

double settled() { return dem(resting_lattice(k_particles)); }

/// Collisions at half a metre per second, a few rebuilds of the lists.
double agitated() {
  ParticleStore bed = lattice(k_particles, 1.04 * k_diameter, 0.015 * k_diameter);
  for (Row& v : bed.velocity) v = {0.5 * scatter(), 0.5 * scatter(), 0.5 * scatter(), v.w};
  return dem(std::move(bed));
}

double coupled() {
  constexpr int k_gas_steps = 5, k_sub_steps = 10;
  const ModelScene scene = gas_scene(8 * k_cell);
  ParticleStore bed = resting_lattice(k_particles, true);
  const ContactModel law = contact_law(k_stiffness, k_restitution, k_friction);
  const DragModel drag = model_of<similitude_drag_functions>(similitude_drag_plugin, {});
  Gas gas(scene, drag);
  Engine engine(bed, scene, law, options(k_dt));
  gas.coupling.start(bed);
  gas.solver.start(gas.step(0));
  const double dt = k_sub_steps * k_dt;
  const auto step = [&] {
    gas.coupling.deposit(bed, gas.fields, dt);
    gas.advance(dt);
    gas.coupling.interpolate(bed, gas.fields, dt);
    engine.advance(k_sub_steps);
    gas.coupling.settle_accounts(bed);
  };
  step();
  measured_steps(step, k_gas_steps);
  return k_gas_steps * k_sub_steps * static_cast<double>(k_particles);
}

double gas_alone() {
  constexpr int k_gas_steps = 5;
  const ModelScene scene = gas_scene(40 * k_cell);
  const DragModel drag = model_of<similitude_drag_functions>(similitude_drag_plugin, {});
  Gas gas(scene, drag);
  gas.solver.start(gas.step(0));
  gas.advance(1e-3);
  measured_steps([&] { gas.advance(1e-3); }, k_gas_steps);
  return k_gas_steps * static_cast<double>(gas.grid.cell_count());
}

}  // namespace

int main(int count, char** words) {
  const std::map<std::string_view, double (*)()> scenes{
      {"settled", settled}, {"agitated", agitated}, {"coupled", coupled}, {"gas", gas_alone}};
  const auto scene = count == 2 ? scenes.find(words[1]) : scenes.end();
  if (scene == scenes.end()) {
    std::fprintf(stderr, "usage: instruction_scenes settled|agitated|coupled|gas\n");
    return 2;
  }
  std::printf("%.0f\n", scene->second());
  return 0;
}
