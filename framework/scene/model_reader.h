#pragma once
/// The part of a case that names plugins: ids looked up in the catalogue, parameters checked against the plugin's own
/// table.

#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "scene/document.h"
#include "scene/scene.h"

namespace similitude {

/// `node` is an id or a map of id and parameters. `framework_keys` may stand among the parameters and are left to the
/// caller. Parameters outside their typical range append to `warnings`. Throws InputError, or PluginError for an
/// unknown id.
ModelChoice read_model(const std::string& kind, const DocumentNode& node, const std::string& path,
                       const Catalogue& catalogue, const std::vector<std::string>& framework_keys,
                       std::vector<std::string>& warnings);

/// The same without asking for every required parameter: those that are missing are NaN, or a choice without a text.
ModelChoice read_common_parameters(const std::string& kind, const DocumentNode& node, const std::string& path,
                                   const Catalogue& catalogue, const std::vector<std::string>& framework_keys,
                                   std::vector<std::string>& warnings);

/// A map of nothing but parameters, some or all of the model's: one for each row of its table.
std::vector<ModelParameter> read_parameters(const similitude_descriptor& model, const DocumentNode& node,
                                            const std::string& path, std::vector<std::string>& warnings);

/// For messages: what a parameter is, without its full stop, and a value that could be written.
std::string doc_of_parameter(const similitude_parameter& row);
std::string example_of_parameter(const similitude_parameter& row);

}  // namespace similitude
