#pragma once
/// front_view.bin: the bed as seen through its front wall (y = 0), some eighty pictures of a run, small enough to go into its report.
///
/// Little-endian. A header of 32 bytes: "SIMFRONT", uint32 version, uint32 0, float64 width and height of the domain [m].
/// Then pictures, each: float64 time [s], float32 largest speed of all particles [m/s], float32 largest radius [m], float32 share
/// of the visible particles that is drawn, uint32 count, and `count` rows of six bytes, the farthest first: uint16 x and z as
/// shares of width and height, uint8 root of speed over the largest, uint8 radius over the largest. All of the real bed.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "output/directory.h"
#include "output/map_back.h"
#include "particles/store.h"

namespace similitude {

inline constexpr const char* k_front_view_file = "front_view.bin";
inline constexpr int k_front_view_pictures = 80;        // of a run from start to end
inline constexpr std::size_t k_front_view_rows = 4000;  // of a picture: more are thinned by id, the same ones in every picture

class FrontView {
 public:
  /// `width`, `height`: of the real domain [m]. Starts the file anew, or goes on after the last picture at or before
  /// `after` [s, real], cutting off what follows. Throws OutputError.
  FrontView(const OutputDirectory& directory, const MapBack& map_back, double width, double height,
            std::optional<double> after);

  /// `time` [s, simulated]. What stands in front hides what is behind. Throws OutputError.
  void add(const ParticleStore& particles, double time);

 private:
  struct Grain {
    double x, y, z, radius, speed;  // [m], [m/s], of the real bed
    std::uint64_t id;
  };

  void take(const ParticleStore& particles);
  void leave_the_visible();

  std::filesystem::path file_;
  MapBack map_;
  double width_, height_;  // [m]
  std::vector<Grain> grains_;
  std::vector<std::uint8_t> covered_;  // places of the front wall
  std::vector<char> bytes_;
};

/// Where the pictures of a file begin, and where the last whole one ends; empty if it is no such file.
struct FrontViewIndex {
  struct Picture {
    std::size_t begin = 0, end = 0;  // [bytes]
    double time = 0;                 // [s]
  };
  std::vector<Picture> pictures;
};
FrontViewIndex front_view_index(const std::vector<char>& bytes);
inline constexpr std::size_t k_front_view_header = 32;  // [bytes]
/// The whole file; empty if it cannot be read.
std::vector<char> read_front_view(const std::filesystem::path& folder);

}  // namespace similitude
