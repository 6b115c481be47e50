#include "scene/alignment.h"

#include <array>
#include <cmath>
#include <vector>

#include "scene/units.h"

namespace similitude {
namespace {

// Far above the rounding of a quotient, far below what anybody can mean.
constexpr double k_cells_tolerance = 1e-6;
constexpr int k_finest_division = 10;

std::string interval_text(double low, double high) { return std::string("[") + in_mm(low) + ", " + in_mm(high) + "]"; }

/// The coarsest whole fraction of `cell`, but none below `least`, on whose faces all coordinates lie, or 0.
double fitting_cell(const std::vector<double>& coordinates, double cell, double least) {
  for (int division = 2; division <= k_finest_division && cell / division >= least * (1 - k_cells_tolerance); ++division) {
    bool fits = true;
    for (const double coordinate : coordinates) fits &= align(coordinate, cell / division).ok;
    if (fits) return cell / division;
  }
  return 0;
}

std::string or_finer_cells(const std::vector<double>& coordinates, double cell, double least) {
  const double finer = fitting_cell(coordinates, cell, least);
  return finer > 0 ? ", or set scene.domain.cell: " + in_mm(finer) + "." : ".";
}

}  // namespace

Aligned align(double coordinate, double cell) {
  const double cells = coordinate / cell;
  const double nearest = std::round(cells);
  if (std::abs(cells - nearest) <= k_cells_tolerance) return {true, nearest * cell, nearest * cell};
  return {false, std::floor(cells) * cell, std::ceil(cells) * cell};
}

std::string in_mm(double length) { return format_quantity(length, "mm"); }

std::string off_face_text(double coordinate, double cell) {
  const Aligned near = align(coordinate, cell);
  return in_mm(coordinate) + " is not on a cell face (cells of " + in_mm(cell) + ", faces at " + in_mm(near.low) +
         " and " + in_mm(near.high) + ").";
}

std::string off_face_fix(Interval wanted, double cell, double least) {
  const Aligned low = align(wanted.low, cell);
  const Aligned high = align(wanted.high, cell);
  std::vector<std::string> choices;
  const auto offer = [&](double from, double to) {
    if (to - from < 0.5 * cell) return;
    const std::string text = interval_text(from, to);
    if (choices.empty() || choices.back() != text) choices.push_back(text);
  };
  offer(low.low, high.ok || low.ok ? high.low : high.high);
  offer(low.high, high.ok || low.ok ? high.high : high.low);
  std::string text = "Use ";
  for (std::size_t i = 0; i < choices.size(); ++i) text += (i == 0 ? "" : " or ") + choices[i];
  return text + or_finer_cells({wanted.low, wanted.high}, cell, least);
}

std::string off_face_fix(double wanted, double cell, double least) {
  const Aligned near = align(wanted, cell);
  return "Use " + in_mm(near.low) + " or " + in_mm(near.high) + or_finer_cells({wanted}, cell, least);
}

}  // namespace similitude
