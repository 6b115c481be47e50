#pragma once
/// What stops a run, or warns, when the numbers leave the range in which they mean something.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "coupling/coupling.h"
#include "output/accounts.h"
#include "particles/engine.h"
#include "similarity/ratios.h"

namespace similitude {

inline constexpr double k_overlap_to_warn = 0.05;   // of a diameter: a softer bed than the law was meant for
inline constexpr double k_overlap_to_stop = 0.30;   // of a diameter: no sphere is left

/// What makes contacts harder: words for advice.
struct Hardness {
  std::string key = "the contact law's stiffness";   // of the case file, where the law's table says which parameter it is
  std::string falling;                               // how the overlap of an impact falls with it; empty if unknown
};
/// Of a law of contacts, by what its parameters scale as.
Hardness hardness_of(const similitude_descriptor& contact);

class Guards {
 public:
  /// `courant_limits` false: a gas that is not advected may cross any number of cells in a step.
  Guards(const ResultRatios& ratios, std::function<void(const std::string&)> warn, Hardness hardness = {}, bool courant_limits = true)
      : ratios_(ratios), warn_(std::move(warn)), hardness_(std::move(hardness)), courant_limits_(courant_limits) {}

  /// After the DEM sub-steps. `time` in the simulated bed's seconds. Throws SimulationError.
  void check_particles(const EngineReport& report, double time);
  /// After the gas step.
  void check_gas(const similitude_gas_report& report, const similitude_status& status, double time);
  void check_gas_fraction(double smallest, std::array<double, 3> place, double time);
  /// Now and then, after a whole step.
  void check_balances(const Balances& balances, double time);

  /// Which warnings were given, for checkpoints: each is given once in a run, however often it is resumed.
  std::vector<std::uint8_t> warnings_given() const { return {said_.begin(), said_.end()}; }
  void restore_warnings_given(const std::vector<std::uint8_t>& given);

 private:
  enum Warning : std::size_t { k_overlap, k_courant, k_mass, k_gas_balance, k_warnings };
  void warn_once(Warning warning, const std::string& text);

  ResultRatios ratios_;
  std::function<void(const std::string&)> warn_;
  Hardness hardness_;
  bool courant_limits_;
  std::array<std::uint8_t, k_warnings> said_{};
};

}  // namespace similitude
