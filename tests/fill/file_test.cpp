/// Beds from files: CSV, LAMMPS data, VTP; what is wrong is said with file and line.

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "bed_of_springs.h"
#include "particles/bed_file.h"
#include "particles/particle_file.h"
#include "scene/messages.h"

namespace similitude::test {
namespace {

class ParticleFile : public ::testing::Test {
 protected:
  std::string refusal(const std::string& name, const std::string& text) { return refusal_of(folder.write(name, text)); }
  /// What is said of a file, which is named without its folder.
  std::string refusal_of(const std::string& file) {
    try {
      read_particle_file(file);
    } catch (const InputError& error) {
      const std::string what = error.what(), name = std::filesystem::path(file).filename();
      const std::size_t at = what.find(file);
      return at == std::string::npos ? what : what.substr(0, at) + name + what.substr(at + file.size());
    }
    return "no error";
  }
  ScratchFolder folder;
};

TEST_F(ParticleFile, CsvGivesPlacesVelocitiesDiametersAndDensities) {
  const auto read = read_particle_file(folder.write("bed.csv",
                                                    "# poured on Monday\n"
                                                    "x [m], y,z ,vx,vy,vz [m/s],radius,density\n"
                                                    "0.001,0.002,0.003,1,-2,+3,5e-4,1040\r\n"
                                                    "\n"
                                                    "0.004,0.005,0.006,0,0,0,6e-4,2500\n"));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].position, (std::array<double, 3>{0.001, 0.002, 0.003}));
  EXPECT_EQ(read[0].velocity, (std::array<double, 3>{1, -2, 3}));
  EXPECT_EQ(read[0].diameter, 2 * 5e-4);
  EXPECT_EQ(read[1].density, 2500);
  EXPECT_EQ(read[1].line, 5);
}

TEST_F(ParticleFile, CsvNeedsNothingButPlaces) {
  const auto read = read_particle_file(folder.write("bed.csv", "x,y,z\n1,2,3\n"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_FALSE(read[0].diameter);
  EXPECT_EQ(read[0].velocity, (std::array<double, 3>{0, 0, 0}));
}

TEST_F(ParticleFile, CsvErrorsNameFileLineAndWhatWasExpected) {
  EXPECT_EQ(refusal("bed.csv", "x,y,z\n1,2,3\n1,2\n"), "bed.csv:3: expected 3 values as in the header, found 2.");
  EXPECT_EQ(refusal("bed.csv", "x,y,z\n1,two,3\n"), "bed.csv:2: expected a number for y, found \"two\".");
  EXPECT_EQ(refusal("bed.csv", "x,y,z,diameter\n1,2,3,0\n"), "bed.csv:2: expected a diameter greater than 0, found 0.");
  EXPECT_EQ(refusal("bed.csv", "x,y,z\n1,2,nan\n"), "bed.csv:2: expected a number for z, found \"nan\".");
  EXPECT_EQ(refusal("bed.csv", "x,y,height\n"),
            "bed.csv:1: expected a header with the column z, found \"x,y,height\".\n"
            "  The first line names the columns: x,y,z and any of vx,vy,vz,diameter (or radius),density.");
  EXPECT_EQ(refusal("bed.csv", "x [mm],y,z\n"), "bed.csv:1: column \"x [mm]\" is read in [m] only.\n  Write x [m], or x alone, with values in metres.");
  EXPECT_EQ(refusal("bed.csv", ""), "bed.csv: expected a header x,y,z,…, but the file is empty.");
}

TEST_F(ParticleFile, LammpsDataGivesTypesDiametersAndVelocities) {
  const auto read = read_particle_file(folder.write("bed.data",
                                                    "LAMMPS data file via write_data, version 29 Sep 2021\n\n"
                                                    "2 atoms\n1 atom types\n\n0 0.15 xlo xhi\n0 0.02 ylo yhi\n0 1 zlo zhi\n\n"
                                                    "Atoms # sphere\n\n"
                                                    "7 1 0.001 1040 0.01 0.002 0.003 0 0 0\n"
                                                    "3 2 0.002 2500 0.02 0.004 0.006 0 0 0\n\n"
                                                    "Velocities\n\n3 1 2 3 0 0 0\n7 0 0 0.5 0 0 0\n"));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].diameter, 0.001);
  EXPECT_EQ(read[0].velocity[2], 0.5);
  EXPECT_EQ(read[1].type, 2);
  EXPECT_EQ(read[1].position[0], 0.02);
  EXPECT_EQ(read[1].velocity[0], 1);
}

TEST_F(ParticleFile, LammpsErrorsNameFileLineAndWhatWasExpected) {
  EXPECT_EQ(refusal("bed.data", "title\n\n1 atoms\n\nAtoms # atomic\n\n1 1 0 0 0\n"),
            "bed.data:5: expected atoms of style sphere, found style atomic.\n  Write the file with atom_style sphere.");
  EXPECT_EQ(refusal("bed.data", "title\n\nAtoms\n\n1 1 0 0 0\n"),
            "bed.data:5: expected id type diameter density x y z (and possibly three image counts), found 5 values.\n"
            "  Write the file with atom_style sphere.");
  EXPECT_EQ(refusal("bed.data", "title\n\nAtoms\n\n1 1 1e-3 1040 0 0 0\n1 1 1e-3 1040 0 0 0\n"),
            "bed.data:6: atom 1 was given before.");
  EXPECT_EQ(refusal("bed.data", "title\n\n2 atoms\n\nAtoms\n\n1 1 1e-3 1040 0 0 0\n"),
            "bed.data: the header promises 2 atoms, the section Atoms has 1.");
  EXPECT_EQ(refusal("bed.data", "title\n"),
            "bed.data: expected a section Atoms, found none.\n  Is this a LAMMPS data file (write_data)?");
}

struct PointArray {
  const char* name;
  int components;
  std::vector<double> values;
};

/// A file as VTK's own writer makes it.
std::string written(const ScratchFolder& folder, const std::vector<std::array<double, 3>>& places, const std::vector<PointArray>& arrays) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places) points->InsertNextPoint(place.data());
  data->SetPoints(points);
  for (const PointArray& given : arrays) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(given.name);
    array->SetNumberOfComponents(given.components);
    for (const double value : given.values) array->InsertNextValue(value);
    data->GetPointData()->AddArray(array);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  const std::string file = folder.path() + "/bed.vtp";
  writer->SetFileName(file.c_str());
  writer->SetInputData(data);
  EXPECT_EQ(writer->Write(), 1);
  return file;
}

TEST_F(ParticleFile, VtpGivesWhatOurOwnOutputHolds) {
  const auto read = read_particle_file(
      written(folder, {{0.01, 0.02, 0.03}}, {{"velocity [m/s]", 3, {1, 2, 3}}, {"diameter [m]", 1, {0.001}}, {"density", 1, {1040}}}));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].position, (std::array<double, 3>{0.01, 0.02, 0.03}));
  EXPECT_EQ(read[0].velocity, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(read[0].diameter, 0.001);
  EXPECT_EQ(read[0].density, 1040);
}

TEST_F(ParticleFile, VtpThatIsNoneIsRefused) {
  EXPECT_EQ(refusal("bed.vtp", "x,y,z\n"),
            "bed.vtp: expected a VTK XML PolyData file (.vtp).\n  In ParaView: Save Data, as *.vtp.");
}

// Two points, as ParaView writes them; `arrays` and `places` are what differs.
std::string vtp(const std::string& arrays, const std::string& places = "0.01 0.02 0.03 0.02 0.02 0.03") {
  return R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="2" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<PointData>)" + arrays + R"(</PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">)" + places + R"(</DataArray></Points>
</Piece></PolyData></VTKFile>
)";
}

std::string vtp_array(const std::string& name, int components, const std::string& values) {
  return "<DataArray type=\"Float64\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">" + values +
         "</DataArray>";
}

TEST_F(ParticleFile, VtpMayGiveRadiiAndNoUnits) {
  const auto read = read_particle_file(folder.write("bed.vtp", vtp(vtp_array("radius", 1, "0.0005 0.001"))));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[1].diameter, 0.002);
  EXPECT_EQ(read[1].position, (std::array<double, 3>{0.02, 0.02, 0.03}));
}

TEST_F(ParticleFile, VtpErrorsNameThePointAndWhatWasExpected) {
  EXPECT_EQ(refusal("bed.vtp", vtp(vtp_array("velocity", 2, "1 2 3 4"))),
            "bed.vtp: expected the point array velocity with 3 components, found 2.");
  EXPECT_EQ(refusal("bed.vtp", vtp(vtp_array("diameter", 3, "1 2 3 4 5 6"))),
            "bed.vtp: expected the point array diameter with 1 component, found 3.");
  EXPECT_EQ(refusal("bed.vtp", vtp(vtp_array("diameter [m]", 1, "0.001 -0.001"))), "bed.vtp: point 1: expected a diameter greater than 0.");
  EXPECT_EQ(refusal("bed.vtp", vtp(vtp_array("radius", 1, "0 0.001"))), "bed.vtp: point 0: expected a diameter greater than 0.");
  // Numbers that are none survive only in VTK's own binary form.
  constexpr double k_none = std::numeric_limits<double>::quiet_NaN(), k_endless = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal_of(written(folder, {{0.01, 0.02, 0.03}}, {{"density", 1, {k_none}}})), "bed.vtp: point 0: expected a density greater than 0.");
  EXPECT_EQ(refusal_of(written(folder, {{0.01, 0.02, 0.03}}, {{"radius", 1, {k_endless}}})), "bed.vtp: point 0: expected a diameter greater than 0.");
  EXPECT_EQ(refusal_of(written(folder, {{0.01, 0.02, 0.03}, {0.02, k_endless, 0.03}}, {})),
            "bed.vtp: point 1: expected a finite position and velocity.");
  EXPECT_EQ(refusal_of(written(folder, {{0.01, 0.02, 0.03}}, {{"velocity", 3, {0, k_none, 0}}})),
            "bed.vtp: point 0: expected a finite position and velocity.");
}

// What VTK itself stumbles over, whatever it would say about it.
TEST_F(ParticleFile, VtpThatIsBrokenIsRefusedInOneSentence) {
  const std::string whole = vtp(vtp_array("diameter", 1, "0.001 0.001"));
  const std::string broken = "bed.vtp: expected a VTK XML PolyData file (.vtp).\n  In ParaView: Save Data, as *.vtp.";
  const auto with = [&whole](const std::string& was, const std::string& is) {
    std::string text = whole;
    return text.replace(text.find(was), was.size(), is);
  };
  EXPECT_EQ(refusal("bed.vtp", whole.substr(0, whole.size() / 2)), broken);
  EXPECT_EQ(refusal("bed.vtp", with("NumberOfPoints=\"2\"", "NumberOfPoints=\"99999\"")), broken);
  EXPECT_EQ(refusal("bed.vtp", with("NumberOfComponents=\"3\"", "NumberOfComponents=\"-3\"")), broken);
  EXPECT_EQ(refusal("bed.vtp", with("NumberOfComponents=\"3\"", "NumberOfComponents=\"2147483648\"")), broken);   // VTK would read for hours
  EXPECT_EQ(refusal("bed.vtp", with("type=\"PolyData\"", "type=\"ImageData\"")), broken);
  EXPECT_EQ(refusal("bed.vtp", vtp(vtp_array("diameter", 1, "0.001"))), broken);   // two points
  EXPECT_EQ(refusal("bed.vtp", ""), broken);
}

TEST_F(ParticleFile, VtpThatIsNotThereIsNamed) {
  EXPECT_EQ(refusal_of(folder.path() + "/none.vtp"), "cannot read the particle file none.vtp.");
}

TEST_F(ParticleFile, OfUnknownKindIsRefused) {
  EXPECT_EQ(refusal("bed.xyz", ""),
            "particles cannot be read from bed.xyz: its kind is not known by its name.\n"
            "  Use .csv, .vtp, or .data, .lmp or .lammps for LAMMPS data.");
}

class FillFromFile : public ParticleFile {
 protected:
  ModelScene scene(const std::string& name, const std::string& text) {
    ModelScene bed = small_bed(0);
    bed.bed.kind = FillKind::file;
    bed.bed.file = folder.write(name, text);
    return bed;
  }
  std::string refusal_of(const ModelScene& bed) {
    ParticleStore particles = empty_store();
    try {
      fill_bed(particles, bed, law, FillOptions{});
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder.path().size() + 1);
    }
    return "no error";
  }
  ContactModel law = spring_law(k_stiffness);
};

TEST_F(FillFromFile, ScalesTheRealBedsLengthsSpeedsAndDensities) {
  const ModelScene bed = scene("bed.csv", "x,y,z,vz,diameter,density\n0.008,0.004,0.012,2,0.001,1000\n");
  ParticleStore particles = empty_store();
  FillOptions options;
  options.length_ratio = 0.25;
  options.diameter_ratio = 0.5;
  options.velocity_ratio = 0.5;
  options.density_ratio = 2;
  fill_bed(particles, bed, law, options);
  ASSERT_EQ(particles.size(), 1u);
  EXPECT_EQ(particles.position[0].x, 0.002);
  EXPECT_EQ(particles.position[0].w, 0.00025);
  EXPECT_EQ(particles.velocity[0].z, 1);
  EXPECT_DOUBLE_EQ(particles.velocity[0].w, 2000 * 3.141592653589793 / 6 * std::pow(0.0005, 3));
}

TEST_F(FillFromFile, TakesTheClassNearestInSizeOrTheType) {
  ModelScene bed = scene("bed.csv", "x,y,z,diameter\n0.001,0.001,0.001,0.0011\n0.004,0.001,0.001,0.0019\n");
  bed.particles.push_back(bed.particles[0]);
  bed.particles[1].diameter = 2e-3;
  ParticleStore particles = empty_store();
  fill_bed(particles, bed, law, FillOptions{});
  EXPECT_EQ(particles.species[0], 0u);
  EXPECT_EQ(particles.species[1], 1u);
}

class BedRows : public FillFromFile {
 protected:
  static ParticleClass type(const std::string& name, double diameter) {
    ParticleClass type;
    type.name = name;
    type.diameter = diameter;   // [m]
    type.density = 1000;        // [kg/m^3]
    return type;
  }
  RealScene read(const std::string& name, const std::string& text) {
    RealScene bed;
    bed.particles = {type("small", 1e-3)};
    bed.bed.kind = FillKind::file;
    bed.bed.file = folder.write(name, text);
    return bed;
  }
};

TEST_F(BedRows, LikeTheirClassAreExactlyTheClass) {
  RealScene bed = read("bed.csv", "x,y,z,diameter,density\n0,0,0,0.001,1000\n0,0,0,0.001,1000\n");
  read_bed_rows(bed);
  const FileRows rows = *bed.particles[0].rows;
  EXPECT_EQ(rows.count, 2);
  EXPECT_EQ(rows.volume, 2);
  EXPECT_EQ(rows.least_mass, 1);
  EXPECT_EQ(rows.diameter_of_lightest, 1);
  EXPECT_EQ(rows.least_diameter, 1);
  EXPECT_EQ(rows.least_density, 1);
  EXPECT_EQ(rows.largest_density, 1);
}

TEST_F(BedRows, TellTheLightestAndTheSmallestOfEachClass) {
  RealScene bed = read("bed.csv",
                       "x,y,z,diameter,density\n"
                       "0,0,0,0.0005,2000\n"     // 1/4 of its class's mass
                       "0,0,0,0.00025,9000\n"    // the smallest, 9/64
                       "0,0,0,0.0005,1000\n"     // the lightest, 1/8
                       "0,0,0,0.004,1000\n");
  bed.particles.push_back(type("large", 4e-3));
  read_bed_rows(bed);
  const FileRows small = *bed.particles[0].rows, large = *bed.particles[1].rows;
  EXPECT_EQ(small.count, 3);
  EXPECT_DOUBLE_EQ(small.volume, 2 * 0.125 + 1.0 / 64);
  EXPECT_DOUBLE_EQ(small.least_mass, 0.125);
  EXPECT_DOUBLE_EQ(small.diameter_of_lightest, 0.5);
  EXPECT_DOUBLE_EQ(small.least_diameter, 0.25);
  EXPECT_DOUBLE_EQ(small.least_density, 1);
  EXPECT_DOUBLE_EQ(small.largest_density, 9);
  EXPECT_EQ(large.count, 1);
  EXPECT_EQ(large.least_mass, 1);
}

TEST_F(BedRows, AreReadOnce) {
  RealScene bed = read("bed.csv", "x,y,z\n0,0,0\n");
  read_bed_rows(bed);
  bed.bed.file = "gone.csv";
  read_bed_rows(bed);
  EXPECT_EQ(bed.particles[0].rows->count, 1);
}

TEST_F(FillFromFile, RefusesWhatIsFarFromItsClass) {
  const std::string mend = "\n  Give such particles a class of their own in scene.particles. Files hold metres and kg/m^3 of the real bed.";
  const ModelScene bed = scene("bed.csv", "x,y,z\n0.001,0.001,0.001\n");
  const std::string of_class = " of its class " + bed.particles[0].name + "." + mend;
  const double d = bed.particles[0].diameter, density = bed.particles[0].density;   // [m], [kg/m^3]
  const auto said = [&](const std::string& column, double value) {
    return refusal_of(scene("bed.csv", "x,y,z," + column + "\n0.001,0.001,0.001," + std::to_string(value) + "\n"));
  };
  EXPECT_EQ(said("diameter", 11 * d).find("bed.csv:2: a diameter of "), 0u);
  EXPECT_NE(said("diameter", 11 * d).find(of_class), std::string::npos);
  EXPECT_NE(said("density", density / 11).find(of_class), std::string::npos);
  EXPECT_EQ(refusal_of(scene("bed.csv", "x,y,z,diameter\n0.001,0.001,0.001,5e-308\n")).find("bed.csv:2: a diameter of 5e-305 mm is far from the "), 0u);
}

TEST_F(FillFromFile, RefusesWhatIsOutsideTheDomainOrOfNoClass) {
  EXPECT_EQ(refusal_of(scene("bed.csv", "x,y,z\n0.001,0.001,0.07\n")),
            "bed.csv:2: z = 70 mm is outside the domain, 0 to 60 mm.\n  Positions are in metres of the real bed.");
  ModelScene two = scene("bed.csv", "x,y,z\n0.001,0.001,0.001\n");
  two.particles.push_back(two.particles[0]);
  EXPECT_EQ(refusal_of(two),
            "bed.csv:2: which of the 2 classes of particles is this?\n  Add a column diameter or density to the file.");
  two = scene("bed.data", "t\n\nAtoms\n\n1 3 0.001 1040 0.001 0.001 0.001\n");
  two.particles.push_back(two.particles[0]);
  EXPECT_EQ(refusal_of(two), "bed.data:5: atom type 3, but the scene has 2 classes of particles.");
}

}  // namespace
}  // namespace similitude::test
