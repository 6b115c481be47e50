#include "output/vtk_writer.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "output/view_script.h"
#include "output/whole_file.h"
#include "scratch.h"

using namespace similitude;
using namespace similitude::test;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

namespace {

/// Five particles in falling order of id, simulated at a quarter: read_back.py knows the same numbers.
ParticleStore five_particles(bool rotation) {
  ParticleStore store(StoreFields{.rotation = rotation});
  for (const std::uint64_t id : {4u, 3u, 2u, 1u, 0u}) {
    const auto k = static_cast<double>(id);
    const std::size_t row = store.add(id, static_cast<std::uint32_t>(id % 2), 0.002 * (k + 1), 0.005, 0.004 * (k + 1),
                                      5e-4 * (1 + 0.5 * k), 1e-6);
    store.velocity[row].x = 0.25 * k;
    store.velocity[row].y = -0.5;
    store.velocity[row].z = 1.5;
    if (rotation) store.angular_velocity[row] = {10 * k, 0, -4, store.angular_velocity[row].w};
  }
  return store;
}

struct Gas {
  GasFields fields;
  Column<double> fraction;
};
Gas gas_in(const Grid& grid) {
  const std::size_t n = grid.cell_count();
  Gas gas;
  gas.fields.velocity.assign(3 * n, 0);
  gas.fields.pressure.assign(n, 0);
  gas.fraction.assign(n, 0);
  for (std::size_t c = 0; c < n; ++c) {
    gas.fields.velocity[c] = 0.125;
    gas.fields.velocity[2 * n + c] = 0.5 * static_cast<double>(c);
    gas.fields.pressure[c] = 100.0 - static_cast<double>(c);
    gas.fraction[c] = 0.4 + 0.001 * static_cast<double>(c);
  }
  return gas;
}

void expect_python_agrees(const std::string& script, const std::filesystem::path& folder, const std::string& words) {
  const std::string command = "/usr/bin/python3 '" + script + "' '" + folder.string() + "' " + words + " > '" +
                              (folder / "said").string() + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of(folder / "said");
}

/// Is it a PNG of some size, with more than one colour in it? An even picture of 1200 rows packs into a few kB.
void expect_picture(const std::filesystem::path& file) {
  const std::string png = text_of(file);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_GT(png.size(), 10'000u);
}

class VtkFiles : public testing::Test {
 protected:
  ScratchFolder folder;
  OutputDirectory directory{folder.path(), false};
  ModelScene scene = small_bed<ModelBed>(0.25);
  Grid grid{scene};
};

}  // namespace

TEST_F(VtkFiles, ReadBackWithVtkAsTheRealBedsValues) {
  VtkWriter writer(directory, quarter_scale(), {"glass", "alumina"});
  const Gas gas = gas_in(grid);
  for (const double time : {0.0, 0.1, 0.25}) {
    writer.particles(five_particles(true), time);
    writer.fluid(grid, gas.fields, gas.fraction, time);
  }
  expect_python_agrees(SIMILITUDE_READ_BACK, folder.path(), "rotation");
}

TEST_F(VtkFiles, HaveNoAngularVelocityWhereParticlesHaveNone) {
  VtkWriter writer(directory, quarter_scale(), {"glass", "alumina"});
  const Gas gas = gas_in(grid);
  for (const double time : {0.0, 0.1, 0.25}) {
    writer.particles(five_particles(false), time);
    writer.fluid(grid, gas.fields, gas.fraction, time);
  }
  expect_python_agrees(SIMILITUDE_READ_BACK, folder.path(), "no-rotation");
}

TEST_F(VtkFiles, AreListedWithTheRealBedsTimesAfterEveryFrame) {
  VtkWriter writer(directory, quarter_scale(), {});
  writer.particles(five_particles(false), 0);
  EXPECT_THAT(lines_of(folder / "particles.pvd"),
              ElementsAre("<?xml version=\"1.0\"?>",
                          "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">", "  <Collection>",
                          "    <DataSet timestep=\"0\" part=\"0\" file=\"particles/particles_000000.vtp\"/>",
                          "  </Collection>", "</VTKFile>"));
  writer.particles(five_particles(false), 1.0 / 3);
  EXPECT_EQ(lines_of(folder / "particles.pvd")[4],
            "    <DataSet timestep=\"0.6666666666666666\" part=\"0\" file=\"particles/particles_000001.vtp\"/>");
  EXPECT_THAT(names_in(folder / "particles"), UnorderedElementsAre("particles_000000.vtp", "particles_000001.vtp"));
}

TEST_F(VtkFiles, AreTheSameWhateverTheOrderOfRows) {
  ParticleStore store = five_particles(true);
  VtkWriter writer(directory, quarter_scale(), {});
  writer.particles(store, 0);
  store.reorder({2, 0, 4, 1, 3});
  writer.particles(store, 0);
  EXPECT_EQ(text_of(folder / "particles/particles_000000.vtp"), text_of(folder / "particles/particles_000001.vtp"));
}

TEST_F(VtkFiles, KeepTheEarlierListWhenTheDiskFillsUp) {
  VtkWriter writer(directory, quarter_scale(), {});
  writer.particles(five_particles(false), 0);
  const std::string list = text_of(folder / "particles.pvd");
  std::filesystem::create_symlink("/dev/full", folder / "particles/particles_000001.vtp.part");
  EXPECT_THAT(message_of<OutputError>([&] { writer.particles(five_particles(false), 0.1); }),
              testing::HasSubstr("particles_000001.vtp: cannot be written: the disk is full."));
  EXPECT_EQ(text_of(folder / "particles.pvd"), list);
  EXPECT_THAT(names_in(folder / "particles"), ElementsAre("particles_000000.vtp"));
}

TEST_F(VtkFiles, OpenWithNoParticles) {
  VtkWriter writer(directory, quarter_scale(), {});
  writer.particles(ParticleStore(), 0);
  expect_python_agrees(SIMILITUDE_READ_BACK, folder.path(), "empty");
}

TEST_F(VtkFiles, AreOpenedByAScriptThatPythonUnderstands) {
  RealScene real = small_bed<RealBed>(1);
  real.baffles[0].name = "plate \"left\"";
  write_view_script(directory, real);
  const std::string script = text_of(folder / "view.py");
  EXPECT_THAT(script, testing::HasSubstr("\nSIZE = [0.08,0.06,0.16]"));
  EXPECT_THAT(script, testing::HasSubstr(
                          R"(PLATES = [{"name":"plate \"left\"","low":[0.039,0.0,0.04],"high":[0.041,0.06,0.1]}])"));
  EXPECT_EQ(std::system(("/usr/bin/python3 -m py_compile '" + (folder / "view.py").string() + "'").c_str()), 0);
}

TEST_F(VtkFiles, AreOpenedByAScriptThatSaysWhatItNeeds) {
  write_view_script(directory, small_bed<RealBed>(1));
  // Isolated: whoever runs the tests may have ParaView in PYTHONPATH or among the packages of the system.
  const std::string without = "/usr/bin/python3 -I -S '" + (folder / "view.py").string() + "' 2> '" + (folder / "said").string() + "'";
  EXPECT_NE(std::system(without.c_str()), 0);
  EXPECT_EQ(text_of(folder / "said"),
            "view.py needs ParaView's Python. Run: paraview view.py, or pvpython view.py --screenshot bed.png.\n");
}

TEST_F(VtkFiles, AreDrawnAsAPictureWithoutAScreen) {
  if (std::system("/usr/bin/python3 -c 'import matplotlib' 2> /dev/null") != 0) GTEST_SKIP() << "no python3-matplotlib";
  VtkWriter writer(directory, quarter_scale(), {});
  writer.particles(five_particles(false), 0);
  write_view_script(directory, small_bed<RealBed>(1));
  expect_python_agrees(SIMILITUDE_BED_PICTURE, folder.path(), "'" + (folder / "bed.png").string() + "'");
  expect_picture(folder / "bed.png");
  const Gas gas = gas_in(grid);
  writer.fluid(grid, gas.fields, gas.fraction, 0);
  expect_python_agrees(SIMILITUDE_BED_PICTURE, folder.path(), "'" + (folder / "with-gas.png").string() + "'");
  EXPECT_NE(text_of(folder / "with-gas.png"), text_of(folder / "bed.png"));
}
