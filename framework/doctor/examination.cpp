#include "doctor/examination.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <variant>

#include "doctor/child.h"
#include "doctor/suites.h"
#include "loader/catalogue.h"
#include "loader/json_text.h"
#include "loader/library.h"
#include "loader/tag.h"

namespace similitude::doctor {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* k_boundary = "No exception may cross the boundary: catch it in the plugin and fill the status, or use "
                                   "the SDK's macros, which do both.";

Json as_json(const Outcome& outcome) {
  return {{"verdict", static_cast<int>(outcome.verdict)}, {"seen", outcome.seen}, {"advice", outcome.advice}};
}

Outcome outcome_from(const Json& page) {
  return {static_cast<Verdict>(page.at("verdict").get<int>()), page.at("seen"), page.at("advice")};
}

/// Whatever a check runs into becomes an outcome.
template <class Work>
Outcome told(Work&& work) {
  try {
    return work();
  } catch (const PluginError& refusal) {
    return fail(refusal.what(), "A model is asked only for what its own tables allow.");
  } catch (const Complaint& complaint) {
    return fail("it reports an error: " + std::string(complaint.what()), "A model takes whatever lies within its declared ranges, in an ordinary bed.");
  } catch (const std::exception& escaped) {
    return fail("an exception leaves it: " + std::string(escaped.what()), k_boundary);
  } catch (...) {
    return fail("an exception leaves it, and it is no std::exception.", k_boundary);
  }
}

Outcome in_own_process(const std::function<Outcome()>& work, double limit) {
  const ChildAnswer answer = in_child([&] { return json_text(as_json(told(work)), -1); }, limit);
  if (!answer.lived) return fail(answer.text, answer.advice);
  return outcome_from(Json::parse(answer.text));
}

// ---------------------------------------------------------------------------------------------------------- the file

Outcome from_refusal(const Refusal& refusal) { return fail(refusal.reason, refusal.fix); }

template <std::size_t N>
std::string text_of(const char (&text)[N]) {
  return std::string(text, strnlen(text, N));
}

Outcome check_tag_bytes(const fs::path& file) {
  const auto tag = read_tag(file);
  if (const auto* refusal = std::get_if<Refusal>(&tag)) return from_refusal(*refusal);
  const auto& t = std::get<similitude_tag>(tag);
  return ok(fmt::format("plugin ABI {}.{}, {}, {}", t.abi_major, t.abi_minor, text_of(t.compiler), text_of(t.instruction_set)));
}

Outcome check_fits(const fs::path& file) {
  const auto tag = read_tag(file);
  if (std::holds_alternative<Refusal>(tag)) return skipped("there is no tag to compare");
  if (const auto refusal = check_tag(std::get<similitude_tag>(tag))) return from_refusal(*refusal);
  return ok(fmt::format("this program offers ABI {}.{}, and this processor has the instructions", SIMILITUDE_ABI_MAJOR,
                        SIMILITUDE_ABI_MINOR));
}

/// "kind id version" of every model, for the parent, which loads nothing.
struct Contents {
  Outcome outcome;
  std::vector<std::string> kinds, ids;
};

Contents contents_of(const fs::path& file, double limit) {
  const ChildAnswer answer = in_child(
      [&] {
        Json page{{"kinds", Json::array()}, {"ids", Json::array()}};
        const Outcome outcome = told([&]() -> Outcome {
          const auto loaded = load_library(file);
          if (const auto* refusal = std::get_if<Refusal>(&loaded)) return from_refusal(*refusal);
          const similitude_entry& entry = *std::get<const similitude_entry*>(loaded);
          std::string models;
          for (std::uint32_t k = 0; k < entry.descriptor_count; ++k) {
            const similitude_descriptor& model = *entry.descriptors[k];
            page["kinds"].push_back(model.kind);
            page["ids"].push_back(model.id);
            models += fmt::format("{}{} {} {} with {} parameter{}", models.empty() ? "" : "; ", model.kind, model.id, model.version,
                                  model.parameter_count, model.parameter_count == 1 ? "" : "s");
          }
          return ok(models);
        });
        page["outcome"] = as_json(outcome);
        return json_text(page, -1);
      },
      limit);
  if (!answer.lived) return {fail(answer.text, answer.advice + " It happens while the file is loaded, in its start-up code."), {}, {}};
  const Json page = Json::parse(answer.text);
  return {outcome_from(page["outcome"]), page["kinds"], page["ids"]};
}

// -------------------------------------------------------------------------------------------------------- its models

std::vector<Check> suite_of(const std::string& kind) {
  std::vector<Check> suite = make_suite();
  const std::vector<Check> own = kind == "drag"      ? drag_suite()
                                 : kind == "contact" ? contact_suite()
                                 : kind == "scaling" ? scaling_suite()
                                 : kind == "fluid"   ? fluid_suite()
                                                     : effect_suite();
  suite.insert(suite.end(), own.begin(), own.end());
  return suite;
}

/// One illness, one line: what rests on a check that failed is skipped, and a crash that comes again is named once.
class History {
 public:
  Outcome shortened(const Check& check, const Outcome& outcome) {
    if (outcome.verdict != Verdict::fail) return outcome;
    if (check.others_rest_on_it && failed_.empty()) failed_ = check.name;
    const auto [first, is_new] = first_seen_.try_emplace(outcome.seen, check.name);
    return is_new ? outcome : fail("as in \"" + first->second + "\"", "");
  }
  /// Name of a failed check that others rest on, or empty.
  const std::string& failed() const { return failed_; }

 private:
  std::string failed_;
  std::map<std::string, std::string> first_seen_;
};

void examine_model(Examination& examination, const std::string& kind, const std::string& id, double limit) {
  History history;
  for (const Check& check : suite_of(kind)) {
    Outcome outcome = skipped("\"" + history.failed() + "\" failed");
    if (history.failed().empty())
      outcome = in_own_process(
          [&] {
            const Catalogue file = Catalogue::of_file(examination.file);
            return check.examine(*file.find(kind, id));
          },
          limit);
    examination.findings.push_back({kind + " model " + id, check.name, history.shortened(check, outcome)});
  }
}

}  // namespace

bool Examination::healthy() const {
  return std::none_of(findings.begin(), findings.end(), [](const Finding& f) { return f.outcome.verdict == Verdict::fail; });
}

Examination examine(const fs::path& file, double limit) {
  Examination examination{fs::absolute(file).lexically_normal(), {}};
  const auto note = [&](const char* check, const Outcome& outcome) {
    examination.findings.push_back({"", check, outcome});
    return outcome.verdict == Verdict::ok;
  };
  const bool readable = note("tag", in_own_process([&] { return check_tag_bytes(examination.file); }, limit));
  const bool fits = readable && note("fits", in_own_process([&] { return check_fits(examination.file); }, limit));
  if (!fits) return examination;
  const Contents contents = contents_of(examination.file, limit);
  if (!note("loads", contents.outcome)) return examination;
  for (std::size_t k = 0; k < contents.ids.size(); ++k) examine_model(examination, contents.kinds[k], contents.ids[k], limit);
  return examination;
}

}  // namespace similitude::doctor
