// A steady flow made up beforehand, with a gas fraction that varies by half: what the equations leave over is given to the solver as
// a force, and it must find the flow again. Errors of velocity and pressure and the order at which they fall with the cells.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "gas_run.h"
#include "record.h"

namespace similitude {
namespace {

using test::Box;
using test::GasRun;
using test::u;

constexpr double k_density = 1.3, k_viscosity = 0.05, k_exchange = 2;   // [kg/m^3], [Pa s], [kg/(m^3 s)], in a box of 2 pi m

using Field = std::function<double(double x, double z)>;

double fraction(double x, double z) { return 0.7 + 0.15 * std::sin(x) + 0.1 * std::cos(z); }
double flux_x(double, double z) { return 1 + 0.5 * std::sin(z); }          // eps u, without divergence
double flux_z(double x, double) { return 0.6 + 0.4 * std::cos(x); }
double velocity_x(double x, double z) { return flux_x(x, z) / fraction(x, z); }
double velocity_z(double x, double z) { return flux_z(x, z) / fraction(x, z); }
double pressure(double x, double z) { return std::cos(x) * std::sin(z) + 0.5 * std::sin(2 * x); }

// Derivatives of known functions: four points, error h^4.
constexpr double k_h = 1e-3;
Field ddx(Field f) {
  return [f](double x, double z) { return (8 * (f(x + k_h, z) - f(x - k_h, z)) - (f(x + 2 * k_h, z) - f(x - 2 * k_h, z))) / (12 * k_h); };
}
Field ddz(Field f) {
  return [f](double x, double z) { return (8 * (f(x, z + k_h) - f(x, z - k_h)) - (f(x, z + 2 * k_h) - f(x, z - 2 * k_h))) / (12 * k_h); };
}
Field product(Field a, Field b) {
  return [a, b](double x, double z) { return a(x, z) * b(x, z); };
}

/// R of rho div(eps u u) = eps (-grad p + div tau) - E u + R, tau = mu (grad u + grad u^T - 2/3 div u I); component x or z.
Field force(bool along_x) {
  const Field own = along_x ? velocity_x : velocity_z;
  const Field carried_x = ddx(product(flux_x, own)), carried_z = ddz(product(flux_z, own));
  const Field ux_x = ddx(velocity_x), ux_z = ddz(velocity_x), uz_x = ddx(velocity_z), uz_z = ddz(velocity_z);
  const Field shear = [=](double x, double z) { return k_viscosity * (ux_z(x, z) + uz_x(x, z)); };
  const Field tension = [=](double x, double z) {
    return k_viscosity * (2 * (along_x ? ux_x(x, z) : uz_z(x, z)) - 2.0 / 3 * (ux_x(x, z) + uz_z(x, z)));
  };
  const Field tau_along = along_x ? ddx(tension) : ddz(tension), tau_across = along_x ? ddz(shear) : ddx(shear);
  const Field gradient = along_x ? ddx(pressure) : ddz(pressure);
  return [=](double x, double z) {
    return k_density * (carried_x(x, z) + carried_z(x, z)) + fraction(x, z) * (gradient(x, z) - tau_along(x, z) - tau_across(x, z)) +
           k_exchange * own(x, z);
  };
}

struct Errors {
  double velocity, pressure;   // root mean squares
};

Errors errors_with(int n) {
  const double h = 2 * std::numbers::pi / n;
  Box box({.cells = {n, 1, n}, .spacing = {h, 1, h}, .periodic = {true, true, true}});
  GasRun run(box, {.density = k_density, .viscosity = k_viscosity, .tolerance = 1e-10});
  const Field force_x = force(true), force_z = force(false);
  const std::size_t cells = u(run.mesh.cell_count);
  for (Index k = 0; k < n; ++k) {
    for (Index i = 0; i < n; ++i) {
      const double x = (static_cast<double>(i) + 0.5) * h, z = (static_cast<double>(k) + 0.5) * h;
      const std::size_t c = u(run.mesh.cell({i, 0, k}));
      run.gas_fraction[c] = fraction(x, z);
      run.exchange[c] = k_exchange;
      run.remainder[c] = force_x(x, z);
      run.remainder[2 * cells + c] = force_z(x, z);
    }
  }
  run.gas_fraction_old = run.gas_fraction;
  run.set_velocity([](std::size_t axis, double x, double, double z) {
    return axis == 0 ? velocity_x(x, z) : axis == 2 ? velocity_z(x, z) : 0;
  });
  EXPECT_LT(run.advance_until_steady(0.2 * h, 1e-7, 4000), 4000);
  double squares_u = 0, squares_p = 0, mean_p = 0, mean_exact = 0;
  for (int pass = 0; pass < 2; ++pass) {
    for (Index k = 0; k < n; ++k) {
      for (Index i = 0; i < n; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * h, z = (static_cast<double>(k) + 0.5) * h;
        const double p = run.pressure_at({i, 0, k}), exact = pressure(x, z), cell = 1.0 / (n * n);
        if (pass == 0) {
          mean_p += p * cell;
          mean_exact += exact * cell;
          const double face_x = static_cast<double>(i) * h;
          const double error = run.solver.face_velocity(0)[u(run.mesh.face(0, {i, 0, k}))] - velocity_x(face_x, z);
          squares_u += error * error * cell;
        } else {
          const double error = p - mean_p - exact + mean_exact;   // a periodic box knows no level of pressure
          squares_p += error * error * cell;
        }
      }
    }
  }
  return {std::sqrt(squares_u), std::sqrt(squares_p)};
}

TEST(ManufacturedFlow, WithAVaryingGasFractionIsFoundAtSecondOrder) {
  const Errors coarse = errors_with(16), middle = errors_with(32), fine = errors_with(64);
  const double order_u = std::log2(middle.velocity / fine.velocity), order_p = std::log2(middle.pressure / fine.pressure);
  std::printf("  u %.3g %.3g %.3g (order %.2f), p %.3g %.3g %.3g (order %.2f)\n", coarse.velocity, middle.velocity, fine.velocity, order_u,
              coarse.pressure, middle.pressure, fine.pressure, order_p);
  EXPECT_GT(order_u, 1.7);   // 2 where the limiter of the advection sleeps; at extremes it falls to 1
  EXPECT_GT(order_p, 1.7);
  test::record({"gas equations with a gas fraction of 0.45 to 0.95", "manufactured solution, 16 to 64 cells",
                fmt::format("orders {:.2f} (u), {:.2f} (p)", order_u, order_p), ""});
  std::vector<std::array<double, 3>> curve;
  curve.push_back({16, coarse.velocity, coarse.pressure});
  curve.push_back({32, middle.velocity, middle.pressure});
  curve.push_back({64, fine.velocity, fine.pressure});
  test::record_curve("manufactured", "cells per side,error of velocity [m/s],error of pressure [Pa]", curve);
}

}  // namespace
}  // namespace similitude
