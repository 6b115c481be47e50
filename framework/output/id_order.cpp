#include "output/id_order.h"

#include <algorithm>
#include <numeric>

namespace similitude {

std::vector<std::uint32_t> rows_by_id(const ParticleStore& particles) {
  std::vector<std::uint32_t> rows(particles.size());
  std::iota(rows.begin(), rows.end(), 0u);
  std::sort(rows.begin(), rows.end(),
            [&](std::uint32_t a, std::uint32_t b) { return particles.id[a] < particles.id[b]; });
  return rows;
}

}  // namespace similitude
