#include "output/probes.h"

#include <gmock/gmock.h>

#include "scratch.h"

using namespace similitude;
using namespace similitude::test;

namespace {

struct Bed {
  ModelScene scene = small_bed<ModelBed>(0.25);   // 4 x 3 x 8 cells of 5 mm
  Grid grid{scene};
  GasFields gas;
  Column<double> fraction;
  Bed() {
    const std::size_t cells = grid.cell_count();
    gas.pressure.assign(cells, 0);
    gas.velocity.assign(3 * cells, 0);
    fraction.assign(cells, 1);
  }
};

}  // namespace

TEST(Probes, APlaceOnAFaceBelongsToTheCellAbove) {
  const Bed bed;
  const double h = bed.grid.spacing(0);
  EXPECT_EQ(cell_at(bed.grid, {0, 0, 0}), bed.grid.cell(0, 0, 0));
  EXPECT_EQ(cell_at(bed.grid, {h, 0.5 * h, 2.9 * h}), bed.grid.cell(1, 0, 2));
  EXPECT_EQ(cell_at(bed.grid, bed.scene.size), bed.grid.cell(bed.grid.cells(0) - 1, bed.grid.cells(1) - 1, bed.grid.cells(2) - 1));
}

TEST(Probes, ReadTheRealBed) {
  Bed bed;
  const std::size_t cell = bed.grid.cell(2, 1, 3), cells = bed.grid.cell_count();
  bed.gas.pressure[cell] = 90;
  bed.gas.velocity[2 * cells + cell] = 1.5;
  bed.fraction[cell] = 0.45;
  const ProbeReading reading = read_probe(cell, bed.gas, bed.fraction, quarter_scale());
  EXPECT_DOUBLE_EQ(reading.pressure, 90 * 4);
  EXPECT_DOUBLE_EQ(reading.gas_velocity[2], 3);
  EXPECT_EQ(reading.gas_fraction, 0.45);
}

TEST(Probes, WriteARowPerProbe) {
  const ScratchFolder folder;
  Bed bed;
  const Probe tap{"tap", {0.0125, 0.0075, 0.0175}};
  {
    ProbeFile file(OutputDirectory(folder.path(), false), {tap}, bed.grid, quarter_scale());
    bed.gas.pressure[cell_at(bed.grid, tap.place)] = 10;
    file.write(0.25, bed.gas, bed.fraction);
  }
  const auto lines = lines_of(folder / "probes.csv");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0],
            "time [s],probe,x [m],y [m],z [m],pressure [Pa],gas_velocity_x [m/s],gas_velocity_y [m/s],gas_velocity_z [m/s],"
            "gas_fraction [1]");
  EXPECT_EQ(lines[1], "0.5,tap,0.05,0.03,0.07,40,0,0,0,1");
}
