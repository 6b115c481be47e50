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

#include "fluid/face_tables.h"
#include "streaks.h"

namespace similitude::vans {

using flow::FaceFields;
using flow::FaceTable;
using flow::make_face_fields;

/// A value per site, by direction of transport.
using SiteFields = std::array<std::vector<double>, 3>;

struct Site {
  Row far_below, below, above, far_above;  // velocities along the direction of transport
  std::array<Row, 2> flux;                 // faces of that direction whose mean flux crosses here
  float shear;                             // [-], of (above - below) / h: 1 inside, 2 at a wall half a cell away, 0 if slip
  float cross;                             // [-], of the gradient of the crossing velocity
};

/// The sites around one active face, by direction.
struct Sides {
  std::array<Row, 3> low, high;
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
  Index open_count;                     // of active faces; the others lie on pressure patches
  std::vector<Sides> sides;             // of active faces, in the order of the face table
  std::array<std::vector<Site>, 3> sites;      // by direction of transport
  std::array<Streaks, 3> site_streaks;         // of sites
  Streaks side_streaks;                        // of sides; none goes on from open faces to those on patches
  std::vector<Row> cell_of_site;               // of sites along the axis; -1 at the outer side of a pressure patch
  std::vector<WallSlot> walls;
  std::vector<MirrorSlot> mirrors;
  Index rows;                           // faces and slots
};

Component make_component(const Staggered& mesh, const FaceTable& table, std::size_t axis);

}  // namespace similitude::vans
