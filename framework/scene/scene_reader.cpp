#include "scene/scene_reader.h"

#include <filesystem>
#include <tuple>

#include "scene/input_file.h"
#include "scene/messages.h"

namespace similitude {
namespace {

constexpr std::array k_axes{Axis::x, Axis::y, Axis::z};

std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }
std::string letter(Axis axis) { return std::string(1, axis_name(axis)); }

Face face_of(const std::string& name) {
  for (const Axis axis : k_axes)
    for (const Side side : {Side::low, Side::high})
      if (face_name({axis, side}) == name) return {axis, side};
  return {};
}

void read_particles(const Section& section, RealScene& scene) {
  for (const auto& [name, particle] : section.named("particles")) {
    ParticleClass species;
    species.name = name;
    species.diameter = species.drag_diameter = species.material_diameter = particle.quantity("diameter");
    species.density = particle.quantity("density");
    if (particle.given("count")) species.count = particle.integer("count");
    scene.particles.push_back(species);
  }
}

void read_bed(const Section& bed, const RealScene& scene, BedFill& fill) {
  const std::string kind = bed.choice("fill");
  fill.kind = kind == "settle"    ? FillKind::settle
              : kind == "lattice" ? FillKind::lattice
              : kind == "file"    ? FillKind::file
                                  : FillKind::none;
  fill.mark = bed.mark();
  if (bed.given("file")) {
    if (fill.kind != FillKind::file)
      throw InputError(bed.mark("file"), bed.path("file"),
                       "a file is read only with fill: file, but fill is " + kind + ".",
                       "Write fill: file, or remove this key.");
    const std::filesystem::path file = std::filesystem::path(scene.folder) / bed.text("file");
    try {
      refuse_folder(file.lexically_normal(), {"particle file", {".csv", ".vtp", ".data"}, ""});
    } catch (const InputError& error) {
      throw InputError(bed.mark("file"), bed.path("file"), error.what());
    }
    std::error_code problem;
    if (!std::filesystem::is_regular_file(file, problem))
      throw InputError(bed.mark("file"), bed.path("file"), "there is no file " + file.lexically_normal().string() + ".",
                       "A relative path starts at the case's folder.");
    fill.file = file.lexically_normal().string();
  } else if (fill.kind == FillKind::file) {
    throw InputError(bed.mark("fill"), bed.path("fill"), "fill: file needs to know which file.",
                     "Add for example file: bed.csv.");
  }
  if (bed.given("height")) fill.height = bed.quantity("height");
  fill.seed = static_cast<std::uint64_t>(bed.integer("seed"));
  fill.cache = bed.flag("cache");
}

/// Extents along the two axes that are not `normal`: as given, else the whole domain.
void read_extents(const Section& section, const RealScene& scene, Axis normal, std::array<Interval, 3>& extent,
                  std::array<SourceMark, 3>& marks) {
  for (const Axis axis : k_axes) {
    const std::string key = letter(axis);
    marks[index(axis)] = section.mark(key);
    if (axis == normal || !section.given(key)) {
      extent[index(axis)] = {0, scene.size[index(axis)]};
    } else {
      const auto [low, high] = section.interval(key);
      extent[index(axis)] = {low, high};
    }
  }
}

Patch read_patch(const std::string& name, const Section& section, const RealScene& scene) {
  Patch patch;
  patch.name = name;
  patch.face = face_of(section.choice("face"));
  patch.mark = section.mark();
  patch.rest = section.flag("rest");
  const std::string face = face_name(patch.face);
  for (const Axis axis : k_axes) {
    const std::string key = letter(axis);
    if (!section.given(key)) continue;
    if (axis == patch.face.axis)
      throw InputError(section.mark(key), section.path(key), "the " + face + " face has no extent along " + key + ".",
                       "Remove this key; a patch on this face extends along " +
                           std::string(axis == Axis::x   ? "y and z"
                                       : axis == Axis::y ? "x and z"
                                                         : "x and y") +
                           ".");
    if (patch.rest)
      throw InputError(section.mark(key), section.path(key),
                       "a patch with rest: true takes what other patches leave, so it has no extent of its own.",
                       "Remove this key, or rest: true.");
  }
  read_extents(section, scene, patch.face.axis, patch.extent, patch.extent_mark);
  const double plane = patch.face.side == Side::low ? 0 : scene.size[index(patch.face.axis)];
  patch.extent[index(patch.face.axis)] = {plane, plane};

  if (section.given("velocity") == section.given("pressure"))
    throw InputError(section.mark(), section.path(),
                     section.given("velocity") ? "a patch has a velocity or a pressure, not both."
                                               : "a patch needs a velocity (inlet) or a pressure (opening).",
                     "Write for example velocity: 1 m/s, or pressure: 0 Pa.");
  if (section.given("velocity")) {
    patch.kind = PatchKind::velocity;
    patch.velocity = section.quantity("velocity");
    patch.ramp = section.quantity("ramp");
  } else {
    patch.kind = PatchKind::pressure;
    patch.pressure = section.quantity("pressure");
    if (section.given("ramp"))
      throw InputError(section.mark("ramp"), section.path("ramp"), "only an inlet (velocity) has a ramp.",
                       "Remove this key.");
  }
  return patch;
}

void read_baffles(const std::string& name, const Section& section, RealScene& scene) {
  std::vector<Axis> normals;
  for (const Axis axis : k_axes)
    if (section.given("at_" + letter(axis))) normals.push_back(axis);
  if (normals.size() != 1)
    throw InputError(section.mark(), section.path(),
                     normals.empty() ? "the plate has no position." : "the plate has positions along two axes.",
                     "Give one of at_x, at_y, at_z: the position of its mid-plane.");
  const Axis normal = normals[0];
  const std::string at = "at_" + letter(normal);
  if (section.given(letter(normal)))
    throw InputError(
        section.mark(letter(normal)), section.path(letter(normal)),
        "a plate normal to " + letter(normal) + " has no extent along it; " + at + " says where it stands.",
        "Remove this key; the thickness has a key of its own.");
  Baffle baffle;
  baffle.normal = normal;
  baffle.thickness = section.quantity("thickness");
  baffle.mark = section.mark();
  read_extents(section, scene, normal, baffle.extent, baffle.extent_mark);
  const std::vector<double> positions = section.positions(at);
  const DocumentNode& node = *section.node(at);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    baffle.name = node.is_list() ? name + "." + std::to_string(i) : name;
    baffle.position = positions[i];
    baffle.extent[index(normal)] = {positions[i], positions[i]};
    baffle.extent_mark[index(normal)] = node.is_list() ? node.items[i].mark : node.mark;
    scene.baffles.push_back(baffle);
  }
}

void read_walls(const Section& walls, RealScene& scene) {
  for (const Axis axis : k_axes) {
    for (const Side side : {Side::low, Side::high}) {
      const std::string face = face_name({axis, side});
      if (scene.periodic[index(axis)] && walls.given(face))
        throw InputError(walls.mark(face), walls.path(face),
                         "the domain is periodic along " + letter(axis) + ", so it has no " + face + " wall.",
                         "Remove this key.");
      scene.walls[index(axis)][static_cast<std::size_t>(side)] =
          walls.choice(face) == "slip" ? WallKind::slip : WallKind::no_slip;
    }
  }
}

void read_periodic(const Section& section, RealScene& scene) {
  const DocumentNode* list = section.node("periodic");
  const std::vector<std::string> words = section.texts("periodic");
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string axis = read_choice(list->items[i], section.path("periodic"), {"x", "y", "z"});
    scene.periodic[static_cast<std::size_t>(axis[0] - 'x')] = true;
  }
}

}  // namespace

void read_scene(const Section& section, RealScene& scene) {
  const Section domain = section.section("domain");
  scene.size = domain.box("size");
  scene.cell = domain.box("cell");
  read_periodic(section, scene);
  scene.gravity = section.box("gravity");
  read_walls(section.section("walls"), scene);

  const Section gas = section.section("gas");
  scene.gas_density = gas.quantity("density");
  scene.gas_viscosity = gas.quantity("viscosity");

  read_particles(section, scene);
  read_bed(section.section("bed"), scene, scene.bed);
  for (const auto& [name, patch] : section.named("patches")) scene.patches.push_back(read_patch(name, patch, scene));
  for (const auto& [name, baffle] : section.named("baffles")) read_baffles(name, baffle, scene);
}

void read_coupling(const Section& section, RealScene& scene) {
  if (section.given("smoothing")) scene.smoothing_length = section.quantity("smoothing");
}

void read_time(const Section& section, RealScene& scene) {
  scene.time.end = section.quantity("end");
  scene.time.dt = section.quantity_or_auto("dt");
  scene.time.gas_dt = section.quantity_or_auto("gas_dt");
  scene.time.mark = section.mark();
  scene.time.dt_mark = section.mark("dt");
  scene.time.gas_dt_mark = section.mark("gas_dt");
}

void read_output(const Section& section, RealScene& scene) {
  scene.output.vtk_every = section.every("vtk");
  scene.output.monitor_every = section.every("monitors");
  for (const auto& [name, probe] : section.named("probes")) scene.output.probes.push_back({name, probe.box("at")});
  scene.output.checkpoint_every = section.every("checkpoint");
  if (!section.given("profiles")) return;
  const Section profiles = section.section("profiles");
  scene.output.profiles.z = profiles.positions("z");
  scene.output.profiles.from = profiles.quantity("from");
}

}  // namespace similitude
