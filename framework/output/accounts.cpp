#include "output/accounts.h"

#include <algorithm>
#include <cmath>

namespace similitude {
namespace {

double magnitude(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

double relative(double missing, double moved) { return moved > 0 ? missing / moved : 0; }

/// Sum of m |v| [kg m/s]: what rounding in the total is measured by, however well momenta cancel.
double gross_momentum_of(const ParticleStore& particles) {
  double sum = 0;
  for (const Row& v : particles.velocity) sum += v.w * std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return sum;
}

}  // namespace

std::array<double, 3> momentum_of(const ParticleStore& particles) {
  std::array<double, 3> sum{};
  for (const Row& v : particles.velocity) {
    sum[0] += v.w * v.x;
    sum[1] += v.w * v.y;
    sum[2] += v.w * v.z;
  }
  return sum;
}

double energy_of(const ParticleStore& particles) {
  double twice = 0;
  for (const Row& v : particles.velocity) twice += v.w * (v.x * v.x + v.y * v.y + v.z * v.z);
  for (const Row& w : particles.angular_velocity) twice += w.w * (w.x * w.x + w.y * w.y + w.z * w.z);
  return 0.5 * twice;
}

Accounts::Accounts(const ParticleStore& particles, double gas_mass)
    : state_{.momentum = momentum_of(particles), .energy = energy_of(particles), .gas_mass = gas_mass} {}

void Accounts::add_gas_step(double inflow, double outflow, const BoundaryAction& boundary, const std::array<double, 3>& buoyancy,
                            double dt) {
  state_.gas_in += inflow * dt;
  state_.gas_out += outflow * dt;
  for (std::size_t a = 0; a < 3; ++a) {
    state_.boundary_impulse[a] += boundary.force[a] * dt;
    state_.buoyancy[a] += buoyancy[a] * dt;
  }
  state_.pumping_work += boundary.pumping * dt;
}

Balances Accounts::balances(const ParticleStore& particles, const ParticleBudget& b, const GasHeld& gas) const {
  Balances out;
  const std::array<double, 3> now = momentum_of(particles);
  std::array<double, 3> missing{};
  for (std::size_t a = 0; a < 3; ++a) {
    missing[a] = now[a] - state_.momentum[a] + b.removed_momentum[a] -
                 (b.gravity_impulse[a] + b.drag_impulse[a] + b.stress_impulse[a] + b.wall_impulse[a]);
  }
  const double impulses = magnitude(state_.momentum) + magnitude(b.gravity_impulse) + magnitude(b.drag_impulse) +
                          magnitude(b.stress_impulse) + magnitude(b.wall_impulse);
  out.momentum = relative(magnitude(missing), std::max(impulses, gross_momentum_of(particles)));
  out.energy = relative(std::abs(energy_of(particles) - state_.energy + b.removed_energy -
                                 (b.gravity_work + b.drag_work + b.stress_work + b.contact_work)),
                        state_.energy + std::abs(b.gravity_work) + std::abs(b.drag_work) + std::abs(b.stress_work) +
                            std::abs(b.contact_work));
  // An open bed without a stream passes next to nothing: rounding over that would be a drift of some per cent.
  const double moved = std::max(state_.gas_in + state_.gas_out, state_.gas_mass);
  out.gas_mass = relative(std::abs(gas.mass - state_.gas_mass - state_.gas_in + state_.gas_out), moved);

  std::array<double, 3> given{}, lost{};   // by the gas to the particles, and what its boundary does not explain
  for (std::size_t a = 0; a < 3; ++a) {
    given[a] = b.drag_impulse[a] + b.stress_impulse[a] - state_.buoyancy[a];
    lost[a] = state_.boundary_impulse[a] - given[a] - gas.momentum[a];
  }
  out.gas_momentum = relative(magnitude(lost), magnitude(state_.boundary_impulse) + magnitude(given));
  return out;
}

}  // namespace similitude
