#pragma once
/// The discrete element method: neighbour lists, contacts in blocks, walls, integration. One call advances all particles
/// by a number of sub-steps.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "particles/budget.h"
#include "particles/store.h"
#include "particles/touching_contacts.h"
#include "scene/scene.h"

namespace similitude {

struct EngineOptions {
  double dt = 0;                               // [s]
  std::array<double, 3> gravity{};             // [m/s^2]; buoyancy comes with stress_force
  double skin = 0;                             // [m], 0: from the largest diameter and how often lists were rebuilt
  double velocity_damping = 0;                 // [1/s], for settling only
};

/// A particle that must stop the run, or a warning. Ids, not rows.
struct ContactExtreme {
  double overlap_ratio = 0;                    // [-], overlap over the smaller diameter
  std::uint64_t particle = 0, partner = 0;     // partner: id, or ~0 for a wall
  std::array<double, 3> place{};               // [m]
};

struct EngineReport {
  std::uint64_t particle_steps = 0;            // since construction
  std::uint64_t rebuilds = 0;
  std::uint64_t removed = 0;                   // left through outlets since construction
  double removed_mass = 0;                     // [kg], simulated
  double removed_volume = 0;                   // [m^3], of what the removed particles displaced, parcel weight not applied
  std::size_t contacts = 0;                    // touching pairs and wall contacts in the last sub-step
  ContactExtreme largest_overlap;              // since the last call of advance() began
  double largest_speed = 0;                    // [m/s], at the end of the last advance()
  ParticleBudget budget;                       // since construction
};

/// What an engine remembers between two calls of advance(), beside the store's rows. Lists are not in it: they are built
/// again from the positions they were built at.
struct EngineState {
  bool listed = false;                         // false: there are no lists yet, and nothing follows about them
  bool stale = true;                           // lists must be built before the next sub-step, whatever moved
  double cut_off = 0;                          // [m], of the cells that rows are sorted by
  double reach = 0, skin = 0;                  // [m]
  double skin_in_diameters = 0;                // [-]
  std::int64_t listed_at = 0, steps = 0;       // sub-steps
  Column<Row> reference;                       // positions when the lists were built [m], w: radius [m]
  TouchingContacts touching;
  EngineReport report;
};

/// [bytes] that an engine takes beside the store's rows. Candidates are what may touch; spare room is in what it takes for each.
struct EngineMemory {
  double lists_per_particle = 0;       // positions that lists were built at, and the order of rows
  double lists_per_candidate = 0;
  double lists_per_crossing = 0;       // a candidate whose partner stands in another brick
  double history_per_candidate = 0;
  double history_per_contact = 0;      // carried over a rebuild
};
/// `history_values` of law and effects together.
EngineMemory engine_memory(std::uint32_t history_values, bool rotation, bool periodic);

/// A stage's share of the time, for timing.json.
struct StageTime {
  std::string name;
  double seconds = 0;
};

class Engine {
 public:
  /// The scene gives walls, baffles, periodic directions and domain: six faces but for periodic ones; velocity patches are
  /// walls, pressure patches let particles out. Store, scene's bed and law stay alive with the engine. Throws
  /// std::invalid_argument if the law needs rotation and the store has none, or if its parameter sets are neither one for all
  /// nor one for each pair of the scene's materials. Of `effects`, which stay alive too, those with a contact pass act.
  Engine(ParticleStore& particles, const ModelScene& scene, const ContactModel& law, const EngineOptions& options,
         std::span<const EffectModel> effects = {});
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Advances by `sub_steps`. The same bits for any number of threads and however the steps are divided among calls.
  /// Sorts the store's rows and takes out particles that left through an outlet; between calls others may add rows at the
  /// end and change positions, velocities and gas rows, but not the order of rows. In a periodic direction a position may lie
  /// up to half a skin beyond the domain: it is brought back when rows are sorted. Throws SimulationError
  /// (particles/errors.h) on a non-finite position or velocity (with particle id, place and step) and with the law's own
  /// words, InputError if a periodic direction is too narrow for its particles.
  void advance(std::int64_t sub_steps);
  /// Changes dt or damping, e.g. when settling ends. History is kept.
  void set_options(const EngineOptions& options);

  /// Between two calls of advance(). A store with the same rows in the same order and restore() go on with the same bits as
  /// if nothing had been between, for any number of threads. [main]
  void save(EngineState& state) const;
  /// `particles` has been set to the rows of that instant. Throws std::invalid_argument if state and rows do not belong
  /// together.
  void restore(const EngineState& state);

  /// The contacts that touched in the last sub-step, in the order of the lists.
  void touching(TouchingContacts& out) const;

  const EngineReport& report() const;
  std::vector<StageTime> stage_times() const;
  /// The passes of a sub-step in order, for the printed pipeline.
  std::vector<std::string> passes() const;
  /// Bytes of lists, with the forces that pass between bricks, and of history, as allocated.
  std::size_t list_bytes() const;
  std::size_t history_bytes() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace similitude
