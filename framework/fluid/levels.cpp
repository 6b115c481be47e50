#include "fluid/levels.h"

#include <algorithm>

namespace similitude::multigrid {

namespace {

constexpr Index k_few_cells = 40;        // solved directly
constexpr Index k_too_many_cells = 400;  // to be solved directly: give up the barriers instead
constexpr double k_same_spacing = 1.5;   // axes whose spacing is within this factor of the finest are halved together

std::size_t u(Index row) { return static_cast<std::size_t>(row); }

template <class Visit>
void for_each_cell(const Level& level, Visit&& visit) {
#pragma omp parallel for schedule(static) if (level.cell_count() >= k_worth_threads)
  for (Index k = 0; k < level.n[2]; ++k) {
    for (Index j = 0; j < level.n[1]; ++j) {
      for (Index i = 0; i < level.n[0]; ++i) visit(Triple{i, j, k}, level.at(i, j, k));
    }
  }
}

/// Groups of two along `axis`, none across a barrier; a remainder stands alone.
std::vector<Index> group_starts(const Level& level, std::size_t axis) {
  std::vector<Index> start;
  Index from = 0;
  std::vector<Index> ends = level.barriers[axis];
  ends.push_back(level.n[axis]);
  for (const Index end : ends) {
    for (; from < end; from = std::min(from + 2, end)) start.push_back(from);
  }
  start.push_back(level.n[axis]);
  return start;
}

bool can_halve(const Level& level, std::size_t axis) {
  return static_cast<Index>(group_starts(level, axis).size()) - 1 < level.n[axis];
}

Level halved(Level& fine, std::size_t axis) {
  fine.halved_axis = axis;
  fine.start = group_starts(fine, axis);
  fine.own.assign(fine.x.size(), 0);
  fine.lean.assign(fine.x.size(), 0);
  Triple n = fine.n;
  n[axis] = static_cast<Index>(fine.start.size()) - 1;
  Level coarse(n, fine.periodic);
  coarse.barriers = fine.barriers;
  for (Index& barrier : coarse.barriers[axis]) {
    barrier = std::lower_bound(fine.start.begin(), fine.start.end(), barrier) - fine.start.begin();
  }
  return coarse;
}

/// Where blocked faces lie inside the domain, and where rows of them begin and end.
void find_barriers(const Staggered& mesh, Level& finest) {
  std::array<std::vector<char>, 3> barred;
  for (std::size_t a = 0; a < 3; ++a) barred[a].assign(static_cast<std::size_t>(mesh.cells[a]), 0);
  const auto blocked = [&](std::size_t a, const Triple& at) { return !mesh.is_open(a, mesh.face(a, at)); };
  for (std::size_t a = 0; a < 3; ++a) {
    Triple at{};
    for (at[2] = 0; at[2] < mesh.cells[2]; ++at[2]) {
      for (at[1] = 0; at[1] < mesh.cells[1]; ++at[1]) {
        for (at[0] = 0; at[0] < mesh.cells[0]; ++at[0]) {
          if (at[a] == 0) continue;
          const bool here = blocked(a, at);
          if (here) barred[a][static_cast<std::size_t>(at[a])] = 1;
          for (std::size_t b = 0; b < 3; ++b) {
            if (b == a || at[b] == 0) continue;
            Triple before = at;
            before[b] -= 1;
            if (blocked(a, before) != here) barred[b][static_cast<std::size_t>(at[b])] = 1;
          }
        }
      }
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (Index f = 1; f < mesh.cells[a]; ++f) {
      if (barred[a][static_cast<std::size_t>(f)]) finest.barriers[a].push_back(f);
    }
  }
}

/// Half the resistance between the two cells of a group, seen from its centre; none in a group of one.
double inner_resistance(const Level& fine, Index first, Index size) {
  if (size < 2) return 0;
  const double inner = fine.weight[fine.halved_axis][static_cast<std::size_t>(first + fine.stride(fine.halved_axis))];
  return inner > 0 ? 0.5 / inner : 0;
}

/// Completes a level whose weights are set.
void set_diagonal(Level& level) {
  for (std::size_t a = 0; a < 3; ++a) level.refresh_ghosts(level.weight[a]);
  for_each_cell(level, [&](const Triple&, Index c) {
    const auto both = [&](std::size_t a) { return level.weight[a][u(c)] + level.weight[a][u(c + level.stride(a))]; };
    const double sum = ((both(0) + both(1)) + both(2)) +
                       ((level.outlet[0][u(c)] + level.outlet[1][u(c)]) + level.outlet[2][u(c)]);
    level.diagonal[u(c)] = sum;
    level.inverse_diagonal[u(c)] = sum > 0 ? 1 / sum : 0;
  });
}

}  // namespace

Level::Level(const Triple& cells, const std::array<bool, 3>& is_periodic)
    : n(cells), periodic(is_periodic), row(cells[0] + 2), plane(row * (cells[1] + 2)) {
  const std::size_t size = static_cast<std::size_t>(plane * (n[2] + 2));
  for (std::size_t a = 0; a < 3; ++a) {
    weight[a].assign(size, 0);
    outlet[a].assign(size, 0);
  }
  for (auto* field : {&diagonal, &inverse_diagonal, &x, &b, &residual, &direction, &scratch}) field->assign(size, 0);
}

void Level::refresh_ghosts(std::vector<double>& field) const {
  for (std::size_t a = 0; a < 3; ++a) {
    if (!periodic[a]) continue;
    const std::size_t u = (a + 1) % 3, v = (a + 2) % 3;
    const Index wrap = n[a] * stride(a);
    for (Index q = 0; q < n[v]; ++q) {
      for (Index p = 0; p < n[u]; ++p) {
        const Index first = at(0, 0, 0) + p * stride(u) + q * stride(v);
        field[static_cast<std::size_t>(first - stride(a))] = field[static_cast<std::size_t>(first + wrap - stride(a))];
        field[static_cast<std::size_t>(first + wrap)] = field[static_cast<std::size_t>(first)];
      }
    }
  }
}

std::vector<Level> make_levels(const Staggered& mesh) {
  std::vector<Level> levels;
  levels.emplace_back(mesh.cells, mesh.periodic);
  find_barriers(mesh, levels.back());
  while (levels.back().cell_count() > k_few_cells) {
    Level& now = levels.back();
    std::array<double, 3> spacing{};  // mean, of this level
    double finest = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      if (!can_halve(now, a)) continue;
      spacing[a] = mesh.spacing[a] * static_cast<double>(mesh.cells[a]) / static_cast<double>(now.n[a]);
      finest = finest == 0 ? spacing[a] : std::min(finest, spacing[a]);
    }
    if (finest == 0) {
      if (now.cell_count() <= k_too_many_cells) break;
      for (auto& barriers : now.barriers) barriers.clear();
      continue;
    }
    bool first = true;
    for (std::size_t a = 0; a < 3; ++a) {
      if (spacing[a] == 0 || spacing[a] > k_same_spacing * finest) continue;
      levels.back().smoothed = first;
      levels.push_back(halved(levels.back(), a));
      first = false;
    }
  }
  return levels;
}

void set_finest(Level& finest, const Staggered& mesh, const std::array<const double*, 3>& coefficient) {
  for (std::size_t a = 0; a < 3; ++a) {
    const double per_square = 1 / (mesh.spacing[a] * mesh.spacing[a]);
    const bool wraps = mesh.periodic[a];
    for_each_cell(finest, [&](const Triple& at, Index c) {
      const Index low = mesh.face(a, at), high = low + mesh.face_stride(a, a);
      const bool first = at[a] == 0, last = at[a] == mesh.cells[a] - 1;
      // The only cell of a periodic direction is its own neighbour: nothing to exchange.
      const bool linked = mesh.is_open(a, low) && (!first || (wraps && !last));
      finest.weight[a][u(c)] = linked ? coefficient[a][low] * per_square : 0;
      double patches = 0;
      if (first && mesh.is_pressure(a, low)) patches += 2 * coefficient[a][low] * per_square;  // half a cell away
      if (last && mesh.is_pressure(a, high)) patches += 2 * coefficient[a][high] * per_square;
      finest.outlet[a][u(c)] = patches;
    });
  }
  set_diagonal(finest);
}

void set_coarser(Level& fine, Level& coarse) {
  const std::size_t a = fine.halved_axis;
  const Index fs = fine.stride(a);
  const auto first_of = [&](Triple at, Index group) {
    at[a] = fine.start[u(group)];
    return fine.at(at[0], at[1], at[2]);
  };
  const auto size_of = [&](Index group) { return fine.start[u(group + 1)] - fine.start[u(group)]; };

  for_each_cell(coarse, [&](const Triple& at, Index c) {
    const Index group = at[a], groups = coarse.n[a], before = group > 0 ? group - 1 : groups - 1;
    const Index first = first_of(at, group), last = first + (size_of(group) - 1) * fs;
    const double here = inner_resistance(fine, first, size_of(group));

    // Along the axis resistances in series, across it conductances side by side.
    const double face = groups > 1 ? fine.weight[a][u(first)] : 0;
    coarse.weight[a][u(c)] =
        face > 0 ? 1 / (here + 1 / face + inner_resistance(fine, first_of(at, before), size_of(before))) : 0;
    coarse.outlet[a][u(c)] = 0;
    for (Index f = first; f <= last; f += fs) {
      const double patch = fine.outlet[a][u(f)];
      if (patch > 0) coarse.outlet[a][u(c)] += 1 / (here + 1 / patch);
    }
    for (std::size_t b = 0; b < 3; ++b) {
      if (b == a) continue;
      coarse.weight[b][u(c)] = fine.weight[b][u(first)] + (last > first ? fine.weight[b][u(last)] : 0);
      coarse.outlet[b][u(c)] = fine.outlet[b][u(first)] + (last > first ? fine.outlet[b][u(last)] : 0);
    }
  });
  set_diagonal(coarse);

  // A cell of a pair leans on the neighbour group, or on the zero beyond a patch, by its share of the resistance between.
  for_each_cell(coarse, [&](const Triple& at, Index c) {
    const Index first = first_of(at, at[a]), last = first + (size_of(at[a]) - 1) * fs;
    const double here = inner_resistance(fine, first, size_of(at[a]));
    for (const Index f : {first, last}) {
      const double link = coarse.weight[a][u(f == first ? c : c + coarse.stride(a))];
      const double patch = fine.outlet[a][u(f)];
      fine.lean[u(f)] = here * link;
      fine.own[u(f)] = 1 - here * link - (patch > 0 ? here / (here + 1 / patch) : 0);
    }
  });
  fine.refresh_ghosts(fine.lean);
}

void restrict_to(const Level& fine, std::vector<double>& from, Level& coarse) {
  fine.refresh_ghosts(from);
  const std::size_t a = fine.halved_axis;
  const Index fs = fine.stride(a);
  const double* const value = from.data();
  const double* const own = fine.own.data();
  const double* const lean = fine.lean.data();
  double* const out = coarse.b.data();
  const Index* const start = fine.start.data();
#pragma omp parallel for schedule(static) if (fine.cell_count() >= k_worth_threads)
  for (Index k = 0; k < coarse.n[2]; ++k) {
    for (Index j = 0; j < coarse.n[1]; ++j) {
      const Index to = coarse.at(0, j, k);
      if (a == 0) {
        const Index line = fine.at(0, j, k);
        for (Index i = 0; i < coarse.n[0]; ++i) {
          const Index first = line + start[i], last = line + start[i + 1] - 1;
          double sum = lean[first - 1] * value[first - 1] + own[first] * value[first];
          if (last > first) sum += own[last] * value[last];
          out[to + i] = sum + lean[last + 1] * value[last + 1];
        }
        continue;
      }
      const Index group = a == 1 ? j : k;
      const Index size = start[group + 1] - start[group];
      const Index line = a == 1 ? fine.at(0, start[group], k) : fine.at(0, j, start[group]);
      const Index end = line + size * fs, last = end - fs;
      if (size == 2) {
#pragma omp simd
        for (Index i = 0; i < coarse.n[0]; ++i) {
          out[to + i] = lean[line - fs + i] * value[line - fs + i] + own[line + i] * value[line + i] +
                        own[last + i] * value[last + i] + lean[end + i] * value[end + i];
        }
      } else {
#pragma omp simd
        for (Index i = 0; i < coarse.n[0]; ++i) {
          out[to + i] = lean[line - fs + i] * value[line - fs + i] + own[line + i] * value[line + i] +
                        lean[end + i] * value[end + i];
        }
      }
    }
  }
}

void interpolate_from(Level& fine, Level& coarse) {
  coarse.refresh_ghosts(coarse.x);
  const std::size_t a = fine.halved_axis;
  const double* const value = coarse.x.data();
  const double* const own = fine.own.data();
  const double* const lean = fine.lean.data();
  double* const out = fine.x.data();
  const Index* const start = fine.start.data();
  const double keep = fine.smoothed ? 1 : 0;
#pragma omp parallel for schedule(static) if (fine.cell_count() >= k_worth_threads)
  for (Index k = 0; k < coarse.n[2]; ++k) {
    for (Index j = 0; j < coarse.n[1]; ++j) {
      const Index from = coarse.at(0, j, k);
      if (a == 0) {
        const Index line = fine.at(0, j, k);
        for (Index i = 0; i < coarse.n[0]; ++i) {
          const Index first = line + start[i], last = line + start[i + 1] - 1;
          out[first] = keep * out[first] + own[first] * value[from + i] + lean[first] * value[from + i - 1];
          if (last > first) out[last] = keep * out[last] + own[last] * value[from + i] + lean[last] * value[from + i + 1];
        }
        continue;
      }
      const Index cs = coarse.stride(a), fs = fine.stride(a);
      const Index group = a == 1 ? j : k;
      const Index size = start[group + 1] - start[group];
      const Index line = a == 1 ? fine.at(0, start[group], k) : fine.at(0, j, start[group]);
#pragma omp simd
      for (Index i = 0; i < coarse.n[0]; ++i) {
        out[line + i] = keep * out[line + i] + own[line + i] * value[from + i] + lean[line + i] * value[from + i - cs];
      }
      if (size != 2) continue;
#pragma omp simd
      for (Index i = 0; i < coarse.n[0]; ++i) {
        const Index c = line + fs + i;
        out[c] = keep * out[c] + own[c] * value[from + i] + lean[c] * value[from + i + cs];
      }
    }
  }
}

}  // namespace similitude::multigrid
