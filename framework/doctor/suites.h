#pragma once
/// What is checked of a model of each kind. A check runs in a child process that has loaded the file and nothing else; it
/// may throw PluginError (the model refused) and Complaint.

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "doctor/finding.h"
#include "loader/catalogue.h"

namespace similitude::doctor {

struct Check {
  std::string name;
  std::function<Outcome(const PluginEntry&)> examine;
  bool others_rest_on_it = false;   // if it fails, the checks after it would only say so again
};

/// The model reports an error where it must not, in its own words.
class Complaint : public std::runtime_error {
 public:
  explicit Complaint(const similitude_status& status);
};

/// Of every kind: that it can be made, and over its parameters' whole ranges.
std::vector<Check> make_suite();

std::vector<Check> drag_suite();
std::vector<Check> contact_suite();
std::vector<Check> scaling_suite();
std::vector<Check> fluid_suite();
std::vector<Check> effect_suite();

}  // namespace similitude::doctor
