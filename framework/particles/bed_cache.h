#pragma once
/// Settled beds on disk. A file holds its whole key and a checksum: what does not match to the letter is as good as absent.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "particles/fill.h"
#include "scene/scene.h"

namespace similitude {

/// One settled particle, by id.
struct CachedParticle {
  std::array<double, 3> position;   // [m]
  std::uint32_t species;
};

/// All that shapes a settled bed, as text with every digit: geometry, classes, gravity, law with version and parameters, step.
std::string bed_key(const ModelScene& scene, const ContactModel& law, const FillOptions& options);

/// <folder>/<hash of the key>.bin
std::string bed_cache_file(const std::string& folder, const std::string& key);

/// Empty if there is no such file, or it is damaged, or of another bed or format.
std::optional<std::vector<CachedParticle>> read_bed(const std::string& file, const std::string& key);

/// Writes under a temporary name and renames, so that nobody reads half a bed. A cache that cannot be written is no error:
/// returns false.
bool write_bed(const std::string& file, const std::string& key, const std::vector<CachedParticle>& bed);

}  // namespace similitude
