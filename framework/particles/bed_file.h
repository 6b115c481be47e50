#pragma once
/// A bed that comes from a file, against the classes of its scene.

#include "particles/fill.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude {

/// Reads the bed's file once and tells every class what it holds of it (ParticleClass::rows): how many there are, and how
/// small. Does nothing for a bed that comes from elsewhere, or that has been read.
/// Throws InputError naming file and line for a row that is of no class of the scene, or far from its class.
void read_bed_rows(RealScene& scene);

/// Adds the file's rows in their order. Throws InputError as read_bed_rows, and for a place outside the domain.
void fill_from_file(ParticleStore& particles, const ModelScene& scene, const FillOptions& options);

}  // namespace similitude
