#include "study/case_matrix.h"

#include "scene/messages.h"

namespace similitude {
namespace {

/// A model's name speaks for itself; a number needs its key: "dt_2e-6s".
std::string name_of(const Setting& setting) {
  const char first = setting.label.front();
  const bool speaks = (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
  if (speaks && setting.label != "none" && setting.label != "auto" && setting.label != "true" &&
      setting.label != "false")
    return setting.label;
  return setting.path.substr(setting.path.rfind('.') + 1) + "_" + setting.label;
}

}  // namespace

std::vector<NamedCase> cases_of(const StudyFile& study) {
  if (!study.cases.empty()) return study.cases;
  std::vector<NamedCase> cases(1);
  for (const StudyAxis& axis : study.axes) {
    std::vector<NamedCase> longer;
    for (const NamedCase& so_far : cases)
      for (const Setting& value : axis.values) {
        NamedCase next = so_far;
        next.name += (next.name.empty() ? "" : "-") + name_of(value);
        next.mark = value.mark;
        next.settings.push_back(value);
        longer.push_back(std::move(next));
      }
    cases = std::move(longer);
  }
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (cases[i].name == cases[j].name)
        throw InputError(cases[i].mark, cases[i].settings.back().written_at,
                         "two combinations would both be called " + cases[i].name + ".",
                         "Remove a value that stands twice, or list the cases with names of your own under cases:.");
  return cases;
}

}  // namespace similitude
