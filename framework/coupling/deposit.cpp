#include "coupling/deposit.h"

#include <utility>

namespace similitude {

Deposit::Deposit(const CellMap& map) : map_(map) {
  const auto slabs = static_cast<std::size_t>((map.layers() + k_layers_per_slab - 1) / k_layers_per_slab);
  slab_begin_.assign(slabs + 1, 0);
  sums_.resize(slabs * (k_layers_per_slab + 2) * map.layer_size());
}

std::size_t Deposit::slab_layers(std::size_t slab) const {
  const std::size_t first = slab * k_layers_per_slab;
  return std::min<std::size_t>(k_layers_per_slab, static_cast<std::size_t>(map_.layers()) - first);
}

/// Counting sort: blocks of rows count for themselves, and write where the blocks before them end.
void Deposit::sort(const Column<Row>& position) {
  constexpr std::size_t block_rows = 4096;
  const std::size_t particles = position.size(), slabs = slab_begin_.size() - 1;
  const std::size_t blocks = (particles + block_rows - 1) / block_rows;
  slab_of_.resize(particles);
  order_.resize(particles);
  next_.assign(blocks * slabs, 0);
  const std::size_t cells_per_slab = k_layers_per_slab * map_.layer_size();
  const auto end_of = [&](std::size_t block) { return std::min(particles, (block + 1) * block_rows); };
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks); ++b) {
    const auto block = static_cast<std::size_t>(b);
    std::uint32_t* const count = next_.data() + block * slabs;
    for (std::size_t p = block * block_rows; p < end_of(block); ++p) {
      slab_of_[p] = static_cast<std::uint32_t>(map_.cell_at(position[p]) / cells_per_slab);
      ++count[slab_of_[p]];
    }
  }
  std::uint32_t before = 0;
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    slab_begin_[slab] = before;
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::uint32_t count = std::exchange(next_[block * slabs + slab], before);
      before += count;
    }
  }
  slab_begin_[slabs] = before;
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks); ++b) {
    const auto block = static_cast<std::size_t>(b);
    std::uint32_t* const next = next_.data() + block * slabs;
    for (std::size_t p = block * block_rows; p < end_of(block); ++p) order_[next[slab_of_[p]]++] = static_cast<std::uint32_t>(p);
  }
}

void Deposit::combine(std::size_t slab, CellRows& field) {
  const std::size_t slabs = slab_begin_.size() - 1, layer = map_.layer_size(), layers = slab_layers(slab);
  const Row* const own = slab_cells(slab) + layer;
  Row* const out = field.data() + slab * k_layers_per_slab * layer;
  std::copy(own, own + layers * layer, out);
  const auto add = [layer](const Row* margin, Row* to) {
    for (std::size_t c = 0; c < layer; ++c) pack::store(to[c], pack::load(to[c]) + pack::load(margin[c]));
  };
  if (slab > 0 || map_.periodic_layers()) {
    const std::size_t below = slab > 0 ? slab - 1 : slabs - 1;
    add(slab_cells(below) + (slab_layers(below) + 1) * layer, out);
  }
  if (slab + 1 < slabs || map_.periodic_layers()) {
    add(slab_cells(slab + 1 < slabs ? slab + 1 : 0), out + (layers - 1) * layer);
  }
}

}  // namespace similitude
