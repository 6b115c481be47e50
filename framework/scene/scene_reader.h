#pragma once
/// The sections scene, coupling, time and output of a case: from keys to the fields of RealScene.

#include "scene/scene.h"
#include "scene/section.h"

namespace similitude {

void read_scene(const Section& section, RealScene& scene);
void read_coupling(const Section& section, RealScene& scene);
void read_time(const Section& section, RealScene& scene);
void read_output(const Section& section, RealScene& scene);

}  // namespace similitude
