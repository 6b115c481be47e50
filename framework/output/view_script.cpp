#include "output/view_script.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "loader/json_text.h"
#include "output/whole_file.h"

namespace similitude {
namespace {

using json = nlohmann::ordered_json;

// ParaView runs this text as Python: by itself (pvpython view.py), or inside its window.
constexpr const char* k_script_head =
    R"py("""Opens this run in ParaView: particles and gas in the central plane, coloured by speed.

    pvpython view.py --screenshot bed.png [--time 1.5]   saves a picture (of the last frame, or of a time [s])
    pvpython view.py                                     shows the last frame in a window
    paraview view.py                                     opens everything in ParaView; in a folder that was moved or
                                                         copied, go there first
"""
import argparse
import os
import sys

try:
    from paraview.simple import *
except ImportError:
    raise SystemExit("view.py needs ParaView's Python. Run: paraview view.py, or pvpython view.py --screenshot bed.png.")

)py";

constexpr const char* k_script_body = R"py(

def here():
    """The folder of this script. Inside its window ParaView does not say where a script lies."""
    if "__file__" in globals():
        return os.path.dirname(os.path.abspath(__file__))
    if os.path.exists("view.py") and os.path.exists("manifest.json"):
        return os.getcwd()
    return WRITTEN_IN


def points_of_frame(source):
    return source.GetDataInformation().GetNumberOfPoints() > 0


def read(file, name):
    """The last frame. ParaView goes on after a file that it could not read, and would draw an empty bed."""
    source = PVDReader(registrationName=name, FileName=file)
    source.UpdatePipeline(last_time(source))
    if "scaling_law" not in source.FieldData.keys():      # every file says what it is, one without particles too
        raise SystemExit("view.py: this ParaView cannot read the last frame of " + file)
    return source


def show_particles(file, view):
    bed = read(file, "particles")
    shown = Show(bed, view)
    ColorBy(shown, ("POINTS", "speed [m/s]"))
    if points_of_frame(bed):
        smallest, largest = bed.PointData["diameter [m]"].GetRange(0)
        shown.SetRepresentationType("Point Gaussian")
        shown.ShaderPreset = "Sphere"
        if smallest == largest:
            shown.GaussianRadius = 0.5 * largest
        else:
            shown.ScaleByArray = 1
            shown.SetScaleArray = ["POINTS", "diameter [m]"]
            shown.UseScaleFunction = 0
            shown.GaussianRadius = 0.5
    colours(shown, "speed [m/s]", "Turbo", view)
    return bed


def show_gas(file, view):
    gas = read(file, "gas")
    plane = Slice(registrationName="gas in the central plane", Input=gas)
    plane.SliceType = "Plane"
    plane.SliceType.Origin = [0.5 * SIZE[0], 0.5 * SIZE[1], 0.5 * SIZE[2]]
    plane.SliceType.Normal = [0.0, 1.0, 0.0]
    shown = Show(plane, view)
    shown.Position = [0.0, 0.5 * SIZE[1], 0.0]      # drawn on the back wall, where it hides no particle
    shown.Opacity = 0.5
    ColorBy(shown, ("CELLS", "gas_speed [m/s]"))
    colours(shown, "gas_speed [m/s]", "X Ray", view)
    return gas


def colours(shown, array, preset, view):
    table = GetColorTransferFunction(array)
    table.ApplyPreset(preset, True)
    shown.RescaleTransferFunctionToDataRange(False, True)
    bar = GetScalarBar(table, view)
    bar.Title = array
    bar.ComponentTitle = ""
    if bar.RangeLabelFormat.startswith("%"):      # as in ParaView 5: the ends of the range like the numbers between them
        bar.RangeLabelFormat = "%.4g"
    bar.TitleColor = [0.0, 0.0, 0.0]
    bar.LabelColor = [0.0, 0.0, 0.0]
    shown.SetScalarBarVisibility(view, True)


def show_box(name, low, high, view, representation):
    box = Box(registrationName=name)
    box.XLength, box.YLength, box.ZLength = [b - a for a, b in zip(low, high)]
    box.Center = [0.5 * (a + b) for a, b in zip(low, high)]
    shown = Show(box, view)
    shown.SetRepresentationType(representation)
    shown.AmbientColor = shown.DiffuseColor = [0.2, 0.2, 0.2]


def last_time(source):
    times = source.TimestepValues
    try:
        return times[-1]
    except TypeError:      # ParaView gives a single frame's time as a number
        return times


def look_from_the_front(view):
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [0.5 * s for s in SIZE]
    view.CameraPosition = [0.5 * SIZE[0], -3 * max(SIZE), 0.5 * SIZE[2]]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraParallelScale = 0.52 * max(SIZE[2], SIZE[0] * view.ViewSize[1] / view.ViewSize[0])


def main():
    parser = argparse.ArgumentParser(description="Shows a run of Similitude in ParaView.")
    parser.add_argument("--screenshot", metavar="FILE", help="save a picture and end")
    parser.add_argument("--time", type=float, help="[s], instead of the last frame")
    # Inside ParaView's window the command line is ParaView's own.
    args, _ = parser.parse_known_args(sys.argv[1:])

    view = GetActiveViewOrCreate("RenderView")
    if args.screenshot:
        view.ViewSize = [900, 1200]
        view.OrientationAxesVisibility = 0      # would cover the foot of the bed
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]

    show_box("bed", [0.0, 0.0, 0.0], SIZE, view, "Wireframe")
    for plate in PLATES:
        show_box(plate["name"], plate["low"], plate["high"], view, "Surface")
    times = []
    for name, show in (("particles.pvd", show_particles), ("fluid.pvd", show_gas)):
        file = os.path.join(here(), name)
        if os.path.exists(file):
            times.append(last_time(show(file, view)))
    if not times:
        raise SystemExit("view.py: there is neither particles.pvd nor fluid.pvd in " + here())

    GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    view.ViewTime = args.time if args.time is not None else max(times)
    Render(view)
    for shown in view.Representations:      # ranges of the frame that is shown, not of the first
        if getattr(shown, "ColorArrayName", ["", ""])[1]:
            shown.RescaleTransferFunctionToDataRange(False, True)
    look_from_the_front(view)
    Render(view)
    if args.screenshot:
        SaveScreenshot(args.screenshot, view)
    elif "pvpython" in os.path.basename(sys.executable or ""):
        Interact(view)


main()
)py";

json box_json(const Baffle& baffle) {
  json low = json::array(), high = json::array();
  for (std::size_t a = 0; a < 3; ++a) {
    const bool across = a == static_cast<std::size_t>(baffle.normal);
    low.push_back(across ? baffle.position - 0.5 * baffle.thickness : baffle.extent[a].low);
    high.push_back(across ? baffle.position + 0.5 * baffle.thickness : baffle.extent[a].high);
  }
  return {{"name", baffle.name}, {"low", low}, {"high", high}};
}

}  // namespace

void write_view_script(const OutputDirectory& directory, const RealScene& real) {
  json plates = json::array();
  for (const Baffle& baffle : real.baffles) plates.push_back(box_json(baffle));
  // JSON of numbers, strings and lists is Python as well.
  std::string text = k_script_head;
  const std::string folder = std::filesystem::absolute(directory.path()).lexically_normal().string();
  text += "WRITTEN_IN = " + json_text(json(folder), -1) + "\n";
  text += "SIZE = " + json(real.size).dump() + "      # [m], the bed\n";
  text += "PLATES = " + plates.dump() + "   # [m]\n";
  write_whole_file(directory.file("view.py"), text + k_script_body);
}

}  // namespace similitude
