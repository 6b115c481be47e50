#include "stepper/guards.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "particles/errors.h"

namespace similitude {
namespace {

constexpr double k_courant_to_warn = 0.8;        // accuracy suffers, and a gust may pass the limit
constexpr double k_courant_to_stop = 1.0;        // explicit advection is unbounded beyond
constexpr double k_mass_residual_to_warn = 1e-5; // of the throughput, per step
constexpr double k_gas_balance_to_warn = 1e-5;   // of all that flowed or was there: a hundred times the solver's own tolerance
constexpr double k_gas_balance_to_stop = 1e-2;   // of all that flowed or was there: a bed's expansion or pressure drop is no better then
constexpr double k_rounding_to_stop = 1e-6;      // of all that was exchanged: roundings of 1e8 sub-steps, were they all to one side, give 1e-8
constexpr double k_smallest_gas_fraction = 0.10; // denser than any packing of overlapping spheres that means something

std::string at(std::array<double, 3> place, const ResultRatios& ratios) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * place[0] / ratios.length, 1e3 * place[1] / ratios.length,
                     1e3 * place[2] / ratios.length);
}

}  // namespace

Hardness hardness_of(const similitude_descriptor& contact) {
  for (std::uint32_t i = 0; i < contact.parameter_count; ++i) {
    const similitude_parameter& row = contact.parameters[i];
    const std::string key = std::string("models.contact.") + row.name;
    // The end of an impact: m v^2 = k delta^2, or m v^2 ~ E delta^(5/2) of Hertz.
    if (row.scales_as == SIMILITUDE_SCALES_AS_STIFFNESS) return {key, " (the overlap falls with its square root)"};
    if (row.scales_as == SIMILITUDE_SCALES_AS_MODULUS) return {key, " (the overlap falls with its power 2/5)"};
  }
  return {};
}

void Guards::warn_once(Warning warning, const std::string& text) {
  if (said_[warning] != 0) return;
  said_[warning] = 1;
  warn_(text);
}

void Guards::restore_warnings_given(const std::vector<std::uint8_t>& given) {
  said_ = {};
  std::copy_n(given.begin(), std::min(given.size(), said_.size()), said_.begin());
}

void Guards::check_particles(const EngineReport& report, double time) {
  const ContactExtreme& extreme = report.largest_overlap;
  if (!(extreme.overlap_ratio > k_overlap_to_warn)) return;
  const bool wall = extreme.partner == std::numeric_limits<std::uint64_t>::max();
  const std::string what =
      fmt::format("particle {} overlaps {} by {:.1f} % of its diameter at {}, t = {:.6g} s", extreme.particle,
                  wall ? std::string("a wall") : fmt::format("particle {}", extreme.partner), 100 * extreme.overlap_ratio,
                  at(extreme.place, ratios_), time / ratios_.time);
  if (extreme.overlap_ratio > k_overlap_to_stop) {
    throw SimulationError(what + ": spheres no longer mean anything there.",
                          "The spring is too soft for these speeds or the step too long: raise " + hardness_.key + hardness_.falling +
                              " or use time.dt: auto.");
  }
  warn_once(k_overlap, what + ": above 5 %. Raise " + hardness_.key + " if that matters here.");
}

void Guards::check_gas(const similitude_gas_report& report, const similitude_status& status, double time) {
  if (status.code != 0) {
    throw SimulationError(fmt::format("the gas solver stopped at t = {:.6g} s: {}", time / ratios_.time, status.text), "");
  }
  if (!std::isfinite(report.courant) || !std::isfinite(report.mass_residual)) {
    throw SimulationError(fmt::format("the gas is not finite at t = {:.6g} s.", time / ratios_.time),
                          "Lower time.gas_dt; if that does not help, look at fluid.pvd just before.");
  }
  if (courant_limits_ && report.courant > k_courant_to_stop) {
    throw SimulationError(fmt::format("the gas moves {:.2f} cells in one gas step (CFL) at t = {:.6g} s; more than {} is unstable.",
                                      report.courant, time / ratios_.time, k_courant_to_stop),
                          fmt::format("Lower time.gas_dt by a factor {:.1f} or more.", report.courant / 0.5));
  }
  if (courant_limits_ && report.courant > k_courant_to_warn) {
    warn_once(k_courant, fmt::format("the gas moves {:.2f} cells in one gas step (CFL) at t = {:.6g} s; beyond {} the run stops. "
                                         "Lower time.gas_dt if that matters here.",
                                         report.courant, time / ratios_.time, k_courant_to_stop));
  }
  if (report.mass_residual > k_mass_residual_to_warn) {
    warn_once(k_mass, fmt::format("gas mass balance is off by {:.2g} of the throughput in one step at t = {:.6g} s",
                                      report.mass_residual, time / ratios_.time));
  }
}

void Guards::check_balances(const Balances& balances, double time) {
  const auto stop_at = [&](const char* what, double residual) {
    if (residual <= k_rounding_to_stop) return;
    throw SimulationError(fmt::format("the particles' {} and what they were given differ by {:.2g} of it at t = {:.6g} s: more than "
                                      "rounding explains.",
                                      what, residual, time / ratios_.time),
                          "That is a fault of the program or of one of the models in use, not of the case.");
  };
  stop_at("momentum", balances.momentum);
  stop_at("energy", balances.energy);
  const auto drift = [&] {
    return fmt::format("the gas in the bed and what flowed in and out differ by {:.2g} of what flowed or was there at t = {:.6g} s", balances.gas_mass,
                       time / ratios_.time);
  };
  if (!(balances.gas_mass <= k_gas_balance_to_stop)) {
    throw SimulationError(drift() + fmt::format("; more than {} makes every gas flow doubtful.", k_gas_balance_to_stop),
                          "Lower the gas solver's tolerance or time.gas_dt.");
  }
  if (balances.gas_mass > k_gas_balance_to_warn) {
    warn_once(k_gas_balance, drift() + fmt::format("; beyond {} the run stops.", k_gas_balance_to_stop));
  }
}

void Guards::check_gas_fraction(double smallest, std::array<double, 3> place, double time) {
  if (smallest > k_smallest_gas_fraction) return;
  throw SimulationError(fmt::format("the gas fraction is {:.3f} at {}, t = {:.6g} s: particles have piled into each other.",
                                    smallest, at(place, ratios_), time / ratios_.time),
                        "Raise " + hardness_.key + ", or coupling.smoothing if particles are larger than cells.");
}

}  // namespace similitude
