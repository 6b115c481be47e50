#pragma once
/// A model's parameters, declared once. The same table feeds the case parser, the JSON Schema, `plugins info`, the
/// reference pages and the error texts; here it also fills the author's structure.
///
///   static void parameters(similitude::Parameters<Law>& p) {
///     p.real("stiffness", &Law::stiffness, {.unit = "N/m", .min = 0, .doc = "normal spring"});
///   }
///
/// A parameter without `.def` is required. `.def = similitude::not_given` makes it optional: left out, the member is
/// NaN. Ranges are hard and checked by the framework; outside the typical range it warns.

#include <cmath>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <similitude/abi.h>

namespace similitude {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// How the framework turns the real bed's value into the simulated bed's. `by_unit`: N/m as a stiffness, m/s as a
/// velocity, s as a time, Pa as a modulus, N, J and J/m^2 as a particle's, pure numbers, angles and temperatures not at all. In any other unit the author
/// must say: a metre may be a length of the bed or of a particle.
enum class Scales {
  by_unit = -1,
  not_at_all = SIMILITUDE_SCALES_NOT,
  as_length = SIMILITUDE_SCALES_AS_LENGTH,
  as_diameter = SIMILITUDE_SCALES_AS_DIAMETER,
  as_time = SIMILITUDE_SCALES_AS_TIME,
  as_velocity = SIMILITUDE_SCALES_AS_VELOCITY,
  as_stiffness = SIMILITUDE_SCALES_AS_STIFFNESS,
  as_modulus = SIMILITUDE_SCALES_AS_MODULUS,
  as_restitution = SIMILITUDE_SCALES_AS_RESTITUTION,   // a pure number that some laws change; must be said
  as_force = SIMILITUDE_SCALES_AS_FORCE,
  as_surface_energy = SIMILITUDE_SCALES_AS_SURFACE_ENERGY,
  as_energy = SIMILITUDE_SCALES_AS_ENERGY,
  as_diffusivity = SIMILITUDE_SCALES_AS_DIFFUSIVITY,
  as_rate = SIMILITUDE_SCALES_AS_RATE,
  refused = SIMILITUDE_SCALES_REFUSED   // a scaled run with this model is an error
};

struct RealOptions {
  const char* unit = "1";
  std::optional<double> def{};
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  double typical_min = 0, typical_max = 0;   // equal: no typical range
  const char* doc = "";
  const char* reference = nullptr;
  Scales scales_as = Scales::by_unit;
  const char* taken_from = nullptr;   // "contact": left out, the contact law's parameter of the same name is meant
};

struct IntegerOptions {
  std::optional<std::int32_t> def{};
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  double typical_min = 0, typical_max = 0;
  const char* doc = "";
  const char* reference = nullptr;
};

struct FlagOptions {
  std::optional<bool> def{};
  const char* doc = "";
  const char* reference = nullptr;
};

struct ChoiceOptions {
  const char* choices = "";    // "a|b|c", in the order of the enumeration
  const char* def = nullptr;   // null: required
  const char* doc = "";
  const char* reference = nullptr;
};

/// The scaling that a unit implies, or nothing where the author must say.
constexpr std::optional<Scales> scaling_implied_by(std::string_view unit) {
  if (unit == "N/m") return Scales::as_stiffness;
  if (unit == "m/s") return Scales::as_velocity;
  if (unit == "s") return Scales::as_time;
  if (unit == "Pa") return Scales::as_modulus;
  if (unit == "N") return Scales::as_force;
  if (unit == "J/m^2") return Scales::as_surface_energy;
  if (unit == "J") return Scales::as_energy;
  if (unit == "1/s") return Scales::as_rate;
  if (unit == "1" || unit == "rad" || unit == "deg" || unit == "K") return Scales::not_at_all;
  return std::nullopt;
}

template <class T>
class Parameters {
 public:
  void real(const char* name, double T::*member, const RealOptions& o) {
    similitude_parameter row = blank(name, SIMILITUDE_REAL, o.unit, o.doc, o.reference);
    row.required = o.def ? 0 : 1;
    row.default_value = o.def.value_or(not_given);
    set_range(row, o);
    Scales scales = o.scales_as;
    if (scales == Scales::by_unit) {
      const std::optional<Scales> implied = scaling_implied_by(o.unit);
      if (!implied && mistake_.empty()) {
        mistake_ = std::string("parameter ") + name + " is in " + o.unit +
                   ", and nothing says how it scales with the bed.\n  Add .scales_as = similitude::Scales::as_length, "
                   "as_diameter or another to its declaration.";
      }
      scales = implied.value_or(Scales::not_at_all);
    }
    row.scales_as = static_cast<std::int32_t>(scales);
    row.taken_from = o.taken_from;
    add(row, [member](T& model, const similitude_value& value) { model.*member = value.real; });
  }

  template <std::integral I>
  void integer(const char* name, I T::*member, const IntegerOptions& o) {
    similitude_parameter row = blank(name, SIMILITUDE_INTEGER, "1", o.doc, o.reference);
    row.required = o.def ? 0 : 1;
    row.default_value = o.def ? static_cast<double>(*o.def) : not_given;
    set_range(row, o);
    add(row, [member](T& model, const similitude_value& value) { model.*member = static_cast<I>(std::llround(value.real)); });
  }

  void flag(const char* name, bool T::*member, const FlagOptions& o) {
    similitude_parameter row = blank(name, SIMILITUDE_FLAG, "", o.doc, o.reference);
    row.required = o.def ? 0 : 1;
    row.default_value = o.def ? (*o.def ? 1.0 : 0.0) : not_given;
    row.minimum = 0;
    row.maximum = 1;
    add(row, [member](T& model, const similitude_value& value) { model.*member = value.real != 0; });
  }

  /// The member is an enumeration whose values number the choices from 0.
  template <class E>
    requires std::is_enum_v<E>
  void choice(const char* name, E T::*member, const ChoiceOptions& o) {
    similitude_parameter row = blank(name, SIMILITUDE_CHOICE, "", o.doc, o.reference);
    row.required = o.def ? 0 : 1;
    row.choices = o.choices;
    row.default_text = o.def;
    add(row, [=](T& model, const similitude_value& value) {
      model.*member = static_cast<E>(place_in(o.choices, value.text ? value.text : "", name));
    });
  }

  const std::vector<similitude_parameter>& table() const { return table_; }

  /// Fills a model from one row of values in the table's order. Throws on a choice that does not exist and, with words
  /// for the author, on a table that is wrong in itself.
  void read(const similitude_value* values, T& model) const {
    if (!mistake_.empty()) throw std::logic_error(mistake_);
    for (std::size_t i = 0; i < table_.size(); ++i) setters_[i](model, values[i]);
  }

 private:
  using Setter = std::function<void(T&, const similitude_value&)>;

  static similitude_parameter blank(const char* name, std::int32_t type, const char* unit, const char* doc,
                                    const char* reference) {
    similitude_parameter row{};
    row.struct_size = sizeof row;
    row.type = type;
    row.name = name;
    row.unit = unit;
    row.doc = doc;
    row.reference = reference;
    row.default_value = not_given;
    row.minimum = -std::numeric_limits<double>::infinity();
    row.maximum = std::numeric_limits<double>::infinity();
    return row;
  }

  template <class Options>
  static void set_range(similitude_parameter& row, const Options& o) {
    row.minimum = o.min;
    row.maximum = o.max;
    row.typical_minimum = o.typical_min;
    row.typical_maximum = o.typical_max;
  }

  static int place_in(std::string_view choices, std::string_view wanted, const char* name) {
    std::string_view rest = choices;
    for (int place = 0;; ++place) {
      const std::size_t end = rest.find('|');
      if (rest.substr(0, end) == wanted) return place;
      if (end == std::string_view::npos) break;
      rest.remove_prefix(end + 1);
    }
    throw std::invalid_argument(std::string(name) + ": there is no choice \"" + std::string(wanted) + "\".\n  Use one of " +
                                std::string(choices) + ".");
  }

  void add(const similitude_parameter& row, Setter setter) {
    table_.push_back(row);
    setters_.push_back(std::move(setter));
  }

  std::vector<similitude_parameter> table_;
  std::vector<Setter> setters_;
  std::string mistake_;
};

/// The one table of a model type. Without a `parameters` function it is empty.
template <class T>
const Parameters<T>& parameters_of() {
  static const Parameters<T> table = [] {
    Parameters<T> p;
    if constexpr (requires { T::parameters(p); }) T::parameters(p);
    return p;
  }();
  return table;
}

}  // namespace similitude
