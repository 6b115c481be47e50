/// Particle-steps per second of the DEM engine on the case that other codes were measured on (bench_bed.h).
///
///   dem_bench [--bed FILE.data | --particles N] [--state settled|dense|kick|spout|resting] [--steps N] [--repeats N] [--warm N]
///             [--skin M] [--friction MU] [--json FILE]
///   dem_bench … --make FILE.data        write the bed instead of measuring
///   dem_bench --bed FILE.data --copies N --particles N --make FILE.data   pile copies of a settled bed, bring it to rest
///   dem_bench --observe FILE.data       what positions and velocities of a bed say, as JSON
///
/// Without --bed, particles are poured and settled first; `resting` is a lattice with as many contacts, at once. Time is the processor time of all threads and the wall time; other
/// jobs on the machine move the second more than the first.

#include <ctime>
#include <exception>
#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>

#include "bed_states.h"
#include "bench_bed.h"

namespace {
using namespace similitude;
using namespace similitude::bench;

double seconds(clockid_t clock) {
  std::timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

nlohmann::json to_json(const Observables& seen) {
  return {{"coordination", seen.coordination}, {"top", seen.top},         {"kinetic_energy", seen.kinetic_energy},
          {"normal_force", seen.normal_force}, {"pairs", seen.pairs}};
}

using Given = std::map<std::string, std::string>;

ParticleStore bed_of(const Given& given) {
  const auto particles = static_cast<std::size_t>(std::stoull(given.at("--particles")));
  const std::string& file = given.at("--bed");
  if (given.at("--state") == "resting") return resting_lattice(particles);
  ParticleStore bed = file.empty() ? poured_bed(particles) : read_bed(file);
  if (const int copies = std::stoi(given.at("--copies")); copies > 1) bed = piled_bed(bed, copies, particles);
  if (!put_into_state(bed, given.at("--state"))) {
    std::fprintf(stderr, "--state: there is no state %s.\n  Use settled, dense, kick, spout or resting.\n", given.at("--state").c_str());
    std::exit(2);
  }
  return bed;
}

/// Measures and prints; the measured loops as JSON.
nlohmann::json measure(ParticleStore& bed, const Given& given) {
  const auto steps = std::stoll(given.at("--steps"));
  const std::size_t particles = bed.size();
  const double work = static_cast<double>(particles) * static_cast<double>(steps);
  const ModelScene scene = box_around(bed);
  const ContactModel law = contact_law(k_stiffness, k_restitution, std::stod(given.at("--friction")));
  const double begin = seconds(CLOCK_MONOTONIC);
  Engine engine(bed, scene, law, options(k_dt, 0, std::stod(given.at("--skin"))));
  engine.advance(1);
  const double start = seconds(CLOCK_MONOTONIC) - begin;
  engine.advance(std::max(std::stoll(given.at("--warm")) - 1, 0ll));   // a step of warming is done
  double best_processor = std::numeric_limits<double>::infinity(), best_wall = best_processor;
  nlohmann::json loops = nlohmann::json::array();
  for (int repeat = 0; repeat < std::stoi(given.at("--repeats")); ++repeat) {
    const std::vector<StageTime> before = engine.stage_times();
    const std::uint64_t rebuilds_before = engine.report().rebuilds;
    const double processor = seconds(CLOCK_PROCESS_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
    engine.advance(steps);
    const double spent = seconds(CLOCK_PROCESS_CPUTIME_ID) - processor, passed = seconds(CLOCK_MONOTONIC) - wall;
    const std::uint64_t rebuilds = engine.report().rebuilds - rebuilds_before;
    best_processor = std::min(best_processor, spent);
    best_wall = std::min(best_wall, passed);
    std::printf("%6.2f M particle-steps/s of processor time, %6.2f M/s of wall time; rebuilds %3llu;", 1e-6 * work / spent,
                1e-6 * work / passed, static_cast<unsigned long long>(rebuilds));
    const std::vector<StageTime> after = engine.stage_times();
    nlohmann::json stages;
    for (std::size_t stage = 0; stage < after.size(); ++stage) {
      const double nanoseconds = 1e9 * (after[stage].seconds - before[stage].seconds) / work;
      std::printf(" %s %.1f ns", after[stage].name.c_str(), nanoseconds);
      stages[after[stage].name] = nanoseconds;
    }
    std::printf("\n");
    loops.push_back({{"particle_steps_per_s", work / passed}, {"rebuilds", rebuilds}, {"ns_per_particle_step", stages}});
  }
  std::printf("best: %.2f M particle-steps/s of processor time, %.2f M/s of wall time\n", 1e-6 * work / best_processor,
              1e-6 * work / best_wall);
  std::printf("contacts per particle %.2f; largest overlap %.4f d; bytes per particle: rows %zu, lists %zu, history %zu\n",
              static_cast<double>(engine.report().contacts) / static_cast<double>(particles),
              engine.report().largest_overlap.overlap_ratio, bed.bytes_per_particle(), engine.list_bytes() / particles,
              engine.history_bytes() / particles);
  return {{"particles", particles}, {"steps", steps}, {"start_s", start}, {"loops", loops}, {"physics", to_json(observe(bed))}};
}

int run(const Given& given) {
  if (const std::string& file = given.at("--observe"); !file.empty()) {
    std::printf("%s\n", to_json(observe(read_bed(file))).dump().c_str());
    return 0;
  }
  ParticleStore bed = bed_of(given);
  if (const std::string& file = given.at("--make"); !file.empty()) {
    write_bed(bed, file);
    return 0;
  }
  const nlohmann::json result = measure(bed, given);
  if (const std::string& file = given.at("--json"); !file.empty()) std::ofstream(file) << result.dump(1) << '\n';
  return 0;
}

}  // namespace

int main(int count, char** words) {
  Given given{{"--particles", "20000"}, {"--bed", ""},   {"--copies", "1"},  {"--state", "settled"}, {"--make", ""},     {"--observe", ""},
              {"--steps", "600"},       {"--warm", "200"}, {"--repeats", "5"}, {"--skin", "0"},      {"--friction", "0.3"}, {"--json", ""}};
  for (int w = 1; w < count; w += 2) {
    if (!given.contains(words[w]) || w + 1 == count) {
      std::fprintf(stderr, "%s: no such option, or its value is missing.\n", words[w]);
      return 2;
    }
    given[words[w]] = words[w + 1];
  }
  try {
    return run(given);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
