/// Particle-steps per second of the DEM engine on a settled bed, with the case that other codes were measured on: 1 mm
/// spheres of 1040 kg/m^3 in a box 145 x 20 mm, k = 1000 N/m, e = 0.74, friction 0.3 with tangential history,
/// dt = 2.5e-6 s.
///
///   dem_bench [--particles N] [--bed FILE] [--steps N] [--repeats N] [--kick M_PER_S] [--stretch FACTOR] [--skin M]
///             [--friction MU] [--start free|history]
///
/// The settled bed is kept in FILE and read from it the next time. Time is the processor time of all threads and the wall
/// time; other jobs on the machine move the second more than the first.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <map>
#include <string>

#include <similitude/abi.h>

#include "particles/engine.h"

extern "C" {
extern const similitude_entry similitude_plugin;
}

namespace {
using namespace similitude;

constexpr double k_diameter = 1e-3;    // [m]
constexpr double k_density = 1040;     // [kg/m^3]
constexpr double k_mass = k_density * 3.14159265358979323846 / 6 * k_diameter * k_diameter * k_diameter;

ModelScene box() {
  ModelScene scene;
  scene.size = {0.145, 0.02, 0.6};
  return scene;
}

ContactModel law(double stiffness, double restitution, double friction) {
  const similitude_descriptor& plugin = *similitude_plugin.descriptors[0];
  std::vector<similitude_value> values;
  const std::map<std::string, double> given{{"stiffness", stiffness}, {"restitution", restitution}, {"friction", friction},
                                            {"attraction", 1}};
  for (std::uint32_t p = 0; p < plugin.parameter_count; ++p) {
    const auto it = given.find(plugin.parameters[p].name);
    values.push_back({it == given.end() ? plugin.parameters[p].default_value : it->second, nullptr});
  }
  similitude_host host{};
  host.struct_size = sizeof host;
  similitude_bed bed{};
  bed.struct_size = sizeof bed;
  similitude_status status{};
  void* instance = plugin.create(&host, &bed, values.data(), 1, &status);
  if (!instance) {
    std::fprintf(stderr, "%s\n", status.text);
    std::exit(2);
  }
  return ContactModel(plugin, instance);
}

EngineOptions options(double dt, double damping, double skin = 0) {
  EngineOptions out;
  out.dt = dt;
  out.gravity = {0, 0, -9.81};
  out.velocity_damping = damping;
  out.skin = skin;
  return out;
}

/// A reproducible number in [-1, 1).
double scatter() {
  static std::uint64_t state = 12345;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) / 4503599627370496.0 - 1;
}

void pour(ParticleStore& bed, std::size_t count) {
  const double pitch = 1.09 * k_diameter, jitter = 0.03 * k_diameter;
  const auto nx = static_cast<std::size_t>((0.145 - 0.1 * k_diameter) / pitch);
  const auto ny = static_cast<std::size_t>((0.02 - 0.1 * k_diameter) / pitch);
  const double ax = 0.145 / static_cast<double>(nx), ay = 0.02 / static_cast<double>(ny);
  for (std::size_t n = 0; n < count; ++n) {
    const auto column = static_cast<double>(n % nx), line = static_cast<double>(n / nx % ny);
    const auto layer = static_cast<double>(n / (nx * ny));
    bed.add(n, 0, (column + 0.5) * ax + jitter * scatter(), (line + 0.5) * ay + jitter * scatter(),
            (layer + 0.5) * pitch + jitter * scatter(), 0.5 * k_diameter, k_mass);
  }
}

void settle(ParticleStore& bed) {
  const ModelScene scene = box();
  const double height = std::max_element(bed.position.begin(), bed.position.end(),
                                         [](const Row& a, const Row& b) { return a.z < b.z; })->z;
  // Soft and damped until all lies, then the target stiffness until all is quiet.
  const ContactModel soft = law(67, 0.3, 0.3);
  const double fall = std::sqrt(2 * 0.2 * height / 9.81) + 0.05;   // [s]
  Engine falling(bed, scene, soft, options(1e-5, 20));
  falling.advance(static_cast<std::int64_t>(fall / 1e-5));
  const ContactModel stiff = law(1000, 0.3, 0.3);
  Engine resting(bed, scene, stiff, options(5e-6, 50));
  resting.advance(10'000);
}

bool read_bed(ParticleStore& bed, const std::string& file, std::size_t count) {
  std::ifstream in(file, std::ios::binary);
  for (std::size_t n = 0; n < count && in; ++n) {
    std::array<double, 6> p{};
    in.read(reinterpret_cast<char*>(p.data()), sizeof p);
    if (!in) return false;
    const std::size_t row = bed.add(n, 0, p[0], p[1], p[2], 0.5 * k_diameter, k_mass);
    bed.velocity[row] = {p[3], p[4], p[5], k_mass};
  }
  return bed.size() == count;
}

void write_bed(const ParticleStore& bed, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  for (std::size_t row = 0; row < bed.size(); ++row) {
    const Row &x = bed.position[row], &v = bed.velocity[row];
    const std::array<double, 6> p{x.x, x.y, x.z, v.x, v.y, v.z};
    out.write(reinterpret_cast<const char*>(p.data()), sizeof p);
  }
}

double processor_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

int main(int count, char** words) {
  std::map<std::string, std::string> given{{"--particles", "20000"}, {"--bed", ""},     {"--steps", "600"}, {"--repeats", "5"},
                                           {"--kick", "0"},          {"--stretch", "1"}, {"--skin", "0"},    {"--friction", "0.3"},
                                           {"--warm", "200"}};
  for (int w = 1; w + 1 < count; w += 2) given[words[w]] = words[w + 1];
  const auto particles = static_cast<std::size_t>(std::stoull(given["--particles"]));
  const auto steps = std::stoll(given["--steps"]);
  const double kick = std::stod(given["--kick"]), stretch = std::stod(given["--stretch"]);

  ParticleStore bed({.rotation = true, .coupling = false});
  if (given["--bed"].empty() || !read_bed(bed, given["--bed"], particles)) {
    bed = ParticleStore({.rotation = true, .coupling = false});
    pour(bed, particles);
    settle(bed);
    if (!given["--bed"].empty()) write_bed(bed, given["--bed"]);
  }
  for (std::size_t row = 0; row < bed.size(); ++row) {
    Row& v = bed.velocity[row];
    v = {v.x + kick * scatter(), v.y + kick * scatter(), v.z + kick * scatter(), v.w};
    bed.position[row].z *= stretch;
  }

  const ModelScene scene = box();
  const ContactModel measured = law(1000, 0.74, std::stod(given["--friction"]));
  Engine engine(bed, scene, measured, options(2.5e-6, 0, std::stod(given["--skin"])));
  engine.advance(std::stoll(given["--warm"]));
  double best_processor = std::numeric_limits<double>::infinity(), best_wall = best_processor;
  for (int repeat = 0; repeat < std::stoi(given["--repeats"]); ++repeat) {
    const std::vector<StageTime> before = engine.stage_times();
    const std::uint64_t rebuilds = engine.report().rebuilds;
    const double processor = processor_seconds(), wall = wall_seconds();
    engine.advance(steps);
    const double spent = processor_seconds() - processor, passed = wall_seconds() - wall;
    best_processor = std::min(best_processor, spent);
    best_wall = std::min(best_wall, passed);
    const double work = static_cast<double>(particles) * static_cast<double>(steps);
    std::printf("%6.2f M particle-steps/s of processor time, %6.2f M/s of wall time; rebuilds %3llu;", 1e-6 * work / spent,
                1e-6 * work / passed, static_cast<unsigned long long>(engine.report().rebuilds - rebuilds));
    const std::vector<StageTime> after = engine.stage_times();
    for (std::size_t stage = 0; stage < after.size(); ++stage) {
      std::printf(" %s %.1f ns", after[stage].name.c_str(), 1e9 * (after[stage].seconds - before[stage].seconds) / work);
    }
    std::printf("\n");
  }
  const double work = 1e-6 * static_cast<double>(particles) * static_cast<double>(steps);
  std::printf("best: %.2f M particle-steps/s of processor time, %.2f M/s of wall time\n", work / best_processor, work / best_wall);
  std::printf("contacts per particle %.2f; largest overlap %.4f d; bytes per particle: rows %zu, lists %zu, history %zu\n",
              static_cast<double>(engine.report().contacts) / static_cast<double>(particles),
              engine.report().largest_overlap.overlap_ratio, bed.bytes_per_particle(), engine.list_bytes() / particles,
              engine.history_bytes() / particles);
  return 0;
}
