#include "fluid/scalar_transport.h"

#include <algorithm>
#include <cmath>

#include "fluid/limiter.h"

namespace similitude {

using flow::u;

namespace {

// [-], of a cell's content that may leave it in one stage: with half of it, Koren's limiter makes no new extremes.
constexpr double k_share_that_leaves = 0.5;

Triple place_of(const Staggered& mesh, Index cell) {
  return {cell % mesh.cells[0], cell / mesh.cells[0] % mesh.cells[1], cell / (mesh.cells[0] * mesh.cells[1])};
}

double closed_if_not_a_number(double value) { return std::isnan(value) ? 0 : value; }

}  // namespace

/// What lies next to a cell: a cell through an open face, an inlet's mirror, else the cell itself.
flow::Row ScalarTransport::beyond(std::size_t axis, flow::Row cell, int direction) {
  Triple other = place_of(mesh_, cell), at = other;
  if (direction > 0) at[axis] += 1;
  other[axis] += direction;
  if (mesh_.periodic[axis]) other[axis] = (other[axis] + mesh_.cells[axis]) % mesh_.cells[axis];
  const Index face = mesh_.face(axis, at);
  if (mesh_.is_open(axis, face)) return static_cast<flow::Row>(mesh_.cell(other));
  const similitude_patch* const patch = mesh_.patch(axis, face);
  if (patch == nullptr || patch->kind != SIMILITUDE_PATCH_VELOCITY) return cell;
  const auto slot = static_cast<flow::Row>(mesh_.cell_count + static_cast<Index>(mirrors_.size()));
  mirrors_.push_back({slot, cell, mesh_.kind(axis, face) - SIMILITUDE_FACE_PATCH});
  return slot;
}

ScalarTransport::ScalarTransport(const similitude_grid& grid) : mesh_(grid), transported_(flow::make_face_fields(mesh_)) {
  for (std::size_t a = 0; a < 3; ++a) {
    tables_[a] = flow::make_face_table(mesh_, a);
    for (Index n = 0; n < tables_[a].open_count; ++n) {
      const flow::ActiveFace& face = tables_[a].faces[u(n)];
      open_[a].push_back({face.face, face.below, face.above, beyond(a, face.below, -1), beyond(a, face.above, 1)});
    }
    if (mesh_.periodic[a]) continue;
    const std::size_t v = (a + 1) % 3, w = (a + 2) % 3;
    for (Index q = 0; q < mesh_.cells[w]; ++q) {
      for (Index p = 0; p < mesh_.cells[v]; ++p) {
        for (int side = 0; side < 2; ++side) {
          Triple at{};
          at[v] = p;
          at[w] = q;
          at[a] = side == 0 ? 0 : mesh_.cells[a];
          const Index face = mesh_.face(a, at);
          if (mesh_.kind(a, face) != SIMILITUDE_FACE_NO_SLIP && mesh_.kind(a, face) != SIMILITUDE_FACE_SLIP) continue;
          const auto [below, above] = mesh_.cells_of_face(a, at);
          walls_[a].push_back({static_cast<flow::Row>(face), static_cast<flow::Row>(side == 0 ? above : below), side});
        }
      }
    }
  }
  for (auto* field : {&theta_, &stage_}) field->assign(u(mesh_.cell_count) + mirrors_.size(), 0.0);
  for (auto* field : {&gain_, &content_}) field->assign(u(mesh_.cell_count), 0.0);
}

int ScalarTransport::parts(const ScalarStep& step, const ScalarTerms& terms) {
  // What crosses each face outward, of the smaller of the cell's contents at both ends.
  std::fill(content_.begin(), content_.end(), 0.0);
  const bool walls = !std::isnan(terms.wall);
  for (std::size_t a = 0; a < 3; ++a) {
    const double per_length = 1 / mesh_.spacing[a], per_square = per_length * per_length;
    const double* const flux = step.flux[a];
    const auto diffusivity = [&](flow::Row cell) {
      return terms.diffusivity + (terms.added_diffusivity != nullptr ? terms.added_diffusivity[cell] : 0);
    };
    for (const OpenFace& face : open_[a]) {
      const double through = flux[face.face] * per_length;
      const double mixed = 0.25 * (step.gas_fraction[face.below] + step.gas_fraction[face.above]) *
                           (diffusivity(face.below) + diffusivity(face.above)) * per_square;
      content_[u(face.below)] += std::max(through, 0.0) + mixed;
      content_[u(face.above)] += std::max(-through, 0.0) + mixed;
    }
    for (const flow::PatchFace& face : tables_[a].pressure) {
      content_[u(face.cell)] += std::max(-face.inward(flux[face.face]), 0.0) * per_length;
    }
    for (const flow::PatchFace& face : tables_[a].velocity) {
      content_[u(face.cell)] += std::max(-face.inward(flux[face.face]), 0.0) * per_length;
    }
    if (!walls) continue;
    for (const WallFace& face : walls_[a]) content_[u(face.cell)] += 2 * step.gas_fraction[face.cell] * terms.diffusivity * per_square;
  }
  double largest = 0;
  for (Index c = 0; c < mesh_.cell_count; ++c) {
    largest = std::max(largest, content_[u(c)] * step.dt / std::min(step.gas_fraction[c], step.gas_fraction_old[c]));
  }
  return std::max(1, static_cast<int>(std::ceil(largest / k_share_that_leaves * (1 - 1e-9))));
}

/// transported_ = F theta - eps D grad theta on all faces.
void ScalarTransport::carry(const ScalarStep& step, const ScalarTerms& terms, const double* gas_fraction,
                            std::vector<double>& theta) {
  for (const Mirror& mirror : mirrors_) {
    theta[u(mirror.slot)] = 2 * (terms.patch_value[mirror.patch] - terms.reference) - theta[u(mirror.cell)];
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const double per_length = 1 / mesh_.spacing[a];
    const double* const flux = step.flux[a];
    double* const out = transported_[a].data();
    const OpenFace* const faces = open_[a].data();
    const Index count = static_cast<Index>(open_[a].size());
    const double* const added = terms.added_diffusivity;
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const OpenFace& face = faces[n];
      const double below = theta[u(face.below)], above = theta[u(face.above)];
      const double f = flux[face.face];
      const bool upward = f > 0;
      const double across = above - below;
      double carried = upward ? below : above;
      const double back = carried - theta[u(upward ? face.far_below : face.far_above)];
      carried += limited_half_step(back, upward ? across : -across);
      double diffusivity = terms.diffusivity;
      if (added != nullptr) diffusivity += 0.5 * (added[face.below] + added[face.above]);
      const double mean_fraction = 0.5 * (gas_fraction[face.below] + gas_fraction[face.above]);
      out[face.face] = f * carried - mean_fraction * diffusivity * across * per_length;
    }
    const auto patch = [&](const flow::PatchFace& face) {
      const double f = flux[face.face];
      const bool inward = face.inward(f) > 0;
      out[face.face] = f * (inward ? terms.patch_value[face.patch] - terms.reference : theta[u(face.cell)]);
    };
    for (const flow::PatchFace& face : tables_[a].velocity) patch(face);
    for (const flow::PatchFace& face : tables_[a].pressure) patch(face);
    const double wall_theta = closed_if_not_a_number(terms.wall) - terms.reference;
    const double conducts = std::isnan(terms.wall) ? 0 : terms.diffusivity;
    for (const WallFace& face : walls_[a]) {
      const double inward = 2 * gas_fraction[face.cell] * conducts * (wall_theta - theta[u(face.cell)]) * per_length;
      out[face.face] = face.side == 0 ? inward : -inward;
    }
    flow::copy_periodic_faces(mesh_, a, transported_[a]);
  }
}

/// gain += -div(transported)
void ScalarTransport::collect(std::vector<double>& gain) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const double per_length = 1 / mesh_.spacing[a];
    const Index step = mesh_.face_stride(a, a);
    const double* const transported = transported_[a].data();
#pragma omp parallel for schedule(static) if (mesh_.cell_count >= k_worth_threads)
    for (Index k = 0; k < mesh_.cells[2]; ++k) {
      for (Index j = 0; j < mesh_.cells[1]; ++j) {
        const Index cell = mesh_.cell({0, j, k}), face = mesh_.face(a, {0, j, k});
        for (Index i = 0; i < mesh_.cells[0]; ++i) {
          const Index low = face + i;
          gain[u(cell + i)] -= (transported[low + step] - transported[low]) * per_length;
        }
      }
    }
  }
}

void ScalarTransport::count(const ScalarTerms& terms, double share_of_time, ScalarBudget& budget) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const double volume = share_of_time * mesh_.face_area(a);
    const auto patch = [&](const flow::PatchFace& face) {
      const double inward = volume * face.inward(transported_[a][u(face.face)]);
      (inward > 0 ? budget.in : budget.out) += std::abs(inward);
    };
    for (const flow::PatchFace& face : tables_[a].velocity) patch(face);
    for (const flow::PatchFace& face : tables_[a].pressure) patch(face);
    if (std::isnan(terms.wall)) continue;
    for (const WallFace& face : walls_[a]) {
      const double along = transported_[a][u(face.face)];
      budget.walls += volume * (face.side == 0 ? along : -along);
    }
  }
}

ScalarBudget ScalarTransport::advance(const ScalarStep& step, const ScalarTerms& terms, double* phi, double* mean) {
  const int count_of_parts = parts(step, terms);
  const double share = 1.0 / count_of_parts, dt = step.dt * share;
  ScalarBudget budget;
  const Index cells = mesh_.cell_count;
  const double* const old_fraction = step.gas_fraction_old;
  const double* const new_fraction = step.gas_fraction;
  for (Index c = 0; c < cells; ++c) theta_[u(c)] = phi[c] - terms.reference;
  if (mean != nullptr) std::fill_n(mean, cells, 0.0);

  for (int part = 0; part < count_of_parts; ++part) {
    const double from = part * share, to = part + 1 == count_of_parts ? 1.0 : (part + 1) * share;
    // (eps' theta' = eps theta + dt (gain - a theta' + b - a reference), with `weight` of what gain_ holds.
    const auto settle = [&](double weight, std::vector<double>& out, bool last) {
#pragma omp parallel for schedule(static) if (cells >= k_worth_threads)
      for (Index c = 0; c < cells; ++c) {
        const double change = new_fraction[c] - old_fraction[c];
        const double held = old_fraction[c] + from * change, holds = to < 1 ? old_fraction[c] + to * change : new_fraction[c];
        double content = held * theta_[u(c)] + dt * weight * gain_[u(c)], capacity = holds;
        if (terms.exchange != nullptr) {
          content += dt * (terms.exchange_source[c] - terms.exchange[c] * terms.reference);
          capacity += dt * terms.exchange[c];
        }
        out[u(c)] = content / capacity;
        if (last && mean != nullptr) mean[c] += share * (out[u(c)] + terms.reference);
      }
    };
    std::fill(gain_.begin(), gain_.end(), 0.0);
    carry(step, terms, new_fraction, theta_);
    count(terms, 0.5 * dt, budget);
    collect(gain_);
    settle(1, stage_, false);
    carry(step, terms, new_fraction, stage_);
    count(terms, 0.5 * dt, budget);
    collect(gain_);
    settle(0.5, theta_, true);
    if (terms.exchange != nullptr) {
      double sum = 0;
      for (Index c = 0; c < cells; ++c) {
        sum += terms.exchange_source[c] - terms.exchange[c] * (theta_[u(c)] + terms.reference);
      }
      budget.exchanged += sum * dt * mesh_.cell_volume();
    }
  }
  for (Index c = 0; c < cells; ++c) phi[c] = theta_[u(c)] + terms.reference;
  return budget;
}

double ScalarTransport::amount(const double* gas_fraction, const double* phi, double reference) const {
  double sum = 0;
  for (Index c = 0; c < mesh_.cell_count; ++c) sum += gas_fraction[c] * (phi[c] - reference);
  return sum * mesh_.cell_volume();
}

}  // namespace similitude
