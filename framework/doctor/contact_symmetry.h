#pragma once
/// What a contact law owes the space it is in: partners may swap, axes may turn, blocks may be cut.

#include "doctor/finding.h"
#include "loader/catalogue.h"

namespace similitude::doctor {

Outcome check_third_law(const PluginEntry& plugin);
Outcome check_parity(const PluginEntry& plugin);
Outcome check_turned_space(const PluginEntry& plugin);
Outcome check_contact_edges(const PluginEntry& plugin);
Outcome check_contact_split(const PluginEntry& plugin);
Outcome check_contact_pairs(const PluginEntry& plugin);
Outcome check_contact_threads(const PluginEntry& plugin);

}  // namespace similitude::doctor
