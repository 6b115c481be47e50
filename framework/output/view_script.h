#pragma once
#include <string>

#include "output/directory.h"
#include "scene/scene.h"

namespace similitude {

/// view.py: `paraview view.py`, `pvpython view.py` or `pvpython view.py --screenshot bed.png` shows the last frame,
/// coloured by speed: particles as spheres of their diameter, plates as boxes, the gas of the central plane behind
/// them. Finds its files beside itself, so the folder can be moved. Throws OutputError.
void write_view_script(const OutputDirectory& directory, const RealScene& real);

}  // namespace similitude
