#pragma once
/// Tables of rows in streaks: most neighbours on a grid lie one further on from entry to entry, so that a loop over a
/// streak reads its first entry and then runs along the fields, in packs. Which entries belong together is found once.

#include <vector>

#include "fluid/face_tables.h"

namespace similitude::vans {

using flow::Row;
using flow::u;

/// Entries [begin, end) of a table.
struct Streak {
  Row begin, end;
  bool regular;   // every row named lies one further on from entry to entry, and all else is the same
};

struct Streaks {
  std::vector<Streak> all;
  std::vector<Index> part;   // parts of like work, for threads: each one's first streak, and the end

  bool worth_threads() const { return !all.empty() && all.back().end >= k_worth_threads; }
};

/// `follows(n)`: entry n goes on as entry n - 1 did. No streak crosses `border`.
template <class Follows>
Streaks find_streaks(Row count, Row border, Follows&& follows) {
  constexpr Row k_shortest = 4, k_longest = 512;   // short ones are not worth a loop of their own; threads share long ones
  Streaks found;
  for (Row begin = 0; begin < count;) {
    Row end = begin + 1;
    while (end < count && end != border && end - begin < k_longest && follows(end)) ++end;
    const bool regular = end - begin >= k_shortest;
    const bool joins = !regular && begin != border && !found.all.empty() && !found.all.back().regular;
    if (joins && end - found.all.back().begin <= k_longest) {
      found.all.back().end = end;
    } else {
      found.all.push_back({begin, end, regular});
    }
    begin = end;
  }
  Row part_end = 0;
  for (std::size_t s = 0; s < found.all.size(); ++s) {
    if (found.all[s].begin < part_end) continue;
    found.part.push_back(static_cast<Index>(s));
    part_end = found.all[s].begin + k_longest;
  }
  found.part.push_back(static_cast<Index>(found.all.size()));
  return found;
}

/// body(streak) for all of them, shared by the threads of the parallel region around. No barrier at the end.
template <class Body>
void for_each_streak(const Streaks& streaks, Body&& body) {
  const Index parts = static_cast<Index>(streaks.part.size()) - 1;
#pragma omp for schedule(static) nowait
  for (Index p = 0; p < parts; ++p) {
    for (Index s = streaks.part[u(p)]; s < streaks.part[u(p + 1)]; ++s) body(streaks.all[u(s)]);
  }
}

}  // namespace similitude::vans
