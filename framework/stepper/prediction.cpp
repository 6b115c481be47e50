#include "stepper/prediction.h"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>

#include "particles/bed_cache.h"
#include "particles/errors.h"
#include "scene/messages.h"
#include "stepper/bed.h"
#include "stepper/inspection.h"
#include "stepper/run_outputs.h"
#include "stepper/seconds_since.h"
#include "stepper/simulation.h"
#include "stepper/stop_signal.h"

namespace similitude {
namespace {

constexpr std::int64_t k_settled_at_once = 3000;   // particles: settling them takes about as long as the calibration
constexpr double k_warm_up_share = 0.3;            // of the calibration: caches, first lists, inlets at full ramp
constexpr int k_fewest_steps = 2;                  // of gas, measured
constexpr int k_windows = 9;                       // of time, of which the middle one counts
// A bed that has come to life throws grains up, and the fastest decide how often contact lists are made anew. Their speed is an eighth of
// the inlet in the small spouted bed of configs/studies.
constexpr double k_fountain_share = 0.02;          // of the grains, the topmost
constexpr double k_fountain_speed = 0.12;          // of the fastest inlet

/// The bed as the run will find it; a lattice in its place where settling would take long.
ParticleStore bed_to_try(const Assembly& assembly, const TimeSteps& steps, std::int64_t expected) {
  if (assembly.model.bed.kind != FillKind::settle || expected <= k_settled_at_once || settled_bed_is_kept(assembly, steps))
    return fill_bed(assembly, steps, {}).particles;
  ParticleStore particles(store_fields(assembly));
  ModelScene loose = assembly.model;
  loose.bed.kind = FillKind::lattice;
  try {
    fill_bed(particles, loose, assembly.contact, {.dt = steps.dt, .softer_law = {}, .progress = {}, .cache_folder = {}});
  } catch (const InputError&) {   // denser than a lattice
    return fill_bed(assembly, steps, {}).particles;
  }
  return particles;
}

/// The topmost grains fly, as they will for most of the run.
void start_fountain(ParticleStore& particles, const ModelScene& scene) {
  double fastest = 0;   // [m/s]
  for (const Patch& patch : scene.patches)
    if (patch.kind == PatchKind::velocity) fastest = std::max(fastest, std::abs(patch.velocity));
  std::vector<double> heights;   // [m]
  for (const Row& p : particles.position) heights.push_back(p.z);
  const auto thrown = static_cast<std::ptrdiff_t>(k_fountain_share * static_cast<double>(heights.size()));
  if (thrown == 0) return;
  std::nth_element(heights.begin(), heights.end() - thrown, heights.end());
  const double least = *(heights.end() - thrown);
  for (std::size_t k = 0; k < particles.size(); ++k)
    if (particles.position[k].z >= least) particles.velocity[k].z = k_fountain_speed * fastest;
}

double middle(std::vector<double> values) {
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), half, values.end());
  return *half;
}

/// A folder that goes as it came.
class Scratch {
 public:
  Scratch() : path_(std::filesystem::temp_directory_path() / ("similitude-calibration-" + std::to_string(::getpid()))) {}
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

double seconds_of_outputs(const Assembly& assembly, const Simulation& simulation) {
  const Scratch scratch;
  RunOutputs outputs(OutputDirectory(scratch.path(), true), assembly);
  return outputs.seconds_to_the_end(simulation);
}

bool belongs_to_particles(const std::string& stage) { return stage.starts_with("particles: "); }
bool counts_particles(const std::string& stage) {
  return stage == "deposit" || stage == "drag" || stage == "interpolate" || stage == "settle accounts" || stage.starts_with("effect: ");
}

void calibrate(const Assembly& assembly, const TimeSteps& steps, double gas_steps, PredictedCost& cost) {
  ParticleStore bed = bed_to_try(assembly, steps, cost.particles);
  if (assembly.model.bed.kind == FillKind::settle) start_fountain(bed, assembly.model);
  Simulation simulation(assembly, steps, std::move(bed), [](const std::string&) {});
  const auto particles = static_cast<double>(simulation.particles().size());
  const auto start = std::chrono::steady_clock::now();
  const auto until = [&](double share, std::int64_t fewest) {
    const std::int64_t first = simulation.steps_done();
    while ((simulation.steps_done() < first + fewest || seconds_since(start) < share * k_calibration_s) &&
           static_cast<double>(simulation.steps_done()) < gas_steps && StopSignal::received() == 0)
      simulation.step();
  };
  until(k_warm_up_share, 1);
  // Windows of time, and of each stage the middle one: what else the machine does for a moment does not count.
  std::vector<std::vector<double>> seconds(simulation.stage_times().size());   // [s per gas step], by stage and window
  for (int window = 1; window <= k_windows; ++window) {
    const std::vector<StageTime> before = simulation.stage_times();
    const std::int64_t first = simulation.steps_done();
    until(k_warm_up_share + (1 - k_warm_up_share) * window / k_windows, window <= k_fewest_steps ? 1 : 0);
    const auto steps_of_window = static_cast<double>(simulation.steps_done() - first);
    const std::vector<StageTime> after = simulation.stage_times();
    for (std::size_t k = 0; steps_of_window > 0 && k < after.size(); ++k)
      seconds[k].push_back((after[k].seconds - before[k].seconds) / steps_of_window);
  }
  const std::vector<StageTime> whole = simulation.stage_times();
  double in_particles = 0, per_particle = 0, others = 0;   // [s per gas step]
  for (std::size_t k = 0; k < whole.size(); ++k) {
    // Of lists that are rebuilt now and then the mean, and so of a run that is over before the first window.
    const bool now_and_then = whole[k].name == "particles: neighbour list" || seconds[k].empty();
    const double each = now_and_then ? whole[k].seconds / static_cast<double>(simulation.steps_done()) : middle(seconds[k]);
    cost.stages.push_back({whole[k].name, each * gas_steps});
    (belongs_to_particles(whole[k].name) ? in_particles : counts_particles(whole[k].name) ? per_particle : others) += each;
  }
  cost.stages.push_back({"other", seconds_of_outputs(assembly, simulation)});
  if (particles > 0) {
    cost.particle_steps_per_s = particles * static_cast<double>(steps.sub_steps) / in_particles;
    cost.exchange_s = per_particle / particles;
  } else {
    others += per_particle;
  }
  cost.gas_step_s = others;
  for (const StageTime& stage : cost.stages) cost.wall_s += stage.seconds;
}

}  // namespace

void predict_with_threads(int threads) {
  omp_set_num_threads(threads > 0 ? threads : omp_get_num_procs());
}

PredictedCost predict_cost(const Assembly& assembly, const TimeSteps& steps) {
  PredictedCost cost;
  cost.threads = omp_get_max_threads();
  cost.particles = expected_particles(assembly.model);
  const auto gas_steps = static_cast<double>(steps.gas_steps_until(assembly.model.time.end));
  cost.particle_steps = static_cast<double>(cost.particles) * gas_steps * static_cast<double>(steps.sub_steps);
  try {
    calibrate(assembly, steps, gas_steps, cost);
  } catch (const std::exception& error) {   // a guard, a bed that does not fit, a full disk: the run will say it in its place
    cost.gap = error.what();
    cost.wall_s = std::numeric_limits<double>::quiet_NaN();
    cost.stages.clear();
  }
  return cost;
}

}  // namespace similitude
