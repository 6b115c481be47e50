#include "study/profile_error.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace similitude {
namespace {

constexpr double k_confidence = 0.95;
constexpr double k_same_place = 1e-6;  // relative: coordinates were written by the same rule, or typed by hand

bool same(double a, double b) { return std::abs(a - b) <= k_same_place * std::max(std::abs(a), std::abs(b)); }

bool usable(const Profile& profile, const ProfileBin& bin) {
  if (std::isnan(bin.mean)) return false;
  return profile.measured || (!std::isnan(bin.standard_error) && bin.blocks >= k_fewest_blocks_of_a_bin);
}

double error_of(const ProfileBin& bin) { return std::isnan(bin.standard_error) ? 0 : bin.standard_error; }

/// A place of the reference and the bins of the profile that lie around it.
struct Place {
  std::size_t reference = 0;
  std::size_t left = 0, right = 0;  // bins of the profile; the same one where it lies on the place
  double right_share = 0;
  double z = 0;
  double difference = 0;
};

/// The usable bins of the profile next to x at one height; false if x lies outside them or a neighbour is missing.
bool find_around(const Profile& profile, const ProfileBin& at, Place& place) {
  const ProfileBin *left = nullptr, *right = nullptr;
  double spacing = 0, last_x = Estimate::k_unknown;
  for (const ProfileBin& bin : profile.bins) {
    if (!same(bin.z, at.z)) continue;
    if (!std::isnan(last_x)) spacing = std::max(spacing, std::abs(bin.x - last_x));
    last_x = bin.x;
    if ((bin.x <= at.x || same(bin.x, at.x)) && (left == nullptr || bin.x > left->x)) left = &bin;
    if ((bin.x >= at.x || same(bin.x, at.x)) && (right == nullptr || bin.x < right->x)) right = &bin;
  }
  // Up to half a bin beyond the outermost centres the outermost bin stands.
  if (left == nullptr && right != nullptr && right->x - at.x <= 0.5 * spacing * (1 + k_same_place)) left = right;
  if (right == nullptr && left != nullptr && at.x - left->x <= 0.5 * spacing * (1 + k_same_place)) right = left;
  if (left == nullptr || right == nullptr || !usable(profile, *left) || !usable(profile, *right)) return false;
  place.left = static_cast<std::size_t>(left - profile.bins.data());
  place.right = static_cast<std::size_t>(right - profile.bins.data());
  const double width = right->x - left->x;
  place.right_share = width > 0 ? std::clamp((at.x - left->x) / width, 0.0, 1.0) : 0;
  return true;
}

double mean_at(const Profile& profile, const Place& place) {
  return (1 - place.right_share) * profile.bins[place.left].mean + place.right_share * profile.bins[place.right].mean;
}

/// Coefficients c of the places as coefficients of the profile's and the reference's bins.
struct Coefficients {
  std::vector<double> profile, reference;
  Coefficients(const Profile& p, const Profile& r) : profile(p.bins.size(), 0.0), reference(r.bins.size(), 0.0) {}
  void add(const Place& place, double c) {
    profile[place.left] += c * (1 - place.right_share);
    profile[place.right] += c * place.right_share;
    reference[place.reference] += c;
  }
};

struct Comparison {
  const Profile& profile;
  const Profile& reference;
  double scale = 0;               // the reference's largest magnitude
  double degrees_of_freedom = 0;  // of Student's t

  double variance(const Coefficients& c) const {
    return variance_of_combination(profile, c.profile) + variance_of_combination(reference, c.reference);
  }
  double variance_at(const Place& place) const {
    Coefficients c(profile, reference);
    c.add(place, 1);
    return variance(c);
  }
};

Estimate root_mean_square(const Comparison& compared, const std::vector<Place>& places) {
  const auto n = static_cast<double>(places.size());
  Coefficients slope(compared.profile, compared.reference);
  double square = 0, noise = 0;
  for (const Place& place : places) {
    square += place.difference * place.difference / n;
    noise += compared.variance_at(place) / n;
    slope.add(place, 2 * place.difference / n);
  }
  const double without_noise = square - noise;
  const double reach = student_two_sided(k_confidence, compared.degrees_of_freedom) *
                       std::sqrt(compared.variance(slope) + 2 * noise * noise);
  Estimate result;
  result.value = std::sqrt(std::max(0.0, without_noise)) / compared.scale;
  result.low = std::sqrt(std::max(0.0, without_noise - reach)) / compared.scale;
  result.high = std::sqrt(std::max(0.0, without_noise) + reach) / compared.scale;
  return result;
}

Estimate mean_difference(const Comparison& compared, const std::vector<Place>& places) {
  Coefficients c(compared.profile, compared.reference);
  Estimate result;
  result.value = 0;
  for (const Place& place : places) {
    const double share = 1 / static_cast<double>(places.size());
    c.add(place, share);
    result.value += share * place.difference / compared.scale;
  }
  const double reach =
      student_two_sided(k_confidence, compared.degrees_of_freedom) * std::sqrt(compared.variance(c)) / compared.scale;
  result.low = result.value - reach;
  result.high = result.value + reach;
  return result;
}

Estimate largest(const Comparison& compared, const std::vector<Place>& places) {
  const double each = 1 - (1 - k_confidence) / static_cast<double>(places.size());
  Estimate result;
  result.value = result.low = result.high = 0;
  for (const Place& place : places) {
    double blocks = compared.degrees_of_freedom + 1;
    for (const ProfileBin* bin : {&compared.profile.bins[place.left], &compared.profile.bins[place.right],
                                  &compared.reference.bins[place.reference]})
      if (bin->blocks > 1) blocks = std::min(blocks, bin->blocks);
    const double reach = student_two_sided(each, blocks - 1) * std::sqrt(compared.variance_at(place));
    const double distance = std::abs(place.difference);
    result.value = std::max(result.value, distance / compared.scale);
    result.low = std::max(result.low, (distance - reach) / compared.scale);
    result.high = std::max(result.high, (distance + reach) / compared.scale);
  }
  return result;
}

/// The fewest blocks of a bin that counts; measured data have none and set no limit.
double fewest_blocks(const Profile& profile, double fewest) {
  if (profile.measured) return fewest;
  for (const ProfileBin& bin : profile.bins)
    if (usable(profile, bin) && !bin.in_blocks.empty())
      fewest = std::min(fewest, static_cast<double>(bin.in_blocks.size()));
    else if (usable(profile, bin))
      fewest = std::min(fewest, bin.blocks);
  return fewest;
}

}  // namespace

double variance_of_combination(const Profile& profile, const std::vector<double>& coefficients) {
  std::size_t blocks = 0;
  bool known = true;
  for (std::size_t i = 0; i < profile.bins.size(); ++i) {
    if (coefficients[i] == 0) continue;
    const std::size_t here = profile.bins[i].in_blocks.size();
    if (blocks == 0) blocks = here;
    known = known && here == blocks && here >= 2;
  }
  if (!known) {
    std::map<double, double> of_height;
    for (std::size_t i = 0; i < profile.bins.size(); ++i)
      if (coefficients[i] != 0) of_height[profile.bins[i].z] += std::abs(coefficients[i]) * error_of(profile.bins[i]);
    double variance = 0;
    for (const auto& [z, error] : of_height) variance += error * error;
    return variance;
  }
  std::vector<double> residual(blocks, 0.0);
  for (std::size_t i = 0; i < profile.bins.size(); ++i) {
    if (coefficients[i] == 0) continue;
    const ProfileBin& bin = profile.bins[i];
    ProfileBin::Block sum;
    for (const ProfileBin::Block& block : bin.in_blocks) {
      sum.weighted_sum += block.weighted_sum;
      sum.weight += block.weight;
    }
    // As output/block_average.h has it for one bin, Cochran (1977), eq. 6.9, with the bin's own effective blocks.
    const double mean = sum.weighted_sum / sum.weight;
    const double factor = coefficients[i] * std::sqrt(bin.blocks / (bin.blocks - 1)) / sum.weight;
    for (std::size_t b = 0; b < blocks; ++b)
      residual[b] += factor * (bin.in_blocks[b].weighted_sum - mean * bin.in_blocks[b].weight);
  }
  double variance = 0;
  for (const double r : residual) variance += r * r;
  return variance;
}

ProfileError profile_error(const Profile& profile, const Profile& reference) {
  ProfileError error;
  Comparison compared{profile, reference, 0, fewest_blocks(profile, fewest_blocks(reference, 1e6)) - 1};
  std::vector<Place> places;
  std::map<double, std::vector<Place>> by_height;
  for (std::size_t r = 0; r < reference.bins.size(); ++r) {
    const ProfileBin& at = reference.bins[r];
    if (!usable(reference, at)) {
      ++error.left_out;
      continue;
    }
    compared.scale = std::max(compared.scale, std::abs(at.mean));
    Place place{.reference = r, .z = at.z};
    if (!find_around(profile, at, place)) {
      ++error.left_out;
      continue;
    }
    place.difference = mean_at(profile, place) - at.mean;
    places.push_back(place);
    by_height[at.z].push_back(place);
  }
  error.bins = places.size();
  if (places.empty() || !(compared.scale > 0)) {
    error.l2 = error.maximum =
        gap(places.empty() ? "no bin was seen long enough on both sides" : "the reference is zero everywhere");
    return error;
  }
  error.l2 = root_mean_square(compared, places);
  error.maximum = largest(compared, places);
  for (const auto& [z, here] : by_height)
    error.heights.push_back({z, root_mean_square(compared, here), mean_difference(compared, here)});
  return error;
}

}  // namespace similitude
