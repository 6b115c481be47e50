#include "particles/bed_cache.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/material_pairs.h"

namespace similitude {

namespace {

// Raise with every change of how beds are filled or written, or old beds pass for new ones.
constexpr char k_format[] = "similitude bed 1\n";

std::uint64_t checksum(const std::string& bytes) {   // FNV-1a
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
bool take(const std::string& bytes, std::size_t& at, T& value) {
  if (bytes.size() - at < sizeof value) return false;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return true;
}

/// Numbers with all their bits.
class Key {
 public:
  Key() { text_ << std::hexfloat; }
  template <class... Values>
  Key& line(const char* name, const Values&... values) {
    text_ << name;
    ((text_ << ' ' << values), ...);
    text_ << '\n';
    return *this;
  }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

}  // namespace

std::string cache_folder_of_beds() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return std::string(cache) + "/similitude/beds";
  if (const char* home = std::getenv("HOME"); home && *home) return std::string(home) + "/.cache/similitude/beds";
  return {};
}

std::string bed_key(const ModelScene& scene, const ContactModel& law, const FillOptions& options) {
  Key key;
  key.line("size", scene.size[0], scene.size[1], scene.size[2]);
  key.line("periodic", scene.periodic[0], scene.periodic[1], scene.periodic[2]);
  key.line("gravity", scene.gravity[0], scene.gravity[1], scene.gravity[2]);
  for (const ParticleClass& type : scene.particles) {
    key.line("class", type.diameter, type.density, type.count.value_or(-1));
  }
  for (const Baffle& baffle : scene.baffles) {
    key.line("baffle", static_cast<int>(baffle.normal), baffle.position, baffle.thickness);
    for (const Interval& extent : baffle.extent) key.line("extent", extent.low, extent.high);
  }
  key.line("height", scene.bed.height.value_or(-1)).line("seed", scene.bed.seed).line("dt", options.dt);
  key.line("softened", static_cast<bool>(options.softer_law));
  key.line("law", law.descriptor().id, law.descriptor().version ? law.descriptor().version : "", options.law_sha256);
  for (const ModelChoice& set : contact_sets(scene.models)) {
    for (const ModelParameter& parameter : set.parameters) key.line("parameter", parameter.name, parameter.real, parameter.text);
  }
  return key.text();
}

std::string bed_cache_file(const std::string& folder, const std::string& key) {
  char name[32];
  std::snprintf(name, sizeof name, "/%016llx.bin", static_cast<unsigned long long>(checksum(k_format + key)));
  return folder + name;
}

std::optional<std::vector<CachedParticle>> read_bed(const std::string& file, const std::string& key) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return {};
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const std::string head = k_format + key + '\0';
  std::size_t at = head.size();
  std::uint64_t count = 0, sum = 0;
  if (bytes.size() < sizeof sum || bytes.compare(0, head.size(), head) != 0) return {};
  std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
  bytes.resize(bytes.size() - sizeof sum);
  if (checksum(bytes) != sum || !take(bytes, at, count)) return {};

  std::vector<CachedParticle> bed;
  CachedParticle particle{};
  while (at < bytes.size()) {
    for (double& x : particle.position) {
      if (!take(bytes, at, x)) return {};
    }
    if (!take(bytes, at, particle.species)) return {};
    bed.push_back(particle);
  }
  if (bed.size() != count) return {};
  return bed;
}

bool write_bed(const std::string& file, const std::string& key, const std::vector<CachedParticle>& bed) {
  std::string bytes = k_format + key + '\0';
  append(bytes, static_cast<std::uint64_t>(bed.size()));
  for (const CachedParticle& particle : bed) {
    for (const double x : particle.position) append(bytes, x);
    append(bytes, particle.species);
  }
  append(bytes, checksum(bytes));

  std::error_code problem;
  const std::filesystem::path place(file);
  std::filesystem::create_directories(place.parent_path(), problem);
  if (problem) return false;
  const std::string draft = file + "." + std::to_string(::getpid()) + ".tmp";
  std::ofstream out(draft, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (out) std::filesystem::rename(draft, place, problem);
  if (!out || problem) {
    std::error_code ignored;
    std::filesystem::remove(draft, ignored);
    return false;
  }
  return true;
}

}  // namespace similitude
