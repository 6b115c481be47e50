#include "output/front_view.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>

#include "scratch.h"

using namespace similitude;
using namespace similitude::test;
using testing::ElementsAre;

namespace {

constexpr double k_radius = 0.5e-3;   // [m]

void add(ParticleStore& store, std::uint64_t id, double x, double y, double z) { store.add(id, 0, x, y, z, k_radius, 1e-6); }

std::uint32_t count_in(const std::vector<char>& bytes, const FrontViewIndex::Picture& picture) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + picture.begin + 20, sizeof count);
  return count;
}

/// How many particles each picture shows.
std::vector<std::uint32_t> counts(const std::filesystem::path& folder) {
  const std::vector<char> bytes = read_front_view(folder);
  std::vector<std::uint32_t> all;
  for (const FrontViewIndex::Picture& picture : front_view_index(bytes).pictures) all.push_back(count_in(bytes, picture));
  return all;
}

}  // namespace

TEST(FrontView, ShowsWhatNothingStandsBefore) {
  const ScratchFolder scratch;
  const OutputDirectory directory(scratch.path() / "run", false);
  FrontView view(directory, MapBack(), 0.02, 0.04, {});
  ParticleStore store;
  add(store, 0, 0.010, 0.001, 0.010);
  add(store, 1, 0.010, 0.003, 0.010);    // right behind
  add(store, 2, 0.0105, 0.003, 0.010);   // half behind
  add(store, 3, 0.015, 0.009, 0.010);    // deep, but free
  view.add(store, 0);
  EXPECT_THAT(counts(directory.path()), ElementsAre(3));
}

TEST(FrontView, DoesNotDependOnTheOrderOfRows) {
  const ScratchFolder scratch;
  const OutputDirectory a(scratch.path() / "a", false), b(scratch.path() / "b", false);
  ParticleStore forth, back;
  for (std::uint64_t k = 0; k < 50; ++k) {
    const auto place = [](std::uint64_t id) { return 0.0003 * static_cast<double>(id); };
    add(forth, k, place(k), 0.002, 0.01);
    add(back, 49 - k, place(49 - k), 0.002, 0.01);
  }
  FrontView(a, MapBack(), 0.02, 0.04, {}).add(forth, 0);
  FrontView(b, MapBack(), 0.02, 0.04, {}).add(back, 0);
  EXPECT_EQ(read_front_view(a.path()), read_front_view(b.path()));
}

TEST(FrontView, OfALargeBedKeepsSoManyThatAReportStaysSmall) {
  const ScratchFolder scratch;
  const OutputDirectory directory(scratch.path() / "run", false);
  ParticleStore store;
  for (std::uint64_t k = 0; k < 20'000; ++k)
    add(store, k, 1.1e-3 * static_cast<double>(k % 100) + k_radius, 0.001, 1.1e-3 * static_cast<double>(k / 100) + k_radius);
  FrontView(directory, MapBack(), 0.12, 0.24, {}).add(store, 0);
  const std::uint32_t shown = counts(directory.path()).front();
  EXPECT_NEAR(shown, k_front_view_rows, 4 * std::sqrt(k_front_view_rows));   // drawn by lot: four standard deviations
}

TEST(FrontView, GoesOnAfterAGivenTimeAndCutsWhatFollows) {
  const ScratchFolder scratch;
  const OutputDirectory directory(scratch.path() / "run", false);
  ParticleStore store;
  add(store, 0, 0.010, 0.001, 0.010);
  {
    FrontView view(directory, MapBack(), 0.02, 0.04, {});
    for (const double time : {0.0, 0.1, 0.2, 0.3}) view.add(store, time);
  }
  FrontView(directory, MapBack(), 0.02, 0.04, 0.1).add(store, 0.15);
  std::vector<double> times;
  for (const FrontViewIndex::Picture& picture : front_view_index(read_front_view(directory.path())).pictures) times.push_back(picture.time);
  EXPECT_THAT(times, ElementsAre(0.0, 0.1, 0.15));
}
