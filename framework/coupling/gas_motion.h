#pragma once
/// How the gas turns and accelerates where particles are, for effects that read it. Smoothed and interpolated as the gas
/// velocity itself is, so that particles see the motion of the gas they see.

#include <memory>

#include "coupling/coupling.h"
#include "fluid/grid.h"
#include "scene/scene.h"

namespace similitude {

class GasMotion {
 public:
  /// `reads`: SIMILITUDE_READS_... of all effects together; fields exist only for what is among them. `coupled` as Coupling's.
  /// The grid stays alive with this. [setup]
  GasMotion(const ModelScene& scene, const Grid& grid, bool coupled, unsigned reads);
  ~GasMotion();

  bool vorticity() const;
  bool acceleration() const;
  /// Before the gas step: the velocity it starts from. [main]
  void remember(const GasFields& gas);
  /// After it: curl u, and Du/Dt = du/dt + (u . grad) u with du/dt over this step of length dt [s] that ended at `time` [s]. [main]
  void update(const GasFields& gas, double time, double dt);
  /// [1/s] and [m/s^2], per cell, the fourth number without meaning.
  const CellRows& vorticity_in_cells() const;
  const CellRows& acceleration_in_cells() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace similitude
