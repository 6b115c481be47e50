// The JSON Schema against Debian's python3-jsonschema: an editor must agree with the program.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "case_text.h"
#include "scene/case_keys.h"
#include "scene/schema.h"

namespace similitude {
namespace {

using testing::CaseFolder;
using testing::complaint;
using testing::example_with;
using testing::fake_catalogue;
using testing::k_example;

constexpr const char* k_python = "/usr/bin/python3";

bool python_can() {
  return std::system((std::string(k_python) + " -c 'import jsonschema, yaml' 2>/dev/null").c_str()) == 0;
}

/// "valid …" or "invalid …" per case, or what Python said instead.
std::string verdicts(const CaseFolder& folder, const std::vector<std::filesystem::path>& cases,
                     const Catalogue& catalogue = fake_catalogue()) {
  std::string command = std::string(k_python).append(" ").append(SIMILITUDE_VALIDATE_CASES).append(" ");
  command += folder.write("schema.json", case_schema(catalogue).dump()).string();
  for (const auto& one : cases) command.append(" ").append(one.string());
  std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"), pclose);
  std::string output;
  for (int c; (c = std::fgetc(pipe.get())) != EOF;) output += static_cast<char>(c);
  return output;
}

class Schema : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!python_can()) GTEST_SKIP() << k_python << " has no jsonschema or yaml (python3-jsonschema, python3-yaml)";
  }
  void expect(const std::string& verdict, const std::vector<std::string>& texts) {
    const CaseFolder folder;
    std::vector<std::filesystem::path> files;
    std::string wanted;
    for (const std::string& text : texts) {
      files.push_back(folder.write("case" + std::to_string(files.size()) + ".yaml", text));
      wanted += verdict + " " + files.back().string() + "\n";
    }
    EXPECT_EQ(verdicts(folder, files), wanted);
  }
};

// With the built plugins: a shipped case may name any of them.
TEST_F(Schema, TakesEveryShippedCase) {
  const CaseFolder folder;
  std::vector<std::filesystem::path> cases;
  std::string wanted;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SIMILITUDE_CONFIGS)) {
    if (entry.path().extension() != ".yaml") continue;
    std::ifstream stream(entry.path());
    std::ostringstream text;
    text << stream.rdbuf();
    if (text.str().find("\nsimilitude: ") == std::string::npos) continue;  // a study, or data of another kind
    cases.push_back(entry.path());
    wanted += "valid " + entry.path().string() + "\n";
  }
  ASSERT_GE(cases.size(), 3u);
  EXPECT_EQ(verdicts(folder, cases, Catalogue(search_levels({}))), wanted);
}

TEST_F(Schema, TakesTheExampleAndItsResolvedForm) {
  expect("valid", {k_example, testing::read_text_case(k_example).resolved,
                   testing::read_text_case(
                       k_example, {"models.effects=[magnus]", "scene.gravity=9.8 m/s^2", "scene.bed.fill=lattice",
                                   "output.vtk=none", "time.dt=1 us", "models.contact.tangential=slip"})
                       .resolved});
}

// Each is refused by the program as well: the two do not drift apart.
TEST_F(Schema, RefusesWhatTheProgramRefuses) {
  const std::vector<std::string> broken{
      example_with("similitude: 1", "similitude: 2"),
      example_with("similitude: 1\n", ""),
      example_with("diameter: 1 mm", "diamter: 1 mm"),
      example_with("diameter: 1 mm", "diameter: -1 mm"),
      example_with("cell: 5 mm", "cell: 5"),
      example_with("[150 mm, 20 mm, 1 m]", "[150 mm, 20 mm]"),
      example_with("count: 461000", "count: many"),
      example_with("count: 461000", "count: -1"),
      example_with("face: bottom, x", "face: botom, x"),
      example_with("rest: true", "rest: maybe"),
      example_with("pressure: 0 Pa", "pressure: 0 Pa, velocity: 1 m/s"),
      example_with("at_x: [60 mm, 90 mm], ", ""),
      example_with("drag: syamlal_obrien", "drag: gidaspo"),
      example_with("restitution: 0.74", "restitution: 1.4"),
      example_with("friction: 0.2", "fricton: 0.2"),
      example_with("stiffness: 500 N/m, ", ""),
      example_with("vtk: every 50 ms", "vtk: 50 ms"),
      example_with("effects: auto", "effects: some"),
      example_with("  fluid: vans\n", ""),
      k_example + "colour: red\n",
  };
  expect("invalid", broken);
  for (const std::string& text : broken) EXPECT_NE(complaint(text), "") << text;
}

/// The rows of the reference page's tables: key, how it is written, default, meaning.
void collect(KeyTable table, const std::string& path, std::vector<std::string>& rows) {
  static const char* const forms[] = {"text",
                                      "whole number",
                                      "true or false",
                                      "",
                                      "[UNIT]",
                                      "[UNIT] or auto",
                                      "two of [UNIT]",
                                      "three of [UNIT]",
                                      "[UNIT], or three",
                                      "[UNIT], or three",
                                      "[UNIT], or a list",
                                      "every [UNIT]",
                                      "every [UNIT], or none",
                                      "list of x, y, z",
                                      "list of texts",
                                      "keys below",
                                      "names, each with the keys below",
                                      "model",
                                      "auto, or list of models"};
  for (const CaseKey& key : table) {
    std::string form = forms[static_cast<int>(key.form)];
    if (key.form == Form::choice) form = key.choices;
    for (std::size_t bar = form.find('|'); bar != std::string::npos; bar = form.find('|')) form.replace(bar, 1, ", ");
    const std::size_t unit = form.find("[UNIT]");
    if (unit != std::string::npos) form.replace(unit, 6, key.unit);
    std::string row = "| `";
    row.append(path).append(key.name).append("` | ").append(form).append(" | ");
    row.append(key.required ? "required" : key.default_text).append(" | ").append(key.doc).append(" |");
    rows.push_back(row);
    if (key.table != nullptr) {
      const std::string below = path + std::string(key.name) + (key.form == Form::named_sections ? ".NAME." : ".");
      collect(key.table(), below, rows);
    }
  }
}

// Made from the tables that the reader goes by; a failure prints the row to paste.
TEST(ReferencePage, HasARowForEveryKey) {
  std::ifstream stream(SIMILITUDE_CASE_PAGE);
  std::ostringstream page;
  page << stream.rdbuf();
  std::vector<std::string> rows;
  collect(case_keys(), "", rows);
  EXPECT_GT(rows.size(), 60u);
  for (const std::string& row : rows) EXPECT_NE(page.str().find(row + "\n"), std::string::npos) << row;
}

}  // namespace
}  // namespace similitude
