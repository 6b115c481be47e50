#include "study/observed_order.h"

#include <algorithm>
#include <cmath>

namespace similitude {
namespace {

constexpr double k_highest_order = 8;  // of no scheme here
constexpr int k_halvings = 60;

/// ln((h^p - r^p) / (g^p - r^p)): what the order p makes of the ratio of two errors. Grows with p.
double log_ratio(double h, double g, double r, double p) {
  return std::log((std::pow(h, p) - std::pow(r, p)) / (std::pow(g, p) - std::pow(r, p)));
}

/// The p that gives the two errors' ratio; steps as ratios to the finest.
double order_of(double coarse, double fine, double reference, double log_of_errors) {
  double low = 1e-3, high = k_highest_order;
  if (log_ratio(coarse, fine, reference, low) >= log_of_errors) return low;
  if (log_ratio(coarse, fine, reference, high) <= log_of_errors) return high;
  for (int k = 0; k < k_halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (log_ratio(coarse, fine, reference, middle) < log_of_errors ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Sum of squares of ln(error) - ln(A (h^p - r^p)) with the best A.
double misfit(const std::vector<OrderPoint>& points, double reference, double p) {
  double sum = 0, squares = 0;
  for (const OrderPoint& point : points) {
    const double rest = std::log(point.error.value) - std::log(std::pow(point.step, p) - std::pow(reference, p));
    sum += rest;
    squares += rest * rest;
  }
  return squares - sum * sum / static_cast<double>(points.size());
}

double best_order(const std::vector<OrderPoint>& points, double reference) {
  // One minimum: golden section.
  constexpr double k_golden = 0.6180339887498949;
  double low = 1e-3, high = k_highest_order;
  for (int k = 0; k < k_halvings; ++k) {
    const double a = high - k_golden * (high - low), b = low + k_golden * (high - low);
    (misfit(points, reference, a) < misfit(points, reference, b) ? high : low) =
        misfit(points, reference, a) < misfit(points, reference, b) ? b : a;
  }
  return 0.5 * (low + high);
}

}  // namespace

Estimate observed_order(const std::vector<OrderPoint>& given, double reference_step) {
  std::vector<OrderPoint> points;
  for (const OrderPoint& point : given)
    if (point.error.known() && point.error.low > 0 && point.step > reference_step) points.push_back(point);
  if (points.size() < 2) return gap("fewer than two errors stand out of the noise");
  std::sort(points.begin(), points.end(), [](const OrderPoint& a, const OrderPoint& b) { return a.step < b.step; });
  const double unit = points.front().step;  // so that the fit sees no metres or seconds
  for (OrderPoint& point : points) point.step /= unit;
  const double reference = reference_step / unit;

  Estimate order;
  const OrderPoint &fine = points.front(), &coarse = points.back();
  order.value = best_order(points, reference);
  order.low = order_of(coarse.step, fine.step, reference, std::log(coarse.error.low / fine.error.high));
  order.high = order_of(coarse.step, fine.step, reference, std::log(coarse.error.high / fine.error.low));
  order.low = std::min(order.low, order.value);
  order.high = std::max(order.high, order.value);
  order.lower_bound =
      std::any_of(points.begin(), points.end(), [](const OrderPoint& p) { return p.error.lower_bound; });
  return order;
}

}  // namespace similitude
