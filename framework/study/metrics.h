#pragma once
/// What a study can measure of a bed, and how far it lies from the reference.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/estimate.h"
#include "study/profile_error.h"

namespace similitude {

struct Observations;

enum class MetricKind { profile_l2, profile_maximum, mean, fluctuation, frequency, last, residual };

struct Metric {
  const char* name;
  MetricKind kind;
  const char* source;  // sampler of profiles.csv or column of monitors.csv
  const char* unit;    // of its value
  const char* doc;

  bool of_profile() const { return kind == MetricKind::profile_l2 || kind == MetricKind::profile_maximum; }
  bool can_be_measured() const { return kind != MetricKind::residual; }
};

std::span<const Metric> all_metrics();
/// Null if there is none of that name.
const Metric* find_metric(const std::string& name);

/// One metric of one case.
struct MetricResult {
  const Metric* metric = nullptr;
  Estimate value;  // in the metric's unit
  Estimate error;  // [-]: of profiles the value itself; of residuals too; else |value - reference| / |reference|
  std::vector<ErrorAtHeight> heights;  // of profiles
  std::size_t bins = 0, bins_left_out = 0;
};

/// `reference` null: there is nothing to compare with, and only values come out.
MetricResult measure(const Metric& metric, const Observations& seen, const Observations* reference);

/// Independent samples in the window of the averages: the fewer of pressure drop's and bed height's; NaN if neither is
/// there.
double effective_samples_of(const Observations& seen);

}  // namespace similitude
