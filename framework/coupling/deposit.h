#pragma once
/// Particle quantities onto cells, through the tent. The order of every sum is fixed by the particles' rows and the cells'
/// layers alone, so the bits do not depend on the number of threads.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "coupling/cell_map.h"

namespace similitude {

/// Cells are cut into slabs of whole z layers. Each slab collects its own particles, with a layer of margin on either side
/// for what they reach beyond it; then each cell adds its slab's sum and the margins of the slabs below and above.
class Deposit {
 public:
  explicit Deposit(const CellMap& map);

  /// Sorts particle rows into slabs, rows of a slab in their order. Call after every move, before spread().
  void sort(const Column<Row>& position);

  /// field[cell] = sum over particles of weight * value(row). `value` maps a particle row to a Row.
  template <class Value>
  void spread(const Column<Row>& position, Value&& value, CellRows& field) {
    const auto slabs = static_cast<std::ptrdiff_t>(slab_begin_.size()) - 1;
#pragma omp parallel
    {
#pragma omp for schedule(dynamic, 1)
      for (std::ptrdiff_t slab = 0; slab < slabs; ++slab) collect(static_cast<std::size_t>(slab), position, value);
#pragma omp for schedule(static)
      for (std::ptrdiff_t slab = 0; slab < slabs; ++slab) combine(static_cast<std::size_t>(slab), field);
    }
  }

 private:
  static constexpr int k_layers_per_slab = 4;

  std::size_t slab_layers(std::size_t slab) const;
  Row* slab_cells(std::size_t slab) { return sums_.data() + slab * (k_layers_per_slab + 2) * map_.layer_size(); }

  template <class Value>
  void collect(std::size_t slab, const Column<Row>& position, Value& value) {
    Row* const sums = slab_cells(slab);
    const std::size_t layer = map_.layer_size();
    std::fill(sums, sums + (slab_layers(slab) + 2) * layer, Row{});
    const std::size_t first_cell = slab * k_layers_per_slab * layer;
    for (std::uint32_t n = slab_begin_[slab]; n < slab_begin_[slab + 1]; ++n) {
      const std::uint32_t p = order_[n];
      const Stencil s = map_.stencil(position[p]);
      const pack::V4 v = pack::load(value(static_cast<std::size_t>(p)));
      const auto add = [&](Row& target, double weight) { pack::store(target, pack::load(target) + pack::all(weight) * v); };
      const std::ptrdiff_t step = s.layer_step * static_cast<std::ptrdiff_t>(layer);
      std::array<Row*, 4> foot;
      for (std::size_t m = 0; m < 4; ++m) foot[m] = sums + (s.cell[m] - first_cell + layer);
      for (std::size_t m = 0; m < 4; ++m) add(*foot[m], s.weight[m]);
      for (std::size_t m = 0; m < 4; ++m) add(*(foot[m] + (s.cell[4 + m] != s.cell[m] ? step : 0)), s.weight[4 + m]);
    }
  }

  void combine(std::size_t slab, CellRows& field);

  const CellMap& map_;
  std::vector<std::uint32_t> slab_begin_;   // into order_
  std::vector<std::uint32_t> slab_of_;      // of each particle row
  std::vector<std::uint32_t> order_;        // particle rows, slab by slab
  std::vector<std::uint32_t> next_;         // by block of rows, then by slab: where its next row goes
  CellRows sums_;                           // slab by slab, each with its two margin layers
};

}  // namespace similitude
