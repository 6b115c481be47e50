#pragma once
/// A catalogue of models that only have parameters: enough to read cases against, no plugin file needed.

#include <limits>
#include <vector>

#include "loader/catalogue.h"

namespace similitude::testing {

inline constexpr double k_open = std::numeric_limits<double>::infinity();

inline similitude_parameter real(const char* name, const char* unit, const char* doc, double fallback, double low,
                                 double high, int scales_as = SIMILITUDE_SCALES_NOT) {
  return {sizeof(similitude_parameter),
          SIMILITUDE_REAL,
          0,
          scales_as,
          name,
          unit,
          doc,
          nullptr,
          nullptr,
          nullptr,
          fallback,
          low,
          high,
          0,
          0,
          nullptr};
}

inline similitude_parameter required(similitude_parameter parameter) {
  parameter.required = 1;
  return parameter;
}

inline similitude_parameter typical(similitude_parameter parameter, double low, double high) {
  parameter.typical_minimum = low;
  parameter.typical_maximum = high;
  return parameter;
}

inline similitude_parameter other(int type, const char* name, const char* doc, double fallback,
                                  const char* choices = nullptr, const char* text = nullptr) {
  return {sizeof(similitude_parameter),
          type,
          0,
          SIMILITUDE_SCALES_NOT,
          name,
          "",
          doc,
          nullptr,
          choices,
          text,
          fallback,
          0,
          100,
          0,
          0,
          nullptr};
}

template <std::size_t Count>
PluginEntry model(const char* kind, const char* id, const similitude_parameter (&parameters)[Count]) {
  return {new similitude_descriptor{sizeof(similitude_descriptor), static_cast<std::uint32_t>(Count), kind, id, "1.0.0",
                                    id, nullptr, nullptr, parameters, nullptr, nullptr, nullptr},
          "/plugins/" + std::string(kind) + "_" + id + ".so", "test", ""};
}

inline PluginEntry model(const char* kind, const char* id) {
  return {new similitude_descriptor{sizeof(similitude_descriptor), 0, kind, id, "1.0.0", id, nullptr, nullptr, nullptr,
                                    nullptr, nullptr, nullptr},
          "/plugins/" + std::string(kind) + "_" + id + ".so", "test", ""};
}

inline const Catalogue& fake_catalogue() {
  static const similitude_parameter spring[] = {
      required(
          typical(real("stiffness", "N/m", "normal spring", 0, 0, k_open, SIMILITUDE_SCALES_AS_STIFFNESS), 10, 1e6)),
      required(real("restitution", "1", "normal restitution", 0, 0.01, 1, SIMILITUDE_SCALES_AS_RESTITUTION)),
      real("friction", "1", "Coulomb friction", 0, 0, 2),
      real("glide_speed", "m/s", "speed of full sliding", 1, 0, k_open, SIMILITUDE_SCALES_AS_VELOCITY),
      real("youngs_modulus", "GPa", "elastic modulus", std::numeric_limits<double>::quiet_NaN(), 0, k_open,
           SIMILITUDE_SCALES_AS_MODULUS),
      real("film", "um", "liquid film", 2e-6, 0, 1e-3, SIMILITUDE_SCALES_AS_DIAMETER),
      real("cut_off", "mm", "longest reach", 5e-3, 0, k_open, SIMILITUDE_SCALES_AS_LENGTH),
      real("relaxation", "s", "relaxation time", 0.25, 0, k_open, SIMILITUDE_SCALES_AS_TIME),
      other(SIMILITUDE_FLAG, "attraction", "allow attraction when parting", 0),
      other(SIMILITUDE_CHOICE, "tangential", "tangential model", 0, "history|slip", "history"),
      other(SIMILITUDE_INTEGER, "terms", "terms of a series", 3),
  };
  static const similitude_parameter drag[] = {real("c1", "1", "first constant", 0.8, 0, k_open),
                                              real("d1", "1", "exponent", 2.65, 0, k_open)};
  static const similitude_parameter geometry[] = {real("geometry", "1", "length ratio", 0.25, 1e-3, 1)};
  static const Catalogue catalogue(std::vector<PluginEntry>{
      model("contact", "linear_spring", spring), model("drag", "gidaspow"), model("drag", "syamlal_obrien", drag),
      model("effect", "magnus"), model("effect", "saffman"), model("fluid", "vans"), model("scaling", "exact"),
      model("scaling", "terminal_velocity", geometry)});
  return catalogue;
}

}  // namespace similitude::testing
