#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "doctor/effect_pass.h"
#include "doctor/suites.h"
#include "doctor/trial_values.h"

namespace similitude::doctor {
namespace {

constexpr std::size_t k_situations = 64;

std::vector<std::size_t> all_situations() {
  std::vector<std::size_t> all(k_situations);
  std::iota(all.begin(), all.end(), std::size_t{1});
  return all;
}

/// A check of every pass that the effect has; what it returns for the first that is not ok stands for all.
template <class Examine>
Outcome of_every_pass(const PluginEntry& plugin, const std::string& seen, Examine&& examine) {
  const EffectModel effect = made_effect(plugin);
  std::string passes;
  for (const Pass& pass : effect_passes()) {
    if (!pass.is_there(effect)) continue;
    if (const Outcome outcome = examine(effect, pass); outcome.verdict == Verdict::fail) return outcome;
    passes += (passes.empty() ? "" : ", ") + std::string(pass.name);
  }
  if (passes.empty()) return skipped("it has no pass over particles, contacts or cells");
  return ok(passes + ": " + seen);
}

Outcome check_verdict(const PluginEntry& plugin) {
  const EffectModel effect = made_effect(plugin);
  const similitude_bed bed = trial_bed();
  const std::vector<double> values = quantity_values(effect.functions());
  similitude_evidence evidence{};
  evidence.struct_size = sizeof evidence;
  evidence.bed = &bed;
  evidence.value = evidence.inflow_value = values.empty() ? nullptr : values.data();
  similitude_relevance r{};
  r.struct_size = sizeof r;
  effect.functions().relevance(effect.instance(), &evidence, &r);
  if (r.verdict < -1 || r.verdict > 1) return fail(fmt::format("its verdict is {}.", r.verdict), "1 needed, 0 negligible, -1 cannot tell.");
  if (r.verdict == -1)
    return ok(fmt::format("cannot tell for a bed of alumina in air{}", r.missing != nullptr ? std::string(", without ") + r.missing : ""));
  if (r.group == nullptr || *r.group == 0 || r.source == nullptr || *r.source == 0)
    return fail("it judges without saying by which group, or by whose threshold.", "Fill group and source: a user must be able to check the verdict.");
  if (!std::isfinite(r.threshold) || std::isnan(r.value))
    return fail(fmt::format("it judges by {} = {:g} against {:g}.", r.group, r.value, r.threshold), "A verdict needs a value and a threshold; without, it is -1: cannot tell.");
  const bool below = r.value < r.threshold;
  if (r.lowest == r.highest && r.value != r.threshold && (r.verdict == 1) == (below != (r.needed_below != 0)))
    return fail(fmt::format("it calls {} = {:g} against {:g} {}.", r.group, r.value, r.threshold, r.verdict == 1 ? "needed" : "negligible"),
                "Needed is what lies above the threshold, or below it where needed_below is 1.");
  return ok(fmt::format("{} for a bed of alumina in air: {} = {:.3g} against {:g}", r.verdict == 1 ? "needed" : "negligible", r.group, r.value, r.threshold));
}

Outcome check_edges(const PluginEntry& plugin) {
  return of_every_pass(plugin, "blocks of 8 and 64 rows between forbidden pages, inputs write-protected", [](const EffectModel& effect, const Pass& pass) {
    for (const std::size_t rows : {std::size_t{8}, k_situations}) {
      std::vector<std::size_t> situations = all_situations();
      situations.resize(rows);
      for (const Edge edge : {Edge::end, Edge::start}) pass.run(effect, situations, {.edge = edge});
    }
    return ok("");
  });
}

Outcome check_finite(const PluginEntry& plugin) {
  return of_every_pass(plugin, fmt::format("{} rows, what it adds is finite", k_situations), [](const EffectModel& effect, const Pass& pass) {
    const PassResult result = pass.run(effect, all_situations(), {});
    for (std::size_t c = 0; c < result.names.size(); ++c)
      for (const double value : result.added[c])
        if (!std::isfinite(value))
          return fail(fmt::format("in the {} it adds {:g} to {}.", pass.name, value, result.names[c]),
                      "Keep rest, empty gas, zero overlap and infinite radii (a flat wall) out of denominators and roots.");
    return ok("");
  });
}

/// What stands in a column already is another effect's.
Outcome check_adds(const PluginEntry& plugin) {
  constexpr double rounding = 1e-9;   // of what stands there and what is added
  return of_every_pass(plugin, "it adds to what stands there", [](const EffectModel& effect, const Pass& pass) {
    const PassResult alone = pass.run(effect, all_situations(), {}), upon = pass.run(effect, all_situations(), {.already = 1});
    for (std::size_t c = 0; c < alone.names.size(); ++c)
      for (std::size_t row = 0; row < k_situations && alone.adds[c]; ++row)
        if (std::abs(upon.added[c][row] - alone.added[c][row]) > rounding * (std::abs(alone.added[c][row]) + std::abs(upon.before[c][row])))
          return fail(fmt::format("in the {} it overwrites {} instead of adding to it.", pass.name, alone.names[c]),
                      "Other effects add to the same columns: b->force[0][row] += ...");
    return ok("");
  });
}

/// Columns that it did not ask for are left away, then there with one content, then with another: nothing may change.
Outcome check_declared(const PluginEntry& plugin) {
  return of_every_pass(plugin, "what it declares is all that it reads and adds", [](const EffectModel& effect, const Pass& pass) {
    const PassResult without = pass.run(effect, all_situations(), {});
    const PassResult with = pass.run(effect, all_situations(), {.undeclared_too = true});
    const PassResult other = pass.run(effect, all_situations(), {.undeclared_too = true, .undeclared = -3});
    std::size_t own = 0;   // among those that are always there
    for (std::size_t c = 0; c < with.names.size(); ++c) {
      const bool declared = with.declared[c];
      if (!declared && std::any_of(with.added[c].begin(), with.added[c].end(), [](double value) { return value != 0; }))
        return fail(fmt::format("in the {} it adds to {}, which it does not declare.", pass.name, with.names[c]),
                    "What an effect adds beyond a force stands in needs: similitude_effect_needs::adds, or adds() with the SDK.");
      if (!declared) continue;
      if (without.added[own] != with.added[c] || with.added[c] != other.added[c])
        return fail(fmt::format("in the {} what it adds to {} hangs on columns that it does not declare.", pass.name, with.names[c]),
                    "What an effect reads beyond the usual stands in needs: similitude_effect_needs::reads, or reads() with the SDK.");
      ++own;
    }
    return ok("");
  });
}

Outcome check_split(const PluginEntry& plugin) {
  constexpr std::size_t part = 16, stride = 29;   // prime to the count: every row once, in another order
  return of_every_pass(plugin, "the same bits in one block and in shuffled blocks of 16", [](const EffectModel& effect, const Pass& pass) {
    const std::vector<std::size_t> all = all_situations();
    const PassResult whole = pass.run(effect, all, {});
    for (std::size_t first = 0; first < k_situations; first += part) {
      std::vector<std::size_t> some, from;
      for (std::size_t n = 0; n < part; ++n) {
        from.push_back((first + n) * stride % k_situations);
        some.push_back(all[from.back()]);
      }
      const PassResult result = pass.run(effect, some, {});
      for (std::size_t c = 0; c < whole.names.size(); ++c)
        for (std::size_t n = 0; n < part; ++n)
          if (result.added[c][n] != whole.added[c][from[n]])
            return fail(fmt::format("in the {} it adds {:.17g} to {} in one block and {:.17g} in another.", pass.name, whole.added[c][from[n]],
                                    whole.names[c], result.added[c][n]),
                        "A row's answer may depend on that row alone, not on its place or its neighbours.");
    }
    return ok("");
  });
}

/// Number of the column "<name>[0]", or one beyond the last.
std::size_t column_of(const PassResult& result, const std::string& name) {
  return static_cast<std::size_t>(std::find(result.names.begin(), result.names.end(), name + "[0]") - result.names.begin());
}

Vec3<double> vector_at(const PassResult& result, std::size_t column, std::size_t row) {
  return {result.added[column][row], result.added[column + 1][row], result.added[column + 2][row]};
}

double size(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }

constexpr double k_rounding = 1e-9;   // of some hundred operations

/// Whether every vector of `b` is what `expected` makes of that of `a`; the name of the first that is not.
template <class Expected>
std::string first_difference(const PassResult& a, const PassResult& b, Expected&& expected) {
  for (const char* name : {"force", "couple"}) {
    const std::size_t column = column_of(a, name);
    if (column == a.names.size()) continue;
    const std::size_t rows = a.added[column].size();
    double largest = 0;
    for (std::size_t row = 0; row < rows; ++row) largest = std::max(largest, size(vector_at(a, column, row)));
    for (std::size_t row = 0; row < rows; ++row)
      if (size(vector_at(b, column, row) - expected(vector_at(a, column, row))) > k_rounding * largest) return name;
  }
  return "";
}

/// The first flow that does not change sign from `a` to `b`, or empty.
std::string first_flow_that_does_not_cancel(const PassResult& a, const PassResult& b) {
  for (std::size_t c = 0; c < a.names.size(); ++c) {
    if (!a.names[c].starts_with("flow ")) continue;
    double largest = 0;
    for (const double flow : a.added[c]) largest = std::max(largest, std::abs(flow));
    for (std::size_t row = 0; row < a.added[c].size(); ++row)
      if (std::abs(a.added[c][row] + b.added[c][row]) > k_rounding * largest) return a.names[c];
  }
  return "";
}

Outcome check_third_law(const PluginEntry& plugin) {
  const EffectModel effect = made_effect(plugin);
  std::vector<std::size_t> pairs = all_situations();
  std::erase_if(pairs, is_wall);   // a wall is never the first partner
  bool asked = false;
  for (const Pass& pass : effect_passes()) {
    if (!pass.has_partners || !pass.is_there(effect)) continue;
    asked = true;
    const PassResult there = pass.run(effect, pairs, {}), back = pass.run(effect, pairs, {.swapped = true});
    std::string wrong = first_difference(there, back, [](const Vec3<double>& v) { return -v; });
    if (wrong.empty()) wrong = first_flow_that_does_not_cancel(there, back);
    if (!wrong.empty())
      return fail(fmt::format("the {} on the partners of a contact does not cancel.", wrong),
                  "Swap i and j: normal and velocity change sign, radii, spins and values change places, and what is added must change sign.");
  }
  return asked ? ok(fmt::format("{} contacts: swapped partners feel the opposite", pairs.size())) : skipped("it has no contact pass");
}

Outcome check_turned_space(const PluginEntry& plugin) {
  return of_every_pass(plugin, "what it adds turns with space", [](const EffectModel& effect, const Pass& pass) {
    const PassResult straight = pass.run(effect, all_situations(), {}), other = pass.run(effect, all_situations(), {.turned = true});
    const std::string wrong = first_difference(straight, other, [](const Vec3<double>& v) { return turned(v); });
    if (wrong.empty()) return ok("");
    return fail(fmt::format("in the {} the {} does not turn with space.", pass.name, wrong), "Build it from vectors as wholes: no axis of space is special.");
  });
}

}  // namespace

std::vector<Check> effect_suite() {
  return {{"stays in its columns", check_edges},    {"finite", check_finite, true},          {"block split", check_split, true},
          {"declared is all", check_declared},      {"adds to what is there", check_adds},   {"Newton's third law", check_third_law},
          {"turned space", check_turned_space},     {"verdict", check_verdict}};
}

}  // namespace similitude::doctor
