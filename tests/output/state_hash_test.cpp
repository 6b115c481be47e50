#include "output/state_hash.h"

#include <gtest/gtest.h>

#include <cmath>

#include "output/sha256.h"
#include "output/whole_file.h"
#include "scratch.h"

using namespace similitude;
using namespace similitude::test;

namespace {

std::string sha256_of(const std::string& text) {
  Sha256 hash;
  hash.add(text.data(), text.size());
  return hash.hex();
}

ParticleStore three_particles() {
  ParticleStore store(StoreFields{.rotation = true});
  for (const std::uint64_t id : {7u, 3u, 5u}) {
    const std::size_t row = store.add(id, 0, 0.01 * static_cast<double>(id), 0.02, 0.03, 5e-4, 1e-6);
    store.velocity[row].z = static_cast<double>(id);
    store.angular_velocity[row].x = 2;
  }
  return store;
}

}  // namespace

// NIST, examples of FIPS 180-2, appendix B.
TEST(Sha256, ReproducesTheExamplesOfTheStandard) {
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnHowTheBytesArrive) {
  const std::string text(1000, 'x');
  for (const std::size_t piece : {1u, 7u, 63u, 64u, 65u, 119u}) {
    Sha256 hash;
    for (std::size_t at = 0; at < text.size(); at += piece)
      hash.add(text.data() + at, std::min(piece, text.size() - at));
    EXPECT_EQ(hash.hex(), sha256_of(text)) << piece;
  }
}

TEST(Sha256, OfAFileIsThatOfItsBytes) {
  const ScratchFolder folder;
  write_whole_file(folder / "a", std::string(100'000, 'b'));
  EXPECT_EQ(sha256_of_file(folder / "a"), sha256_of(std::string(100'000, 'b')));
  EXPECT_EQ(sha256_of_file(folder / "none"), "");
}

TEST(StateHash, HasThirtyTwoDigitsAndIsTheSameForTheSameState) {
  EXPECT_EQ(state_hash(three_particles(), nullptr, nullptr).size(), 32u);
  EXPECT_EQ(state_hash(three_particles(), nullptr, nullptr), state_hash(three_particles(), nullptr, nullptr));
}

TEST(StateHash, DoesNotDependOnTheOrderOfRows) {
  ParticleStore sorted = three_particles();
  sorted.reorder({1, 2, 0});
  EXPECT_EQ(state_hash(sorted, nullptr, nullptr), state_hash(three_particles(), nullptr, nullptr));
}

TEST(StateHash, SeesTheLastBitOfEveryField) {
  const std::string before = state_hash(three_particles(), nullptr, nullptr);
  const auto differs = [&](auto change) {
    ParticleStore store = three_particles();
    change(store);
    return state_hash(store, nullptr, nullptr) != before;
  };
  EXPECT_TRUE(differs([](ParticleStore& s) { s.position[1].y = std::nextafter(s.position[1].y, 1.0); }));
  EXPECT_TRUE(differs([](ParticleStore& s) { s.velocity[2].z = std::nextafter(s.velocity[2].z, 9.0); }));
  EXPECT_TRUE(differs([](ParticleStore& s) { s.velocity[0].x = -0.0; }));
  EXPECT_TRUE(differs([](ParticleStore& s) { s.angular_velocity[0].x = std::nextafter(2.0, 3.0); }));
  EXPECT_TRUE(differs([](ParticleStore& s) { s.species[0] = 1; }));
  EXPECT_TRUE(differs([](ParticleStore& s) { s.reorder({0, 1}); }));
}

TEST(StateHash, SeesTheGas) {
  const ParticleStore store = three_particles();
  GasFields gas;
  gas.velocity.assign(6, 1.0);
  gas.pressure.assign(2, 5.0);
  const Column<double> fraction(2, 0.5), other(2, std::nextafter(0.5, 1.0));
  const std::string before = state_hash(store, &gas, &fraction);
  EXPECT_NE(before, state_hash(store, nullptr, nullptr));
  EXPECT_NE(before, state_hash(store, &gas, nullptr));
  EXPECT_NE(before, state_hash(store, &gas, &other));
  gas.pressure[1] = std::nextafter(5.0, 6.0);
  EXPECT_NE(before, state_hash(store, &gas, &fraction));
}
