#include <gtest/gtest.h>

#include "cage.h"
#include "loader/catalogue.h"

namespace similitude {
namespace {

using zoo::Cage;
using zoo::error_of;

/// The answer of a model that refuses, to a factor.
std::string answer_to(double factor, const Cage& cage) {
  const Catalogue catalogue = cage.catalogue();
  return error_of([&] {
    create_model<similitude_drag_functions>(*catalogue.find("drag", "refuses"), similitude_bed{}, {{factor, nullptr}});
  });
}

TEST(CreateModel, GivesFunctionsAndInstance) {
  Cage cage;
  const Catalogue catalogue = cage.add("sound").catalogue();
  const DragModel model =
      create_model<similitude_drag_functions>(*catalogue.find("drag", "sound"), similitude_bed{}, {{0.5, nullptr}});
  EXPECT_TRUE(model);
  EXPECT_NE(model.instance(), nullptr);
  EXPECT_NE(model.functions().exchange, nullptr);
}

TEST(CreateModel, ARefusalCarriesThePluginsOwnWords) {
  Cage cage;
  EXPECT_EQ(answer_to(0.75, cage.add("refuses")),
            "drag model \"refuses\" cannot be created: the factor 0.75 does not fit a bed of 1 mm particles.\n"
            "  Use at most 0.5.\n"
            "  (from " +
                cage.path("drag_refuses.so") + ", version 1.0.0)");
}

TEST(CreateModel, ARefusalWithoutAWordIsStillARefusal) {
  Cage cage;
  EXPECT_EQ(answer_to(0.0, cage.add("refuses")),
            "drag model \"refuses\" cannot be created: it does not say why.\n  (from " + cage.path("drag_refuses.so") +
                ", version 1.0.0)");
}

TEST(CreateModel, ATextWithoutAnEndIsCutAtTheEndOfItsField) {
  Cage cage;
  EXPECT_EQ(answer_to(0.25, cage.add("refuses")), "drag model \"refuses\" cannot be created: " + std::string(504, 'x') +
                                                      "\n  (from " + cage.path("drag_refuses.so") + ", version 1.0.0)");
}

TEST(CreateModel, AnotherKindOrAnotherNumberOfValuesIsTheCallersMistake) {
  Cage cage;
  const Catalogue catalogue = cage.add("sound").catalogue();
  const PluginEntry& sound = *catalogue.find("drag", "sound");
  EXPECT_THROW(create_model<similitude_contact_functions>(sound, similitude_bed{}, {{0.5, nullptr}}), std::logic_error);
  EXPECT_THROW(create_model<similitude_drag_functions>(sound, similitude_bed{}, {}), std::logic_error);
  EXPECT_THROW(create_model<similitude_drag_functions>(sound, similitude_bed{}, {{0.5, nullptr}}, 2), std::logic_error);
}

/// A model made here, to watch what crosses the boundary.
struct Watched {
  static inline int alive = 0;
  static inline std::string heard;
  static void* create(const similitude_host* host, const similitude_bed* bed, const similitude_value* values, uint32_t,
                      similitude_status* status) {
    EXPECT_EQ(host->struct_size, sizeof(similitude_host));
    EXPECT_NE(host->log, nullptr);
    EXPECT_EQ(bed->struct_size, sizeof(similitude_bed));
    heard = values[0].text == nullptr ? "nothing" : values[0].text;
    status->code = heard == "both" ? 1 : 0;
    ++alive;
    return &alive;
  }
  static void destroy(void*) { --alive; }
};

constexpr similitude_parameter k_manner{sizeof(similitude_parameter),
                                        SIMILITUDE_CHOICE,
                                        0,
                                        0,
                                        "manner",
                                        "",
                                        "how",
                                        nullptr,
                                        "one|other|both",
                                        "other",
                                        0,
                                        0,
                                        0,
                                        0,
                                        0,
                                        nullptr};
constexpr similitude_effect_functions k_no_passes = [] {
  similitude_effect_functions table{};
  table.struct_size = sizeof table;
  return table;
}();
constexpr similitude_descriptor k_watched{sizeof(similitude_descriptor),
                                          1,
                                          "effect",
                                          "watched",
                                          "1.0.0",
                                          "Watched",
                                          nullptr,
                                          nullptr,
                                          &k_manner,
                                          &k_no_passes,
                                          Watched::create,
                                          Watched::destroy};
const PluginEntry k_entry{&k_watched, "", "", ""};

TEST(CreateModel, ALeftOutChoiceIsItsDefault) {
  const EffectModel model = create_model<similitude_effect_functions>(k_entry, similitude_bed{}, {{0, nullptr}});
  EXPECT_EQ(Watched::heard, "other");
}

TEST(CreateModel, TheInstanceIsDestroyedOnce) {
  {
    EffectModel model = create_model<similitude_effect_functions>(k_entry, similitude_bed{}, {{0, "one"}});
    const EffectModel moved = std::move(model);
    EXPECT_EQ(Watched::alive, 1);
  }
  EXPECT_EQ(Watched::alive, 0);
}

TEST(CreateModel, AnInstanceThatComesWithAnErrorIsDestroyed) {
  EXPECT_THROW(create_model<similitude_effect_functions>(k_entry, similitude_bed{}, {{0, "both"}}), PluginError);
  EXPECT_EQ(Watched::alive, 0);
}

}  // namespace
}  // namespace similitude
