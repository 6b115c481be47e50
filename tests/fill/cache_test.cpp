/// The cache of settled beds: the same bed at once, and never a wrong one.

#include <gtest/gtest.h>

#include <filesystem>

#include "bed_of_springs.h"
#include "particles/bed_cache.h"

namespace similitude::test {
namespace {

struct Fill {
  FilledBed bed;
  ParticleStore particles = empty_store();
};

class BedCache : public ::testing::Test {
 protected:
  Fill fill(const ModelScene& scene) {
    Fill out;
    FillOptions options = options_for(scene);
    options.cache_folder = folder.path() + "/beds";
    out.bed = fill_bed(out.particles, scene, law, options);
    return out;
  }
  ModelScene scene() {
    ModelScene bed = small_bed(40);
    bed.bed.cache = true;
    return bed;
  }
  ScratchFolder folder;
  ContactModel law = spring_law(k_stiffness);
};

TEST_F(BedCache, GivesTheSecondRunTheSameBits) {
  const Fill first = fill(scene()), second = fill(scene());
  EXPECT_FALSE(first.bed.from_cache);
  EXPECT_TRUE(second.bed.from_cache);
  EXPECT_EQ(second.bed.sub_steps, 0);
  EXPECT_EQ(first.bed.cache_file, second.bed.cache_file);
  EXPECT_EQ(first.bed.height, second.bed.height);
  ASSERT_EQ(first.particles.size(), second.particles.size());
  for (std::size_t p = 0; p < first.particles.size(); ++p) {
    EXPECT_EQ(first.particles.position[p].x, second.particles.position[p].x);
    EXPECT_EQ(first.particles.position[p].w, second.particles.position[p].w);
    EXPECT_EQ(first.particles.velocity[p].w, second.particles.velocity[p].w);
    EXPECT_EQ(first.particles.id[p], second.particles.id[p]);
  }
}

TEST_F(BedCache, IsAnotherBedWhenAnythingThatShapesItChanges) {
  const std::string key = bed_key(scene(), law, options_for(scene()));
  const auto changed = [&](auto&& change) {
    ModelScene other = scene();
    change(other);
    return bed_key(other, law, options_for(scene()));
  };
  EXPECT_NE(key, changed([](ModelScene& s) { s.size[0] *= 1 + 1e-15; }));
  EXPECT_NE(key, changed([](ModelScene& s) { s.periodic[1] = true; }));
  EXPECT_NE(key, changed([](ModelScene& s) { s.gravity[2] = -1.6; }));
  EXPECT_NE(key, changed([](ModelScene& s) { s.particles[0].diameter *= 2; }));
  EXPECT_NE(key, changed([](ModelScene& s) { s.particles[0].density *= 2; }));
  EXPECT_NE(key, changed([](ModelScene& s) { *s.particles[0].count += 1; }));
  EXPECT_NE(key, changed([](ModelScene& s) { s.baffles.emplace_back(); }));
  EXPECT_NE(key, changed([](ModelScene& s) { s.bed.seed = 9; }));
  EXPECT_NE(key, changed([](ModelScene& s) { s.bed.height = 1e-3; }));
  EXPECT_NE(key, changed([](ModelScene& s) { s.models.contact.parameters[0].real *= 2; }));
  const auto with_pairs = [](double second) {
    return [second](ModelScene& s) {
      s.models.contact_pairs = {s.models.contact, s.models.contact};
      s.models.contact_pairs[1].parameters[0].real = second;
    };
  };
  EXPECT_NE(key, changed(with_pairs(k_stiffness)));
  EXPECT_NE(changed(with_pairs(2 * k_stiffness)), changed(with_pairs(k_stiffness)));
  FillOptions longer = options_for(scene());
  longer.dt *= 2;
  EXPECT_NE(key, bed_key(scene(), law, longer));
  FillOptions rebuilt = options_for(scene());   // the same id and version, another file
  rebuilt.law_sha256 = "0";
  EXPECT_NE(key, bed_key(scene(), law, rebuilt));
  // The gas and the output do not shape a bed.
  EXPECT_EQ(key, changed([](ModelScene& s) { s.gas_density = 2; }));
  EXPECT_EQ(key, changed([](ModelScene& s) { s.output.vtk_every = 2; }));
}

TEST_F(BedCache, IgnoresAFileThatIsCutDamagedOrForeign) {
  const std::string file = fill(scene()).bed.cache_file;
  ASSERT_TRUE(std::filesystem::exists(file));
  std::string bytes;
  {
    std::ifstream in(file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  const auto put = [&](const std::string& text) { std::ofstream(file, std::ios::binary) << text; };
  put(bytes.substr(0, bytes.size() / 2));
  EXPECT_FALSE(fill(scene()).bed.from_cache);
  std::string damaged = bytes;
  damaged[bytes.size() - 100] = static_cast<char>(damaged[bytes.size() - 100] ^ 1);
  put(damaged);
  EXPECT_FALSE(fill(scene()).bed.from_cache);
  put("something else");
  EXPECT_FALSE(fill(scene()).bed.from_cache);
  put("");
  EXPECT_FALSE(fill(scene()).bed.from_cache);
  EXPECT_TRUE(fill(scene()).bed.from_cache);   // mended by the run before
}

TEST_F(BedCache, LeavesNoDraftsBehind) {
  fill(scene());
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() + "/beds")) {
    ++files;
    EXPECT_EQ(entry.path().extension(), ".bin");
  }
  EXPECT_EQ(files, 1);
}

TEST_F(BedCache, IsNotUsedIfTheCaseSaysSo) {
  ModelScene bed = scene();
  bed.bed.cache = false;
  EXPECT_EQ(fill(bed).bed.cache_file, "");
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/beds"));
}

TEST_F(BedCache, ThatCannotBeWrittenIsNoError) {
  folder.write("beds", "a file where the folder should be");
  const Fill result = fill(scene());
  EXPECT_EQ(result.particles.size(), 40u);
  EXPECT_EQ(result.bed.cache_file, "");
}

TEST(CacheFolder, FollowsTheEnvironment) {
  ::setenv("XDG_CACHE_HOME", "/somewhere", 1);
  EXPECT_EQ(cache_folder_of_beds(), "/somewhere/similitude/beds");
  ::unsetenv("XDG_CACHE_HOME");
  ::setenv("HOME", "/home/anna", 1);
  EXPECT_EQ(cache_folder_of_beds(), "/home/anna/.cache/similitude/beds");
}

}  // namespace
}  // namespace similitude::test
