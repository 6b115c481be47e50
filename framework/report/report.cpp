#include "report/report.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "loader/json_text.h"
#include "output/whole_file.h"
#include "report/page_parts.h"
#include "report/run_data.h"
#include "scene/messages.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

constexpr std::size_t k_view_bytes = 7'500'000;  // of all cases together, before base64: keeps a page below 15 MB

json study_data(const fs::path& folder, json study) {
  json runs = json::array();
  const json& cases = study.at("cases");
  const std::size_t view_bytes = k_view_bytes / std::max<std::size_t>(1, cases.size());
  for (const json& one : cases) {
    // A stored reference lies elsewhere; its path is absolute or the study's.
    const fs::path inside = folder / one.value("folder", std::string());
    json run = run_data(inside, view_bytes);
    run["profiles"] = nullptr;  // stand in study.json
    runs.push_back(std::move(run));
  }
  return {{"kind", "study"}, {"title", study.value("title", std::string())}, {"study", std::move(study)}, {"runs", std::move(runs)}};
}

json single_run_data(const fs::path& folder, const json& manifest) {
  json run = run_data(folder, k_view_bytes);
  const std::string title = manifest.contains("case") ? manifest["case"].value("title", std::string()) : std::string();
  return {{"kind", "run"}, {"title", title.empty() ? fs::absolute(folder).filename().string() : title}, {"runs", {std::move(run)}}};
}

json data_of(const fs::path& folder) {
  json study = json_file(folder / "study.json");
  if (study.is_object() && study.contains("cases") && study["cases"].is_array()) return study_data(folder, std::move(study));
  const json manifest = json_file(folder / "manifest.json");
  if (manifest.is_object()) return single_run_data(folder, manifest);
  throw InputError(folder.string() + " holds no finished study and no run.",
                   "A report is made of the folder that similitude run or similitude study wrote.");
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else out += c;
  }
  return out;
}

/// JSON inside a script element: no "</script>" may stand in it.
std::string as_script(const json& data) {
  std::string text = json_text(data, -1), out;
  for (const char c : text) {
    if (c == '<') out += "\\u003c";
    else out += c;
  }
  return out;
}

/// The template with every {{name}} filled in; what is filled in is not looked at again.
std::string filled(std::string_view page, const std::map<std::string_view, std::string_view>& parts) {
  std::string out;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t open = std::min(page.find("{{", at), page.size());
    out += page.substr(at, open - at);
    if (open == page.size()) break;
    const std::size_t close = page.find("}}", open);
    out += parts.at(page.substr(open + 2, close - open - 2));
    at = close + 2;
  }
  return out;
}

}  // namespace

fs::path write_report(const fs::path& folder) {
  const json data = data_of(folder);
  const std::string title = escaped(data["title"].get<std::string>()), numbers = as_script(data);
  const fs::path file = folder / "report.html";
  write_whole_file(file, filled(k_page, {{"title", title},
                                         {"style", k_page_style},
                                         {"chart_library", k_chart_library},
                                         {"chart_licence", k_chart_licence},
                                         {"base", k_page_base},
                                         {"charts", k_page_charts},
                                         {"bed", k_page_bed},
                                         {"sections", k_page_sections},
                                         {"data", numbers}}));
  return file;
}

}  // namespace similitude
