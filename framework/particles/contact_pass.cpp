#include "particles/contact_pass.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "particles/pack.h"
#include "scene/material_pairs.h"

namespace similitude {

using pack::V4;
using pack::V4x3;

namespace {

/// The approach at which two that are `distance` apart and touch at `touch_distance` must be looked at again. [m] Rounded down by
/// more than floats round the numbers it is made of; not below zero, which would say that they touch.
template <class F>
F next_look(F so_far, F distance, F touch_distance) {
  constexpr float rounding = 1e-6f;
  const F next = (so_far + (distance - touch_distance - rounding * touch_distance)) * (1 - rounding);
  return next > 0 ? next : F{};
}

}  // namespace

/// One brick's walk through its lists.
struct ContactPass::Run {
  const BrickLists& lists;
  double dt;
  BlockColumns& columns;
  DeepestContact& deepest;
  LawComplaint& complaint;
  std::uint32_t brick;
  std::uint32_t first_slot_candidate = 0;   // the candidate that slot lists.first_slot belongs to
  std::uint32_t rows = 0;                   // touching contacts gathered
  std::uint32_t padded = 0;                 // rows with copies
  std::uint32_t parted = 0;                 // of `rows`: what touched a sub-step ago and no longer does
};

ContactPass::ContactPass(ParticleStore& particles, const ContactModel& law, const ContactEffects& effects, std::size_t classes,
                         const Surfaces& surfaces, const Bricks& bricks, ContactLists& lists)
    : particles_(particles), law_(law), effects_(effects), surfaces_(surfaces), bricks_(bricks), lists_(lists), materials_(classes + 1) {
  needs_.struct_size = sizeof(needs_);
  law.functions().needs(law.instance(), &needs_);
  law_couple_ = needs_.couple != 0;
  needs_.rotation = needs_.rotation || effects.rotation();
  needs_.couple = needs_.couple || effects.couple();
  if (needs_.rotation && !particles.fields.rotation) {
    throw std::invalid_argument("the contact law needs angular velocities: make the ParticleStore with fields.rotation");
  }
  if (law.sets() == 1) return;
  const std::vector<MaterialPair> pairs = material_pairs(classes);
  if (law.sets() != pairs.size()) {
    throw std::invalid_argument("the contact law has " + std::to_string(law.sets()) + " parameter sets for " +
                                std::to_string(pairs.size()) + " pairs of materials");
  }
  pair_of_.resize(materials_ * materials_);
  for (std::uint32_t set = 0; set < pairs.size(); ++set) {
    pair_of_[pairs[set].first * materials_ + pairs[set].second] = set;
    pair_of_[pairs[set].second * materials_ + pairs[set].first] = set;
  }
}

void ContactPass::make_room() {
  if (share_force_.size() >= lists_.slots) return;
  const std::size_t room = lists_.slots + lists_.slots / 4;
  share_force_.resize(room);
  if (needs_.rotation) share_torque_.resize(room);
}

void ContactPass::forget(std::uint32_t candidate) {
  const std::size_t rows = lists_.history_rows();
  for (std::size_t r = 0; r < rows; ++r) lists_.history[candidate * rows + r] = {};
}

// ------------------------------------------------------------------------------------------------ rows to columns

void ContactPass::gather_history(Run& run, std::uint32_t first) {
  const std::size_t rows = lists_.history_rows();
  const std::uint32_t* k = run.columns.candidate + first;
  for (std::size_t r = 0; r < rows; ++r) {
    const Row* history = lists_.history.data() + r;
    V4 a = pack::load(history[k[0] * rows]), b = pack::load(history[k[1] * rows]);
    V4 c = pack::load(history[k[2] * rows]), d = pack::load(history[k[3] * rows]);
    pack::transpose(a, b, c, d);
    pack::store(run.columns.history[4 * r] + first, a);
    pack::store(run.columns.history[4 * r + 1] + first, b);
    pack::store(run.columns.history[4 * r + 2] + first, c);
    pack::store(run.columns.history[4 * r + 3] + first, d);
  }
}

void ContactPass::scatter_history(Run& run) {
  const std::size_t rows = lists_.history_rows();
  for (std::size_t r = 0; r < rows; ++r) {
    Row* history = lists_.history.data() + r;
    for (std::uint32_t first = 0; first < run.rows; first += 4) {
      const std::uint32_t* k = run.columns.candidate + first;
      V4 a = pack::load(run.columns.history[4 * r] + first), b = pack::load(run.columns.history[4 * r + 1] + first);
      V4 c = pack::load(run.columns.history[4 * r + 2] + first), d = pack::load(run.columns.history[4 * r + 3] + first);
      pack::transpose(a, b, c, d);
      // Copies that fill the last pack hold the last contact's own numbers: storing them again changes nothing.
      pack::store(history[k[0] * rows], a);
      pack::store(history[k[1] * rows], b);
      pack::store(history[k[2] * rows], c);
      pack::store(history[k[3] * rows], d);
    }
  }
}

template <bool Rotation, bool Periodic>
void ContactPass::gather(Run& run) {
  BlockColumns& out = run.columns;
  const Row* position = particles_.position.data();
  const Row* velocity = particles_.velocity.data();
  const Row* spin = particles_.angular_velocity.data();
  for (std::uint32_t first = 0; first < run.padded; first += 4) {
    const std::uint32_t* k = out.candidate + first;
    const Candidate c0 = lists_.candidates[k[0]], c1 = lists_.candidates[k[1]];
    const Candidate c2 = lists_.candidates[k[2]], c3 = lists_.candidates[k[3]];

    const V4 pi0 = pack::load(position[c0.owner]), pj0 = pack::load(position[c0.partner]);
    const V4 pi1 = pack::load(position[c1.owner]), pj1 = pack::load(position[c1.partner]);
    const V4 pi2 = pack::load(position[c2.owner]), pj2 = pack::load(position[c2.partner]);
    const V4 pi3 = pack::load(position[c3.owner]), pj3 = pack::load(position[c3.partner]);
    V4 x = pi0 - pj0, y = pi1 - pj1, z = pi2 - pj2, rest = pi3 - pj3;
    if constexpr (Periodic) {
      x -= pack::load(bricks_.shift(lists_.image[k[0]]));
      y -= pack::load(bricks_.shift(lists_.image[k[1]]));
      z -= pack::load(bricks_.shift(lists_.image[k[2]]));
      rest -= pack::load(bricks_.shift(lists_.image[k[3]]));
    }
    pack::transpose(x, y, z, rest);
    const V4 radius_i = pack::fourth(pi0, pi1, pi2, pi3), radius_j = pack::fourth(pj0, pj1, pj2, pj3);
    const V4 distance_squared = x * x + y * y + z * z;
    const V4 distance = pack::square_root(distance_squared);
    const V4 per_distance = 1.0 / distance;
    const V4x3 normal{x * per_distance, y * per_distance, z * per_distance};
    const V4 radii = radius_i + radius_j;
    const V4 overlap = radii - distance;
    const V4 limit = radii + pack::all(reach_);
    const unsigned touching = pack::bits(distance_squared < limit * limit);
    const V4 lever_i = distance * (radius_i / radii);
    const V4 lever_j = distance - lever_i;   // their sum is the distance: angular momentum is conserved
    pack::store(out.normal[0] + first, normal.x);
    pack::store(out.normal[1] + first, normal.y);
    pack::store(out.normal[2] + first, normal.z);
    pack::store(out.overlap + first, overlap);
    pack::store(out.radius_i + first, radius_i);
    pack::store(out.radius_j + first, radius_j);
    pack::store(out.lever_i + first, lever_i);
    pack::store(out.lever_j + first, lever_j);

    const V4 vi0 = pack::load(velocity[c0.owner]), vj0 = pack::load(velocity[c0.partner]);
    const V4 vi1 = pack::load(velocity[c1.owner]), vj1 = pack::load(velocity[c1.partner]);
    const V4 vi2 = pack::load(velocity[c2.owner]), vj2 = pack::load(velocity[c2.partner]);
    const V4 vi3 = pack::load(velocity[c3.owner]), vj3 = pack::load(velocity[c3.partner]);
    V4x3 slip{vi0 - vj0, vi1 - vj1, vi2 - vj2};
    rest = vi3 - vj3;
    pack::transpose(slip.x, slip.y, slip.z, rest);
    const V4 mass_i = pack::fourth(vi0, vi1, vi2, vi3), mass_j = pack::fourth(vj0, vj1, vj2, vj3);
    pack::store(out.effective_mass + first, mass_i * mass_j / (mass_i + mass_j));

    if constexpr (Rotation) {
      V4x3 wi{pack::load(spin[c0.owner]), pack::load(spin[c1.owner]), pack::load(spin[c2.owner])};
      rest = pack::load(spin[c3.owner]);
      pack::transpose(wi.x, wi.y, wi.z, rest);
      V4x3 wj{pack::load(spin[c0.partner]), pack::load(spin[c1.partner]), pack::load(spin[c2.partner])};
      rest = pack::load(spin[c3.partner]);
      pack::transpose(wj.x, wj.y, wj.z, rest);
      pack::store(out.angular_velocity_i[0] + first, wi.x);
      pack::store(out.angular_velocity_i[1] + first, wi.y);
      pack::store(out.angular_velocity_i[2] + first, wi.z);
      pack::store(out.angular_velocity_j[0] + first, wj.x);
      pack::store(out.angular_velocity_j[1] + first, wj.y);
      pack::store(out.angular_velocity_j[2] + first, wj.z);
      // v_i - v_j + w_i x (-l_i n) - w_j x (l_j n)
      const V4x3 roll = pack::cross(normal, {lever_i * wi.x + lever_j * wj.x, lever_i * wi.y + lever_j * wj.y,
                                             lever_i * wi.z + lever_j * wj.z});
      slip = {slip.x + roll.x, slip.y + roll.y, slip.z + roll.z};
    }
    pack::store(out.velocity[0] + first, slip.x);
    pack::store(out.velocity[1] + first, slip.y);
    pack::store(out.velocity[2] + first, slip.z);
    gather_history(run, first);

    const unsigned deeper = pack::bits(overlap > pack::all(run.deepest.twice_ratio) * pack::smaller(radius_i, radius_j));
    if (deeper != 0) [[unlikely]] note_deepest(run, first, deeper);
    if (touching != 0xf) [[unlikely]] part(run, first, touching);
  }
}

/// Contacts that parted stay in the block as what a law may meet, and what it says of them is left out.
void ContactPass::part(Run& run, std::uint32_t first, unsigned touching) {
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    if (touching >> lane & 1) continue;
    const std::uint32_t n = first + lane;
    run.columns.overlap[n] = -reach_;
    lists_.look_at[run.columns.candidate[n]] = ContactLists::k_look_now;
    run.parted += n < run.rows ? 1 : 0;
  }
}

void ContactPass::note_deepest(Run& run, std::uint32_t first, unsigned lanes) {
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    if ((lanes >> lane & 1) == 0) continue;
    const std::uint32_t n = first + lane;
    const double ratio = run.columns.overlap[n] / std::min(run.columns.radius_i[n], run.columns.radius_j[n]);
    if (!(ratio > run.deepest.twice_ratio)) continue;
    const Candidate& contact = lists_.candidates[run.columns.candidate[n]];
    const Row& place = particles_.position[contact.owner];
    run.deepest = {ratio, contact.owner, contact.partner, false, {place.x, place.y, place.z}};
  }
}

// ------------------------------------------------------------------------------------------------------- the law

void ContactPass::fill_up(Run& run) {
  constexpr std::uint32_t multiple = SIMILITUDE_ROW_MULTIPLE;
  run.padded = (run.rows + multiple - 1) / multiple * multiple;
  for (std::uint32_t n = run.rows; n < run.padded; ++n) run.columns.candidate[n] = run.columns.candidate[run.rows - 1];
}

void ContactPass::name_pairs(Run& run) {
  const std::uint32_t* species = particles_.species.data();
  for (std::uint32_t n = 0; n < run.padded; ++n) {
    const Candidate contact = lists_.candidates[run.columns.candidate[n]];
    run.columns.pair[n] = pair_of_[species[contact.owner] * materials_ + species[contact.partner]];
  }
}

void ContactPass::name_pairs_with_wall(Run& run) {
  const std::size_t wall = materials_ - 1;
  for (std::uint32_t n = 0; n < run.padded; ++n) {
    const std::uint32_t row = lists_.candidates[run.columns.candidate[n]].owner;
    run.columns.pair[n] = pair_of_[particles_.species[row] * materials_ + wall];
  }
}

void ContactPass::call_law(Run& run) {
  BlockColumns& c = run.columns;
  similitude_contact_block block{};
  block.struct_size = sizeof(block);
  block.rows = run.padded;
  block.dt = run.dt;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.normal[axis] = c.normal[axis];
    block.velocity[axis] = c.velocity[axis];
    block.angular_velocity_i[axis] = needs_.rotation ? c.angular_velocity_i[axis] : nullptr;
    block.angular_velocity_j[axis] = needs_.rotation ? c.angular_velocity_j[axis] : nullptr;
    block.force[axis] = c.force[axis];
    block.couple[axis] = law_couple_ ? c.couple[axis] : nullptr;
  }
  block.overlap = c.overlap;
  block.radius_i = c.radius_i;
  block.radius_j = c.radius_j;
  block.effective_mass = c.effective_mass;
  block.pair = pair_of_.empty() ? nullptr : c.pair;
  for (std::size_t h = 0; h < needs_.history_count; ++h) block.history[h] = c.history[h];
  similitude_status status;
  status.code = 0;
  status.row = -1;
  status.text[0] = 0;
  if (!effects_.empty() && reach_ > law_reach_) effects_.before_law(block, c, law_reach_);
  law_.functions().forces(law_.instance(), &block, &status);
  const char* blame = nullptr;
  if (!effects_.empty() && status.code == 0) effects_.after_law(block, c, law_reach_, status, blame);
  if (status.code != 0 && !run.complaint.raised) {
    const bool named = status.row >= 0 && static_cast<std::uint32_t>(status.row) < run.padded;
    const std::uint32_t nobody = ~0u;
    run.complaint = {true, run.brick, named ? lists_.candidates[c.candidate[status.row]].owner : nobody, status.text, blame};
  }
}

// ------------------------------------------------------------------------------------------------ columns to rows

template <bool Rotation, bool Across>
void ContactPass::scatter(Run& run) {
  const BlockColumns& in = run.columns;
  Row* force = particles_.force.data();
  Row* torque = particles_.torque.data();
  const V4 none = pack::all(0);
  for (std::uint32_t first = 0; first < run.rows; first += 4) {
    const V4x3 f{pack::load(in.force[0] + first), pack::load(in.force[1] + first), pack::load(in.force[2] + first)};
    V4 push[4] = {f.x, f.y, f.z, none};
    pack::transpose(push[0], push[1], push[2], push[3]);
    V4 turn_i[4], turn_j[4];
    if constexpr (Rotation) {
      const V4x3 n{pack::load(in.normal[0] + first), pack::load(in.normal[1] + first), pack::load(in.normal[2] + first)};
      const V4 lever_i = pack::load(in.lever_i + first), lever_j = pack::load(in.lever_j + first);
      const V4x3 moment = pack::cross(f, n);   // (-l_i n) x F = l_i F x n, and (l_j n) x (-F) = l_j F x n
      V4x3 ti{lever_i * moment.x, lever_i * moment.y, lever_i * moment.z};
      V4x3 tj{lever_j * moment.x, lever_j * moment.y, lever_j * moment.z};
      if (needs_.couple) {
        const V4x3 c{pack::load(in.couple[0] + first), pack::load(in.couple[1] + first), pack::load(in.couple[2] + first)};
        ti = {ti.x + c.x, ti.y + c.y, ti.z + c.z};
        tj = {tj.x - c.x, tj.y - c.y, tj.z - c.z};
      }
      turn_i[0] = ti.x, turn_i[1] = ti.y, turn_i[2] = ti.z, turn_i[3] = none;
      turn_j[0] = tj.x, turn_j[1] = tj.y, turn_j[2] = tj.z, turn_j[3] = none;
      pack::transpose(turn_i[0], turn_i[1], turn_i[2], turn_i[3]);
      pack::transpose(turn_j[0], turn_j[1], turn_j[2], turn_j[3]);
    }
    const std::uint32_t lanes = std::min(4u, run.rows - first);
    for (std::uint32_t lane = 0; lane < lanes; ++lane) {
      const std::uint32_t k = in.candidate[first + lane];
      if (!lists_.touches(k)) [[unlikely]] continue;
      const Candidate contact = lists_.candidates[k];
      pack::store(force[contact.owner], pack::load(force[contact.owner]) + push[lane]);
      if constexpr (Rotation) pack::store(torque[contact.owner], pack::load(torque[contact.owner]) + turn_i[lane]);
      if constexpr (Across) {
        const std::uint32_t slot = run.lists.first_slot + (k - run.first_slot_candidate);
        pack::store(share_force_[slot], -push[lane]);
        if constexpr (Rotation) pack::store(share_torque_[slot], turn_j[lane]);
      } else {
        pack::store(force[contact.partner], pack::load(force[contact.partner]) - push[lane]);
        if constexpr (Rotation) pack::store(torque[contact.partner], pack::load(torque[contact.partner]) + turn_j[lane]);
      }
    }
  }
  scatter_history(run);
}

void ContactPass::collect_shares(std::uint32_t brick) {
  for (std::uint32_t n = lists_.first_incoming[brick]; n < lists_.first_incoming[brick + 1]; ++n) {
    const Incoming& from = lists_.incoming[n];
    if (!lists_.touches(from.candidate)) continue;
    Row& force = particles_.force[from.row];
    pack::store(force, pack::load(force) + pack::load(share_force_[from.slot]));
    if (needs_.rotation) {
      Row& torque = particles_.torque[from.row];
      pack::store(torque, pack::load(torque) + pack::load(share_torque_[from.slot]));
    }
  }
}

// ------------------------------------------------------------------------------------------------ pairs of a brick

/// Looks at four candidates that did not touch in the last sub-step; the last of them may be copies.
template <bool Periodic>
void ContactPass::look(const std::uint32_t* k, float so_far) {
  const Row* position = particles_.position.data();
  const Candidate* candidates = lists_.candidates.data();
  const Candidate c0 = candidates[k[0]], c1 = candidates[k[1]], c2 = candidates[k[2]], c3 = candidates[k[3]];
  const V4 pi0 = pack::load(position[c0.owner]), pj0 = pack::load(position[c0.partner]);
  const V4 pi1 = pack::load(position[c1.owner]), pj1 = pack::load(position[c1.partner]);
  const V4 pi2 = pack::load(position[c2.owner]), pj2 = pack::load(position[c2.partner]);
  const V4 pi3 = pack::load(position[c3.owner]), pj3 = pack::load(position[c3.partner]);
  V4 x = pi0 - pj0, y = pi1 - pj1, z = pi2 - pj2, w = pi3 - pj3;
  if constexpr (Periodic) {
    x -= pack::load(bricks_.shift(lists_.image[k[0]]));
    y -= pack::load(bricks_.shift(lists_.image[k[1]]));
    z -= pack::load(bricks_.shift(lists_.image[k[2]]));
    w -= pack::load(bricks_.shift(lists_.image[k[3]]));
  }
  pack::transpose(x, y, z, w);
  const V4 limit = pack::fourth(pi0, pi1, pi2, pi3) + pack::fourth(pj0, pj1, pj2, pj3) + pack::all(reach_);
  const V4 distance_squared = x * x + y * y + z * z;
  const unsigned touches = pack::bits(distance_squared < limit * limit);
  const pack::F4 next = next_look(so_far + pack::F4{}, pack::rough_square_root(distance_squared), __builtin_convertvector(limit, pack::F4));
  for (std::uint32_t lane = 0; lane < 4; ++lane) lists_.look_at[k[lane]] = next[lane];
  if (touches == 0) [[likely]] return;
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    if ((touches >> lane & 1) == 0) continue;
    lists_.look_at[k[lane]] = ContactLists::k_touching;
    forget(k[lane]);   // a contact begins without memory
  }
}

/// Looks at all of [begin, end) that do not touch and may by now.
template <bool Periodic>
void ContactPass::look_at_due(std::uint32_t begin, std::uint32_t end, double approach, Run& run) {
  const float* look_at = lists_.look_at.data();
  const auto so_far = static_cast<float>(approach);
  const float limit = run.lists.approach.unknown ? std::numeric_limits<float>::max() : so_far;
  std::uint32_t* const due = run.columns.due;
  std::uint32_t count = 0;
  for (std::uint32_t k = begin; k < end; k += 8) {
    const unsigned now = pack::at_most(look_at + k, limit) & ~pack::negative(look_at + k);
    if (now != 0) count += pack::keep_lanes(due + count, k, now);
  }
  for (std::uint32_t copy = count; copy % 4 != 0; ++copy) due[copy] = due[count - 1];
  for (std::uint32_t n = 0; n < count; n += 4) look<Periodic>(due + n, so_far);
}

template <bool Rotation, bool Periodic, bool Across>
std::size_t ContactPass::piece(const Piece& piece, double approach, Run& run) {
  const Candidate* candidates = lists_.candidates.data();
  const float* look_at = lists_.look_at.data();
  run.first_slot_candidate = piece.begin;
  std::size_t contacts = 0;

  const auto finish_block = [&] {
    if (run.rows == 0) return;
    fill_up(run);
    gather<Rotation, Periodic>(run);
    contacts += run.rows - run.parted;
    if (!pair_of_.empty()) name_pairs(run);
    call_law(run);
    scatter<Rotation, Across>(run);
    run.rows = run.parted = 0;
  };

  for (std::uint32_t begin = piece.begin; begin < piece.end; begin += k_window) {
    const std::uint32_t end = std::min(begin + k_window, piece.end);
    look_at_due<Periodic>(begin, end, approach, run);
    for (std::uint32_t k = begin; k < end; k += 8) {
      const unsigned touching = pack::negative(look_at + k);
      if (touching == 0) continue;
      const std::uint32_t kept = pack::keep_lanes(run.columns.candidate + run.rows, k, touching);
      // The block is gathered some hundred candidates later: time to fetch what only touching pairs need.
      for (std::uint32_t n = run.rows; n < run.rows + kept; ++n) {
        const std::uint32_t now = run.columns.candidate[n];
        __builtin_prefetch(lists_.history.data() + now * lists_.history_rows(), 1);
        __builtin_prefetch(&particles_.position[candidates[now].partner]);
        __builtin_prefetch(&particles_.velocity[candidates[now].partner]);
        if constexpr (Rotation) __builtin_prefetch(&particles_.angular_velocity[candidates[now].partner]);
      }
      run.rows += kept;
      if (run.rows > k_block_rows - 8) finish_block();
    }
  }
  finish_block();
  return contacts;
}

template <bool Rotation, bool Periodic>
std::size_t ContactPass::both_pieces(Run& run) {
  const BrickLists& lists = run.lists;
  return piece<Rotation, Periodic, false>(lists.inside, lists.approach.inside, run) +
         piece<Rotation, Periodic, true>(lists.across, lists.approach.across, run);
}

std::size_t ContactPass::pairs(std::uint32_t brick, double dt, BlockColumns& scratch, DeepestContact& deepest,
                               LawComplaint& complaint) {
  const std::uint32_t begin = bricks_.first_row(brick), end = bricks_.end_row(brick);
  const V4 none = pack::all(0);
  for (std::uint32_t row = begin; row < end; ++row) pack::store(particles_.force[row], none);
  if (needs_.rotation) {
    for (std::uint32_t row = begin; row < end; ++row) pack::store(particles_.torque[row], none);
  }
  Run run{lists_.bricks[brick], dt, scratch, deepest, complaint, brick};
  if (needs_.rotation) return lists_.has_images() ? both_pieces<true, true>(run) : both_pieces<true, false>(run);
  return lists_.has_images() ? both_pieces<false, true>(run) : both_pieces<false, false>(run);
}

// --------------------------------------------------------------------------------------- walls and baffles of a brick

template <bool Rotation>
void ContactPass::gather_surface(Run& run, std::uint32_t k, const SurfaceTouch& touch) {
  BlockColumns& out = run.columns;
  const std::uint32_t n = run.rows++;
  const std::uint32_t row = lists_.candidates[k].owner;
  const Row& position = particles_.position[row];
  const Row& velocity = particles_.velocity[row];
  const std::array<double, 3>& normal = touch.normal;
  out.candidate[n] = k;
  for (std::size_t axis = 0; axis < 3; ++axis) out.normal[axis][n] = normal[axis];
  out.overlap[n] = position.w - touch.distance;
  out.radius_i[n] = position.w;
  out.radius_j[n] = std::numeric_limits<double>::infinity();
  out.effective_mass[n] = velocity.w;
  out.lever_i[n] = touch.distance;
  double vx = velocity.x, vy = velocity.y, vz = velocity.z;
  if constexpr (Rotation) {
    const Row& spin = particles_.angular_velocity[row];
    out.angular_velocity_i[0][n] = spin.x;
    out.angular_velocity_i[1][n] = spin.y;
    out.angular_velocity_i[2][n] = spin.z;
    for (std::size_t axis = 0; axis < 3; ++axis) out.angular_velocity_j[axis][n] = 0;
    vx += touch.distance * (normal[1] * spin.z - normal[2] * spin.y);
    vy += touch.distance * (normal[2] * spin.x - normal[0] * spin.z);
    vz += touch.distance * (normal[0] * spin.y - normal[1] * spin.x);
  }
  out.velocity[0][n] = vx;
  out.velocity[1][n] = vy;
  out.velocity[2][n] = vz;
  const std::size_t rows = lists_.history_rows();
  for (std::size_t r = 0; r < rows; ++r) {
    const Row& past = lists_.history[k * rows + r];
    out.history[4 * r][n] = past.x;
    out.history[4 * r + 1][n] = past.y;
    out.history[4 * r + 2][n] = past.z;
    out.history[4 * r + 3][n] = past.w;
  }
  const double ratio = out.overlap[n] / position.w;
  if (ratio > run.deepest.twice_ratio) {
    run.deepest = {ratio, row, lists_.candidates[k].partner, true, {position.x, position.y, position.z}};
  }
}

template <bool Rotation>
void ContactPass::scatter_surfaces(Run& run, Row& push) {
  const BlockColumns& in = run.columns;
  for (std::uint32_t n = 0; n < run.rows; ++n) {
    const std::uint32_t row = lists_.candidates[in.candidate[n]].owner;
    const double fx = in.force[0][n], fy = in.force[1][n], fz = in.force[2][n];
    Row& force = particles_.force[row];
    force = {force.x + fx, force.y + fy, force.z + fz, 0};
    push = {push.x + fx, push.y + fy, push.z + fz, 0};
    if constexpr (Rotation) {
      const double nx = in.normal[0][n], ny = in.normal[1][n], nz = in.normal[2][n], lever = in.lever_i[n];
      double tx = lever * (fy * nz - fz * ny), ty = lever * (fz * nx - fx * nz), tz = lever * (fx * ny - fy * nx);
      if (needs_.couple) {
        tx += in.couple[0][n];
        ty += in.couple[1][n];
        tz += in.couple[2][n];
      }
      Row& torque = particles_.torque[row];
      torque = {torque.x + tx, torque.y + ty, torque.z + tz, 0};
    }
  }
  scatter_history(run);
}

template <bool Rotation>
std::size_t ContactPass::surface_piece(Run& run, Row& push) {
  std::size_t contacts = 0;
  SurfaceTouch touch;
  const auto finish_block = [&] {
    if (run.rows == 0) return;
    contacts += run.rows;
    const std::uint32_t last = run.rows - 1;
    const std::uint32_t k = run.columns.candidate[last];
    surfaces_.nearest(lists_.candidates[k].partner, particles_.position[lists_.candidates[k].owner], touch);
    const std::uint32_t rows = run.rows;
    fill_up(run);
    while (run.rows < run.padded) gather_surface<Rotation>(run, k, touch);
    run.rows = rows;
    if (!pair_of_.empty()) name_pairs_with_wall(run);
    call_law(run);
    scatter_surfaces<Rotation>(run, push);
    run.rows = 0;
  };
  const Piece& piece = run.lists.surfaces;
  const Approach& approach = run.lists.approach;
  const auto so_far = static_cast<float>(approach.surfaces);
  const float limit = approach.unknown ? std::numeric_limits<float>::max() : so_far;
  for (std::uint32_t k = piece.begin; k < piece.end; ++k) {
    float& look_at = lists_.look_at[k];
    if (look_at > limit) continue;
    const Candidate& candidate = lists_.candidates[k];
    const Row& centre = particles_.position[candidate.owner];
    const bool faces = surfaces_.nearest(candidate.partner, centre, touch);
    if (faces && centre.w - touch.distance > -reach_) {
      if (!(look_at < 0)) forget(k);
      gather_surface<Rotation>(run, k, touch);
      look_at = ContactLists::k_touching;
    } else {
      const double touches_at = centre.w + reach_;
      look_at = faces ? next_look(so_far, static_cast<float>(touch.distance), static_cast<float>(touches_at)) : ContactLists::k_look_now;
    }
    if (run.rows == k_block_rows) finish_block();
  }
  finish_block();
  return contacts;
}

std::size_t ContactPass::surfaces(std::uint32_t brick, double dt, BlockColumns& scratch, Row& push, DeepestContact& deepest,
                                  LawComplaint& complaint) {
  push = {};
  Run run{lists_.bricks[brick], dt, scratch, deepest, complaint, brick};
  return needs_.rotation ? surface_piece<true>(run, push) : surface_piece<false>(run, push);
}

}  // namespace similitude
