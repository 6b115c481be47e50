#include "coupling/deposit.h"

namespace similitude {

Deposit::Deposit(const CellMap& map) : map_(map) {
  const auto slabs = static_cast<std::size_t>((map.layers() + k_layers_per_slab - 1) / k_layers_per_slab);
  slab_begin_.assign(slabs + 1, 0);
  next_.assign(slabs, 0);
  sums_.resize(slabs * (k_layers_per_slab + 2) * map.layer_size());
}

std::size_t Deposit::slab_layers(std::size_t slab) const {
  const std::size_t first = slab * k_layers_per_slab;
  return std::min<std::size_t>(k_layers_per_slab, static_cast<std::size_t>(map_.layers()) - first);
}

void Deposit::sort(const Column<Row>& position) {
  const std::size_t particles = position.size();
  slab_of_.resize(particles);
  order_.resize(particles);
  const std::size_t cells_per_slab = k_layers_per_slab * map_.layer_size();
  const auto rows = static_cast<std::ptrdiff_t>(particles);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t p = 0; p < rows; ++p) {
    const auto row = static_cast<std::size_t>(p);
    slab_of_[row] = static_cast<std::uint32_t>(map_.cell_at(position[row]) / cells_per_slab);
  }
  std::fill(slab_begin_.begin(), slab_begin_.end(), 0u);
  for (std::size_t p = 0; p < particles; ++p) ++slab_begin_[slab_of_[p] + 1];
  for (std::size_t s = 1; s < slab_begin_.size(); ++s) slab_begin_[s] += slab_begin_[s - 1];
  std::copy(slab_begin_.begin(), slab_begin_.end() - 1, next_.begin());
  for (std::size_t p = 0; p < particles; ++p) order_[next_[slab_of_[p]]++] = static_cast<std::uint32_t>(p);
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
