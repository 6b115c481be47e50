#include "scene/case_keys.h"

#include <array>

namespace similitude {

KeyTable case_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "similitude", .form = Form::integer, .required = true, .doc = "version of the case format: 1"},
      CaseKey{.name = "title", .form = Form::text, .doc = "one line for reports; the file's name if left out"},
      CaseKey{.name = "plugin_paths",
              .form = Form::texts,
              .default_text = "[]",
              .doc = "folders searched for plugins before all others, from the case's folder"},
      CaseKey{.name = "scene", .form = Form::section, .required = true, .doc = "the real bed", .table = scene_keys},
      CaseKey{.name = "models",
              .form = Form::section,
              .required = true,
              .doc = "which plugins, with their parameters",
              .table = models_keys},
      CaseKey{.name = "coupling",
              .form = Form::section,
              .doc = "exchange between particles and gas",
              .table = coupling_keys},
      CaseKey{.name = "time", .form = Form::section, .required = true, .doc = "real-bed times", .table = time_keys},
      CaseKey{.name = "output",
              .form = Form::section,
              .doc = "what is written, in real-bed times and lengths",
              .table = output_keys},
  };
  return keys;
}

KeyTable scene_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "domain",
              .form = Form::section,
              .required = true,
              .doc = "the box and its cells",
              .table = domain_keys},
      CaseKey{.name = "gas", .form = Form::section, .required = true, .doc = "the gas", .table = gas_keys},
      CaseKey{.name = "particles",
              .form = Form::named_sections,
              .doc = "classes of spheres by name",
              .table = particle_keys},
      CaseKey{.name = "bed",
              .form = Form::section,
              .doc = "how the particles come to lie in the domain",
              .table = bed_keys},
      CaseKey{
          .name = "patches", .form = Form::named_sections, .doc = "inlets and openings by name", .table = patch_keys},
      CaseKey{.name = "baffles",
              .form = Form::named_sections,
              .doc = "thin plates inside the bed by name",
              .table = baffle_keys},
      CaseKey{.name = "walls",
              .form = Form::section,
              .doc = "what the faces without patches are to the gas",
              .table = wall_keys},
      CaseKey{.name = "periodic",
              .form = Form::axes,
              .default_text = "[]",
              .doc = "directions in which the domain repeats"},
      CaseKey{.name = "gravity",
              .form = Form::gravity,
              .unit = "m/s^2",
              .default_text = "9.81 m/s^2",
              .doc = "downward if one value, a vector if three"},
  };
  return keys;
}

KeyTable domain_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "size",
              .form = Form::box,
              .unit = "mm",
              .sign = Sign::positive,
              .required = true,
              .doc = "width (x), depth (y) and height (z)"},
      CaseKey{.name = "cell",
              .form = Form::box_or_cube,
              .unit = "mm",
              .sign = Sign::positive,
              .required = true,
              .doc = "edge of a gas cell; the size is a whole number of cells"},
  };
  return keys;
}

KeyTable gas_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "density",
              .form = Form::quantity,
              .unit = "kg/m^3",
              .sign = Sign::positive,
              .required = true,
              .doc = "density"},
      CaseKey{.name = "viscosity",
              .form = Form::quantity,
              .unit = "Pa s",
              .sign = Sign::positive,
              .required = true,
              .doc = "dynamic viscosity"},
  };
  return keys;
}

KeyTable particle_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "diameter",
              .form = Form::quantity,
              .unit = "mm",
              .sign = Sign::positive,
              .required = true,
              .doc = "diameter"},
      CaseKey{.name = "density",
              .form = Form::quantity,
              .unit = "kg/m^3",
              .sign = Sign::positive,
              .required = true,
              .doc = "density of one particle"},
      CaseKey{.name = "count",
              .form = Form::integer,
              .sign = Sign::positive,
              .doc = "how many in the real bed; left out with bed.height or fill: file"},
  };
  return keys;
}

KeyTable bed_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "fill",
              .form = Form::choice,
              .default_text = "settle",
              .doc = "settle: rain and let come to rest; lattice: placed and left; file: read; none: no particles",
              .choices = "settle|lattice|file|none"},
      CaseKey{.name = "file",
              .form = Form::text,
              .doc = "with fill: file. CSV, VTP or LAMMPS data, from the case's folder"},
      CaseKey{.name = "height",
              .form = Form::quantity,
              .unit = "mm",
              .sign = Sign::positive,
              .doc = "fill to this height instead of a count"},
      CaseKey{.name = "seed",
              .form = Form::integer,
              .sign = Sign::not_negative,
              .default_text = "1",
              .doc = "of the jitter of the first positions"},
      CaseKey{
          .name = "cache", .form = Form::flag, .default_text = "true", .doc = "keep the settled bed and use it again"},
  };
  return keys;
}

KeyTable patch_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "face",
              .form = Form::choice,
              .required = true,
              .doc = "which face of the domain it lies on",
              .choices = "left|right|front|back|bottom|top"},
      CaseKey{.name = "x", .form = Form::interval, .unit = "mm", .doc = "extent along x; the whole face if left out"},
      CaseKey{.name = "y", .form = Form::interval, .unit = "mm", .doc = "extent along y; the whole face if left out"},
      CaseKey{.name = "z", .form = Form::interval, .unit = "mm", .doc = "extent along z; the whole face if left out"},
      CaseKey{.name = "rest",
              .form = Form::flag,
              .default_text = "false",
              .doc = "covers what no other patch of the face covers"},
      CaseKey{.name = "velocity",
              .form = Form::quantity,
              .unit = "m/s",
              .doc = "an inlet: superficial velocity into the domain; a wall to particles"},
      CaseKey{.name = "ramp",
              .form = Form::quantity,
              .unit = "ms",
              .sign = Sign::not_negative,
              .default_text = "50 ms",
              .doc = "time in which the velocity grows from zero"},
      CaseKey{.name = "pressure",
              .form = Form::quantity,
              .unit = "Pa",
              .doc = "an opening, also to particles: pressure above the gas's own weight"},
  };
  return keys;
}

KeyTable baffle_keys() {
  static constexpr std::array keys{
      CaseKey{
          .name = "at_x", .form = Form::positions, .unit = "mm", .doc = "mid-plane of a plate normal to x, or several"},
      CaseKey{
          .name = "at_y", .form = Form::positions, .unit = "mm", .doc = "mid-plane of a plate normal to y, or several"},
      CaseKey{
          .name = "at_z", .form = Form::positions, .unit = "mm", .doc = "mid-plane of a plate normal to z, or several"},
      CaseKey{.name = "x", .form = Form::interval, .unit = "mm", .doc = "extent along x; the whole domain if left out"},
      CaseKey{.name = "y", .form = Form::interval, .unit = "mm", .doc = "extent along y; the whole domain if left out"},
      CaseKey{.name = "z", .form = Form::interval, .unit = "mm", .doc = "extent along z; the whole domain if left out"},
      CaseKey{.name = "thickness",
              .form = Form::quantity,
              .unit = "mm",
              .sign = Sign::positive,
              .default_text = "2 mm",
              .doc = "what particles see; the gas sees the mid-plane"},
  };
  return keys;
}

namespace {
constexpr CaseKey wall_key(std::string_view face) {
  return {.name = face,
          .form = Form::choice,
          .default_text = "no_slip",
          .doc = "wall to the gas",
          .choices = "no_slip|slip"};
}
}  // namespace

KeyTable wall_keys() {
  static constexpr std::array keys{wall_key("left"), wall_key("right"),  wall_key("front"),
                                   wall_key("back"), wall_key("bottom"), wall_key("top")};
  return keys;
}

KeyTable models_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "drag",
              .form = Form::model,
              .required = true,
              .doc = "force of the gas on a particle",
              .choices = "drag"},
      CaseKey{.name = "contact",
              .form = Form::model,
              .required = true,
              .doc = "force between particles",
              .choices = "contact"},
      CaseKey{.name = "fluid", .form = Form::model, .required = true, .doc = "gas solver", .choices = "fluid"},
      CaseKey{.name = "scaling",
              .form = Form::model,
              .default_text = "exact",
              .doc = "what is simulated instead of the real bed",
              .choices = "scaling"},
      CaseKey{.name = "effects",
              .form = Form::effects,
              .default_text = "auto",
              .doc = "auto: every effect decides whether this bed calls for it",
              .choices = "effect"},
  };
  return keys;
}

KeyTable coupling_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "smoothing",
              .form = Form::quantity,
              .unit = "mm",
              .sign = Sign::positive,
              .doc = "full width at half maximum of the smoothing of solids and exchange; three diameters of what is "
                     "simulated if left out"},
  };
  return keys;
}

KeyTable time_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "end",
              .form = Form::quantity,
              .unit = "s",
              .sign = Sign::positive,
              .required = true,
              .doc = "duration of the run"},
      CaseKey{.name = "dt",
              .form = Form::quantity_or_auto,
              .unit = "s",
              .sign = Sign::positive,
              .default_text = "auto",
              .doc = "sub-step of the particles"},
      CaseKey{.name = "gas_dt",
              .form = Form::quantity_or_auto,
              .unit = "s",
              .sign = Sign::positive,
              .default_text = "auto",
              .doc = "step of the gas"},
  };
  return keys;
}

KeyTable output_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "vtk",
              .form = Form::every_or_none,
              .unit = "ms",
              .sign = Sign::positive,
              .default_text = "every 50 ms",
              .doc = "particles and gas for ParaView"},
      CaseKey{.name = "monitors",
              .form = Form::every,
              .unit = "ms",
              .sign = Sign::positive,
              .default_text = "every 10 ms",
              .doc = "a row of monitors.csv"},
      CaseKey{.name = "checkpoint",
              .form = Form::every_or_none,
              .unit = "min",
              .sign = Sign::positive,
              .default_text = "every 10 min",
              .doc = "state to resume from; in wall-clock time, since it bounds what is lost"},
      CaseKey{.name = "profiles",
              .form = Form::section,
              .doc = "time-averaged particle velocity across the bed",
              .table = profile_keys},
      CaseKey{.name = "probes",
              .form = Form::named_sections,
              .doc = "places by name whose pressure, gas velocity and gas fraction are written with every row of monitors.csv",
              .table = probe_keys},
  };
  return keys;
}

KeyTable probe_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "at", .form = Form::box, .unit = "mm", .required = true, .doc = "place; its cell speaks for it"},
  };
  return keys;
}

KeyTable profile_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "z", .form = Form::positions, .unit = "mm", .required = true, .doc = "heights"},
      CaseKey{.name = "from",
              .form = Form::quantity,
              .unit = "s",
              .sign = Sign::not_negative,
              .default_text = "0 s",
              .doc = "start of the average"},
  };
  return keys;
}

const CaseKey& simulated_stiffness_key() {
  static constexpr CaseKey key{.name = "stiffness",
                               .form = Form::quantity,
                               .unit = "N/m",
                               .sign = Sign::positive,
                               .doc = "spring stiffness of the simulated bed, in place of the scaled one"};
  return key;
}

const CaseKey& contact_pair_key() {
  static constexpr CaseKey key{.name = "pair",
                               .form = Form::named_sections,
                               .doc = "what differs between pairs of materials: two classes of particles, or a class and "
                                      "wall, joined by a hyphen"};
  return key;
}

}  // namespace similitude
