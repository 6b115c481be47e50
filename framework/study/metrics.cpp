#include "study/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "study/run_files.h"

namespace similitude {
namespace {

constexpr std::array k_metrics{
    Metric{"velocity_profile", MetricKind::profile_l2, "vertical_velocity [m/s]", "1",
           "root mean square difference of the particles' vertical velocity over the reference's largest"},
    Metric{"velocity_profile_maximum", MetricKind::profile_maximum, "vertical_velocity [m/s]", "1",
           "largest difference of the particles' vertical velocity over the reference's largest"},
    Metric{"gas_fraction_profile", MetricKind::profile_l2, "gas_fraction [1]", "1",
           "root mean square difference of the gas fraction over the reference's largest"},
    Metric{"gas_fraction_profile_maximum", MetricKind::profile_maximum, "gas_fraction [1]", "1",
           "largest difference of the gas fraction over the reference's largest"},
    Metric{"pressure_drop", MetricKind::mean, "pressure_drop [Pa]", "Pa", "mean pressure drop"},
    Metric{"pressure_drop_fluctuation", MetricKind::fluctuation, "pressure_drop [Pa]", "Pa",
           "standard deviation of the pressure drop in time"},
    Metric{"bed_height", MetricKind::mean, "bed_height [m]", "m", "mean bed height"},
    Metric{"bed_height_fluctuation", MetricKind::fluctuation, "bed_height [m]", "m",
           "standard deviation of the bed height in time"},
    Metric{"dominant_frequency", MetricKind::frequency, "pressure_drop [Pa]", "Hz",
           "highest peak in the spectrum of the pressure drop"},
    Metric{"last_pressure_drop", MetricKind::last, "pressure_drop [Pa]", "Pa",
           "pressure drop at the end, taken as free of noise: for a gas at rest with its bed"},
    Metric{"last_kinetic_energy", MetricKind::last, "kinetic_energy [J]", "J",
           "kinetic energy of the solids at the end, taken as free of noise: for a single impact"},
    Metric{"momentum_residual", MetricKind::residual, "momentum_residual [1]", "1",
           "largest imbalance of the particles' momentum in the run"},
    Metric{"energy_residual", MetricKind::residual, "energy_residual [1]", "1",
           "largest imbalance of the particles' energy in the run"},
    Metric{"gas_balance_residual", MetricKind::residual, "gas_balance_residual [1]", "1",
           "largest imbalance of the gas's mass in the run"},
};

Estimate value_of(const Metric& metric, const Observations& seen) {
  if (const auto given = seen.given.find(metric.name); given != seen.given.end()) return given->second;
  if (metric.kind == MetricKind::residual) {
    const auto found = seen.largest.find(metric.source);
    return found == seen.largest.end() || std::isnan(found->second)
               ? gap("this run has no " + std::string(metric.source))
               : exactly(found->second);
  }
  const auto found = seen.monitors.find(metric.source);
  if (found == seen.monitors.end() || found->second.values.empty())
    return gap("this run has no " + std::string(metric.source));
  switch (metric.kind) {
    case MetricKind::mean:
      return mean_of(found->second);
    case MetricKind::last:
      return exactly(found->second.values.back());
    case MetricKind::fluctuation:
      return fluctuation_of(found->second);
    default:
      return dominant_frequency_of(found->second);
  }
}

/// |a - b| / |b|, the two intervals independent of each other.
Estimate relative_difference(const Estimate& value, const Estimate& reference) {
  if (!value.known()) return value;
  if (!reference.known()) return gap("the reference: " + reference.gap);
  if (reference.value == 0) return gap("the reference is zero");
  const double scale = std::abs(reference.value), distance = std::abs(value.value - reference.value);
  const double reach = std::hypot(value.half_width(), reference.half_width());
  Estimate error;
  error.value = distance / scale;
  error.low = std::max(0.0, distance - reach) / scale;
  error.high = (distance + reach) / scale;
  error.effective_samples = std::fmin(value.effective_samples, reference.effective_samples);
  error.lower_bound = value.lower_bound || reference.lower_bound;
  return error;
}

void mark(Estimate& estimate, double samples) {
  if (!estimate.known()) return;
  estimate.effective_samples = samples;
  estimate.lower_bound = samples < k_fewest_samples;
}

MetricResult measure_profile(const Metric& metric, const Observations& seen, const Observations* reference) {
  MetricResult result{.metric = &metric, .value = {}, .error = {}, .heights = {}};
  const Profile* own = seen.profile(metric.source);
  const Profile* other = reference != nullptr ? reference->profile(metric.source) : nullptr;
  if (own == nullptr || other == nullptr) {
    result.value = result.error = gap(reference == nullptr ? "there is no reference to compare with"
                                      : own == nullptr     ? "this run has no profiles"
                                                           : "the reference has no " + std::string(metric.source));
    return result;
  }
  const ProfileError error = profile_error(*own, *other);
  result.value = metric.kind == MetricKind::profile_l2 ? error.l2 : error.maximum;
  result.heights = error.heights;
  result.bins = error.bins;
  result.bins_left_out = error.left_out;
  const double samples = other->measured ? effective_samples_of(seen)
                                         : std::fmin(effective_samples_of(seen), effective_samples_of(*reference));
  mark(result.value, samples);
  for (ErrorAtHeight& height : result.heights) {
    mark(height.l2, samples);
    mark(height.difference, samples);
  }
  result.error = result.value;
  return result;
}

}  // namespace

std::span<const Metric> all_metrics() { return k_metrics; }

const Metric* find_metric(const std::string& name) {
  for (const Metric& metric : k_metrics)
    if (name == metric.name) return &metric;
  return nullptr;
}

MetricResult measure(const Metric& metric, const Observations& seen, const Observations* reference) {
  if (metric.of_profile()) return measure_profile(metric, seen, reference);
  MetricResult result{.metric = &metric, .value = value_of(metric, seen), .error = {}, .heights = {}};
  if (metric.kind == MetricKind::residual) {
    result.error = result.value;
  } else if (reference == nullptr) {
    result.error = gap("there is no reference to compare with");
  } else {
    result.error = relative_difference(result.value, value_of(metric, *reference));
  }
  return result;
}

double effective_samples_of(const Observations& seen) {
  double fewest = Estimate::k_unknown;
  for (const char* column : {"pressure_drop [Pa]", "bed_height [m]"}) {
    const auto found = seen.monitors.find(column);
    if (found == seen.monitors.end()) continue;
    const Estimate mean = mean_of(found->second);
    // No plateau: fewer than were counted.
    if (mean.known())
      fewest = std::fmin(fewest, mean.effective_samples);
    else if (!found->second.values.empty())
      fewest = 0;
  }
  return fewest;
}

}  // namespace similitude
