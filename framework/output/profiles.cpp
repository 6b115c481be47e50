#include "output/profiles.h"

#include <algorithm>
#include <cmath>

#include "output/csv.h"

namespace similitude {
namespace {

constexpr const char* k_vertical_velocity = "vertical_velocity [m/s]";
constexpr const char* k_gas_fraction = "gas_fraction [1]";

/// The middle third of the depth.
Interval central_third(double depth) { return {depth / 3, depth * 2 / 3}; }

double shared_length(const Interval& a, const Interval& b) {
  return std::max(0.0, std::min(a.high, b.high) - std::max(a.low, b.low));
}

void extend(ProfileWindow& window, double time) {
  if (window.instants++ == 0) window.from = time;
  window.to = time;
}

/// Shares of the grid's layers along one axis with an interval of the real bed: first layer and lengths [m].
struct Shares {
  std::size_t first = 0;
  std::vector<double> lengths;
};
Shares shares(const Grid& grid, const MapBack& map, int axis, const Interval& wanted) {
  Shares found;
  const double origin = grid.table().origin[axis], h = grid.spacing(axis);
  for (int layer = 0; layer < grid.cells(axis); ++layer) {
    const Interval cell = {map.length(origin + layer * h), map.length(origin + (layer + 1) * h)};
    const double length = shared_length(cell, wanted);
    if (length <= 0) continue;
    if (found.lengths.empty()) found.first = static_cast<std::size_t>(layer);
    found.lengths.push_back(length);
  }
  return found;
}

}  // namespace

ProfileSettings profile_settings(const RealScene& real) {
  ProfileSettings settings;
  settings.heights = real.output.profiles.z;
  settings.size = real.size;
  settings.from = real.output.profiles.from;
  return settings;
}

ProfileSampler::ProfileSampler(ProfileSettings settings, MapBack map_back)
    : settings_(std::move(settings)),
      map_back_(std::move(map_back)),
      seen_{.solids = std::vector<Bin>(settings_.heights.size() * bins_across()),
            .gas = std::vector<Bin>(settings_.heights.size() * bins_across()),
            .solids_window = {},
            .gas_window = {}} {}

std::size_t ProfileSampler::bins_across() const {
  // A width that is a whole number of bins but for rounding must not get a sliver of a bin more.
  const double bins = settings_.size[0] / settings_.bin_width;
  const double nearest = std::round(bins);
  const bool whole = nearest > 0 && std::abs(bins - nearest) < 1e-9 * nearest;
  return static_cast<std::size_t>(whole ? nearest : std::ceil(bins));
}

Interval ProfileSampler::bin_extent(std::size_t bin) const {
  return {static_cast<double>(bin) * settings_.bin_width,
          std::min(static_cast<double>(bin + 1) * settings_.bin_width, settings_.size[0])};
}

void ProfileSampler::sample(const ParticleStore& particles, double time) {
  const double real_time = map_back_.time(time);
  if (real_time < settings_.from || seen_.solids.empty()) return;
  extend(seen_.solids_window, real_time);

  struct Sums {
    double momentum = 0, mass = 0;
  };
  const std::size_t across = bins_across();
  const Interval depth = central_third(settings_.size[1]);
  std::vector<Sums> sums(seen_.solids.size());
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const Row& p = particles.position[k];
    const double y = map_back_.length(p.y), z = map_back_.length(p.z);
    if (y < depth.low || y > depth.high) continue;
    const double place = std::max(0.0, std::floor(map_back_.length(p.x) / settings_.bin_width));
    const std::size_t column = std::min(static_cast<std::size_t>(place), across - 1);
    for (std::size_t level = 0; level < settings_.heights.size(); ++level) {
      if (std::abs(z - settings_.heights[level]) > settings_.half_thickness) continue;
      const std::size_t bin = level * across + column;
      const Row& v = particles.velocity[k];
      sums[bin].momentum += v.w * map_back_.velocity(v.z);
      sums[bin].mass += v.w;
      ++seen_.solids[bin].n;
    }
  }
  for (std::size_t bin = 0; bin < sums.size(); ++bin) seen_.solids[bin].average.add(sums[bin].momentum, sums[bin].mass);
}

void ProfileSampler::sample(const Grid& grid, const Column<double>& gas_fraction, double time) {
  const double real_time = map_back_.time(time);
  if (real_time < settings_.from || seen_.gas.empty()) return;
  extend(seen_.gas_window, real_time);

  const std::size_t across = bins_across();
  const Shares in_y = shares(grid, map_back_, 1, central_third(settings_.size[1]));
  for (std::size_t level = 0; level < settings_.heights.size(); ++level) {
    const double z0 = settings_.heights[level];
    const Shares in_z = shares(grid, map_back_, 2, {z0 - settings_.half_thickness, z0 + settings_.half_thickness});
    for (std::size_t column = 0; column < across; ++column) {
      const Shares in_x = shares(grid, map_back_, 0, bin_extent(column));
      Bin& bin = seen_.gas[level * across + column];
      double sum = 0, volume = 0;
      for (std::size_t k = 0; k < in_z.lengths.size(); ++k)
        for (std::size_t j = 0; j < in_y.lengths.size(); ++j)
          for (std::size_t i = 0; i < in_x.lengths.size(); ++i) {
            const std::size_t cell = grid.cell(static_cast<int>(in_x.first + i), static_cast<int>(in_y.first + j),
                                               static_cast<int>(in_z.first + k));
            const double share = in_x.lengths[i] * in_y.lengths[j] * in_z.lengths[k];
            sum += share * gas_fraction[cell];
            volume += share;
            ++bin.n;
          }
      bin.average.add(sum, volume);
    }
  }
}

void ProfileSampler::append_rows(const std::string& sampler, const std::vector<Bin>& bins,
                                 std::vector<ProfileRow>& rows) const {
  const std::size_t across = bins_across();
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    const Interval extent = bin_extent(bin % across);
    const BlockAverage& average = bins[bin].average;
    rows.push_back({sampler, 0.5 * (extent.low + extent.high), 0.5 * settings_.size[1], settings_.heights[bin / across],
                    average.mean(), average.standard_error(), bins[bin].n, average.effective_blocks()});
  }
}

std::vector<ProfileRow> ProfileSampler::rows() const {
  std::vector<ProfileRow> rows;
  if (seen_.solids_window.instants > 0) append_rows(k_vertical_velocity, seen_.solids, rows);
  if (seen_.gas_window.instants > 0) append_rows(k_gas_fraction, seen_.gas, rows);
  return rows;
}

std::vector<ProfileBlockRow> ProfileSampler::block_rows() const {
  std::vector<ProfileBlockRow> rows;
  const std::size_t across = bins_across();
  const auto append = [&](const char* sampler, const std::vector<Bin>& bins) {
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
      const Interval extent = bin_extent(bin % across);
      const auto& blocks = bins[bin].average.blocks();
      for (std::size_t b = 0; b < blocks.size(); ++b)
        rows.push_back({sampler, 0.5 * (extent.low + extent.high), settings_.heights[bin / across], b, blocks[b].weighted,
                        blocks[b].weight});
    }
  };
  append(k_vertical_velocity, seen_.solids);
  append(k_gas_fraction, seen_.gas);
  return rows;
}

void write_profile_blocks(const OutputDirectory& directory, const std::vector<ProfileBlockRow>& rows) {
  CsvWriter csv(directory.file("profile_blocks.csv"), {"sampler", "x", "z", "block", "weighted sum", "weight"});
  for (const ProfileBlockRow& row : rows)
    csv.row_of_text({row.sampler, csv_number(row.x), csv_number(row.z), std::to_string(row.block),
                     csv_number(row.weighted_sum), csv_number(row.weight)});
}

void write_profiles(const OutputDirectory& directory, const std::vector<ProfileRow>& rows) {
  CsvWriter csv(directory.file("profiles.csv"), {"sampler", "x", "y", "z", "mean", "standard error", "n", "blocks"});
  for (const ProfileRow& row : rows)
    csv.row_of_text({row.sampler, csv_number(row.x), csv_number(row.y), csv_number(row.z), csv_number(row.mean),
                     csv_number(row.standard_error), std::to_string(row.n), csv_number(row.blocks)});
}

}  // namespace similitude
