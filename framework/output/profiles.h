#pragma once
/// Profiles across the bed in the central plane, as an experimenter's camera sees them: means over a window of time.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "coupling/coupling.h"
#include "fluid/grid.h"
#include "output/block_average.h"
#include "output/directory.h"
#include "output/map_back.h"
#include "particles/store.h"

namespace similitude {

/// Of the real bed.
struct ProfileSettings {
  std::vector<double> heights;     // [m]
  std::array<double, 3> size{};    // [m], the bed
  double from = 0;                 // [s], averaging starts
  double bin_width = 5e-3;         // [m], along x; the last bin ends at the wall
  double half_thickness = 2.5e-3;  // [m], of the slab around a height
};
ProfileSettings profile_settings(const RealScene& real);

/// A line of profiles.csv. Of the real bed.
struct ProfileRow {
  std::string sampler;         // "vertical_velocity [m/s]", "gas_fraction [1]"
  double x = 0, y = 0, z = 0;  // [m], centre of the bin
  double mean = 0;             // NaN: the bin stayed empty
  double standard_error = 0;   // NaN: fewer than two blocks saw anything
  std::uint64_t n = 0;         // particles (cells) counted, over all instants
  double blocks = 0;           // effective number of blocks behind the standard error
};

/// A line of profile_blocks.csv: what one block of instants holds of one bin.
struct ProfileBlockRow {
  std::string sampler;
  double x = 0, z = 0;                  // [m], centre of the bin
  std::size_t block = 0;                // from 0; the same instants for all bins of a sampler
  double weighted_sum = 0, weight = 0;  // mean of the block: weighted_sum / weight
};

/// Sampling window of one sampler. Of the real bed.
struct ProfileWindow {
  double from = 0, to = 0;  // [s], first and last instant
  std::uint64_t instants = 0;
};

class ProfileSampler {
 public:
  ProfileSampler(ProfileSettings settings, MapBack map_back);

  /// Vertical velocity of the solids: sum m v / sum m. Simulated bed's time [s]; instants before `from` are passed
  /// over. A particle belongs to a bin by its centre: |z - z0| <= half_thickness, middle third of the depth.
  void sample(const ParticleStore& particles, double time);
  /// Gas fraction over the same bins: cells weighted by the volume they share with the bin.
  void sample(const Grid& grid, const Column<double>& gas_fraction, double time);

  /// By sampler, then height, then x.
  std::vector<ProfileRow> rows() const;
  const ProfileWindow& solids_window() const { return seen_.solids_window; }
  const ProfileWindow& gas_window() const { return seen_.gas_window; }
  /// In the same order, block by block.
  std::vector<ProfileBlockRow> block_rows() const;
  const ProfileSettings& settings() const { return settings_; }

  struct Bin {
    BlockAverage average;
    std::uint64_t n = 0;
  };
  /// All that was seen so far, for checkpoints.
  struct State {
    std::vector<Bin> solids, gas;  // height by height, x fastest
    ProfileWindow solids_window, gas_window;
  };
  const State& state() const { return seen_; }
  /// Of a sampler with the same settings.
  void restore(State state) { seen_ = std::move(state); }

 private:
  std::size_t bins_across() const;
  Interval bin_extent(std::size_t bin) const;
  void append_rows(const std::string& sampler, const std::vector<Bin>& bins, std::vector<ProfileRow>& rows) const;

  ProfileSettings settings_;
  MapBack map_back_;
  State seen_;
};

/// profiles.csv: sampler,x,y,z,mean,standard error,n,blocks. Throws OutputError.
void write_profiles(const OutputDirectory& directory, const std::vector<ProfileRow>& rows);

/// profile_blocks.csv: sampler,x,z,block,weighted sum,weight. Throws OutputError.
void write_profile_blocks(const OutputDirectory& directory, const std::vector<ProfileBlockRow>& rows);

/// A table with bars for the terminal, a block per sampler and height; says the window, and names empty bins.
std::string profile_table(const ProfileSampler& sampler);

}  // namespace similitude
