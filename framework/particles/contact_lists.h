#pragma once
/// Who may touch whom until the next rebuild: half Verlet lists of pairs (the lower row owns a pair), of pairs across
/// bricks, and of particles near walls and baffles, each brick's in one piece, with the history of touching contacts
/// beside them.

#include <atomic>
#include <cstdint>
#include <vector>

#include "particles/bricks.h"
#include "particles/carried_history.h"
#include "particles/store.h"
#include "particles/surfaces.h"

namespace similitude {

/// A possible contact: two rows, or a row and a surface.
struct Candidate {
  std::uint32_t owner = 0;
  std::uint32_t partner = 0;
};

/// One brick's candidates: [begin, end) in ContactLists::candidates. Every piece is padded with copies to whole packs of 4.
struct Piece {
  std::uint32_t begin = 0, end = 0;
};

/// Bounds on how much closer the two of a candidate can have come [m]. They only grow: what lies farther apart than they have
/// grown since it was last looked at cannot touch, and is not looked at.
struct Approach {
  double inside = 0, across = 0, surfaces = 0;
  bool unknown = false;           // rows were moved from outside: look at all once more
};

struct BrickLists {
  Piece inside;                   // both rows in the brick
  Piece across;                   // the partner stands in a later brick
  Piece surfaces;                 // the partner is a surface
  std::uint32_t first_slot = 0;   // of `across`, in the slots of partners' shares
  Approach approach;              // since the lists were built
};

/// A pair of an earlier brick whose partner stands in this one.
struct Incoming {
  std::uint32_t row;
  std::uint32_t candidate;
  std::uint32_t slot;
};

class ContactLists {
 public:
  static constexpr std::uint32_t k_surface_key = 0x8000'0000;   // marks a surface among carried partners

  ContactLists(std::size_t history_rows, bool any_periodic) : history_rows_(history_rows), images_(any_periodic) {}

  /// Lists all pairs within r_i + r_j + margin [m] of each other and all particles within margin of a surface, and
  /// gives contacts that went on their history back. Throws InputError for more candidates than numbers for them (most.h).
  void build(const ParticleStore& particles, const Bricks& bricks, const Surfaces& surfaces, double margin,
             double largest_radius, const CarriedHistory& carried);

  std::vector<BrickLists> bricks;
  Column<Candidate> candidates;
  Column<std::uint8_t> image;          // shift of the partner; periodic beds only
  /// The approach at which a candidate must be looked at [m]: below zero while it touches. Rounded down, as floats halve
  /// what a pass reads.
  Column<float> look_at;
  Column<Row> history;                 // history_rows() rows per candidate; means something only while touching
  std::vector<Incoming> incoming;      // by receiving brick, then by sending brick and list order
  std::vector<std::uint32_t> first_incoming;
  std::uint32_t slots = 0;             // of partners' shares across bricks
  std::vector<std::uint32_t> first_later, later;       // per brick: those that hold partners of its `across`
  std::vector<std::uint32_t> first_earlier, earlier;   // per brick: those whose `across` have partners in it

  static constexpr float k_touching = -1, k_look_now = 0;
  /// In the last contact pass.
  bool touches(std::size_t candidate) const { return look_at[candidate] < 0; }
  /// After a sub-step in which the rows of brick b moved by at most moved[b] [m].
  void have_moved(const std::vector<double>& moved);
  /// Rows may stand anywhere: every candidate is looked at in the next pass.
  void were_moved_from_outside();

  std::size_t history_rows() const { return history_rows_; }
  bool has_images() const { return images_; }
  std::size_t bytes() const;           // without history
  static constexpr std::size_t bytes_per_candidate(bool periodic) {
    return sizeof(Candidate) + sizeof(float) + (periodic ? sizeof(std::uint8_t) : 0);
  }
  static constexpr double k_room = 1.25;   // of candidates, their histories and shares across bricks, over what is wanted: a quarter is spare
  std::size_t history_bytes() const { return history.capacity() * sizeof(Row); }

 private:
  /// Where a thread gathers one brick's candidates before their number is known.
  struct Gathered {
    std::vector<Candidate> inside, across, surfaces;
    std::vector<std::uint8_t> inside_image, across_image;
    std::vector<std::uint32_t> near_surfaces, near_baffles;
    std::size_t inside_count = 0, across_count = 0;
    void make_room(std::size_t more);
  };
  class Search;

  void make_room(std::size_t wanted);
  void settle(std::uint32_t brick, const Gathered& gathered, const CarriedHistory& carried);
  Piece place(std::size_t begin, const std::vector<Candidate>& from, std::size_t count,
              const std::vector<std::uint8_t>* images, std::uint32_t partner_mark, const CarriedHistory& carried);
  void list_incoming(const Bricks& bricks);
  void list_earlier();

  std::size_t history_rows_;
  bool images_;
  std::vector<Gathered> gathered_;     // per thread
  std::vector<std::uint32_t> last_sender_;   // per brick, while links are counted
  std::atomic<std::size_t> used_{0};
};

}  // namespace similitude
