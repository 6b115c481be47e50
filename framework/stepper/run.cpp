#include "stepper/run.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include <fmt/format.h>

#include "output/manifest.h"
#include "output/progress.h"
#include "output/state_hash.h"
#include "output/timing.h"
#include "output/view_script.h"
#include "particles/errors.h"
#include "stepper/bed.h"
#include "stepper/run_outputs.h"
#include "stepper/simulation.h"
#include "stepper/stop_signal.h"
#include "stepper/version.h"

namespace similitude {
namespace {

constexpr int k_exit_of_signal = 128;   // shells' convention: 128 + signal number

void warn(const std::string& text) { std::cerr << "warning: " << text << "\n"; }

Manifest first_manifest(const CaseFile& case_file, const Assembly& assembly, const RunOptions& options, int threads,
                        std::size_t particles) {
  Manifest manifest;
  manifest.program_version = program_version();
  manifest.command = options.command;
  manifest.case_file = case_file.scene.folder + "/" + case_file.scene.name + ".yaml";
  for (const PluginEntry& plugin : assembly.plugins) manifest.plugins.push_back(manifest_plugin(plugin));
  manifest.machine = this_machine();
  manifest.threads = threads;
  manifest.scaling = assembly.ratios;
  manifest.map_back = map_back(assembly);
  manifest.particles = particles;
  manifest.started = utc_now();
  return manifest;
}

void print_start(std::ostream& out, const Assembly& assembly, const TimeSteps& steps, const FilledBed& filled,
                 const Simulation& simulation, std::int64_t gas_steps) {
  const ResultRatios& to = assembly.results;
  out << assembly.real.title << "\n";
  out << fmt::format("  models      drag {}, contact {}, fluid {}, scaling {}\n", assembly.drag.descriptor().id,
                     assembly.contact.descriptor().id, assembly.fluid.descriptor().id, assembly.scaling.descriptor().id);
  out << fmt::format("  bed         {} simulated particles{}, level {:.4g} mm, solids fraction {:.3f}{}\n",
                     simulation.particles().size(), assembly.ratios.diameter == assembly.ratios.length ? "" : " (scaled)",
                     1e3 * filled.height / to.length, filled.solids_fraction, filled.from_cache ? ", from the cache" : "");
  out << fmt::format("  time steps  {:.3g} s ({} per gas step), {} gas steps; limits:\n", steps.dt / to.time, steps.sub_steps,
                     gas_steps);
  for (const TimeStepLimit& limit : steps.limits) {
    out << fmt::format("    {} {:<28} advised {:9.3g} s  hard {:9.3g} s\n", limit.binding ? "*" : " ", limit.name,
                       limit.advised / to.time, limit.hard / to.time);
  }
  out << "  pipeline\n";
  for (const std::string& pass : simulation.pipeline()) out << "    " << pass << "\n";
  out << fmt::format("  memory      {} bytes per particle, before contact lists\n\n", simulation.particles().bytes_per_particle());
}

ProgressState progress_of(const Simulation& simulation, const Assembly& assembly, const RunOutputs& outputs) {
  return {.time = simulation.time() / assembly.results.time,
          .particle_steps = simulation.engine().report().particle_steps,
          .particles = simulation.particles().size(),
          .largest_overlap = outputs.largest_overlap_of_run()};
}

}  // namespace

int run_case(const CaseFile& case_file, const Catalogue& catalogue, const RunOptions& options, std::ostream& out) {
  for (const std::string& warning : case_file.warnings) warn(warning);
  const Assembly assembly = assemble(case_file.scene, catalogue);
  const TimeSteps steps = choose_time_steps(assembly);
  for (const std::string& warning : assembly.warnings) warn(warning);
  for (const std::string& warning : steps.warnings) warn(warning);

  const int threads = options.threads > 0 ? options.threads : omp_get_num_procs();
  omp_set_num_threads(threads);
  const std::filesystem::path folder =
      options.folder.empty() ? std::filesystem::path("results") / case_file.scene.name : options.folder;
  const OutputDirectory directory(folder, options.force);

  const StopSignal stop_signal;
  StartingBed bed = fill_bed(assembly, steps, [said = std::string()](double, const std::string& stage) mutable {
    if (stage == said) return;
    said = stage;
    std::cerr << stage << " …\n";
  });

  const double end = options.until ? std::min(*options.until, case_file.scene.time.end) : case_file.scene.time.end;
  const auto gas_steps =
      static_cast<std::int64_t>(std::ceil(end * assembly.results.time / steps.gas_dt() * (1 - 1e-12)));

  Simulation simulation(assembly, steps, std::move(bed.particles), warn);
  print_start(out, assembly, steps, bed.filled, simulation, gas_steps);
  out.flush();

  Manifest manifest = first_manifest(case_file, assembly, options, threads, simulation.particles().size());
  write_manifest(directory, manifest, case_file.resolved);
  write_view_script(directory, assembly.real);
  RunOutputs outputs(directory, assembly);
  Progress progress(std::cerr, Progress::screen_of_standard_error(), end);
  const auto start = std::chrono::steady_clock::now();

  const auto finish = [&](const std::string& status, int exit_status, const std::string& reason) {
    outputs.finish(simulation);
    progress.finish(progress_of(simulation, assembly, outputs));
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    write_timing(directory, {.wall_s = wall,
                             .simulated_s = simulation.time() / assembly.results.time,
                             .particle_steps = simulation.engine().report().particle_steps,
                             .stages = simulation.stage_times()});
    manifest.ended = utc_now();
    manifest.status = status;
    manifest.exit_status = exit_status;
    manifest.exit_reason = reason;
    manifest.simulated_s = simulation.time() / assembly.results.time;
    manifest.state_hash = state_hash(simulation.particles(), &simulation.gas(), &simulation.exchange().gas_fraction);
    write_manifest(directory, manifest, case_file.resolved);
  };

  try {
    outputs.observe(simulation);
    while (simulation.steps_done() < gas_steps && StopSignal::received() == 0) {
      simulation.step();
      outputs.observe(simulation);
      progress.update(progress_of(simulation, assembly, outputs));
    }
  } catch (const SimulationError& error) {
    finish("stopped", 1, error.what());
    throw;
  }

  const int signal_number = StopSignal::received();
  if (signal_number != 0) {
    finish("interrupted", k_exit_of_signal + signal_number, fmt::format("signal {}", signal_number));
    out << fmt::format("\ninterrupted at t = {:.6g} s; results so far are in {}\n",
                       simulation.time() / assembly.results.time, directory.path().string());
    return k_exit_of_signal + signal_number;
  }
  finish("done", 0, "reached the end time");
  if (!outputs.profiles().settings().heights.empty()) out << "\n" << profile_table(outputs.profiles());
  out << fmt::format("\nresults in {}\nstate {}\n", directory.path().string(), manifest.state_hash);
  return 0;
}

}  // namespace similitude
