#include "report/run_data.h"

#include <cmath>
#include <fstream>
#include <map>

#include "output/audit_file.h"
#include "output/csv_table.h"
#include "output/front_view.h"
#include "report/base64.h"
#include "scene/messages.h"

namespace similitude {
namespace {

using json = nlohmann::ordered_json;

constexpr std::size_t k_rows_of_series = 400;  // of a chart a few hundred pixels wide

/// Six digits are more than a chart shows; tables of results come from study.json and profiles.csv with all of theirs.
json plotted(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (value == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
  return std::round(value / unit) * unit;
}

json monitors(const std::filesystem::path& folder) {
  const CsvTable table(folder / "monitors.csv");
  const std::size_t every = table.rows() / k_rows_of_series + 1;
  json page{{"rows", table.rows()}, {"every", every}, {"columns", json::object()}};
  for (const std::string& column : table.columns()) {
    const std::vector<double> values = table.numbers(column);
    json shown = json::array();
    for (std::size_t row = 0; row < values.size(); row += every) shown.push_back(plotted(values[row]));
    page["columns"][column] = std::move(shown);
  }
  return page;
}

json profiles(const std::filesystem::path& folder) {
  const CsvTable table(folder / "profiles.csv");
  const std::vector<std::string> samplers = table.texts("sampler");
  const std::vector<double> x = table.numbers("x"), z = table.numbers("z"), mean = table.numbers("mean"),
                            error = table.numbers("standard error"), blocks = table.numbers("blocks");
  const auto number = [](double value) { return std::isfinite(value) ? json(value) : json(nullptr); };
  json page = json::array();
  for (std::size_t row = 0; row < samplers.size(); ++row) {
    if (page.empty() || page.back()["sampler"] != samplers[row])
      page.push_back({{"sampler", samplers[row]}, {"bins", json::array()}});
    page.back()["bins"].push_back({{"x", number(x[row])},
                                   {"z", number(z[row])},
                                   {"mean", number(mean[row])},
                                   {"standard_error", number(error[row])},
                                   {"blocks", number(blocks[row])}});
  }
  return page;
}

/// Every so manieth picture, as the file holds it.
json front_view(const std::filesystem::path& folder, std::size_t most_bytes) {
  const std::vector<char> bytes = read_front_view(folder);
  const FrontViewIndex index = front_view_index(bytes);
  if (index.pictures.empty()) return nullptr;
  const std::size_t every = bytes.size() / most_bytes + 1;
  std::vector<char> shown(bytes.begin(), bytes.begin() + k_front_view_header);
  for (std::size_t k = 0; k < index.pictures.size(); k += every)
    shown.insert(shown.end(), bytes.begin() + static_cast<std::ptrdiff_t>(index.pictures[k].begin),
                 bytes.begin() + static_cast<std::ptrdiff_t>(index.pictures[k].end));
  return {{"every", every}, {"pictures", index.pictures.size()}, {"base64", base64(shown)}};
}

/// What `gather` makes, or null if a file is missing or not as a run writes it.
template <class Gather>
json or_null(Gather gather) {
  try {
    return gather();
  } catch (const InputError&) {
    return nullptr;
  }
}

}  // namespace

json json_file(const std::filesystem::path& file) {
  std::ifstream stream(file);
  json page = json::parse(stream, nullptr, false);
  return page.is_discarded() ? json(nullptr) : page;
}

json run_data(const std::filesystem::path& folder, std::size_t view_bytes) {
  return {{"manifest", json_file(folder / "manifest.json")},
          {"timing", json_file(folder / "timing.json")},
          {"audit", json_file(folder / k_audit_file)},
          {"monitors", or_null([&] { return monitors(folder); })},
          {"profiles", or_null([&] { return profiles(folder); })},
          {"view", front_view(folder, view_bytes)}};
}

}  // namespace similitude
