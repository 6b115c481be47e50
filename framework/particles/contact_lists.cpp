#include "particles/contact_lists.h"

#include <algorithm>
#include <array>
#include <limits>

#include <omp.h>

#include "particles/most.h"
#include "particles/pack.h"

namespace similitude {

namespace {

constexpr std::size_t k_piece_rounding = 64;   // pieces of bytes start on cache lines of their own: no false sharing

std::size_t rounded(std::size_t count) { return (count + k_piece_rounding - 1) / k_piece_rounding * k_piece_rounding; }

}  // namespace

/// The search of one brick, by one thread.
class ContactLists::Search {
 public:
  Search(const ParticleStore& particles, const Bricks& bricks, const Surfaces& surfaces, double margin,
         double largest_radius, Gathered& out)
      : particles_(particles), bricks_(bricks), surfaces_(surfaces), margin_(margin), largest_radius_(largest_radius),
        out_(out) {}

  void brick(std::uint32_t brick) {
    out_.inside_count = out_.across_count = 0;
    out_.surfaces.clear();
    find_near_surfaces(brick);
    std::array<RowRange, 27> ranges;
    for (std::uint32_t cell = 0; cell < bricks_.cells_per_brick(); ++cell) {
      const RowRange here = bricks_.cell_rows(brick, cell);
      if (here.begin == here.end) continue;
      const std::size_t count = bricks_.neighbours(brick, cell, ranges);
      std::size_t most = 0;
      for (std::size_t r = 0; r < count; ++r) most += ranges[r].end - ranges[r].begin;
      for (std::uint32_t row = here.begin; row < here.end; ++row) {
        out_.make_room(most + 4);
        for (std::size_t r = 0; r < count; ++r) pairs(row, ranges[r], brick);
        for (const std::uint32_t surface : out_.near_surfaces) touch(row, surface);
      }
    }
  }

 private:
  void find_near_surfaces(std::uint32_t brick) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    std::array<double, 3> low{inf, inf, inf}, high{-inf, -inf, -inf};
    for (std::uint32_t row = bricks_.first_row(brick); row < bricks_.end_row(brick); ++row) {
      const Row& p = particles_.position[row];
      low = {std::min(low[0], p.x), std::min(low[1], p.y), std::min(low[2], p.z)};
      high = {std::max(high[0], p.x), std::max(high[1], p.y), std::max(high[2], p.z)};
    }
    out_.near_surfaces.clear();
    out_.near_baffles.clear();
    for (std::uint32_t surface = 0; surface < surfaces_.count(); ++surface) {
      if (!surfaces_.near_box(surface, low, high, 2 * largest_radius_ + margin_)) continue;
      out_.near_surfaces.push_back(surface);
      if (surfaces_.is_baffle(surface)) out_.near_baffles.push_back(surface);
    }
  }

  void touch(std::uint32_t row, std::uint32_t surface) {
    SurfaceTouch nearest;
    const Row& centre = particles_.position[row];
    if (surfaces_.nearest(surface, centre, nearest) && nearest.distance <= centre.w + margin_) {
      out_.surfaces.push_back({row, surface});
    }
  }

  void pairs(std::uint32_t row, const RowRange& range, std::uint32_t brick) {
    const bool inside = range.brick == brick;
    std::size_t& count = inside ? out_.inside_count : out_.across_count;
    Candidate* found = (inside ? out_.inside : out_.across).data() + count;
    std::uint8_t* images = (inside ? out_.inside_image : out_.across_image).data() + count;
    const std::size_t before = count;
    std::size_t n = 0;

    const Row* position = particles_.position.data();
    const Row& shift = bricks_.shift(range.image);
    const Row centre{position[row].x - shift.x, position[row].y - shift.y, position[row].z - shift.z, position[row].w};
    const double reach = centre.w + margin_;
    const pack::V4 here = pack::load(centre), packed_reach = pack::all(reach);
    std::uint32_t other = std::max(range.begin, row + 1);
    for (; other < range.end; other += 4) {
      const std::uint32_t last = range.end - 1;   // stands in for what is missing of the last pack
      pack::V4 x = pack::load(position[other]), y = pack::load(position[std::min(other + 1, last)]);
      pack::V4 z = pack::load(position[std::min(other + 2, last)]), radius = pack::load(position[std::min(other + 3, last)]);
      pack::transpose(x, y, z, radius);
      x -= pack::all(here[0]);
      y -= pack::all(here[1]);
      z -= pack::all(here[2]);
      const pack::V4 limit = radius + packed_reach;
      const unsigned present = (1u << std::min(4u, range.end - other)) - 1;
      const unsigned near = pack::bits(x * x + y * y + z * z <= limit * limit) & present;
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        found[n] = {row, other + lane};
        n += near >> lane & 1;
      }
    }
    if (!out_.near_baffles.empty()) n = drop_separated(found, n, shift);
    if (!images_empty()) std::fill(images, images + n, range.image);
    count = before + n;
  }

  bool images_empty() const { return out_.inside_image.empty(); }

  /// Leaves out pairs that a baffle keeps apart.
  std::size_t drop_separated(Candidate* found, std::size_t n, const Row& shift) const {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Row& a = particles_.position[found[k].owner];
      const Row& b = particles_.position[found[k].partner];
      const Row b_at_a{b.x + shift.x, b.y + shift.y, b.z + shift.z, 0};
      const Row a_at_b{a.x - shift.x, a.y - shift.y, a.z - shift.z, 0};
      const bool separated = std::any_of(out_.near_baffles.begin(), out_.near_baffles.end(), [&](std::uint32_t baffle) {
        return surfaces_.separates(baffle, a, b_at_a) || surfaces_.separates(baffle, a_at_b, b);
      });
      if (!separated) found[kept++] = found[k];
    }
    return kept;
  }

  const ParticleStore& particles_;
  const Bricks& bricks_;
  const Surfaces& surfaces_;
  const double margin_, largest_radius_;
  Gathered& out_;
};

void ContactLists::Gathered::make_room(std::size_t more) {
  const auto grow = [&](std::vector<Candidate>& list, std::vector<std::uint8_t>& images, std::size_t count) {
    if (count + more <= list.size()) return;
    const bool with_images = !images.empty();
    list.resize(2 * (count + more));
    if (with_images) images.resize(list.size());
  };
  grow(inside, inside_image, inside_count);
  grow(across, across_image, across_count);
}

void ContactLists::make_room(std::size_t wanted) {
  if (wanted <= candidates.size()) return;
  const std::size_t room = wanted + wanted / 4;
  refuse_more_candidates(room);
  candidates.resize(room);
  look_at.resize(room);
  history.resize(room * history_rows_);
  if (images_) image.resize(room);
}

Piece ContactLists::place(std::size_t begin, const std::vector<Candidate>& from, std::size_t count,
                          const std::vector<std::uint8_t>* images, std::uint32_t partner_mark,
                          const CarriedHistory& carried) {
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t k = begin + n;
    candidates[k] = from[n];
    if (images_) image[k] = images ? (*images)[n] : Bricks::k_no_shift;
    look_at[k] = k_look_now;
    if (const Row* past = carried.find(from[n].owner, from[n].partner | partner_mark)) {
      look_at[k] = k_touching;
      std::copy(past, past + history_rows_, history.begin() + static_cast<std::ptrdiff_t>(k * history_rows_));
    }
  }
  for (std::size_t k = begin + count; k < begin + rounded(count); ++k) {
    candidates[k] = candidates[k - 1];
    if (images_) image[k] = image[k - 1];
    look_at[k] = std::numeric_limits<float>::infinity();
  }
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + count)};
}

void ContactLists::settle(std::uint32_t brick, const Gathered& from, const CarriedHistory& carried) {
  // Where a brick's piece lies in memory may differ from run to run; what is in it does not.
  const std::size_t room = rounded(from.inside_count) + rounded(from.across_count) + rounded(from.surfaces.size());
  std::size_t begin = used_.fetch_add(room);
  if (begin + room > candidates.size()) return;   // all is built again with more room
  BrickLists& lists = bricks[brick];
  lists.approach = {};
  lists.inside = place(begin, from.inside, from.inside_count, &from.inside_image, 0, carried);
  begin += rounded(from.inside_count);
  lists.across = place(begin, from.across, from.across_count, &from.across_image, 0, carried);
  begin += rounded(from.across_count);
  lists.surfaces = place(begin, from.surfaces, from.surfaces.size(), nullptr, k_surface_key, carried);
}

void ContactLists::build(const ParticleStore& particles, const Bricks& where, const Surfaces& surfaces, double margin,
                         double largest_radius, const CarriedHistory& carried) {
  bricks.reserve(where.most());
  bricks.resize(where.count());
  constexpr std::size_t most_neighbours = 26;
  for (std::vector<std::uint32_t>* per_brick : {&first_incoming, &first_later, &first_earlier, &last_sender_}) {
    per_brick->reserve(where.most() + 1);
  }
  later.reserve(most_neighbours * where.most());
  earlier.reserve(most_neighbours * where.most());
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  if (gathered_.size() < threads) gathered_.resize(threads);
  for (Gathered& gathered : gathered_) {
    if (images_ && gathered.inside_image.empty()) {
      gathered.inside_image.resize(std::max<std::size_t>(gathered.inside.size(), 1));
      gathered.across_image.resize(std::max<std::size_t>(gathered.across.size(), 1));
    }
  }
  do {
    make_room(used_.load());
    used_ = 0;
#pragma omp parallel for schedule(dynamic, 1) if (particles.size() >= k_rows_worth_threads)
    for (std::uint32_t brick = 0; brick < where.count(); ++brick) {
      Gathered& gathered = gathered_[static_cast<std::size_t>(omp_get_thread_num())];
      Search(particles, where, surfaces, margin, largest_radius, gathered).brick(brick);
      settle(brick, gathered, carried);
    }
  } while (used_.load() > candidates.size());

  // Whichever thread meets the largest brick next time has the room already.
  std::size_t inside = 0, across = 0, near = 0;
  for (const Gathered& gathered : gathered_) {
    inside = std::max(inside, gathered.inside.size());
    across = std::max(across, gathered.across.size());
    near = std::max(near, gathered.surfaces.capacity());
  }
  for (Gathered& gathered : gathered_) {
    gathered.inside.resize(inside);
    gathered.across.resize(across);
    gathered.surfaces.reserve(near);
    if (images_) {
      gathered.inside_image.resize(inside);
      gathered.across_image.resize(across);
    }
  }
  list_incoming(where);
}

void ContactLists::list_incoming(const Bricks& where) {
  constexpr std::uint32_t nobody = 0xffff'ffff;
  first_incoming.assign(bricks.size() + 1, 0);
  first_later.assign(bricks.size() + 1, 0);
  last_sender_.assign(bricks.size(), nobody);
  later.clear();
  slots = 0;
  std::uint32_t receiver = 0;   // partners of one row follow each other: mostly the same brick again
  const auto receiver_of = [&](std::uint32_t row) {
    if (row < where.first_row(receiver) || row >= where.end_row(receiver)) receiver = where.brick_of(row);
    return receiver;
  };
  for (std::uint32_t sender = 0; sender < bricks.size(); ++sender) {
    BrickLists& brick = bricks[sender];
    brick.first_slot = slots;
    slots += brick.across.end - brick.across.begin;
    for (std::uint32_t k = brick.across.begin; k < brick.across.end; ++k) {
      const std::uint32_t to = receiver_of(candidates[k].partner);
      ++first_incoming[to + 1];
      if (last_sender_[to] == sender) continue;
      last_sender_[to] = sender;
      later.push_back(to);
    }
    first_later[sender + 1] = static_cast<std::uint32_t>(later.size());
  }
  for (std::size_t brick = 0; brick < bricks.size(); ++brick) first_incoming[brick + 1] += first_incoming[brick];
  if (incoming.size() < slots) incoming.resize(slots + slots / 4);
  for (const BrickLists& brick : bricks) {
    for (std::uint32_t k = brick.across.begin; k < brick.across.end; ++k) {
      const std::uint32_t row = candidates[k].partner;
      incoming[first_incoming[receiver_of(row)]++] = {row, k, brick.first_slot + (k - brick.across.begin)};
    }
  }
  for (std::size_t brick = bricks.size(); brick > 0; --brick) first_incoming[brick] = first_incoming[brick - 1];
  first_incoming[0] = 0;
  list_earlier();
}

void ContactLists::list_earlier() {
  first_earlier.assign(bricks.size() + 1, 0);
  earlier.resize(later.size());
  for (const std::uint32_t to : later) ++first_earlier[to + 1];
  for (std::size_t brick = 0; brick < bricks.size(); ++brick) first_earlier[brick + 1] += first_earlier[brick];
  for (std::uint32_t from = 0; from < bricks.size(); ++from) {
    for (std::uint32_t n = first_later[from]; n < first_later[from + 1]; ++n) earlier[first_earlier[later[n]]++] = from;
  }
  for (std::size_t brick = bricks.size(); brick > 0; --brick) first_earlier[brick] = first_earlier[brick - 1];
  first_earlier[0] = 0;
}

void ContactLists::have_moved(const std::vector<double>& moved) {
  for (std::size_t brick = 0; brick < bricks.size(); ++brick) {
    double partners = 0;
    for (std::uint32_t n = first_later[brick]; n < first_later[brick + 1]; ++n) partners = std::max(partners, moved[later[n]]);
    Approach& approach = bricks[brick].approach;
    approach.inside += 2 * moved[brick];
    approach.across += moved[brick] + partners;
    approach.surfaces += moved[brick];
    approach.unknown = false;
  }
}

void ContactLists::were_moved_from_outside() {
  for (BrickLists& brick : bricks) brick.approach = {.unknown = true};
}

std::size_t ContactLists::bytes() const {
  std::size_t bytes = candidates.capacity() * sizeof(Candidate) + image.capacity() + look_at.capacity() * sizeof(float) +
                      incoming.capacity() * sizeof(Incoming) + bricks.capacity() * sizeof(BrickLists) +
                      4 * (first_incoming.capacity() + first_later.capacity() + later.capacity() + first_earlier.capacity() +
                           earlier.capacity() + last_sender_.capacity());
  for (const Gathered& gathered : gathered_) {
    bytes += (gathered.inside.capacity() + gathered.across.capacity()) * (sizeof(Candidate) + (images_ ? 1 : 0)) +
             gathered.surfaces.capacity() * sizeof(Candidate);
  }
  return bytes;
}

}  // namespace similitude
