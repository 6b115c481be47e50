#pragma once
#include <stdexcept>
#include <string>

namespace similitude {

/// The simulation was stopped by a guard. Exit status 1. Message: what, where (particle or cell, place, step), the
/// likely cause; then an indented line of advice.
class SimulationError : public std::runtime_error {
 public:
  SimulationError(const std::string& what, const std::string& advice)
      : std::runtime_error(what + (advice.empty() ? "" : "\n  " + advice)) {}
};

}  // namespace similitude
