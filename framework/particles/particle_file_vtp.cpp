#include <vtkDataArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "particles/particle_file.h"
#include "scene/messages.h"

namespace similitude {

namespace {

/// Notes that VTK complained; it would otherwise write to the terminal and go on. The parts of a reader complain each for
/// themselves, so their common way out is listened to while a file is read.
class Complaint : public vtkOutputWindow {
 public:
  static Complaint* New() { return new Complaint; }
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override { heard = true; }
  void DisplayWarningText(const char*) override {}
  bool heard = false;
};

class Listening {
 public:
  explicit Listening(vtkOutputWindow* instead)
      : before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkOutputWindow::SetInstance(instead);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);   // it writes beside the window
  }
  ~Listening() {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

 private:
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
};

/// VTK's reader looks for a name of each component of an array, one by one: for hours, where a file promises two thousand million.
bool promises_too_many_components(const std::string& file) {
  constexpr double k_most = 1000;   // [-], a tensor has nine
  const std::string attribute = "NumberOfComponents";
  std::ifstream in(file, std::ios::binary);
  std::string head;   // all but what is raw
  for (std::string line; std::getline(in, line) && line.find("<AppendedData") == std::string::npos;) head += line + '\n';
  for (std::size_t at = 0; (at = head.find(attribute, at)) != std::string::npos;) {
    at = head.find_first_not_of(" \t\r\n=\"'", at + attribute.size());
    if (at == std::string::npos) return false;
    if (std::strtod(head.c_str() + at, nullptr) > k_most) return true;
  }
  return false;
}

/// The point array of that name, with or without its unit; null if there is none.
vtkDataArray* array_of(vtkPolyData& data, const std::string& name, const std::string& unit, int components, const std::string& file) {
  vtkDataArray* array = data.GetPointData()->GetArray((name + " [" + unit + "]").c_str());
  if (!array) array = data.GetPointData()->GetArray(name.c_str());
  if (array && array->GetNumberOfComponents() != components) {
    throw InputError(file + ": expected the point array " + name + " with " + std::to_string(components) +
                     (components == 1 ? " component" : " components") + ", found " +
                     std::to_string(array->GetNumberOfComponents()) + ".");
  }
  if (array && array->GetNumberOfTuples() != data.GetNumberOfPoints()) {
    throw InputError(file + ": the point array " + name + " has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
                     std::to_string(data.GetNumberOfPoints()) + " points.");
  }
  return array;
}

}  // namespace

std::vector<FileParticle> read_vtp_particles(const std::string& file) {
  if (!std::filesystem::is_regular_file(file)) throw InputError("cannot read the particle file " + file + ".");
  vtkNew<Complaint> complaint;
  const Listening listening(complaint);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  vtkPolyData* data = nullptr;
  try {
    if (!promises_too_many_components(file) && reader->CanReadFile(file.c_str())) {
      reader->Update();
      data = reader->GetOutput();
    }
  } catch (const std::exception&) {   // an attribute that VTK takes for a size
    complaint->heard = true;
  }
  // A piece may promise any number of points, and VTK believes it.
  const bool points_missing = data && data->GetPoints() && data->GetPoints()->GetData()->GetSize() < 3 * data->GetNumberOfPoints();
  if (!data || complaint->heard || data->GetNumberOfPoints() < 0 || points_missing) {
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
    const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
    if (particle.diameter && !positive(*particle.diameter)) refuse("expected a diameter greater than 0.");
    if (particle.density && !positive(*particle.density)) refuse("expected a density greater than 0.");
  }
  return particles;
}

}  // namespace similitude
