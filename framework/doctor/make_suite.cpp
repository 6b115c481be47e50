#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "doctor/suites.h"
#include "doctor/trial_values.h"
#include "scene/units.h"

namespace similitude::doctor {

Complaint::Complaint(const similitude_status& status)
    : std::runtime_error(std::string(status.text, strnlen(status.text, sizeof status.text))) {}

namespace {

using Values = std::vector<similitude_value>;

/// A unit that nobody can type makes a parameter that nobody can give.
Outcome check_units(const PluginEntry& plugin) {
  const similitude_descriptor& model = *plugin.descriptor;
  std::string units;
  for (std::uint32_t k = 0; k < model.parameter_count; ++k) {
    const similitude_parameter& p = model.parameters[k];
    if (p.type != SIMILITUDE_REAL) continue;
    if (!parse_unit(p.unit))
      return fail(fmt::format("the unit \"{}\" of the parameter {} is unknown.", p.unit, p.name),
                  "Write SI units as in a case file: \"N/m\", \"kg/(m^2 s)\"; \"1\" for a pure number.");
    units += fmt::format("{}{} [{}]", units.empty() ? "" : ", ", p.name, p.unit);
  }
  return units.empty() ? ok("it has no parameter with a unit") : ok(units);
}

Outcome check_created(const PluginEntry& plugin) {
  const similitude_descriptor& model = *plugin.descriptor;
  const Values values = trial_values(model);
  similitude_status status{};
  status.row = -1;
  const similitude_bed bed = trial_bed();
  const similitude_host host{sizeof host, SIMILITUDE_ABI_MAJOR, SIMILITUDE_ABI_MINOR, [](std::int32_t, const char*) {}};
  void* instance = model.create(&host, &bed, values.data(), 1, &status);
  if (instance == nullptr || status.code != 0) {
    const std::string words = Complaint(status).what();
    return fail("it refuses the values that its own table suggests: " + (words.empty() ? "it does not say why." : words),
                "Give the parameters defaults, or typical ranges, that go together in an ordinary bed.");
  }
  std::string told;
  for (std::uint32_t k = 0; k < model.parameter_count; ++k) {
    if (model.parameters[k].required == 0) continue;
    told += fmt::format("{}{} {:g}", told.empty() ? " with " : ", ", model.parameters[k].name, values[k].real);
  }
  model.destroy(instance);
  return ok("made and destroyed" + (told.empty() ? " with its defaults" : told));
}

struct Tally {
  int taken = 0, refused = 0;
};

/// Empty if the model takes the values or says why not.
std::string tried(const similitude_descriptor& model, const Values& values, Tally& tally) {
  similitude_status status{};
  status.row = -1;
  const similitude_bed bed = trial_bed();
  const similitude_host host{sizeof host, SIMILITUDE_ABI_MAJOR, SIMILITUDE_ABI_MINOR, [](std::int32_t, const char*) {}};
  void* instance = model.create(&host, &bed, values.data(), 1, &status);
  const bool made = instance != nullptr && status.code == 0;
  if (instance != nullptr) model.destroy(instance);
  ++(made ? tally.taken : tally.refused);
  return made || status.text[0] != 0 ? "" : "it refuses without a word";
}

std::string choice_at(const similitude_parameter& p, std::size_t place) {
  std::string rest = p.choices;
  for (; place > 0 && rest.find('|') != std::string::npos; --place) rest.erase(0, rest.find('|') + 1);
  return place > 0 ? "" : rest.substr(0, rest.find('|'));
}

/// Every parameter alone at the ends of its range and at every choice: taken, or refused in words.
Outcome check_ranges(const PluginEntry& plugin) {
  const similitude_descriptor& model = *plugin.descriptor;
  if (model.parameter_count == 0) return skipped("it has no parameters");
  const Values middle = trial_values(model);
  Tally tally;
  for (std::uint32_t k = 0; k < model.parameter_count; ++k) {
    const similitude_parameter& p = model.parameters[k];
    const auto complain = [&](const std::string& value, const std::string& words) {
      return fail(fmt::format("{} with {} = {}.", words, p.name, value),
                  "Fill status->text, and narrow the declared range to what the model takes.");
    };
    Values values = middle;
    if (p.type == SIMILITUDE_CHOICE) {
      for (std::size_t place = 0;; ++place) {
        const std::string word = choice_at(p, place);
        if (word.empty()) break;
        values[k].text = word.c_str();
        if (const std::string words = tried(model, values, tally); !words.empty()) return complain(word, words);
      }
      continue;
    }
    for (const double end : {p.minimum, p.maximum}) {
      if (!std::isfinite(end)) continue;
      values[k].real = end;
      if (const std::string words = tried(model, values, tally); !words.empty())
        return complain(fmt::format("{:g}", end), words);
    }
  }
  return ok(fmt::format("{} values at the ends of the ranges: {} taken, {} refused in words", tally.taken + tally.refused,
                        tally.taken, tally.refused));
}

}  // namespace

std::vector<Check> make_suite() {
  return {{"units", check_units}, {"made", check_created, true}, {"parameter ranges", check_ranges}};
}

}  // namespace similitude::doctor
