#pragma once
/// What contact laws and effects in contacts answer before a run, as numbers that can be relied on. [setup]

#include "loader/catalogue.h"

namespace similitude {

/// A head-on impact that a law is asked about.
struct HeadOnImpact {
  std::uint32_t set = 0;         // of the law's parameters
  double effective_mass = 0;     // [kg]
  double effective_radius = 0;   // [m]
  double speed = 0;              // [m/s]
};

/// [s], above zero; infinite where the partners never part. Throws PluginError if the law has no such answer: what it threw
/// was told to the host's log.
double contact_time_of(const ContactModel& law, const HeadOnImpact& impact);
/// [s], above zero. Throws as above.
double largest_stable_step_of(const ContactModel& law, const HeadOnImpact& impact);
/// [m], finite, zero for a law without the function. Throws as above.
double reach_of(const ContactModel& law, double diameter);

/// Of an effect's contact pass: infinite without the function. Throws as above.
double largest_stable_step_of(const EffectModel& effect, const HeadOnImpact& impact);
double reach_of(const EffectModel& effect, double diameter);   // [m]

}  // namespace similitude
