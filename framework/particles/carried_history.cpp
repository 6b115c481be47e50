#include "particles/carried_history.h"

#include "particles/contact_lists.h"

namespace similitude {

CarriedHistory::CarriedHistory(const ContactMemory& memory) : rows_(memory.rows()) {
  std::array<double, k_most_history> sign{};
  for (std::size_t h = 0; h < k_most_history; ++h) {
    sign[h] = h < memory.count && memory.parity[h] == SIMILITUDE_ODD ? -1 : 1;
  }
  for (std::size_t r = 0; r < sign_when_swapped_.size(); ++r) {
    sign_when_swapped_[r] = {sign[4 * r], sign[4 * r + 1], sign[4 * r + 2], sign[4 * r + 3]};
  }
}

void CarriedHistory::collect(const ContactLists& lists, const std::vector<std::uint32_t>& new_row, std::size_t new_rows) {
  first_.assign(new_rows + 1, 0);
  if (rows_ == 0) return;

  // What becomes of a touching candidate: its owner and partner in the new rows.
  struct Moved {
    std::uint32_t owner, partner;
    bool swapped;
  };
  const auto moved = [&](const Candidate& old, bool surface) -> Moved {
    const std::uint32_t a = new_row[old.owner];
    if (surface) return {a, old.partner | ContactLists::k_surface_key, false};
    const std::uint32_t b = new_row[old.partner];
    if (a == k_gone || b == k_gone) return {k_gone, b, false};
    return a < b ? Moved{a, b, false} : Moved{b, a, true};
  };
  const auto each_touching = [&](auto&& visit) {
    for (const BrickLists& brick : lists.bricks) {
      for (const Piece* piece : {&brick.inside, &brick.across, &brick.surfaces}) {
        for (std::uint32_t k = piece->begin; k < piece->end; ++k) {
          if (!lists.touches(k)) continue;
          const Moved now = moved(lists.candidates[k], piece == &brick.surfaces);
          if (now.owner != k_gone) visit(k, now);
        }
      }
    }
  };

  each_touching([&](std::uint32_t, const Moved& now) { ++first_[now.owner + 1]; });
  for (std::size_t row = 0; row < new_rows; ++row) first_[row + 1] += first_[row];
  const std::size_t contacts = first_[new_rows];
  if (partner_.size() < contacts) {
    partner_.resize(contacts + contacts / 8);
    history_.resize(partner_.size() * rows_);
  }
  each_touching([&](std::uint32_t k, const Moved& now) {
    const std::uint32_t entry = first_[now.owner]++;
    partner_[entry] = now.partner;
    for (std::size_t r = 0; r < rows_; ++r) {
      Row value = lists.history[k * rows_ + r];
      if (now.swapped) {
        const Row& sign = sign_when_swapped_[r];
        value = {value.x * sign.x, value.y * sign.y, value.z * sign.z, value.w * sign.w};
      }
      history_[entry * rows_ + r] = value;
    }
  });
  for (std::size_t row = new_rows; row > 0; --row) first_[row] = first_[row - 1];
  first_[0] = 0;
}

}  // namespace similitude
