#pragma once
/// The contact model of a case: one set of parameters, or by its key `pair` one for each pair of materials.

#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "scene/document.h"
#include "scene/scene.h"

namespace similitude {

/// Fills in models.contact and, if the key `pair` is given, models.contact_pairs. The scene's particle classes are read
/// already. Throws InputError when a pair is missing, unknown or given twice or lacks a parameter, and all that
/// read_model throws.
void read_contact(const DocumentNode& node, const std::string& path, const Catalogue& catalogue, const Document& document,
                  RealScene& scene, std::vector<std::string>& warnings);

}  // namespace similitude
