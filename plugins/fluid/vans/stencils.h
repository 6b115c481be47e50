#pragma once
/// Who exchanges momentum with whom. Worked out once from the face kinds, so that a step runs over flat tables without
/// asking what a face is.
///
/// The momentum of a face lives in the box between the centres of its two cells (half a box at a pressure patch). Its six
/// sides are sites: along the velocity at a cell centre, across it at an edge. A site names the velocities around it as
/// rows of the component: faces, then slots for values that no face holds (a wall's, an inlet's, their mirror images).

#include <array>
#include <cstdint>
#include <vector>

#include "fields.h"

namespace similitude::vans {

using Row = std::int32_t;

struct Site {
  Row far_below, below, above, far_above;  // velocities along the direction of transport
  std::array<Row, 2> flux;                 // faces of that direction whose mean flux crosses here
  float shear;                             // [-], of (above - below) / h: 1 inside, 2 at a wall half a cell away, 0 if slip
  float cross;                             // [-], of the gradient of the crossing velocity
};

/// A face whose velocity is solved for: open, or on a pressure patch.
struct ActiveFace {
  Row face;
  Row below, above;          // cells; the same one twice at a pressure patch
  std::array<Row, 3> low, high;   // sites by direction
};

struct PatchFace {
  Row face, cell;
  int side;                  // 0: the cell lies above the face, 1: below
  int patch;
};

/// value = mean of two walls' velocities; patch -1: at rest.
struct WallSlot {
  Row slot;
  std::array<int, 2> patch;
};

/// value = 2 wall - inner: the linear continuation beyond a wall.
struct MirrorSlot {
  Row slot, inner, wall;
};

/// Everything about one velocity component.
struct Component {
  std::size_t axis;
  std::vector<ActiveFace> faces;        // open ones first
  Index open_count;
  std::vector<PatchFace> pressure, velocity;   // `pressure` in the order of the faces from open_count on
  std::array<std::vector<Site>, 3> sites;      // by direction of transport
  std::vector<Row> cell_of_site;               // of sites along the axis; -1 at the outer side of a pressure patch
  std::vector<WallSlot> walls;
  std::vector<MirrorSlot> mirrors;
  Index rows;                           // faces and slots
};

std::array<Component, 3> make_components(const Staggered& mesh);

}  // namespace similitude::vans
