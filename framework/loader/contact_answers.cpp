#include "loader/contact_answers.h"

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "loader/number_text.h"

namespace similitude {
namespace {

template <class AnyModel>
[[noreturn]] void refuse(const AnyModel& model, const std::string& answer) {
  throw PluginError(std::string(model.descriptor().kind) + " model \"" + model.descriptor().id + "\": " + answer,
                    "This is for the plugin's author to mend: `similitude plugins doctor` on its file says more. If the " +
                        std::string(std::is_same_v<AnyModel, ContactModel> ? "law" : "effect") + " threw, its words stand above.");
}

std::string circumstances(const HeadOnImpact& impact) {
  return " for an impact at " + number_text(impact.speed) + " m/s of an effective mass of " + number_text(impact.effective_mass) +
         " kg and radius of " + number_text(impact.effective_radius) + " m.";
}

std::string seconds(double time) { return std::isnan(time) ? "not a number" : number_text(time) + " s"; }

template <class AnyModel>
double checked_step(const AnyModel& model, double step, const HeadOnImpact& impact) {
  if (!(step > 0)) refuse(model, "its largest stable step is " + seconds(step) + circumstances(impact));
  return step;
}

template <class AnyModel>
double checked_reach(const AnyModel& model, double diameter) {
  const auto& functions = model.functions();
  const double reach = functions.reach != nullptr ? functions.reach(model.instance(), diameter) : 0;
  if (!(reach >= 0) || !std::isfinite(reach))
    refuse(model, "its reach is " + (std::isnan(reach) ? "not a number" : number_text(reach) + " m") + " for a diameter of " +
                      number_text(diameter) + " m.");
  return reach;
}

}  // namespace

double contact_time_of(const ContactModel& law, const HeadOnImpact& impact) {
  const double time = law.functions().contact_time(law.instance(), impact.set, impact.effective_mass, impact.effective_radius, impact.speed);
  if (!(time > 0)) refuse(law, "its contact time is " + seconds(time) + circumstances(impact));
  return time;
}

double largest_stable_step_of(const ContactModel& law, const HeadOnImpact& impact) {
  const auto& functions = law.functions();
  return checked_step(
      law, functions.largest_stable_step(law.instance(), impact.set, impact.effective_mass, impact.effective_radius, impact.speed), impact);
}

double largest_stable_step_of(const EffectModel& effect, const HeadOnImpact& impact) {
  const auto& functions = effect.functions();
  if (functions.largest_stable_step == nullptr) return std::numeric_limits<double>::infinity();
  return checked_step(effect, functions.largest_stable_step(effect.instance(), impact.effective_mass, impact.effective_radius, impact.speed),
                      impact);
}

double reach_of(const ContactModel& law, double diameter) { return checked_reach(law, diameter); }
double reach_of(const EffectModel& effect, double diameter) { return checked_reach(effect, diameter); }

}  // namespace similitude
