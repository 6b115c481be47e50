#include "stencils.h"

#include <map>
#include <utility>

namespace similitude::vans {

namespace {

constexpr Row k_none = -1;

/// The faces that separate two halves of a side of a momentum box, and what they are.
struct Halves {
  std::array<Row, 2> face;
  std::array<std::uint8_t, 2> kind;
  bool any_open() const { return kind[0] == SIMILITUDE_FACE_OPEN || kind[1] == SIMILITUDE_FACE_OPEN; }
  bool all_open() const { return kind[0] == SIMILITUDE_FACE_OPEN && kind[1] == SIMILITUDE_FACE_OPEN; }
};

class Builder {
 public:
  Builder(const Staggered& mesh, const FaceTable& table, std::size_t axis) : mesh_(mesh), table_(table), axis_(axis) {
    made_.axis = axis;
    made_.open_count = table.open_count;
    made_.sides.resize(table.faces.size());
    for (const flow::ActiveFace& active : table.faces) at_.push_back(place_of(active.face));
    next_slot_ = static_cast<Row>(mesh.face_count[axis]);
  }

  Component build() {
    for (std::size_t b = 0; b < 3; ++b) {
      high_site_.assign(u(mesh_.face_count[axis_]), k_none);
      for (std::size_t n = 0; n < table_.faces.size(); ++n) {
        made_.sides[n].high[b] = b == axis_ ? site_along(n, 1) : site_across(n, b, 1);
        high_site_[u(table_.faces[n].face)] = made_.sides[n].high[b];
      }
      for (std::size_t n = 0; n < table_.faces.size(); ++n) {
        const Row shared = site_below(n, b);
        made_.sides[n].low[b] = shared != k_none ? shared : b == axis_ ? site_along(n, 0) : site_across(n, b, 0);
      }
    }
    made_.rows = next_slot_;
    find_all_streaks();
    return std::move(made_);
  }

 private:
  Triple place_of(Index face) const {
    const Triple& extent = mesh_.face_extent[axis_];
    return {face % extent[0], face / extent[0] % extent[1], face / (extent[0] * extent[1])};
  }

  /// Moves a face position by one along `direction`; false where the domain ends.
  bool step(Triple& at, std::size_t direction, int side) const {
    const Index count = direction == axis_ ? mesh_.distinct_faces(axis_) : mesh_.cells[direction];
    at[direction] += side == 0 ? -1 : 1;
    if (mesh_.periodic[direction]) at[direction] = (at[direction] + count) % count;
    return at[direction] >= 0 && at[direction] < count;
  }

  /// The faces normal to b on one side of the cells around a face.
  Halves halves(const Triple& at, std::size_t b, int side) const {
    Halves both{};
    for (std::size_t h = 0; h < 2; ++h) {
      Triple cell = at;
      cell[axis_] -= h == 0 ? 1 : 0;
      if (mesh_.periodic[axis_]) cell[axis_] = (cell[axis_] + mesh_.cells[axis_]) % mesh_.cells[axis_];
      cell[axis_] = std::min(std::max(cell[axis_], Index{0}), mesh_.cells[axis_] - 1);  // one cell only at a patch
      cell[b] += side;
      if (mesh_.periodic[b] && cell[b] == mesh_.cells[b]) cell[b] = 0;
      both.face[h] = static_cast<Row>(mesh_.face(b, cell));
      both.kind[h] = mesh_.kind(b, both.face[h]);
    }
    return both;
  }

  /// The velocity of the walls or patches that close a side.
  Row wall(const Halves& both) {
    std::array<int, 2> patch{-1, -1};
    for (std::size_t h = 0; h < 2; ++h) {
      const int p = both.kind[h] - SIMILITUDE_FACE_PATCH;
      if (p >= 0 && mesh_.grid->patches[p].kind == SIMILITUDE_PATCH_VELOCITY) patch[h] = p;
    }
    const auto [found, is_new] = walls_.try_emplace(patch, next_slot_);
    if (is_new) made_.walls.push_back({next_slot_++, patch});
    return found->second;
  }

  Row mirror(Row inner, Row wall_row) {
    const auto [found, is_new] = mirrors_.try_emplace({inner, wall_row}, next_slot_);
    if (is_new) made_.mirrors.push_back({next_slot_++, inner, wall_row});
    return found->second;
  }

  float shear(const Halves& both) const {
    float sum = 0;
    for (std::size_t h = 0; h < 2; ++h) {
      const bool free = both.kind[h] == SIMILITUDE_FACE_SLIP || mesh_.is_pressure_kind(both.kind[h]);
      sum += free ? 0.0f : 2.0f;
    }
    return sum / 2;
  }

  float cross(const Halves& both) const {
    return ((both.kind[0] == SIMILITUDE_FACE_SLIP ? 0.0f : 1.0f) + (both.kind[1] == SIMILITUDE_FACE_SLIP ? 0.0f : 1.0f)) / 2;
  }

  /// The velocity one face further across, for slopes; the face itself where a slope must not be formed.
  Row far_across(const Triple& at, std::size_t b, int side) {
    const Row face = static_cast<Row>(mesh_.face(axis_, at));
    const Halves both = halves(at, b, side);
    Triple next = at;
    if (both.all_open() && step(next, b, side)) return static_cast<Row>(mesh_.face(axis_, next));
    if (both.any_open() || shear(both) < 2) return face;
    return mirror(face, wall(both));
  }

  Row site_across(std::size_t n, std::size_t b, int side) {
    const Triple& at = at_[n];
    const Row face = table_.faces[n].face;
    const Halves both = halves(at, b, side);
    Site site{};
    site.flux = both.face;
    Triple next = at;
    if (both.any_open() && step(next, b, side)) {
      const Row other = static_cast<Row>(mesh_.face(axis_, next));
      const Row far_here = far_across(at, b, 1 - side), far_there = far_across(next, b, side);
      site = side == 1 ? Site{far_here, face, other, far_there, both.face, 1, 1}
                       : Site{far_there, other, face, far_here, both.face, 1, 1};
    } else {
      const Row beyond = wall(both);
      const Row far_here = far_across(at, b, 1 - side);
      site = side == 1 ? Site{far_here, face, beyond, beyond, both.face, shear(both), cross(both)}
                       : Site{beyond, beyond, face, far_here, both.face, shear(both), cross(both)};
    }
    return add(b, site);
  }

  /// The velocity one face further along, beyond `edge` as seen from `inner`.
  Row far_along(const Triple& edge, const Triple& inner, int side) {
    const Row face = static_cast<Row>(mesh_.face(axis_, edge));
    Triple next = edge;
    if (mesh_.is_open(axis_, face) && step(next, axis_, side)) return static_cast<Row>(mesh_.face(axis_, next));
    if (mesh_.patch(axis_, face)) return face;
    return mirror(static_cast<Row>(mesh_.face(axis_, inner)), face);
  }

  Row site_along(std::size_t n, int side) {
    const Triple& at = at_[n];
    const Row face = table_.faces[n].face;
    Triple next = at;
    const bool ends = !step(next, axis_, side);
    made_.cell_of_site.push_back(ends ? k_none : side == 1 ? table_.faces[n].above : table_.faces[n].below);
    if (ends) return add(axis_, {face, face, face, face, {face, face}, 0, 0});  // a pressure patch
    const Row other = static_cast<Row>(mesh_.face(axis_, next));
    const Row far_here = far_along(at, next, 1 - side), far_there = far_along(next, at, side);
    return add(axis_, side == 1 ? Site{far_here, face, other, far_there, {face, other}, 1, 1}
                                : Site{far_there, other, face, far_here, {other, face}, 1, 1});
  }

  /// The site that the face below has made already, if the two exchange anything.
  Row site_below(std::size_t n, std::size_t b) const {
    Triple below = at_[n];
    if (!step(below, b, 0)) return k_none;
    if (b != axis_ && !halves(at_[n], b, 0).any_open()) return k_none;
    return high_site_[u(mesh_.face(axis_, below))];
  }

  Row add(std::size_t b, const Site& site) {
    made_.sites[b].push_back(site);
    return static_cast<Row>(made_.sites[b].size() - 1);
  }

  void find_all_streaks() {
    for (std::size_t b = 0; b < 3; ++b) {
      const std::vector<Site>& sites = made_.sites[b];
      made_.site_streaks[b] = find_streaks(static_cast<Row>(sites.size()), 0, [&](Row n) {
        const Site &last = sites[u(n - 1)], &next = sites[u(n)];
        const bool same = next.flux[0] == last.flux[0] + 1 && next.flux[1] == last.flux[1] + 1 && next.shear == last.shear &&
                          next.cross == last.cross;
        if (!same) return Course::mixed;
        if (b == axis_) {
          const Row cell = made_.cell_of_site[u(n - 1)];
          if (cell == k_none || made_.cell_of_site[u(n)] != cell + 1) return Course::mixed;
        }
        const Row below = next.below - last.below, above = next.above - last.above;
        if (next.far_below - last.far_below != below || next.far_above - last.far_above != above) return Course::mixed;
        if (below == 1 && above == 1) return Course::along;
        if (below == 0 && above == 1 && last.below == last.far_below) return Course::wall_below;
        if (below == 1 && above == 0 && last.above == last.far_above) return Course::wall_above;
        return Course::mixed;
      });
    }
    made_.side_streaks = find_streaks(static_cast<Row>(made_.sides.size()), static_cast<Row>(made_.open_count), [&](Row n) {
      const Sides &last = made_.sides[u(n - 1)], &next = made_.sides[u(n)];
      bool along = true;
      for (std::size_t b = 0; b < 3; ++b) along &= next.low[b] == last.low[b] + 1 && next.high[b] == last.high[b] + 1;
      return along ? Course::along : Course::mixed;
    });
  }

  const Staggered& mesh_;
  const FaceTable& table_;
  std::size_t axis_;
  Component made_;
  std::vector<Triple> at_;       // by active face
  std::vector<Row> high_site_;   // by face
  Row next_slot_;
  std::map<std::array<int, 2>, Row> walls_;
  std::map<std::pair<Row, Row>, Row> mirrors_;
};

}  // namespace

Component make_component(const Staggered& mesh, const FaceTable& table, std::size_t axis) {
  return Builder(mesh, table, axis).build();
}

}  // namespace similitude::vans
