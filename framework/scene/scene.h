#pragma once
/// What is in a bed, in SI units. One shape, two types: the bed the user describes and the bed that is simulated
/// cannot be mixed up, because the compiler tells them apart.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace similitude {

struct RealBed {};
struct ModelBed {};

enum class Axis : int { x = 0, y = 1, z = 2 };
enum class Side : int { low = 0, high = 1 };

/// One of the six faces of the domain box: left/right (x), front/back (y), bottom/top (z).
struct Face {
  Axis axis = Axis::z;
  Side side = Side::low;
  bool operator==(const Face&) const = default;
};
std::string face_name(Face face);
char axis_name(Axis axis);

/// Where in a file a value was written, for messages.
struct SourceMark {
  std::string file;
  int line = 0, column = 0;   // from 1; 0: not from a file (a default or --set)
};

/// The value of a key that effects declare: a temperature, a mass fraction, a heat capacity. SI.
struct GivenValue {
  std::string name, unit;
  double value = 0;
  int scales_as = 0;                // SIMILITUDE_SCALES_...
  SourceMark mark;
};
using GivenValues = std::vector<GivenValue>;
/// NaN if it is not among them.
double value_of(const GivenValues& values, std::string_view name);

enum class WallKind { no_slip, slip };
enum class PatchKind { velocity, pressure };

struct Interval {
  double low = 0, high = 0;   // [m]
};

/// A rectangle of one face: an inlet of given superficial velocity, or an opening at given pressure.
struct Patch {
  std::string name;
  Face face;
  std::array<Interval, 3> extent;   // [m]; the face's own axis is a point
  bool rest = false;                // the cells of the face that no other patch covers
  PatchKind kind = PatchKind::velocity;
  double velocity = 0;              // [m/s], superficial, positive into the domain
  double ramp = 0;                  // [s]
  double pressure = 0;              // [Pa], above rho g.x
  GivenValues values;               // of gas that flows in
  SourceMark mark;
  std::array<SourceMark, 3> extent_mark;   // of the extent along each axis; the patch's own where it was left out
};

/// A thin plate inside the bed: particles see a box with rounded edges, the gas blocked faces at the mid-plane.
struct Baffle {
  std::string name;
  Axis normal = Axis::x;
  double position = 0;              // [m], mid-plane, on a cell face
  std::array<Interval, 3> extent;   // [m]; the normal axis is a point
  double thickness = 0;             // [m]
  SourceMark mark;
  std::array<SourceMark, 3> extent_mark;   // of the extent along each axis (normal axis: of the position)
};

/// What the rows of a bed's file are of one class: relative to a particle of the class, so that it holds in both beds.
struct FileRows {
  std::int64_t count = 0;
  double volume = 0;                // [-], of all rows together
  double least_mass = 1;            // [-], of the lightest row; 1 where there is none
  double diameter_of_lightest = 1;  // [-]
  double least_diameter = 1;        // [-], of the smallest row
  double least_density = 1;         // [-]
  double largest_density = 1;       // [-]
};

struct ParticleClass {
  std::string name;
  double diameter = 0;              // [m], what touches
  double drag_diameter = 0;         // [m], what drag laws see (differs for parcels)
  double material_diameter = 0;     // [m], of the real particle, in this bed's lengths where it differs from `diameter`
  double density = 0;               // [kg/m^3]
  double weight = 1;                // physical particles that one simulated particle stands for
  std::optional<std::int64_t> count;   // how many are wanted
  std::optional<FileRows> rows;     // of a bed from a file, once it is read: see particles/bed_file.h
  GivenValues values;

  /// How many the bed's file holds, or the case asks for; 0: not known.
  double known_count() const { return static_cast<double>(rows ? rows->count : count.value_or(0)); }
  /// How many spheres of the class's own diameter have the volume of all these; 0: not known.
  double spheres_alike() const { return rows ? rows->volume : known_count(); }
};

enum class FillKind { settle, lattice, file, none };

struct BedFill {
  FillKind kind = FillKind::settle;
  std::string file;                 // CSV, VTP or LAMMPS data; absolute
  std::optional<double> height;     // [m], fill to this height instead of a count
  std::uint64_t seed = 1;           // of the lattice's jitter
  bool cache = true;                // keep and reuse the settled bed
  SourceMark mark;
};

/// One parameter of a model as resolved against the model's own table: SI, real bed (or simulated, after scaling).
struct ModelParameter {
  std::string name;
  double real = 0;                  // of reals, integers and flags; NaN: not given
  std::string text;                 // of choices
  int scales_as = 0;                // SIMILITUDE_SCALES_...
  bool given = false;               // by the case, not a default
};

/// A plugin chosen by the case, with all its parameters in the order of its table.
struct ModelChoice {
  std::string kind, id;
  std::vector<ModelParameter> parameters;
  SourceMark mark;
};

struct Models {
  ModelChoice drag, contact, fluid, scaling;
  /// The contact model's parameters for each pair of materials, in the order of material_pairs(); `contact` then holds what
  /// is common to them. Empty: `contact` for all.
  std::vector<ModelChoice> contact_pairs;
  std::vector<ModelChoice> effects;
  bool effects_auto = true;
  std::optional<double> simulated_stiffness;   // [N/m], models.scaling.stiffness: replaces every scaled spring stiffness
};

struct TimeControl {
  double end = 0;                   // [s]
  std::optional<double> dt;         // [s], DEM sub-step; empty: auto
  std::optional<double> gas_dt;     // [s], empty: auto
  SourceMark mark, dt_mark, gas_dt_mark;
};

struct ProfileOutput {
  std::vector<double> z;            // [m], heights
  double from = 0;                  // [s], averaging starts
};

/// A place whose gas is written along the run.
struct Probe {
  std::string name;
  std::array<double, 3> place{};    // [m]
};

struct Output {
  double vtk_every = 0;             // [s]; 0: no VTK
  double monitor_every = 0;         // [s]
  double checkpoint_every = 0;      // [s] of wall-clock time, the same for both beds; 0: none
  ProfileOutput profiles;
  std::vector<Probe> probes;
};

template <class Bed>
struct Scene {
  std::string title;
  std::string name;                                 // of the case: the file's stem
  std::string folder;                               // of the case file; relative paths start here
  std::array<double, 3> size{};                     // [m], the domain is [0, size]
  std::array<double, 3> cell{};                     // [m]
  std::array<bool, 3> periodic{};
  std::array<double, 3> gravity{0, 0, -9.81};       // [m/s^2]
  std::array<std::array<WallKind, 2>, 3> walls{};   // for the gas, by axis and side
  double gas_density = 0;                           // [kg/m^3]
  double gas_viscosity = 0;                         // [Pa s]
  GivenValues gas_values, wall_values;
  std::vector<ParticleClass> particles;
  BedFill bed;
  std::vector<Patch> patches;
  std::vector<Baffle> baffles;
  std::optional<double> smoothing_length;           // [m], full width at half maximum; empty: 3 diameters
  Models models;
  TimeControl time;
  Output output;
};

/// [m], of what touches; 0 without particles.
template <class Bed>
double largest_diameter(const Scene<Bed>& scene) {
  double largest = 0;
  for (const ParticleClass& species : scene.particles) largest = species.diameter > largest ? species.diameter : largest;
  return largest;
}

using RealScene = Scene<RealBed>;
using ModelScene = Scene<ModelBed>;

}  // namespace similitude
