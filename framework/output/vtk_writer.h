#pragma once
/// Particles and gas as frames that ParaView opens: VTK's own XML files, compressed, in real-bed units.

#include <memory>
#include <string>
#include <vector>

#include "coupling/coupling.h"
#include "fluid/grid.h"
#include "output/directory.h"
#include "output/map_back.h"
#include "particles/store.h"

namespace similitude {

class VtkWriter {
 public:
  /// `class_names`: of the particle classes in the scene's order; kept in each file's field data.
  VtkWriter(const OutputDirectory& directory, const MapBack& map_back, std::vector<std::string> class_names);
  ~VtkWriter();
  VtkWriter(const VtkWriter&) = delete;
  VtkWriter& operator=(const VtkWriter&) = delete;

  /// particles/particles_<frame>.vtp, rows in the order of id, and particles.pvd with all frames so far. Points are
  /// float64 (overlaps can be recomputed from them), other reals float32. `time` [s] is the simulated bed's. Throws
  /// OutputError.
  void particles(const ParticleStore& particles, double time);

  /// Times of the frames so far [s, real bed].
  struct Frames {
    std::vector<double> particles, fluid;
  };
  Frames frames() const;
  /// Goes on after these frames of an earlier run in the folder: the lists name them alone, later ones are removed. Throws
  /// OutputError.
  void go_on_after(const Frames& frames);

  /// fluid/fluid_<frame>.vti (cell data, float32) and fluid.pvd.
  void fluid(const Grid& grid, const GasFields& gas, const Column<double>& gas_fraction, double time);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace similitude
