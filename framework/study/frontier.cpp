#include "study/frontier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loader/number_text.h"

namespace similitude {
namespace {

constexpr double k_as_fast = 1.1;  // two wall times closer than this are called the same: what one machine repeats

bool placed(const Contender& c) { return !std::isnan(c.wall_s) && c.error.known(); }

bool beats(const Contender& a, const Contender& b) {
  return a.wall_s <= b.wall_s && a.error.value <= b.error.value &&
         (a.wall_s < b.wall_s || a.error.value < b.error.value);
}

std::vector<Contender> all_placed(const std::vector<Contender>& contenders) {
  std::vector<Contender> found;
  for (const Contender& c : contenders)
    if (placed(c)) found.push_back(c);
  std::stable_sort(found.begin(), found.end(),
                   [](const Contender& a, const Contender& b) { return a.wall_s < b.wall_s; });
  return found;
}

/// "4.1 x faster than exact", "as fast as exact", "1.5 x slower than exact".
std::string speed_against(const Contender& one, const Contender& other) {
  const double ratio = other.wall_s / one.wall_s;
  if (ratio > k_as_fast) return two_digits(ratio) + " x faster than " + other.name;
  if (ratio < 1 / k_as_fast) return two_digits(1 / ratio) + " x slower than " + other.name;
  return "as fast as " + other.name;
}

/// What stands next to the chosen case, as the end of the sentence that says its error.
std::string neighbours(const Contender& chosen, const Contender& best, const std::vector<Contender>& others) {
  if (chosen.error.low <= 0) return "cannot be told from zero";
  if (chosen.name != best.name) {
    const double ratio = best.wall_s / chosen.wall_s;
    return "cannot be told from " + best.name + "'s, " + percent_text(best.error) +
           (ratio > k_as_fast ? ", which takes " + two_digits(ratio) + " x as long" : ", which takes as long");
  }
  const Contender* faster = nullptr;  // the most accurate of those that are faster
  for (const Contender& c : others)
    if (c.wall_s < chosen.wall_s && (faster == nullptr || c.error.value < faster->error.value)) faster = &c;
  if (faster == nullptr) return others.size() > 1 ? "is also the smallest" : "has nothing to be compared with";
  const double ratio = chosen.wall_s / faster->wall_s;
  return "is the smallest; " + faster->name +
         (ratio > k_as_fast ? " is " + two_digits(ratio) + " x faster still" : " is as fast") + ", but off by " +
         percent_text(faster->error);
}

}  // namespace

bool Frontier::holds(const std::string& name) const {
  return std::find(cases.begin(), cases.end(), name) != cases.end();
}

Frontier frontier_of(const std::vector<Contender>& contenders) {
  const std::vector<Contender> all = all_placed(contenders);
  Frontier frontier;
  const Contender* last = nullptr;
  for (const Contender& c : all) {
    if (std::any_of(all.begin(), all.end(), [&](const Contender& other) { return beats(other, c); })) continue;
    frontier.cases.push_back(c.name);
    if (last != nullptr)
      frontier.steps.push_back({last->name, c.name, c.wall_s / last->wall_s, c.error.value - last->error.value,
                                !overlap(c.error, last->error)});
    last = &c;
  }
  return frontier;
}

std::vector<std::pair<std::string, std::string>> indistinguishable(const std::vector<Contender>& contenders) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (std::size_t i = 0; i < contenders.size(); ++i)
    for (std::size_t j = i + 1; j < contenders.size(); ++j) {
      const Contender &a = contenders[i], &b = contenders[j];
      if (!a.reference && !b.reference && a.error.known() && b.error.known() && overlap(a.error, b.error))
        pairs.emplace_back(a.name, b.name);
    }
  return pairs;
}

std::string advice(const std::vector<Contender>& contenders, const std::string& metric) {
  const std::vector<Contender> all = all_placed(contenders);
  const Contender* reference = nullptr;
  std::vector<Contender> candidates;
  for (const Contender& c : all) {
    if (c.reference)
      reference = &c;
    else
      candidates.push_back(c);
  }
  if (candidates.empty()) return "No case has both a wall time and a " + metric + ": there is nothing to advise.";
  const Contender& fastest = candidates.front();
  if (reference != nullptr && reference->wall_s * k_as_fast < fastest.wall_s)
    return fmt::format("Nothing here beats {}: the fastest other case, {}, takes {} x as long, and its {} is {}.",
                       reference->name, fastest.name, two_digits(fastest.wall_s / reference->wall_s), metric,
                       percent_text(fastest.error));

  const Contender& best =
      *std::min_element(candidates.begin(), candidates.end(),
                        [](const Contender& a, const Contender& b) { return a.error.value < b.error.value; });
  const Contender& chosen = *std::find_if(candidates.begin(), candidates.end(),
                                          [&](const Contender& c) { return overlap(c.error, best.error); });
  std::string head;
  if (reference != nullptr)
    head = chosen.name + " is " + speed_against(chosen, *reference);
  else if (const Contender& slowest = candidates.back(); slowest.name != chosen.name)
    head = chosen.name + " is " + speed_against(chosen, slowest);
  else
    head = chosen.name + " is the slowest";
  return head + "; its " + metric + ", " + percent_text(chosen.error) + ", " + neighbours(chosen, best, candidates) +
         ".";
}

std::string percent_text(const Estimate& error) {
  const std::string bound = error.lower_bound ? "at least " : "";
  if (error.low == error.high) return two_digits(100 * error.value) + " %";
  if (error.low <= 0 && error.high > 0) return "0 to " + bound + two_digits(100 * error.high) + " %";
  return two_digits(100 * error.value) + " ± " + bound + two_digits(100 * error.half_width()) + " %";
}

}  // namespace similitude
