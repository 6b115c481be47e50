#include "fluid/regions.h"

#include <algorithm>
#include <cmath>

namespace similitude::multigrid {

Regions::Regions(const Staggered& mesh) {
  constexpr std::size_t k_unseen = static_cast<std::size_t>(-1);
  label.assign(static_cast<std::size_t>(mesh.cell_count), k_unseen);
  std::vector<Index> open_ends;
  for (Index seed = 0; seed < mesh.cell_count; ++seed) {
    if (label[static_cast<std::size_t>(seed)] != k_unseen) continue;
    const std::size_t region = reaches_outlet.size();
    reaches_outlet.push_back(false);
    label[static_cast<std::size_t>(seed)] = region;
    open_ends.assign(1, seed);
    while (!open_ends.empty()) {
      const Index here = open_ends.back();
      open_ends.pop_back();
      const Triple at{here % mesh.cells[0], here / mesh.cells[0] % mesh.cells[1], here / (mesh.cells[0] * mesh.cells[1])};
      for (std::size_t a = 0; a < 3; ++a) {
        for (const Index side : {Index{0}, Index{1}}) {
          Triple face_at = at;
          face_at[a] += side;
          const Index face = mesh.face(a, face_at);
          if (mesh.is_pressure(a, face)) reaches_outlet[region] = true;
          if (!mesh.is_open(a, face)) continue;
          for (const Index other : mesh.cells_of_face(a, face_at)) {
            if (other < 0 || label[static_cast<std::size_t>(other)] != k_unseen) continue;
            label[static_cast<std::size_t>(other)] = region;
            open_ends.push_back(other);
          }
        }
      }
    }
  }
}

ClosedRegions::ClosedRegions(const Staggered& mesh) {
  const Regions all(mesh);
  std::vector<std::vector<Index>> cells(all.reaches_outlet.size());
  const Level layout(mesh.cells, mesh.periodic);
  for (Index c = 0; c < mesh.cell_count; ++c) {
    const std::size_t region = all.label[static_cast<std::size_t>(c)];
    if (all.reaches_outlet[region]) continue;
    cells[region].push_back(
        layout.at(c % mesh.cells[0], c / mesh.cells[0] % mesh.cells[1], c / (mesh.cells[0] * mesh.cells[1])));
  }
  for (auto& region : cells) {
    if (!region.empty()) regions_.push_back(std::move(region));
  }
}

double ClosedRegions::subtract_mean(std::vector<double>& field) const {
  double largest = 0;
  for (const std::vector<Index>& region : regions_) {
    double sum = 0;
    for (const Index c : region) sum += field[static_cast<std::size_t>(c)];
    const double mean = sum / static_cast<double>(region.size());
    for (const Index c : region) field[static_cast<std::size_t>(c)] -= mean;
    largest = std::max(largest, std::abs(mean));
  }
  return largest;
}

}  // namespace similitude::multigrid
