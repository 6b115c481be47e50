#include "output/map_back.h"

#include "output/number.h"

namespace similitude {

double MapBack::gas_mass(double simulated) const {
  return simulated / (gas_density * ratios.length * ratios.length * ratios.length);
}

double MapBack::gas_mass_flow(double simulated) const {
  return simulated / (gas_density * ratios.length * ratios.length * ratios.velocity);
}

MapBack map_back(const RealScene& real, const similitude_ratios& scaling) {
  MapBack map;
  map.ratios = result_ratios(real, scaling);
  map.gas_density = scaling.gas_density;
  map.jet_ratio = scaling.gas_density * (map.ratios.velocity * map.ratios.velocity) / map.ratios.pressure;
  if (!real.models.scaling.id.empty()) map.scaling_law = real.models.scaling.id;
  return map;
}

std::string map_back_note(const MapBack& map) {
  const ResultRatios& r = map.ratios;
  const bool itself = r.length == 1 && r.time == 1 && r.velocity == 1 && r.pressure == 1 && r.diameter == 1;
  if (itself) return "The real bed itself was simulated; values are as computed.";
  std::string note =
      "Values are the real bed's: simulated values divided by the ratios of this file. Pressures are mapped by bed "
      "weight";
  if (map.jet_ratio != 1) note += "; dynamic pressures are off by the jet ratio J* = " + readable(map.jet_ratio);
  note += ". 'diameter [m]' is what touches, 'material_diameter [m]' the real particle's.";
  return note;
}

}  // namespace similitude
