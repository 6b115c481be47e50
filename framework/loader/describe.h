#pragma once
/// What `similitude plugins` prints. Text for people, JSON for scripts; both end where the last thing said ends.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "loader/catalogue.h"

namespace similitude {

/// A line per plugin: kind, id, version, title, file; then what hides what, and how many files were refused.
std::string plugins_text(const Catalogue& catalogue);
/// {"plugins": [{"kind", "id", "version", "title", "file"}]}
nlohmann::json plugins_json(const Catalogue& catalogue);

/// Every model of this id, of whatever kind: who made it, where it is, and its parameters with unit, default, range,
/// text and reference. Throws PluginError if there is none.
std::string plugin_info_text(const Catalogue& catalogue, const std::string& id);
/// {"plugins": [{…as above, "authors", "reference", "level", "hides", "parameters": [{"name", "type", "unit",
/// "required", "default", "minimum", "maximum", "typical_minimum", "typical_maximum", "choices", "scales_as", "doc",
/// "reference"}]}]}; null where there is none.
nlohmann::json plugin_info_json(const Catalogue& catalogue, const std::string& id);

/// The default of a parameter for people, without its unit: "6.5e-20", "van_der_waals", "left out", "required".
std::string default_text(const similitude_parameter& parameter);

/// Every refused file with the reason and what to do.
std::string failures_text(const Catalogue& catalogue);
/// {"failures": [{"file", "reason", "fix"}]}
nlohmann::json failures_json(const Catalogue& catalogue);

}  // namespace similitude
