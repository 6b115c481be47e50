#pragma once
/// The numbers by which an engineer knows a bed, and what in them no run of it can follow. Of a case, before it runs.

#include <string>
#include <vector>

#include "stepper/assembly.h"

namespace similitude {

/// Of one particle class of the real bed.
struct ClassNumbers {
  std::string name;
  double count = 0;                  // 0: not known before a file is read
  double minimum_fluidisation = 0;   // [m/s], superficial, Ergun; NaN here and below where there is none
  double terminal_velocity = 0;      // [m/s], Schiller-Naumann
};

struct BedNumbers {
  std::vector<ClassNumbers> classes;
  double pressure = 0;               // [Pa], buoyant weight over the bottom's area; 0: unknown
  double height = 0;                 // [m], settled, about; 0: unknown
  double cell_over_diameter = 0;     // [-], smallest cell over largest particle
};
BedNumbers bed_numbers(const RealScene& scene);
/// "1000 x glass, 171 Pa, about 15 mm settled, u_mf 0.333 m/s (Ergun), …" in one line; empty without particles.
std::string in_words(const BedNumbers& numbers);

/// Largest overlaps over the diameter that springs without damping would see, from the contact law's own contact times: the
/// bottom grains of the bed at rest, each under a column of one diameter's width that no wall helps to carry, and a grain that falls the bed's height onto
/// another. 0: unknown, as for a law whose partners never part.
struct PredictedOverlap {
  double at_rest = 0, in_a_fall = 0;
  double exponent = 1;   // p of force ~ overlap^p: 1 linear, 3/2 Hertz
};
PredictedOverlap predicted_overlap(const Assembly& assembly);

/// What can be written in a case but not be simulated as it is meant: inlets near the speed of sound, inlets that suck, springs
/// that the bed's own weight or fall presses in. Each with its place, as InputError's.
std::vector<std::string> bed_warnings(const Assembly& assembly);

}  // namespace similitude
