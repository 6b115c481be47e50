// Gas that flows straight up, as much through every height as must: a solver in thirty lines, and its illnesses.
#include <similitude/fluid_solver.h>

#include <vector>

namespace {
using namespace similitude;

enum class Illness { none, leaks, stirs, explicit_drag, forgets, writes_beyond };

template <Illness illness>
struct PlugFlow {
  double density = 0;              // [kg/m^3]
  const similitude_grid* grid = nullptr;
  double inflow_speed = 0;         // [m/s], superficial
  double age = 0;                  // steps taken

  void prepare(const Bed& bed) { density = bed.gas_density; }

  void initialise(const similitude_grid& given, const similitude_gas_step& step) {
    grid = &given;
    for (std::uint32_t p = 0; p < given.patch_count; ++p)
      if (given.patches[p].kind == SIMILITUDE_PATCH_VELOCITY) inflow_speed = given.patches[p].velocity[2];
    const std::size_t cells = count();
    for (std::size_t c = 0; c < 3 * cells; ++c) step.velocity[c] = step.stress_force[c] = 0;
    for (std::size_t c = 0; c < cells; ++c) step.pressure[c] = 0;
  }

  std::size_t count() const { return layer() * static_cast<std::size_t>(grid->cells[2]); }
  std::size_t layer() const { return static_cast<std::size_t>(grid->cells[0]) * static_cast<std::size_t>(grid->cells[1]); }

  void advance(const similitude_gas_step& step, similitude_gas_report& report) {
    const double area = grid->spacing[0] * grid->spacing[1];
    double volume = inflow_speed * area * static_cast<double>(layer());   // [m^3/s], through the face below a layer
    report.inflow = density * volume;
    age += 1;
    for (std::size_t k = 0; k < static_cast<std::size_t>(grid->cells[2]); ++k) {
      double swelling = 0;   // [m^3/s]
      for (std::size_t c = k * layer(); c < (k + 1) * layer(); ++c)
        swelling += (step.gas_fraction_old[c] - step.gas_fraction[c]) * area * grid->spacing[2] / step.dt;
      for (std::size_t c = k * layer(); c < (k + 1) * layer(); ++c) {
        double& up = step.velocity[2 * count() + c];
        up = (volume + 0.5 * swelling) / (static_cast<double>(layer()) * area * step.gas_fraction[c]);
        if (illness == Illness::stirs) up += 1e-3 * step.dt * grid->gravity[2];
        if (illness == Illness::explicit_drag) up *= 1 + step.exchange[c] * step.dt / density * 1e-4;
        if (illness == Illness::forgets) up *= 1 + 1e-6 * age;
      }
      volume += swelling;
    }
    report.outflow = density * volume * (illness == Illness::leaks ? 0.9 : 1);
    if (illness == Illness::writes_beyond) step.pressure[count()] = 0;
  }
};

}  // namespace

SIMILITUDE_PLUGIN(fluid_solver<PlugFlow<Illness::none>>({"plug", "1.0.0", "Nothing is wrong with it"}),
                  fluid_solver<PlugFlow<Illness::leaks>>({"leaks", "1.0.0", "Ill"}),
                  fluid_solver<PlugFlow<Illness::stirs>>({"stirs", "1.0.0", "Ill"}),
                  fluid_solver<PlugFlow<Illness::explicit_drag>>({"explicit_drag", "1.0.0", "Ill"}),
                  fluid_solver<PlugFlow<Illness::forgets>>({"forgets", "1.0.0", "Ill"}),
                  fluid_solver<PlugFlow<Illness::writes_beyond>>({"writes_beyond", "1.0.0", "Ill"}))
