#pragma once
/// How either side of the boundary reads a structure of an older or a newer other side. A minor release appends fields and
/// hooks; `struct_size` says how far the other side's structure reaches. What it does not reach is zero here: no such
/// value, no such hook.

#include <algorithm>
#include <cstddef>
#include <cstring>

#include <similitude/abi.h>

namespace similitude {

/// [bytes] of a structure as it was in <major>.0, which is the least that anybody hands over. A structure that grew says so
/// here, with the offset of the first field that was appended.
template <class S>
inline constexpr std::size_t k_first_size = sizeof(S);

/// A structure as it is known here.
template <class S>
S as_known_here(const S* given) {
  S copy{};
  std::memcpy(static_cast<void*>(&copy), given, std::min<std::size_t>(given->struct_size, sizeof copy));
  copy.struct_size = sizeof copy;
  return copy;
}

}  // namespace similitude
