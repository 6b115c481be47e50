#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/text_table.h"
#include "loader/json_text.h"
#include "stepper/comparison.h"
#include "stepper/prediction.h"

namespace similitude::app {
namespace {

struct ScaleArguments {
  std::string case_file;
  std::vector<std::string> overrides, laws;
  double speedup = 0;
  int threads = 0;
  bool json = false, markdown = false;
};

struct Factor {
  const char* name;
  const char* meaning;
  double similitude_ratios::*value;
};

constexpr Factor k_factors[] = {{"length", "length", &similitude_ratios::length},
                                {"diameter", "particle diameter", &similitude_ratios::diameter},
                                {"drag_diameter", "diameter for drag", &similitude_ratios::drag_diameter},
                                {"particle_density", "particle density", &similitude_ratios::particle_density},
                                {"gas_density", "gas density", &similitude_ratios::gas_density},
                                {"gas_viscosity", "gas viscosity", &similitude_ratios::gas_viscosity},
                                {"velocity", "velocity", &similitude_ratios::velocity},
                                {"time", "time", &similitude_ratios::time},
                                {"stiffness", "spring stiffness", &similitude_ratios::stiffness},
                                {"modulus", "elastic modulus", &similitude_ratios::modulus},
                                {"energy_loss", "1 - e^2", &similitude_ratios::energy_loss},
                                {"parcel_weight", "particles per grain", &similitude_ratios::parcel_weight}};

// ------------------------------------------------------------------------------------------------------------ JSON

/// A law without a bed for this case keeps its row, empty, and says why among its warnings.
nlohmann::json as_json(const Strategy& strategy) {
  nlohmann::json page{{"id", strategy.law.id},
                      {"factors", nlohmann::json::object()},
                      {"groups", nlohmann::json::object()},
                      {"particles", nullptr},
                      {"cost", {{"particle_steps", nullptr}, {"wall_s", nullptr}}},
                      {"warnings", strategy.warnings}};
  if (!strategy.error.empty()) {
    page["warnings"].push_back(strategy.error);
    return page;
  }
  for (const Factor& factor : k_factors) page["factors"][factor.name] = strategy.factors.*factor.value;
  for (const GroupComparison& group : strategy.groups)
    page["groups"][group.name] = {{"exact", group.exact}, {"scaled", group.scaled}, {"ratio", group.ratio}, {"kept", group.kept}};
  page["particles"] = strategy.particles;
  page["cost"] = {{"particle_steps", strategy.particle_steps}, {"wall_s", strategy.wall_s}};
  return page;
}

nlohmann::json as_json(const Comparison& comparison) {
  nlohmann::json page{{"strategies", nlohmann::json::array()}};
  for (const Strategy& strategy : comparison.strategies) page["strategies"].push_back(as_json(strategy));
  return page;
}

// ------------------------------------------------------------------------------------------------------------ text

std::string short_number(double value) {
  if (value != 0 && (std::abs(value) >= 1e5 || std::abs(value) < 1e-3)) return fmt::format("{:.2e}", value);
  return fmt::format("{:.4g}", value);
}

std::vector<const Strategy*> with_beds(const Comparison& comparison) {
  std::vector<const Strategy*> found;
  for (const Strategy& strategy : comparison.strategies)
    if (strategy.error.empty()) found.push_back(&strategy);
  return found;
}

template <class Cell>
std::vector<std::string> row(const std::string& name, const std::string& real, const std::vector<const Strategy*>& strategies,
                             Cell cell) {
  std::vector<std::string> cells{name, real};
  for (const Strategy* strategy : strategies) cells.push_back(cell(*strategy));
  return cells;
}

/// Rows of factors, groups and cost; a column per strategy, the real bed's own numbers first.
Table table_of(const std::vector<const Strategy*>& shown) {
  Table table;
  table.push_back(row("", "real bed", shown, [](const Strategy& s) { return s.law.id; }));
  table.push_back(row("parameters", "", shown, [](const Strategy& s) { return s.law.parameters.empty() ? "-" : s.law.parameters; }));
  for (const Factor& factor : k_factors)
    table.push_back(row(factor.meaning, "", shown, [&](const Strategy& s) { return short_number(s.factors.*factor.value); }));
  for (std::size_t g = 0; g < shown.front()->groups.size(); ++g) {
    const GroupComparison& group = shown.front()->groups[g];
    table.push_back(row(group.name, short_number(group.exact), shown, [&](const Strategy& s) {
      return s.groups[g].kept ? "kept" : fmt::format("x {:.4g}", s.groups[g].ratio);
    }));
  }
  table.push_back(row("particles", "", shown, [](const Strategy& s) { return fmt::format("{:.0f}", s.particles); }));
  table.push_back(row("particle-steps", "", shown, [](const Strategy& s) { return fmt::format("{:.2e}", s.particle_steps); }));
  table.push_back(row("speed-up", "", shown, [](const Strategy& s) { return fmt::format("{:.3g}", s.speedup); }));
  table.push_back(row("wall time", "", shown, [](const Strategy& s) { return seconds_text(s.wall_s); }));
  return table;
}

void print_markdown(const Table& table, std::ostream& out) {
  for (std::size_t r = 0; r < table.size(); ++r) {
    std::string line = "|";
    for (const std::string& cell : table[r]) line += " " + cell + " |";
    out << line << "\n";
    if (r > 0) continue;
    line = "|";
    for (std::size_t c = 0; c < table[r].size(); ++c) line += c == 0 ? "---|" : "---:|";
    out << line << "\n";
  }
}

/// What is counted in particles is lost alike, and said once.
std::string lost_groups(const Strategy& strategy) {
  std::string text;
  for (const GroupComparison& group : strategy.groups) {
    const bool counted = group.name.ends_with("/d");
    if (group.kept || (counted && group.name != "L/d")) continue;
    text += (text.empty() ? "" : ", ") + fmt::format("{} x {:.4g}", counted ? "all lengths in particles" : group.name, group.ratio);
  }
  return text.empty() ? "nothing" : text;
}

std::string heading(const Strategy& strategy) {
  return strategy.law.id + (strategy.law.parameters.empty() ? "" : " (" + strategy.law.parameters + ")");
}

/// Under the table: what each law gives up and what that means in this bed.
void print_words(const Comparison& comparison, const char* item, std::ostream& out) {
  for (const Strategy& strategy : comparison.strategies) {
    if (!strategy.error.empty()) {
      out << item << heading(strategy) << ": " << strategy.error << "\n";
      continue;
    }
    out << item << heading(strategy) << ", " << strategy.law.because << ", gives up " << lost_groups(strategy) << ".\n";
    for (const std::string& warning : strategy.warnings) out << "    - " << warning << "\n";
  }
  for (const std::string& text : comparison.left_out) out << item << text << "\n";
}

constexpr std::size_t k_columns = 5;   // strategies in one block of a terminal of 120 characters

void print(const Comparison& comparison, std::ostream& out) {
  out << comparison.title << "\n\nFactors are simulated over real. Groups are kept within 0.1 %, or stand as scaled over real. "
      << fmt::format("u_mf at a gas fraction of {:.4g}.\n", comparison.gas_fraction_at_minimum);
  const std::vector<const Strategy*> all = with_beds(comparison);
  for (std::size_t first = 0; first < all.size(); first += k_columns) {
    const std::size_t last = std::min(all.size(), first + k_columns);
    out << "\n";
    print_table(table_of({all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(last)}), out);
  }
  out << "\n";
  for (const std::string& line : comparison.legend) out << line << "\n";
  out << "\n";
  print_words(comparison, "", out);
  out << fmt::format("\nWall times are for this machine with {} thread{}: {:.3g} M particle-steps/s, {:.3g} ms per gas step and {:.3g} ns per particle in it, measured with the "
                     "case's own law.\n",
                     comparison.threads, comparison.threads == 1 ? "" : "s", 1e-6 * comparison.particle_steps_per_s, 1e3 * comparison.gas_step_s, 1e9 * comparison.exchange_s);
}

void print_as_markdown(const Comparison& comparison, std::ostream& out) {
  out << "# " << comparison.title << "\n\nFactors are simulated over real. Groups are kept within 0.1 %, or stand as scaled over real. "
      << fmt::format("u_mf at a gas fraction of {:.4g}.\n\n", comparison.gas_fraction_at_minimum);
  const std::vector<const Strategy*> all = with_beds(comparison);
  if (!all.empty()) print_markdown(table_of(all), out);
  out << "\n";
  for (const std::string& line : comparison.legend) out << "* " << line << "\n";
  out << "\n";
  print_words(comparison, "* ", out);
}

Comparison comparison_of(const ScaleArguments& arguments, const CaseAsTyped& typed) {
  if (arguments.speedup != 0) return propose(typed, arguments.speedup);
  std::vector<std::string> left_out;
  std::vector<LawChoice> laws;
  for (const std::string& text : arguments.laws) laws.push_back(law_from_text(text));
  if (laws.empty()) laws = default_laws(typed, left_out);
  Comparison comparison = compare_laws(typed, laws);
  comparison.left_out = left_out;
  return comparison;
}

int scale(const ScaleArguments& arguments) {
  const Catalogue plugins = catalogue_for(arguments.case_file);
  predict_with_threads(arguments.threads);
  const Comparison comparison = comparison_of(arguments, {arguments.case_file, arguments.overrides, plugins});
  if (arguments.json) {
    std::cout << json_text(as_json(comparison)) << "\n";
  } else if (arguments.markdown) {
    print_as_markdown(comparison, std::cout);
  } else {
    print(comparison, std::cout);
  }
  return 0;
}

}  // namespace

void add_scale(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<ScaleArguments>();
  CLI::App* command = app.add_subcommand(
      "scale", "Put every scaling law to a case, side by side: what it changes, keeps, gives up and costs. No step is run.");
  command->add_option("CASE", arguments->case_file, "case file (YAML)")->required();
  CLI::Option* laws =
      command->add_option("--law", arguments->laws, "only this law, e.g. link:n=2 or similarity:geometry=0.5,n=1; may be repeated")
          ->allow_extra_args(false);
  command
      ->add_option("--speedup", arguments->speedup,
                   "propose of each law the choice that needs so many times fewer particle-steps, and what it gives up")
      ->excludes(laws);
  command->add_option("--set", arguments->overrides, "change a value of the case: key=value")->allow_extra_args(false);
  add_threads_option(*command, arguments->threads, "threads that the wall times are of (default: all cores)");
  CLI::Option* json = command->add_flag("--json", arguments->json, "for other programs");
  command->add_flag("--markdown", arguments->markdown, "for a report")->excludes(json);
  command->footer("Laws not asked for by --law stand with these choices: the case's own as written; a bed of a quarter the size\n"
                  "where a law shrinks the bed; particles twice as large in it where a law leaves that free.");
  command->callback([arguments, &action] { action = [arguments] { return scale(*arguments); }; });
}

}  // namespace similitude::app
