#pragma once
/// How many rows, candidates and places for them there can be: their numbers have 32 bits, half the memory that lists would need else.

#include <cstddef>

namespace similitude {

/// The highest bit of a partner's number marks a surface (ContactLists::k_surface_key).
inline constexpr std::size_t k_most_rows = std::size_t{1} << 31;
inline constexpr std::size_t k_most_candidates = (std::size_t{1} << 32) - 1;
inline constexpr double k_most_places = (1LL << 32) - 1;   // a double: counted before anybody knows whether it fits

/// InputError beyond these; of particles, of what may touch, of the cells and bricks that rows are sorted by.
void refuse_more_rows(std::size_t rows);
void refuse_more_candidates(std::size_t candidates);
void refuse_more_places(double places);

}  // namespace similitude
