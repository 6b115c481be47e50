#include "stepper/run.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include <fmt/format.h>

#include "output/audit_file.h"
#include "output/checkpoint_file.h"
#include "output/manifest.h"
#include "output/progress.h"
#include "output/state_hash.h"
#include "output/timing.h"
#include "output/view_script.h"
#include "particles/errors.h"
#include "stepper/bed.h"
#include "stepper/checkpoints.h"
#include "stepper/comparison.h"
#include "stepper/effects.h"
#include "stepper/inspection.h"
#include "stepper/occurred.h"
#include "stepper/resume.h"
#include "stepper/run_outputs.h"
#include "stepper/seconds_since.h"
#include "stepper/simulation.h"
#include "stepper/stop_signal.h"
#include "stepper/version.h"

namespace similitude {
namespace {

constexpr int k_exit_of_signal = 128;   // shells' convention: 128 + signal number

void warn(const std::string& text) { std::cerr << "warning: " << text << "\n"; }

RunIdentity run_identity(const CaseFile& case_file, const Assembly& assembly, const TimeSteps& steps) {
  RunIdentity run;
  static_cast<CaseIdentity&>(run) = identity_of(case_file);
  run.program_version = program_version();
  for (const PluginEntry& plugin : assembly.plugins) run.plugins.push_back(manifest_plugin(plugin));
  run.dt = steps.dt;
  run.sub_steps = steps.sub_steps;
  return run;
}

Manifest first_manifest(const CaseFile& case_file, const Assembly& assembly, const RunOptions& options, int threads,
                        const RunIdentity& run) {
  Manifest manifest;
  manifest.program_version = run.program_version;
  manifest.command = options.command;
  manifest.case_file = case_file.path.string();
  manifest.plugins = run.plugins;
  manifest.machine = this_machine();
  manifest.threads = threads;
  manifest.scaling = assembly.ratios;
  manifest.map_back = map_back(assembly);
  manifest.particles = run.particles;
  manifest.started = run.started;
  manifest.resumed = run.resumed;
  return manifest;
}

/// How the run came by its particles.
std::string origin_words(const RunIdentity& run, const FilledBed& filled) {
  if (run.resumed.empty()) return filled.from_cache ? ", from the cache" : "";
  return fmt::format(" at the start; going on at t = {:.6g} s from {}", run.resumed.back().simulated_s, run.resumed.back().checkpoint);
}

/// What chose itself stands there as a case would write it: nobody else has said with which parameters.
void print_effects(std::ostream& out, const Assembly& assembly) {
  std::string line;
  for (const EffectModel& effect : assembly.effects) {
    line += line.empty() ? "" : ", ";
    line += assembly.real.models.effects_auto ? with_its_defaults(effect.descriptor()) : effect.descriptor().id;
  }
  if (!line.empty()) out << "  effects     " << (assembly.real.models.effects_auto ? "auto took, with default parameters: " : "") << line << "\n";
}

void print_start(std::ostream& out, const Assembly& assembly, const TimeSteps& steps, const RunIdentity& run,
                 const std::string& origin, const Simulation& simulation, std::int64_t gas_steps) {
  const ResultRatios& to = assembly.results;
  out << assembly.real.title << "\n";
  out << fmt::format("  models      drag {}, contact {}, fluid {}, scaling {}\n", assembly.drag.descriptor().id,
                     assembly.contact.descriptor().id, assembly.fluid.descriptor().id, assembly.scaling.descriptor().id);
  print_effects(out, assembly);
  out << fmt::format("  bed         {} simulated particles{}, level {:.4g} mm, solids fraction {:.3f}{}\n",
                     run.particles, assembly.ratios.diameter == assembly.ratios.length ? "" : " (scaled)",
                     1e3 * run.height / to.length, run.solids_fraction, origin);
  out << fmt::format("  time steps  {:.3g} s ({} per gas step), {} gas steps; limits:\n", steps.dt / to.time, steps.sub_steps,
                     gas_steps);
  for (const TimeStepLimit& limit : steps.limits) {
    out << fmt::format("    {} {:<28} advised {:9.3g} s  hard {:9.3g} s\n", limit.binding ? "*" : " ", limit.name,
                       limit.advised / to.time, limit.hard / to.time);
  }
  out << "  pipeline\n";
  for (const std::string& pass : simulation.pipeline()) out << "    " << pass << "\n";
  out << fmt::format("  memory      {} bytes per particle, about {:.0f} with contacts and copies of the state\n\n",
                     simulation.particles().bytes_per_particle(), bytes_per_particle(field_uses(assembly), assembly));
}

/// Stage times of an earlier start and of this one, together.
std::vector<StageTime> sum_of(const std::vector<StageTime>& before, const std::vector<StageTime>& now) {
  std::vector<StageTime> sum = now;
  for (const StageTime& old : before) {
    const auto same = std::find_if(sum.begin(), sum.end(), [&](const StageTime& stage) { return stage.name == old.name; });
    if (same != sum.end()) {
      same->seconds += old.seconds;
    } else {
      sum.push_back(old);
    }
  }
  return sum;
}

/// What the books of the run are off by, e.g. after the last step.
std::string books(const Balances& off) {
  std::string line = fmt::format("books off by: solids momentum {:.1e}, solids energy {:.1e}, gas mass {:.1e}", off.momentum, off.energy,
                                 off.gas_mass);
  if (std::isfinite(off.gas_momentum)) line += fmt::format(", gas momentum {:.1e} (friction of walls included)", off.gas_momentum);
  return line + "\n";
}

/// The time loop of a case with all that watches it.
class CaseRun {
 public:
  /// `earlier` null: from the start.
  CaseRun(const Assembly& assembly, Simulation& simulation, const OutputDirectory& directory, Manifest manifest, CaseIdentity identity,
          Checkpoints& checkpoints, const RunState* earlier)
      : assembly_(assembly),
        simulation_(simulation),
        directory_(directory),
        manifest_(std::move(manifest)),
        identity_(std::move(identity)),
        checkpoints_(checkpoints),
        outputs_(earlier != nullptr ? RunOutputs(directory, assembly, earlier->outputs, simulation.time()) : RunOutputs(directory, assembly)),
        occurred_(assembly),
        particle_steps_before_(earlier != nullptr ? simulation.engine().report().particle_steps : 0) {
    if (earlier != nullptr) {
      wall_before_ = earlier->wall_s;
      stages_before_ = earlier->stages;
    } else {
      outputs_.observe(simulation_);
    }
    write_manifest(directory_, manifest_, identity_);
  }

  /// To the end, or until a signal comes. Throws SimulationError, naming the last good state, when a guard trips. Whatever else is
  /// thrown, by a full disk or for want of memory, is written into the manifest as far as that can be.
  void advance(std::int64_t gas_steps, double end) {
    Progress progress(std::cerr, Progress::screen_of_standard_error(), end);
    try {
      step_to(gas_steps, progress);
      if (checkpoints_.wanted()) write_checkpoint();
      const int signal_number = StopSignal::received();
      if (signal_number != 0) {
        finish(progress, "interrupted", k_exit_of_signal + signal_number, fmt::format("signal {}", signal_number));
      } else {
        finish(progress, "done", 0, "reached the end time");
      }
    } catch (const SimulationError&) {   // written down already
      throw;
    } catch (const std::exception& error) {
      fail(progress, error.what());
      throw;
    }
  }

  const RunOutputs& outputs() const { return outputs_; }
  const Occurred& occurred() const { return occurred_; }
  const std::string& hash() const { return manifest_.state_hash; }

 private:
  void step_to(std::int64_t gas_steps, Progress& progress) {
    try {
      while (simulation_.steps_done() < gas_steps && StopSignal::received() == 0) {
        keep_a_copy();
        simulation_.step();
        outputs_.observe(simulation_);
        look_at_what_occurs();
        progress.update(progress_state());
      }
    } catch (const SimulationError& error) {
      const std::string where = go_back_to_the_last_good_step();
      finish(progress, "stopped", 1, error.what());
      throw SimulationError(error.what(), where);
    }
  }

  /// For effects alone: a case that asks for none pays nothing.
  void look_at_what_occurs() {
    if (!asks_for_effects(assembly_.real) || simulation_.time() < next_look_) return;
    occurred_.observe(simulation_);
    next_look_ = simulation_.time() + assembly_.model.output.monitor_every;
  }

  double wall() const {
    return wall_before_ + seconds_since(start_);
  }

  std::vector<StageTime> stages() const {
    std::vector<StageTime> now = simulation_.stage_times();
    now.push_back({"checkpoints", snapshots_.seconds()});
    return sum_of(stages_before_, now);
  }

  void take_a_copy() {
    snapshots_.take([this](RunState& state) {
      simulation_.save(state.simulation);
      outputs_.save(state.outputs);
      state.wall_s = wall();
      state.stages = stages();
    });
  }

  void keep_a_copy() {
    const bool file = checkpoints_.due();
    if (!file && !snapshots_.due()) return;
    take_a_copy();
    if (file) checkpoints_.write_behind(snapshots_.last());
  }

  bool write_checkpoint() {
    take_a_copy();
    return checkpoints_.write(*snapshots_.last());
  }

  /// A guard trips in the middle of a step, when the state is spoilt already. The step before is found again by going on from
  /// the last copy. In words: where it is.
  std::string go_back_to_the_last_good_step() {
    const std::int64_t last_good = simulation_.steps_done();
    try {
      if (snapshots_.last()) simulation_.replay(snapshots_.last()->simulation, last_good);
    } catch (const std::exception&) {   // not the same bits a second time: nothing to trust, nothing to keep
      spoilt_ = true;
      const std::filesystem::path newest = checkpoints_.newest();
      return newest.empty() ? "" : "The newest checkpoint is " + newest.string() + ".";
    }
    const bool written = checkpoints_.wanted() && write_checkpoint();
    std::string where = fmt::format("The last good state, at t = {:.6g} s,", simulation_.time() / assembly_.results.time);
    if (assembly_.model.output.vtk_every > 0) {
      where += " is the last frame of " + directory_.file("particles.pvd").string() + " and " + directory_.file("fluid.pvd").string();
      if (written) where += ", and " + checkpoints_.newest().string();
    } else if (written) {
      where += " is " + checkpoints_.newest().string();
    } else {
      return "";
    }
    return where + ".";
  }

  ProgressState progress_state() const {
    return {.time = simulation_.time() / assembly_.results.time,
            .particle_steps = simulation_.engine().report().particle_steps - particle_steps_before_,
            .particles = simulation_.particles().size(),
            .largest_overlap = outputs_.largest_overlap_of_run()};
  }

  void finish(Progress& progress, const std::string& status, int exit_status, const std::string& reason) {
    if (!spoilt_) outputs_.finish(simulation_);
    progress.finish(progress_state());
    write_timing(directory_, {.wall_s = wall(),
                              .simulated_s = simulation_.time() / assembly_.results.time,
                              .particle_steps = simulation_.engine().report().particle_steps,
                              .stages = stages()});
    if (!spoilt_) manifest_.state_hash = state_hash(simulation_.particles(), &simulation_.gas(), &simulation_.exchange().gas_fraction);
    write_end(status, exit_status, reason);
  }

  /// Where it happened is not known: the state may be that of half a step, a table may be a row ahead. The last copy is whole.
  void fail(Progress& progress, const std::string& reason) {
    progress.finish(progress_state());
    if (checkpoints_.wanted() && snapshots_.last()) checkpoints_.write(*snapshots_.last());
    try {
      write_end("failed", manifest_.exit_status, reason);
    } catch (const std::exception&) {   // on a disk that is full this may fail as well: `reason` is thrown on
    }
  }

  void write_end(const std::string& status, int exit_status, const std::string& reason) {
    manifest_.ended = utc_now();
    manifest_.status = status;
    manifest_.exit_status = exit_status;
    manifest_.exit_reason = reason;
    manifest_.simulated_s = simulation_.time() / assembly_.results.time;
    write_manifest(directory_, manifest_, identity_);
  }

  const Assembly& assembly_;
  Simulation& simulation_;
  const OutputDirectory& directory_;
  Manifest manifest_;
  CaseIdentity identity_;
  Checkpoints& checkpoints_;
  RunOutputs outputs_;
  Occurred occurred_;
  double next_look_ = 0;                    // [s]
  Snapshots snapshots_;
  bool spoilt_ = false;                     // a guard tripped and no good state was found again
  std::uint64_t particle_steps_before_;
  double wall_before_ = 0;                  // [s], of earlier starts
  std::vector<StageTime> stages_before_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Without particles under gravity there is nothing that a scaling law could keep.
void write_audit_of(const OutputDirectory& directory, const Assembly& assembly, const Catalogue& catalogue) {
  const similitude_bed bed = describe(assembly.real);
  if (assembly.real.particles.empty() || !(bed.gravity > 0) || !(bed.particle_count > 0)) return;
  const ScalingAudit audit = audit_of(assembly, catalogue, gas_fraction_at_minimum(assembly.real));
  write_audit(directory, assembly.scaling.descriptor().id, audit.groups, audit.warnings);
}

}  // namespace

std::filesystem::path results_folder(const CaseFile& case_file, const RunOptions& options) {
  return options.folder.empty() ? std::filesystem::path("results") / case_file.scene.name : options.folder;
}

int run_case(const CaseFile& case_file, const Catalogue& catalogue, const RunOptions& options, std::ostream& out) {
  for (const std::string& warning : case_file.warnings) warn(warning);
  const Assembly assembly = assemble(case_file.scene, catalogue);
  const TimeSteps steps = choose_time_steps(assembly);
  for (const std::string& warning : warnings_of(assembly, steps, catalogue)) warn(warning);

  const int threads = options.threads > 0 ? options.threads : omp_get_num_procs();
  omp_set_num_threads(threads);
  const std::filesystem::path folder = results_folder(case_file, options);
  const OutputDirectory directory =
      options.resume ? OutputDirectory::of_earlier_run(folder) : OutputDirectory(folder, options.force);

  const StopSignal stop_signal;
  RunIdentity run = run_identity(case_file, assembly, steps);
  std::optional<EarlierRun> earlier;
  StartingBed bed{.particles = ParticleStore(store_fields(assembly)), .filled = {}};
  if (options.resume) {
    earlier = newest_checkpoint(directory, warn);
    const Checkpoint& checkpoint = earlier->checkpoint;
    refuse_another_run(checkpoint.run, run);
    const CaseIdentity now = run;
    run = checkpoint.run;
    static_cast<CaseIdentity&>(run) = now;
    run.program_version = program_version();
    run.resumed.push_back({.checkpoint = earlier->files.front().string(),
                           .simulated_s = static_cast<double>(checkpoint.state.simulation.steps_done) * steps.gas_dt() / assembly.results.time,
                           .started = utc_now(),
                           .command = options.command,
                           .threads = threads});
    bed.particles.copy_rows(checkpoint.state.simulation.particles);
  } else {
    try {
      bed = fill_bed(assembly, steps, [said = std::string()](double, const std::string& stage) mutable {
        if (stage == said) return;
        said = stage;
        std::cerr << stage << " …\n";
      });
    } catch (const Interrupted&) {
      out << "\ninterrupted while the bed settled: nothing is kept of it\n";
      return k_exit_of_signal + StopSignal::received();
    }
    run.started = utc_now();
    run.particles = bed.particles.size();
    run.solids_fraction = bed.filled.solids_fraction;
    run.height = bed.filled.height;
  }

  const double end = options.until.value_or(case_file.scene.time.end);
  const std::int64_t gas_steps = steps.gas_steps_until(end * assembly.results.time);

  Simulation simulation(assembly, steps, std::move(bed.particles), warn);
  if (earlier) simulation.restore(earlier->checkpoint.state.simulation);
  print_start(out, assembly, steps, run, origin_words(run, bed.filled), simulation, gas_steps);
  out.flush();

  write_view_script(directory, assembly.real);
  write_audit_of(directory, assembly, catalogue);
  Checkpoints checkpoints(directory, assembly.model.output.checkpoint_every, run, earlier ? earlier->files : std::deque<std::filesystem::path>{},
                          warn);
  CaseRun case_run(assembly, simulation, directory, first_manifest(case_file, assembly, options, threads, run), run, checkpoints,
                   earlier ? &earlier->checkpoint.state : nullptr);
  earlier.reset();
  case_run.advance(gas_steps, end);

  const std::filesystem::path newest = checkpoints.newest();
  const std::string go_on = newest.empty() ? "" : fmt::format("checkpoint {} (go on with --resume)\n", newest.string());
  const int signal_number = StopSignal::received();
  if (signal_number != 0) {
    out << fmt::format("\ninterrupted at t = {:.6g} s; results so far are in {}\n{}",
                       simulation.time() / assembly.results.time, directory.path().string(), go_on);
    return k_exit_of_signal + signal_number;
  }
  if (!case_run.outputs().profiles().settings().heights.empty()) out << "\n" << profile_table(case_run.outputs().profiles());
  if (asks_for_effects(case_file.scene)) {
    const similitude_occurred seen = case_run.occurred().ranges();
    const std::vector<EffectVerdict> before = judge_effects(assembly.real, catalogue, nullptr);
    for (const std::string& thought : second_thoughts(assembly.real.models, before, judge_effects(assembly.real, catalogue, &seen))) {
      out << "\neffects: " << thought << "\n";
    }
  }
  out << "\n" << books(simulation.balances());
  out << fmt::format("results in {}\n{}state {}\n", directory.path().string(), go_on, case_run.hash());
  return 0;
}

}  // namespace similitude
