// A pack does in each lane what a double does alone.
#include <gtest/gtest.h>
#include <similitude/pack.h>

#include <array>

namespace similitude {
namespace {

constexpr std::array<double, 8> k_left = {0.3, 0.4, 0.61, 0.6, 0.7, 1.3, 2.5, 7.0}, k_right = {0.6, 0.3, 0.5, 0.6, 0.9, 1.2, 3.0, 0.1};

/// Applies the same generic function to packs and, lane by lane, to doubles.
template <class F>
void expect_same(const F& function) {
  for (std::size_t start = 0; start + Pack::size() <= 8; start += Pack::size()) {
    const Pack a([start](auto lane) { return k_left[start + lane]; }), b([start](auto lane) { return k_right[start + lane]; });
    const Pack result = function(a, b);
    for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
      EXPECT_DOUBLE_EQ(result[lane], function(k_left[start + lane], k_right[start + lane])) << start + lane;
    }
  }
}

TEST(Pack, ChoosesLaneByLane) {
  expect_same([](const auto& a, const auto& b) { return select(a < b, a, 2.0 * b); });
  expect_same([](const auto& a, const auto& b) { return select(a <= b, a, 2.0 * b); });
  expect_same([](const auto& a, const auto& b) { return select(a > b && a < 1.0, a, 2.0 * b); });
  expect_same([](const auto& a, const auto& b) { return select(!(a >= b), a, 2.0 * b); });
  expect_same([](const auto& a, const auto& b) {
    return select(a < b, Vec3<std::decay_t<decltype(a)>>{a, b, a}, Vec3<std::decay_t<decltype(a)>>{b, a, b}).z;
  });
}

TEST(Pack, HasTheFunctionsOfADouble) {
  expect_same([](const auto& a, const auto& b) { return min(a, b) + 10.0 * max(a, b); });
  expect_same([](const auto& a, const auto& b) { return sqrt(a) + abs(a - b); });
  expect_same([](const auto& a, const auto& b) { return exp(a) + log(b); });
  expect_same([](const auto& a, const auto& b) { return pow(a, b); });
  expect_same([](const auto& a, const auto& b) { return atan(a) + cbrt(b); });
  expect_same([](const auto& a, const auto& b) { return max(a, 0.65) * min(b, 0.65); });
}

}  // namespace
}  // namespace similitude
