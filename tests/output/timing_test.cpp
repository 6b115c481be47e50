#include "output/timing.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scratch.h"

using namespace similitude;
using namespace similitude::test;

TEST(TimingFile, AccountsForEverySecond) {
  const ScratchFolder folder;
  write_timing(
      OutputDirectory(folder.path(), false),
      {.wall_s = 20, .simulated_s = 0.5, .particle_steps = 40'000'000, .stages = {{"contacts", 12}, {"gas", 5}}});
  const auto timing = nlohmann::json::parse(text_of(folder / "timing.json"));
  EXPECT_EQ(timing["wall_s"], 20);
  EXPECT_EQ(timing["simulated_s"], 0.5);
  EXPECT_EQ(timing["particle_steps"], 40'000'000);
  EXPECT_EQ(timing["particle_steps_per_s"], 2e6);
  ASSERT_EQ(timing["stages"].size(), 3u);
  EXPECT_EQ(timing["stages"][0], (nlohmann::json{{"name", "contacts"}, {"seconds", 12}, {"share", 0.6}}));
  EXPECT_EQ(timing["stages"][2], (nlohmann::json{{"name", "other"}, {"seconds", 3}, {"share", 0.15}}));
}

TEST(TimingFile, HasNoRatesWhereNoTimePassed) {
  const ScratchFolder folder;
  write_timing(OutputDirectory(folder.path(), false),
               {.wall_s = 0, .simulated_s = 0, .particle_steps = 5, .stages = {{"gas", 0}}});
  const auto timing = nlohmann::json::parse(text_of(folder / "timing.json"));
  EXPECT_EQ(timing["particle_steps_per_s"], 0);
  EXPECT_EQ(timing["stages"], nlohmann::json::parse(R"([{"name": "gas", "seconds": 0, "share": 0}])"));
}
