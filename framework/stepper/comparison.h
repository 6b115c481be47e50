#pragma once
/// Every scaling law of the catalogue put to one case before a step is run: what it changes, keeps, gives up and costs.

#include <filesystem>
#include <string>
#include <vector>

#include "similarity/audit.h"
#include "stepper/assembly.h"

namespace similitude {

/// A law with its parameters, as the case's models.scaling would have it.
struct LawChoice {
  std::string id;
  std::string scaling;      // YAML: "{id: link, n: 2}"; empty: as in the case
  std::string parameters;   // for people: "n = 2"
  std::string because;      // "the case's own", "by default: …", "asked for"
};

struct Strategy {
  LawChoice law;
  std::string error;        // why this law has no bed for this case; then nothing below is set
  similitude_ratios factors{};
  std::vector<GroupComparison> groups;
  double particles = 0;
  double particle_steps = 0;
  double wall_s = 0;
  double speedup = 1;       // particle-steps of the real bed over these
  std::vector<std::string> warnings;
};

struct Comparison {
  std::string title;
  double gas_fraction_at_minimum = 0;   // [-], at which u_mf is taken; a law that was told another is judged at its own
  double particle_steps = 0;            // of the real bed, simulated exactly
  double particle_steps_per_s = 0, gas_step_s = 0, exchange_s = 0;   // measured on this machine, with the case's own law: see prediction.h
  int threads = 0;                      // that these were measured with
  std::vector<std::string> legend;      // what the symbols of the groups stand for in the real bed
  std::vector<Strategy> strategies;
  std::vector<std::string> left_out;    // laws that cannot be put into words without the user
};

/// A case as it was typed: file, --set, plugins.
struct CaseAsTyped {
  std::filesystem::path file;
  std::vector<std::string> overrides;
  const Catalogue& catalogue;
};

/// "link:n=2,other=3" as a law that was asked for. Throws InputError for what has not this form.
LawChoice law_from_text(const std::string& text);

/// The case's own law, then every law of the catalogue that has stated defaults: a bed of a quarter the size where a law
/// shrinks the bed, particles twice as large in it where a law leaves that free. What has not goes to `left_out`.
std::vector<LawChoice> default_laws(const CaseAsTyped& typed, std::vector<std::string>& left_out);

/// What the scaling law of a case keeps and gives up, its own drag law asked for u_mf and u_t.
struct ScalingAudit {
  std::vector<GroupComparison> groups;
  std::vector<std::string> warnings;
  std::vector<std::string> legend;   // see similarity/audit.h
};
ScalingAudit audit_of(const Assembly& assembly, const Catalogue& catalogue, double gas_fraction_at_minimum);

/// The laws side by side. A law that has no bed for this case tells so in its row, unless `laws` were asked for: then it
/// throws. Throws InputError for a case without particles.
Comparison compare_laws(const CaseAsTyped& typed, const std::vector<LawChoice>& laws);

/// Of every law that has one free size, the choice that needs `speedup` times fewer particle-steps than the real bed; of the
/// similarity family several; the exact bed first, to compare with. A law that cannot reach it says how far it gets.
Comparison propose(const CaseAsTyped& typed, double speedup);

}  // namespace similitude
