#include "loader/describe.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "cage.h"

namespace similitude {
namespace {

using nlohmann::json;

constexpr double k_open = std::numeric_limits<double>::infinity();
constexpr double k_not_given = std::numeric_limits<double>::quiet_NaN();

constexpr similitude_parameter k_parameters[] = {
    {sizeof(similitude_parameter), SIMILITUDE_REAL, 1, SIMILITUDE_SCALES_AS_STIFFNESS, "stiffness", "N/m",
     "normal spring", nullptr, nullptr, nullptr, 0, 0, k_open, 100, 5000, nullptr},
    {sizeof(similitude_parameter), SIMILITUDE_REAL, 0, 0, "restitution", "1", "normal restitution", "Tsuji 1992",
     nullptr, nullptr, 0.9, 0.01, 1, 0, 0, nullptr},
    {sizeof(similitude_parameter), SIMILITUDE_REAL, 0, 0, "cutoff", "K", "if given", nullptr, nullptr, nullptr,
     k_not_given, -k_open, k_open, 0, 0, nullptr},
    {sizeof(similitude_parameter), SIMILITUDE_FLAG, 0, 0, "attraction", "", "whether it pulls", nullptr, nullptr,
     nullptr, 0, 0, 1, 0, 0, nullptr},
    {sizeof(similitude_parameter), SIMILITUDE_CHOICE, 0, 0, "wall", "", "which wall", nullptr, "flat|rough", "flat", 0,
     0, 0, 0, 0, nullptr}};
constexpr similitude_descriptor k_spring{sizeof(similitude_descriptor),
                                         5,
                                         "contact",
                                         "spring",
                                         "1.2.0",
                                         "A spring",
                                         "A. Nother",
                                         "Cundall & Strack 1979",
                                         k_parameters,
                                         nullptr,
                                         nullptr,
                                         nullptr};
constexpr similitude_descriptor k_none{sizeof(similitude_descriptor),
                                       0,
                                       "drag",
                                       "none",
                                       "1.0.0",
                                       "No drag",
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       nullptr};

Catalogue two_models() {
  return Catalogue(
      std::vector<PluginEntry>{{&k_none, "/p/drag_none.so", "install folder", ""},
                               {&k_spring, "/u/contact_spring.so", "user folder", "/p/contact_spring.so"}});
}

TEST(PluginsList, HasALinePerPluginByKindAndId) {
  EXPECT_EQ(plugins_text(two_models()),
            "kind     id      version  title     file\n"
            "contact  spring  1.2.0    A spring  /u/contact_spring.so\n"
            "drag     none    1.0.0    No drag   /p/drag_none.so\n"
            "The contact model \"spring\" of user folder hides /p/contact_spring.so.\n");
}

TEST(PluginsList, CountsWhatWasRefused) {
  zoo::Cage cage;
  EXPECT_EQ(plugins_text(cage.write("a.so", "").catalogue()),
            "kind  id  version  title  file\n1 file was refused: `similitude plugins failures` says why.\n");
}

TEST(PluginsList, AsJsonHasKindIdVersionTitleFile) {
  EXPECT_EQ(plugins_json(two_models()), json::parse(R"({"plugins": [
    {"kind": "contact", "id": "spring", "version": "1.2.0", "title": "A spring", "file": "/u/contact_spring.so"},
    {"kind": "drag", "id": "none", "version": "1.0.0", "title": "No drag", "file": "/p/drag_none.so"}]})"));
}

TEST(PluginsList, WithoutPluginsIsAnEmptyList) {
  EXPECT_EQ(plugins_json(Catalogue(std::vector<PluginEntry>{})), json::parse(R"({"plugins": []})"));
}

TEST(PluginInfo, ShowsTheParameterTable) {
  EXPECT_EQ(plugin_info_text(two_models(), "spring"),
            "spring 1.2.0 (contact)\n"
            "  A spring\n"
            "  authors:   A. Nother\n"
            "  reference: Cundall & Strack 1979\n"
            "  file:      /u/contact_spring.so (user folder)\n"
            "  hides:     /p/contact_spring.so\n"
            "  parameter    unit  default   range                            meaning\n"
            "  stiffness    N/m   required  [0, ...], typically [100, 5000]  normal spring\n"
            "  restitution  1     0.9       [0.01, 1]                        normal restitution [Tsuji 1992]\n"
            "  cutoff       K     left out  any                              if given\n"
            "  attraction   -     false     true or false                    whether it pulls\n"
            "  wall         -     flat      flat or rough                    which wall\n");
}

TEST(PluginInfo, SaysThatThereAreNoParameters) {
  EXPECT_EQ(plugin_info_text(two_models(), "none"),
            "none 1.0.0 (drag)\n  No drag\n  file:      /p/drag_none.so (install folder)\n  no parameters\n");
}

TEST(PluginInfo, OfAnUnknownIdNamesTheNearest) {
  EXPECT_EQ(zoo::error_of([] { plugin_info_text(two_models(), "sprig"); }),
            "there is no model \"sprig\".\n"
            "  Did you mean \"spring\" (1.2.0, from /u/contact_spring.so)?\n"
            "  Models found: spring, none.");
}

TEST(PluginInfo, AsJsonHasNullWhereThereIsNothing) {
  const json info = plugin_info_json(two_models(), "spring");
  ASSERT_EQ(info["plugins"].size(), 1u);
  const json& spring = info["plugins"][0];
  EXPECT_EQ(spring["level"], "user folder");
  EXPECT_EQ(spring["hides"], "/p/contact_spring.so");
  EXPECT_EQ(spring["parameters"][0],
            json::parse(R"({"name": "stiffness", "type": "real", "unit": "N/m", "required": true,
    "default": null, "minimum": 0.0, "maximum": null, "typical_minimum": 100.0, "typical_maximum": 5000.0, "choices": null,
    "scales_as": "stiffness", "doc": "normal spring", "reference": null})"));
  EXPECT_EQ(spring["parameters"][2]["default"], json());
  EXPECT_EQ(spring["parameters"][3]["default"], false);
  EXPECT_EQ(spring["parameters"][4]["choices"], json::parse(R"(["flat", "rough"])"));
}

TEST(PluginFailures, TellReasonAndFix) {
  zoo::Cage cage;
  cage.write("a.so", "");
  EXPECT_EQ(failures_text(cage.catalogue()),
            cage.path("a.so") +
                ": refused: it is not a library (no ELF file).\n"
                "  Build the plugin with similitude_add_plugin(), or remove the file.\n");
  EXPECT_EQ(failures_json(cage.catalogue()),
            json({{"failures",
                   {{{"file", cage.path("a.so")},
                     {"reason", "it is not a library (no ELF file)."},
                     {"fix", "Build the plugin with similitude_add_plugin(), or remove the file."}}}}}));
}

TEST(PluginFailures, NoneIsSaidInWords) {
  EXPECT_EQ(failures_text(two_models()), "No file was refused.\n");
  EXPECT_EQ(failures_json(two_models()), json::parse(R"({"failures": []})"));
}

}  // namespace
}  // namespace similitude
