#pragma once
/// The contacts that touch, apart from the lists they stand in: what must be remembered of lists that can be built again.

#include <cstdint>
#include <vector>

#include "particles/store.h"

namespace similitude {

class ContactLists;

/// In the order of the lists: brick by brick, pairs inside, pairs across, surfaces. That order follows from the rows and the
/// positions the lists were built at, whatever the thread count.
struct TouchingContacts {
  std::vector<std::uint32_t> place;     // among all candidates, counted in that order
  std::vector<std::uint32_t> owner;     // row
  std::vector<std::uint32_t> partner;   // row, or a surface marked by ContactLists::k_surface_key
  Column<Row> history;                  // ContactLists::history_rows() rows per contact
};

/// Replaces what `out` held.
void collect_touching(const ContactLists& lists, TouchingContacts& out);
/// Into lists that were built at the same positions. False: these contacts are not in the lists.
bool give_back_touching(const TouchingContacts& contacts, ContactLists& lists);

}  // namespace similitude
