#include "loader/contact_answers.h"

#include <cmath>
#include <string>

#include "loader/number_text.h"

namespace similitude {
namespace {

[[noreturn]] void refuse(const ContactModel& law, const std::string& answer) {
  throw PluginError("contact model \"" + std::string(law.descriptor().id) + "\": " + answer,
                    "This is for the plugin's author to mend: `similitude plugins doctor` on its file says more. If the law "
                    "threw, its words stand above.");
}

std::string circumstances(const HeadOnImpact& impact) {
  return " for an impact at " + number_text(impact.speed) + " m/s of an effective mass of " + number_text(impact.effective_mass) +
         " kg and radius of " + number_text(impact.effective_radius) + " m.";
}

std::string seconds(double time) { return std::isnan(time) ? "not a number" : number_text(time) + " s"; }

}  // namespace

double contact_time_of(const ContactModel& law, const HeadOnImpact& impact) {
  const double time = law.functions().contact_time(law.instance(), impact.set, impact.effective_mass, impact.effective_radius, impact.speed);
  if (!(time > 0)) refuse(law, "its contact time is " + seconds(time) + circumstances(impact));
  return time;
}

double largest_stable_step_of(const ContactModel& law, const HeadOnImpact& impact) {
  const double step =
      law.functions().largest_stable_step(law.instance(), impact.set, impact.effective_mass, impact.effective_radius, impact.speed);
  if (!(step > 0)) refuse(law, "its largest stable step is " + seconds(step) + circumstances(impact));
  return step;
}

double reach_of(const ContactModel& law, double diameter) {
  const auto& functions = law.functions();
  const double reach = functions.reach != nullptr ? functions.reach(law.instance(), diameter) : 0;
  if (!(reach >= 0) || !std::isfinite(reach))
    refuse(law, "its reach is " + (std::isnan(reach) ? "not a number" : number_text(reach) + " m") + " for a diameter of " +
                    number_text(diameter) + " m.");
  return reach;
}

}  // namespace similitude
