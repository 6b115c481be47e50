#pragma once
/// Forces of all contacts of one brick: overlap test over the lists, touching contacts gathered into blocks of columns,
/// the law called once per block, forces and torques scattered back to rows.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <similitude/abi.h>

#include "loader/catalogue.h"
#include "particles/contact_effects.h"
#include "particles/contact_lists.h"
#include "particles/store.h"
#include "particles/surfaces.h"

namespace similitude {

/// Rows of a block: its columns fit the first-level cache beside the rows they come from.
constexpr std::uint32_t k_block_rows = 128;

/// Candidates that are looked at before those of them that touch are handed to the law.
constexpr std::uint32_t k_window = 512;

/// One block's columns, a thread's own. Columns that a law does not need stay untouched.
struct alignas(64) BlockColumns {
  using Numbers = double[k_block_rows];
  alignas(64) Numbers normal[3], overlap, velocity[3], angular_velocity_i[3], angular_velocity_j[3], radius_i, radius_j;
  alignas(64) Numbers effective_mass, lever_i, lever_j, force[3], couple[3], history[k_most_history];
  alignas(64) Numbers law_overlap, law_force[3];   // only where effects have a contact pass
  // Touching candidates, filled up with copies to a whole block multiple; room for one pack more.
  std::uint32_t candidate[k_block_rows + 8];
  std::uint32_t due[k_window + 8];                // candidates to look at
  alignas(64) std::uint32_t pair[k_block_rows];   // parameter set; of laws with several
};

/// The deepest contact so far, as seen by one brick.
struct DeepestContact {
  double twice_ratio = 0;             // [-], overlap over the smaller radius
  std::uint32_t owner = 0, partner = 0;   // rows (of the present order)
  bool surface = false;               // the partner is a surface
  std::array<double, 3> place{};      // [m], of the owner
};

/// What the law said, if it said anything.
struct LawComplaint {
  bool raised = false;
  std::uint32_t brick = 0;
  std::uint32_t owner = 0;            // row, or ~0 if the law named none
  std::string text;
  const char* effect = nullptr;       // its id, if it was an effect and not the law
};

class ContactPass {
 public:
  /// `classes` of particles in the scene. Throws std::invalid_argument if the law needs rotation and the store has none, or if
  /// it has several parameter sets but not one for each pair of materials.
  ContactPass(ParticleStore& particles, const ContactModel& law, const ContactEffects& effects, std::size_t classes,
              const Surfaces& surfaces, const Bricks& bricks, ContactLists& lists);

  /// [m], of the law, and of the farthest of law and effects.
  void set_reach(double of_law, double reach) {
    law_reach_ = of_law;
    reach_ = reach;
  }
  void make_room();                                  // for the slots of the present lists
  std::size_t bytes() const { return (share_force_.capacity() + share_torque_.capacity()) * sizeof(Row); }

  /// Zeroes the rows' force and torque, then adds what contacts owned by this brick do inside it; shares of partners in
  /// other bricks go to slots. Returns the number of touching contacts. [worker]
  std::size_t pairs(std::uint32_t brick, double dt, BlockColumns& scratch, DeepestContact& deepest, LawComplaint& complaint);
  /// The same for walls and baffles; `push` becomes the sum of their forces [N]. [worker]
  std::size_t surfaces(std::uint32_t brick, double dt, BlockColumns& scratch, Row& push, DeepestContact& deepest,
                       LawComplaint& complaint);
  /// Adds the shares that earlier bricks left for this one, in fixed order. [worker], after pairs() of all bricks.
  void collect_shares(std::uint32_t brick);

 private:
  struct Run;
  template <bool Rotation, bool Periodic>
  void gather(Run& run);
  template <bool Rotation, bool Across>
  void scatter(Run& run);
  template <bool Rotation, bool Periodic, bool Across>
  std::size_t piece(const Piece& piece, double approach, Run& run);
  template <bool Rotation, bool Periodic>
  std::size_t both_pieces(Run& run);
  template <bool Rotation>
  std::size_t surface_piece(Run& run, Row& push);
  template <bool Rotation>
  void gather_surface(Run& run, std::uint32_t candidate, const SurfaceTouch& touch);
  template <bool Rotation>
  void scatter_surfaces(Run& run, Row& push);
  void gather_history(Run& run, std::uint32_t first);
  void scatter_history(Run& run);
  void fill_up(Run& run);
  void name_pairs(Run& run);
  void name_pairs_with_wall(Run& run);
  void call_law(Run& run);
  template <bool Periodic>
  void look(const std::uint32_t* candidates, float so_far);
  template <bool Periodic>
  void look_at_due(std::uint32_t begin, std::uint32_t end, double approach, Run& run);
  void part(Run& run, std::uint32_t first, unsigned touching);
  void note_deepest(Run& run, std::uint32_t first, unsigned lanes);
  void forget(std::uint32_t candidate);

  ParticleStore& particles_;
  const ContactModel& law_;
  const ContactEffects& effects_;
  const Surfaces& surfaces_;
  const Bricks& bricks_;
  ContactLists& lists_;
  similitude_contact_needs needs_{};        // of law and effects together, but for history: the law's
  bool law_couple_ = false;
  std::size_t materials_ = 1;               // classes of particles and the wall
  std::vector<std::uint32_t> pair_of_;      // parameter set by both materials; empty: one set for all
  double reach_ = 0, law_reach_ = 0;
  Column<Row> share_force_, share_torque_;   // per slot: what the partner feels
};

}  // namespace similitude
