#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "beds.h"

namespace {
std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* out = alignment > alignof(std::max_align_t) ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                                                    : std::malloc(size);
  if (!out) throw std::bad_alloc();
  return out;
}
}  // namespace

void* operator new(std::size_t size) { return counted(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) { return counted(size, static_cast<std::size_t>(alignment)); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace similitude {
namespace {
using namespace testing;

// A gas of spheres that collide between walls and through periodic faces, sorted and listed anew all the time. It is
// steady but for what it loses in collisions; a bed that is still falling fills new bricks and makes room for them.
TEST(SteadyState, AllocatesNothingInTheTimeLoop) {
  const ModelScene scene = box(0.03, 0.01, 0.02, {false, true, false});
  ParticleStore store = spinning_store();
  fill_lattice(store, scene, 2000, 0.5 * k_diameter, 1.2e-3, 0.05e-3);
  stir(store, 0.5);
  const ContactModel law = make_law({.damping_ratio = 0.01, .friction = 0.3, .rotation = true});
  Engine engine(store, scene, law, options(2.5e-6));
  engine.advance(3000);
  const std::uint64_t rebuilds = engine.report().rebuilds;
  const std::size_t before = allocations;
  engine.advance(3000);
  EXPECT_EQ(allocations - before, 0u);
  EXPECT_GT(engine.report().rebuilds - rebuilds, 20u);
}

}  // namespace
}  // namespace similitude
