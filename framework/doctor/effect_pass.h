#pragma once
/// The passes of an effect, each as a block of named columns that the doctor fills, hands over and reads.

#include <similitude/vec3.h>

#include <functional>
#include <string>
#include <vector>

#include "doctor/guarded_column.h"
#include "loader/catalogue.h"

namespace similitude::doctor {

similitude_effect_needs needs_of(const EffectModel& effect);

/// How a block is filled.
struct PassOptions {
  Edge edge = Edge::far;
  bool undeclared_too = false;     // columns that the effect did not ask for are there as well
  double undeclared = 1;           // what those that are read hold, times their usual values
  double already = 0;              // what the columns that an effect adds to hold before, times their usual sizes
  bool swapped = false;            // contacts: partners change places
  bool turned = false;             // space: every vector, by the same turn
};

/// What a pass left behind.
struct PassResult {
  std::vector<std::string> names;              // of the columns it adds to or writes
  std::vector<bool> declared;
  std::vector<bool> adds;                      // or writes, whatever stands there
  std::vector<std::vector<double>> before;     // by column, by row asked for: what stood there
  std::vector<std::vector<double>> added;      // after less before
};

/// One pass of one effect; `rows` are numbers of situations, always the same for a number.
struct Pass {
  const char* name;   // "particle pass"
  std::function<bool(const EffectModel&)> is_there;
  std::function<PassResult(const EffectModel&, const std::vector<std::size_t>& rows, const PassOptions&)> run;   // throws Complaint
  bool has_partners = false;   // a contact's
};

std::vector<Pass> effect_passes();

/// Whether the second partner of this situation's contact is a wall.
bool is_wall(std::size_t situation);

/// The turn of PassOptions::turned: no axis stays where it was.
Vec3<double> turned(const Vec3<double>& v);

/// The effect of a file with its trial values, configured with plausible gas and wall properties.
EffectModel made_effect(const PluginEntry& plugin);

/// By quantity: the default, or a plausible value.
std::vector<double> quantity_values(const similitude_effect_functions& functions);

}  // namespace similitude::doctor
