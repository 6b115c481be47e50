#pragma once
/// Tables of rows in streaks: most neighbours on a grid lie one further on from entry to entry, so that a loop over a
/// streak reads its first entry and then runs along the fields, in packs. Which entries belong together is found once.

#include <type_traits>
#include <vector>

#include "fluid/face_tables.h"

namespace similitude::vans {

using flow::Row;
using flow::u;

/// How the rows of a table go on from entry to entry.
enum class Course {
  along,        // every row lies one further on, and all else is the same
  wall_below,   // the same, but for the one velocity of a wall on the lower side
  wall_above,
  mixed         // ask the table
};

/// Entries [begin, end) of a table.
struct Streak {
  Row begin, end;
  Course course;
};

struct Streaks {
  std::vector<Streak> all;
  std::vector<Index> part;   // parts of like work, for threads: each one's first streak, and the end

  bool worth_threads() const { return !all.empty() && all.back().end >= k_worth_threads; }
};

/// `course(n)`: how entry n goes on from entry n - 1. No streak crosses `border`.
template <class CourseOf>
Streaks find_streaks(Row count, Row border, CourseOf&& course) {
  constexpr Row k_shortest = 4, k_longest = 512;   // short ones are not worth a loop of their own; threads share long ones
  Streaks found;
  for (Row begin = 0; begin < count;) {
    Row end = begin + 1;
    const Course ahead = end < count ? course(end) : Course::mixed;
    while (ahead != Course::mixed && end < count && end != border && end - begin < k_longest && course(end) == ahead) ++end;
    const Streak here{begin, end, end - begin >= k_shortest ? ahead : Course::mixed};
    const bool joins = here.course == Course::mixed && begin != border && !found.all.empty() && found.all.back().course == Course::mixed;
    if (joins && end - found.all.back().begin <= k_longest) {
      found.all.back().end = end;
    } else {
      found.all.push_back(here);
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

/// run(below_moves, above_moves) for a course that is not mixed, as constants: whether the rows on either side go on.
template <class Run>
void along_course(Course course, Run&& run) {
  using std::false_type, std::true_type;
  if (course == Course::along) run(true_type{}, true_type{});
  if (course == Course::wall_below) run(false_type{}, true_type{});
  if (course == Course::wall_above) run(true_type{}, false_type{});
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
