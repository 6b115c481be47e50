#pragma once
/// What effects add to contacts, after the contact law and on the same blocks. Exists only where a case lists an effect
/// that has a contact pass.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <similitude/abi.h>

#include "loader/catalogue.h"

namespace similitude {

struct BlockColumns;

/// Numbers that a contact remembers, of the law and of all effects together.
constexpr std::size_t k_most_history = 2 * SIMILITUDE_MAX_HISTORY;

/// What a contact remembers: the law's values first, then each effect's.
struct ContactMemory {
  std::uint32_t count = 0;
  std::array<std::int32_t, k_most_history> parity{};   // SIMILITUDE_EVEN or _ODD

  std::size_t rows() const { return (count + 3) / 4; }
};

similitude_effect_needs needs_of(const EffectModel& effect);

class ContactEffects {
 public:
  /// Of `all`, those with a contact pass; they must outlive this. Throws std::invalid_argument if law and effects want to
  /// remember more than k_most_history values.
  ContactEffects(const similitude_contact_needs& law, std::span<const EffectModel> all);

  bool empty() const { return effects_.empty(); }
  bool rotation() const { return rotation_; }   // some pass needs spin
  bool couple() const { return couple_; }       // some pass adds a couple
  const ContactMemory& memory() const { return memory_; }
  double reach(double diameter) const;          // [m], the farthest of all
  /// "rolling_friction, cohesion", for the printed pipeline.
  std::string names() const;

  /// Contacts that only an effect reaches are shown to the law at the end of its own reach. [worker]
  void before_law(similitude_contact_block& block, BlockColumns& columns, double law_reach) const;
  /// Takes back what the law said of contacts beyond its reach, then calls the effects in the order of the case. `blame` becomes the
  /// id of the effect that failed. [worker]
  void after_law(const similitude_contact_block& block, BlockColumns& columns, double law_reach, similitude_status& status,
                 const char*& blame) const;

 private:
  struct One {
    const EffectModel* model;
    similitude_effect_needs needs;
    std::uint32_t first_history;   // column of its first value
  };
  std::vector<One> effects_;
  ContactMemory memory_;
  std::uint32_t law_history_ = 0;
  bool rotation_ = false, couple_ = false, law_couple_ = false;
};

}  // namespace similitude
