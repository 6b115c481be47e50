#pragma once
/// Keys that effects declare: gas.NAME, patches.PATCH.NAME, particles.CLASS.NAME, walls.NAME. They exist if some effect in the
/// catalogue knows the name, and may be written if the case lists one that does.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "scene/document.h"
#include "scene/scene.h"

namespace similitude {

/// The table of an effect in the catalogue.
std::span<const similitude_quantity> quantities_of(const PluginEntry& effect);

/// What was written, by section of the scene.
struct QuantityValues {
  GivenValues gas, walls;
  std::map<std::string, GivenValues> patches, particles;   // by name
};

/// Takes these keys out of the document's scene, so that the rest of it can be read by its tables. Throws InputError on a
/// value that is no quantity of the declared unit, or out of the declared range.
QuantityValues take_quantities(Document& document, const Catalogue& catalogue);

/// Into the scene that was read from the rest.
void set_quantities(const QuantityValues& values, RealScene& scene);

/// A value of the scene that none of the case's effects declares.
struct IdleValue {
  std::string path, name;
  SourceMark mark;
  std::vector<std::string> declared_by;   // ids of the catalogue's effects that do; at least one
};
std::vector<IdleValue> idle_values(const RealScene& scene, const Catalogue& catalogue);

/// Throws InputError at a value that none of the effects in a case's list declares, naming those that do. Nothing with
/// effects: auto, where a value may be what an effect judges by.
void check_quantities(const RealScene& scene, const Catalogue& catalogue);

}  // namespace similitude
