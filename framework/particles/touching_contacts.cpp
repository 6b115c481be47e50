#include "particles/touching_contacts.h"

#include <algorithm>

#include "particles/contact_lists.h"

namespace similitude {
namespace {

/// visit(place in list order, index in memory, marked partner) for every candidate.
template <class Visit>
void each_candidate(const ContactLists& lists, Visit&& visit) {
  std::uint32_t place = 0;
  for (const BrickLists& brick : lists.bricks) {
    for (const Piece* piece : {&brick.inside, &brick.across, &brick.surfaces}) {
      const std::uint32_t mark = piece == &brick.surfaces ? ContactLists::k_surface_key : 0;
      for (std::uint32_t k = piece->begin; k < piece->end; ++k) visit(place++, k, lists.candidates[k].partner | mark);
    }
  }
}

std::ptrdiff_t first_history_row(const ContactLists& lists, std::size_t entry) {
  return static_cast<std::ptrdiff_t>(entry * lists.history_rows());
}

}  // namespace

void collect_touching(const ContactLists& lists, TouchingContacts& out) {
  out.place.clear();
  out.owner.clear();
  out.partner.clear();
  out.history.clear();
  each_candidate(lists, [&](std::uint32_t place, std::uint32_t k, std::uint32_t partner) {
    if (!lists.touches(k)) return;
    out.place.push_back(place);
    out.owner.push_back(lists.candidates[k].owner);
    out.partner.push_back(partner);
    const auto past = lists.history.begin() + first_history_row(lists, k);
    out.history.insert(out.history.end(), past, past + first_history_row(lists, 1));
  });
}

bool give_back_touching(const TouchingContacts& contacts, ContactLists& lists) {
  if (contacts.owner.size() != contacts.place.size() || contacts.partner.size() != contacts.place.size() ||
      contacts.history.size() != contacts.place.size() * lists.history_rows()) {
    return false;
  }
  std::size_t entry = 0;
  bool known = true;
  each_candidate(lists, [&](std::uint32_t place, std::uint32_t k, std::uint32_t partner) {
    if (entry == contacts.place.size() || contacts.place[entry] != place) return;
    known = known && contacts.owner[entry] == lists.candidates[k].owner && contacts.partner[entry] == partner;
    lists.look_at[k] = ContactLists::k_touching;
    std::copy_n(contacts.history.begin() + first_history_row(lists, entry), lists.history_rows(),
                lists.history.begin() + first_history_row(lists, k));
    ++entry;
  });
  return known && entry == contacts.place.size();
}

}  // namespace similitude
