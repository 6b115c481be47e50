#include "output/audit_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "loader/json_text.h"
#include "output/whole_file.h"

namespace similitude {

void write_audit(const OutputDirectory& directory, const std::string& law, const std::vector<GroupComparison>& groups,
                 const std::vector<std::string>& warnings) {
  using json = nlohmann::ordered_json;
  const auto number = [](double value) { return std::isfinite(value) ? json(value) : json(nullptr); };
  json page{{"law", law}, {"groups", json::array()}, {"warnings", warnings}};
  for (const GroupComparison& group : groups)
    page["groups"].push_back({{"name", group.name},
                              {"meaning", group.meaning},
                              {"exact", number(group.exact)},
                              {"scaled", number(group.scaled)},
                              {"ratio", number(group.ratio)},
                              {"kept", group.kept}});
  write_whole_file(directory.file(k_audit_file), json_text(page) + "\n");
}

}  // namespace similitude
