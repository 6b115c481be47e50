#include "app/commands.h"

namespace similitude::app {

Catalogue catalogue_for(const std::string& case_file) { return Catalogue(search_levels(plugin_paths_of(case_file))); }

Catalogue catalogue() { return Catalogue(search_levels({})); }

}  // namespace similitude::app
