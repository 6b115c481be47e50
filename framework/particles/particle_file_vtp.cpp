#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <filesystem>

#include "particles/particle_file.h"
#include "scene/messages.h"

namespace similitude {

namespace {

/// Notes that the reader complained; VTK would otherwise write to the terminal and go on.
class Complaint : public vtkCommand {
 public:
  static Complaint* New() { return new Complaint; }
  void Execute(vtkObject*, unsigned long, void*) override { heard = true; }
  bool heard = false;
};

/// The point array of that name, with or without its unit; null if there is none.
vtkDataArray* array_of(vtkPolyData& data, const std::string& name, const std::string& unit, int components, const std::string& file) {
  vtkDataArray* array = data.GetPointData()->GetArray((name + " [" + unit + "]").c_str());
  if (!array) array = data.GetPointData()->GetArray(name.c_str());
  if (array && array->GetNumberOfComponents() != components) {
    throw InputError(file + ": expected the point array " + name + " with " + std::to_string(components) +
                     (components == 1 ? " component" : " components") + ", found " +
                     std::to_string(array->GetNumberOfComponents()) + ".");
  }
  return array;
}

}  // namespace

std::vector<FileParticle> read_vtp_particles(const std::string& file) {
  if (!std::filesystem::is_regular_file(file)) throw InputError("cannot read the particle file " + file + ".");
  vtkNew<vtkXMLPolyDataReader> reader;
  vtkNew<Complaint> complaint;
  reader->AddObserver(vtkCommand::ErrorEvent, complaint);
  reader->SetFileName(file.c_str());
  vtkPolyData* data = nullptr;
  if (reader->CanReadFile(file.c_str())) {
    reader->Update();
    data = reader->GetOutput();
  }
  if (!data || complaint->heard) {
    throw InputError(file + ": expected a VTK XML PolyData file (.vtp).", "In ParaView: Save Data, as *.vtp.");
  }

  vtkDataArray* const velocity = array_of(*data, "velocity", "m/s", 3, file);
  vtkDataArray* const diameter = array_of(*data, "diameter", "m", 1, file);
  vtkDataArray* const radius = array_of(*data, "radius", "m", 1, file);
  vtkDataArray* const density = array_of(*data, "density", "kg/m^3", 1, file);
  std::vector<FileParticle> particles(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t n = 0; n < particles.size(); ++n) {
    const auto point = static_cast<vtkIdType>(n);
    FileParticle& particle = particles[n];
    data->GetPoint(point, particle.position.data());
    if (velocity) velocity->GetTuple(point, particle.velocity.data());
    if (diameter) particle.diameter = diameter->GetTuple1(point);
    else if (radius) particle.diameter = 2 * radius->GetTuple1(point);
    if (density) particle.density = density->GetTuple1(point);

    const auto refuse = [&](const std::string& what) { throw InputError(file + ": point " + std::to_string(n) + ": " + what); };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(particle.position[axis]) || !std::isfinite(particle.velocity[axis])) {
        refuse("expected a finite position and velocity.");
      }
    }
    if (particle.diameter && !(*particle.diameter > 0)) refuse("expected a diameter greater than 0.");
    if (particle.density && !(*particle.density > 0)) refuse("expected a density greater than 0.");
  }
  return particles;
}

}  // namespace similitude
