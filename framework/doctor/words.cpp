#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "doctor/examination.h"

namespace similitude::doctor {
namespace {

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::ok: return "ok";
    case Verdict::fail: return "FAIL";
    case Verdict::skipped: return "skipped";
  }
  return "";
}

/// Later lines under the first.
std::string indented(const std::string& text, std::size_t columns) {
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '\n') out += std::string(columns, ' ');
  }
  return out;
}

}  // namespace

std::string examination_text(const Examination& examination) {
  std::size_t width = 0;
  for (const Finding& finding : examination.findings) width = std::max(width, finding.check.size());
  const std::size_t margin = 2 + 7 + 2 + width + 2;   // the widest verdict is "skipped"
  std::string text = examination.file.string() + "\n";
  std::string heading;
  int failed = 0, done = 0, skipped = 0;
  for (const Finding& finding : examination.findings) {
    const std::string of = finding.model.empty() ? "file" : finding.model;
    if (of != heading) text += "\n" + of + "\n";
    heading = of;
    const Outcome& outcome = finding.outcome;
    text += fmt::format("  {:<7}  {:<{}}  {}\n", word_of(outcome.verdict), finding.check, width, indented(outcome.seen, margin));
    if (!outcome.advice.empty()) text += std::string(margin, ' ') + indented(outcome.advice, margin) + "\n";
    ++(outcome.verdict == Verdict::fail ? failed : outcome.verdict == Verdict::skipped ? skipped : done);
  }
  text += failed == 0 ? fmt::format("\nHealthy: {} checks passed", done)
                      : fmt::format("\nNot healthy: {} of {} checks failed", failed, done + failed);
  return text + (skipped == 0 ? ".\n" : fmt::format(", {} skipped.\n", skipped));
}

nlohmann::json examination_json(const Examination& examination) {
  nlohmann::json page{{"file", examination.file.string()}, {"healthy", examination.healthy()}, {"findings", nlohmann::json::array()}};
  for (const Finding& finding : examination.findings) {
    const Outcome& outcome = finding.outcome;
    page["findings"].push_back({{"model", finding.model.empty() ? nlohmann::json(nullptr) : nlohmann::json(finding.model)},
                                {"check", finding.check},
                                {"verdict", word_of(outcome.verdict)},
                                {"seen", outcome.seen},
                                {"advice", outcome.advice}});
  }
  return page;
}

}  // namespace similitude::doctor
