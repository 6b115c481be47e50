#pragma once
/// JSON Schema (draft 2020-12) of case files, for editors: made from the same tables that the reader checks against.

#include <nlohmann/json_fwd.hpp>

#include "loader/catalogue.h"

namespace similitude {

/// Includes the parameters of every plugin in the catalogue.
nlohmann::json case_schema(const Catalogue& catalogue);

}  // namespace similitude
