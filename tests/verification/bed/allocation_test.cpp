#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "small_bed.h"

namespace {
std::atomic<long> g_allocations{0};

void* counted(std::size_t bytes, std::size_t alignment) {
  ++g_allocations;
  void* place = nullptr;
  if (::posix_memalign(&place, alignment, bytes == 0 ? 1 : bytes) != 0) throw std::bad_alloc();
  return place;
}
}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes, alignof(std::max_align_t)); }
void* operator new[](std::size_t bytes) { return counted(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) { return counted(bytes, static_cast<std::size_t>(alignment)); }
void* operator new[](std::size_t bytes, std::align_val_t alignment) { return counted(bytes, static_cast<std::size_t>(alignment)); }
void operator delete(void* place) noexcept { std::free(place); }
void operator delete[](void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t) noexcept { std::free(place); }
void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete(void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }

namespace similitude::test {

// A spouting bed, neighbour lists being rebuilt: once under way, a step takes no memory.
TEST(TimeLoop, AllocatesNothingInSteadyState) {
  const auto bed = small_bed(R"(
similitude: 1
title: a small spouting bed
scene:
  domain:    {size: [20 mm, 10 mm, 60 mm], cell: 2.5 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles: {alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 2000}}
  bed:       {fill: lattice}
  patches:
    spout:      {face: bottom, x: [7.5 mm, 12.5 mm], velocity: 4 m/s, ramp: 1 ms}
    background: {face: bottom, rest: true, velocity: 0.3 m/s, ramp: 1 ms}
    outlet:     {face: top, pressure: 0 Pa}
models:
  drag: syamlal_obrien
  contact: {id: linear_spring, stiffness: 200 N/m, restitution: 0.74, friction: 0.2}
  fluid: vans
  scaling: exact
time: {end: 1 s, dt: auto}
)");
  // Lists grow with room to spare while the bed expands; then the spout is developed.
  for (int step = 0; step < 2500; ++step) bed->simulation->step();
  const auto rebuilds = bed->simulation->engine().report().rebuilds;
  const long before = g_allocations.load();
  for (int step = 0; step < 200; ++step) bed->simulation->step();
  EXPECT_EQ(g_allocations.load() - before, 0);
  EXPECT_GT(bed->simulation->engine().report().rebuilds, rebuilds);   // the case that tends to allocate did happen
}

}  // namespace similitude::test
