#include "output/vtk_writer.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <cstdio>

#include "output/id_order.h"
#include "output/number.h"
#include "output/whole_file.h"

namespace similitude {
namespace {

/// The frames of one .pvd: what lies where, and when [s, real bed].
struct Series {
  std::string name, extension;
  std::vector<double> times = {};

  std::string frame_file(std::size_t frame) const {
    char number[24];
    std::snprintf(number, sizeof number, "%06zu", frame);
    return name + "/" + name + "_" + number + extension;
  }
  std::string pvd() const {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  "
        "<Collection>\n";
    for (std::size_t frame = 0; frame < times.size(); ++frame)
      text += "    <DataSet timestep=\"" + round_trip(times[frame]) + "\" part=\"0\" file=\"" + frame_file(frame) +
              "\"/>\n";
    return text + "  </Collection>\n</VTKFile>\n";
  }
};

vtkNew<vtkFloatArray> float_array(const char* name, int components, std::size_t rows) {
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows));
  if (components == 3)
    for (int c = 0; c < 3; ++c) array->SetComponentName(c, std::string(1, "xyz"[c]).c_str());
  return array;
}

void add_number(vtkFieldData& fields, const char* name, double value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fields.AddArray(array);
}

void add_text(vtkFieldData& fields, const char* name, const std::vector<std::string>& lines) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& line : lines) array->InsertNextValue(line);
  fields.AddArray(array);
}

/// What every file says about itself, so that a single frame sent by mail can still be understood.
void describe(vtkFieldData& fields, const MapBack& map, const std::vector<std::string>& class_names, double real_time) {
  add_number(fields, "TimeValue", real_time);  // the name by which VTK's readers know the time of a file
  add_text(fields, "scaling_law", {map.scaling_law});
  add_text(fields, "map_back", {map_back_note(map)});
  add_number(fields, "ratio_length", map.ratios.length);
  add_number(fields, "ratio_diameter", map.ratios.diameter);
  add_number(fields, "ratio_time", map.ratios.time);
  add_number(fields, "ratio_velocity", map.ratios.velocity);
  add_number(fields, "ratio_angular_velocity", map.ratios.angular_velocity);
  add_number(fields, "ratio_pressure", map.ratios.pressure);
  add_number(fields, "ratio_force", map.ratios.force);
  add_number(fields, "ratio_mass", map.ratios.mass);
  add_number(fields, "jet_ratio", map.jet_ratio);
  if (!class_names.empty()) add_text(fields, "class_names", class_names);
}

/// As bytes, so that the disk is written in one place (write_whole_file), which sees when it is full. Numbers lie inline in
/// base 64, not raw behind the XML, which the ParaView of Debian 12 cannot read (docs/decisions/0011).
std::string xml_of(vtkXMLWriter& writer, vtkDataObject& data) {
  writer.SetInputDataObject(&data);
  writer.SetDataModeToBinary();
  writer.SetCompressorTypeToZLib();
  writer.SetCompressionLevel(1);  // floats hardly shrink further: level 9 costs several times as long for a few percent
  writer.WriteToOutputStringOn();
  writer.Write();
  return writer.GetOutputString();
}

/// A vertex per particle: filters and representations that go by cells (Threshold, Surface) then see each of them.
vtkNew<vtkCellArray> vertices(vtkIdType count) {
  vtkNew<vtkTypeInt32Array> offsets, points;
  offsets->SetNumberOfValues(count + 1);
  points->SetNumberOfValues(count);
  for (vtkIdType k = 0; k <= count; ++k) offsets->SetValue(k, static_cast<vtkTypeInt32>(k));
  for (vtkIdType k = 0; k < count; ++k) points->SetValue(k, static_cast<vtkTypeInt32>(k));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, points);
  return cells;
}

void set_vector(vtkFloatArray& array, vtkIdType row, double x, double y, double z) {
  array.SetTypedComponent(row, 0, static_cast<float>(x));
  array.SetTypedComponent(row, 1, static_cast<float>(y));
  array.SetTypedComponent(row, 2, static_cast<float>(z));
}

}  // namespace

struct VtkWriter::Parts {
  OutputDirectory directory;
  MapBack map;
  std::vector<std::string> class_names;
  Series particles{"particles", ".vtp"}, fluid{"fluid", ".vti"};

  /// The frame first, then the list that names it: whenever the run dies, the list names whole files only.
  void write(Series& series, const std::string& bytes, double real_time) {
    directory.subfolder(series.name);
    write_whole_file(directory.file(series.frame_file(series.times.size())), bytes);
    series.times.push_back(real_time);
    write_whole_file(directory.file(series.name + ".pvd"), series.pvd());
  }
};

namespace {

/// Frames are numbered without a gap, so the first that is missing is the end.
void remove_frames(const OutputDirectory& directory, const Series& series, std::size_t first) {
  std::error_code error;
  for (std::size_t frame = first; std::filesystem::remove(directory.file(series.frame_file(frame)), error); ++frame) {
  }
  if (error) throw_output_error(directory.file(series.frame_file(first)), "removed", error.value());
}

}  // namespace

VtkWriter::Frames VtkWriter::frames() const { return {parts_->particles.times, parts_->fluid.times}; }

void VtkWriter::go_on_after(const Frames& frames) {
  parts_->particles.times = frames.particles;
  parts_->fluid.times = frames.fluid;
  for (const Series* series : {&parts_->particles, &parts_->fluid}) {
    const auto list = parts_->directory.file(series->name + ".pvd");
    if (series->times.empty()) {
      std::error_code ignored;
      std::filesystem::remove(list, ignored);
    } else {
      write_whole_file(list, series->pvd());
    }
    remove_frames(parts_->directory, *series, series->times.size());
  }
}

VtkWriter::VtkWriter(const OutputDirectory& directory, const MapBack& map_back, std::vector<std::string> class_names)
    : parts_(new Parts{directory, map_back, std::move(class_names)}) {}
VtkWriter::~VtkWriter() = default;

void VtkWriter::particles(const ParticleStore& store, double time) {
  const MapBack& map = parts_->map;
  const std::size_t count = store.size();
  const std::vector<std::uint32_t> order = rows_by_id(store);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  auto velocity = float_array("velocity [m/s]", 3, count);
  auto speed = float_array("speed [m/s]", 1, count);
  auto diameter = float_array("diameter [m]", 1, count);
  auto material_diameter = float_array("material_diameter [m]", 1, count);
  vtkNew<vtkTypeInt64Array> id;
  id->SetName("id");
  id->SetNumberOfValues(static_cast<vtkIdType>(count));
  vtkNew<vtkIntArray> species;
  species->SetName("class");
  species->SetNumberOfValues(static_cast<vtkIdType>(count));

  for (std::size_t k = 0; k < count; ++k) {
    const auto row = static_cast<vtkIdType>(k);
    const Row& p = store.position[order[k]];
    const Row& v = store.velocity[order[k]];
    const double vx = map.velocity(v.x), vy = map.velocity(v.y), vz = map.velocity(v.z);
    points->SetPoint(row, map.length(p.x), map.length(p.y), map.length(p.z));
    set_vector(*velocity, row, vx, vy, vz);
    speed->SetValue(row, static_cast<float>(std::sqrt(vx * vx + vy * vy + vz * vz)));
    diameter->SetValue(row, static_cast<float>(map.length(2 * p.w)));
    material_diameter->SetValue(row, static_cast<float>(map.material_diameter(2 * p.w)));
    id->SetValue(row, static_cast<vtkTypeInt64>(store.id[order[k]]));
    species->SetValue(row, static_cast<int>(store.species[order[k]]));
  }

  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices(static_cast<vtkIdType>(count)));
  vtkPointData& columns = *data->GetPointData();
  columns.AddArray(speed);
  columns.AddArray(velocity);
  columns.AddArray(diameter);
  columns.AddArray(material_diameter);
  columns.AddArray(id);
  columns.AddArray(species);
  for (const NamedColumn& scalar : store.scalars) {
    auto values = float_array((scalar.name + " [" + scalar.unit + "]").c_str(), 1, count);
    for (std::size_t k = 0; k < count; ++k) values->SetValue(static_cast<vtkIdType>(k), static_cast<float>(scalar.value[order[k]]));
    columns.AddArray(values);
  }
  if (store.fields.rotation) {
    auto spin = float_array("angular_velocity [rad/s]", 3, count);
    for (std::size_t k = 0; k < count; ++k) {
      const Row& w = store.angular_velocity[order[k]];
      set_vector(*spin, static_cast<vtkIdType>(k), map.angular_velocity(w.x), map.angular_velocity(w.y),
                 map.angular_velocity(w.z));
    }
    columns.AddArray(spin);
  }
  const double real_time = map.time(time);
  describe(*data->GetFieldData(), map, parts_->class_names, real_time);
  vtkNew<vtkXMLPolyDataWriter> writer;
  parts_->write(parts_->particles, xml_of(*writer, *data), real_time);
}

void VtkWriter::fluid(const Grid& grid, const GasFields& gas, const Column<double>& gas_fraction, double time) {
  const MapBack& map = parts_->map;
  const similitude_grid& table = grid.table();
  const std::size_t cells = grid.cell_count();

  auto velocity = float_array("gas_velocity [m/s]", 3, cells);
  auto speed = float_array("gas_speed [m/s]", 1, cells);
  auto pressure = float_array("pressure [Pa]", 1, cells);
  auto fraction = float_array("gas_fraction [1]", 1, cells);
  for (std::size_t c = 0; c < cells; ++c) {  // the grid's order of cells is VTK's
    const auto row = static_cast<vtkIdType>(c);
    const double u = map.velocity(gas.velocity[c]), v = map.velocity(gas.velocity[cells + c]),
                 w = map.velocity(gas.velocity[2 * cells + c]);
    set_vector(*velocity, row, u, v, w);
    speed->SetValue(row, static_cast<float>(std::sqrt(u * u + v * v + w * w)));
    pressure->SetValue(row, static_cast<float>(map.pressure(gas.pressure[c])));
    fraction->SetValue(row, static_cast<float>(gas_fraction[c]));
  }

  vtkNew<vtkImageData> data;
  data->SetDimensions(grid.cells(0) + 1, grid.cells(1) + 1, grid.cells(2) + 1);
  data->SetOrigin(map.length(table.origin[0]), map.length(table.origin[1]), map.length(table.origin[2]));
  data->SetSpacing(map.length(table.spacing[0]), map.length(table.spacing[1]), map.length(table.spacing[2]));
  vtkCellData& columns = *data->GetCellData();
  columns.AddArray(speed);
  columns.AddArray(velocity);
  columns.AddArray(pressure);
  columns.AddArray(fraction);
  for (const NamedColumn& scalar : gas.scalars) {
    auto values = float_array(("gas_" + scalar.name + " [" + scalar.unit + "]").c_str(), 1, cells);
    for (std::size_t c = 0; c < cells; ++c) values->SetValue(static_cast<vtkIdType>(c), static_cast<float>(scalar.value[c]));
    columns.AddArray(values);
  }
  const double real_time = map.time(time);
  describe(*data->GetFieldData(), map, {}, real_time);
  vtkNew<vtkXMLImageDataWriter> writer;
  parts_->write(parts_->fluid, xml_of(*writer, *data), real_time);
}

}  // namespace similitude
