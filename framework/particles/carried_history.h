#pragma once
/// The memory of touching contacts while rows are sorted anew and lists are rebuilt. What is not found in the new list
/// has parted, and is dropped.

#include <array>
#include <cstdint>
#include <vector>

#include "particles/contact_effects.h"
#include "particles/store.h"

namespace similitude {

class ContactLists;

class CarriedHistory {
 public:
  explicit CarriedHistory(const ContactMemory& memory);

  /// Takes the touching contacts of `lists` over to new rows; new_row[old row] is k_gone where a particle left.
  void collect(const ContactLists& lists, const std::vector<std::uint32_t>& new_row, std::size_t new_rows);
  void clear() { first_.clear(); }

  /// The history of (owner, partner) as rows, or null: a contact that begins. `partner` is a row or a marked surface.
  const Row* find(std::uint32_t owner, std::uint32_t partner) const {
    if (first_.empty()) return nullptr;
    for (std::uint32_t entry = first_[owner]; entry < first_[owner + 1]; ++entry) {
      if (partner_[entry] == partner) return &history_[entry * rows_];
    }
    return nullptr;
  }

  static constexpr std::uint32_t k_gone = 0xffff'ffff;
  static constexpr std::size_t bytes_per_contact(std::size_t history_rows) {
    return history_rows == 0 ? 0 : sizeof(std::uint32_t) + history_rows * sizeof(Row);
  }
  std::size_t bytes() const { return 4 * (first_.capacity() + partner_.capacity()) + history_.capacity() * sizeof(Row); }

 private:
  std::size_t rows_;                             // per contact
  std::array<Row, k_most_history / 4> sign_when_swapped_;
  std::vector<std::uint32_t> first_, partner_;   // by owner
  Column<Row> history_;
};

}  // namespace similitude
