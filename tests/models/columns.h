#pragma once
/// Columns of doubles as a block wants them: 64-byte aligned, all of one length, which is a multiple of 8.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

#include <similitude/abi.h>
#include <similitude/vec3.h>

namespace similitude::test {

class Column {
 public:
  explicit Column(std::size_t rows = 0, double value = 0) : rows_(rows) {
    const std::size_t bytes = (rows * sizeof(double) + 63) / 64 * 64;
    values_.reset(static_cast<double*>(::operator new(bytes + 64, std::align_val_t{64})));
    for (std::size_t row = 0; row < rows; ++row) values_[row] = value;
  }
  double& operator[](std::size_t row) { return values_[row]; }
  double operator[](std::size_t row) const { return values_[row]; }
  double* data() { return values_.get(); }
  std::size_t rows() const { return rows_; }

 private:
  struct Free {
    void operator()(double* p) const { ::operator delete(p, std::align_val_t{64}); }
  };
  std::size_t rows_;
  std::unique_ptr<double[], Free> values_;
};

/// A vector per row.
struct Columns3 {
  explicit Columns3(std::size_t rows) : axis{Column(rows), Column(rows), Column(rows)} {}
  std::array<Column, 3> axis;
  void set(std::size_t row, const Vec3<double>& v) { axis[0][row] = v.x, axis[1][row] = v.y, axis[2][row] = v.z; }
  Vec3<double> get(std::size_t row) const { return {axis[0][row], axis[1][row], axis[2][row]}; }
};

/// A block of contacts that owns its columns.
struct ContactColumns {
  explicit ContactColumns(std::size_t rows)
      : normal(rows), velocity(rows), angular_i(rows), angular_j(rows), force(rows), couple(rows), overlap(rows),
        radius_i(rows), radius_j(rows), effective_mass(rows), pair(rows, 0) {
    if (rows % SIMILITUDE_ROW_MULTIPLE != 0) throw std::invalid_argument("rows must be a multiple of 8");
    for (Column& h : history) h = Column(rows);
  }

  std::size_t rows() const { return overlap.rows(); }

  /// `history_count` as the model needs it; no pairs unless asked for.
  similitude_contact_block block(double dt, std::uint32_t history_count, bool rotation = true, bool with_pairs = false) {
    similitude_contact_block b{};
    b.struct_size = sizeof b;
    b.rows = static_cast<std::uint32_t>(rows());
    b.dt = dt;
    for (std::size_t a = 0; a < 3; ++a) {
      b.normal[a] = normal.axis[a].data();
      b.velocity[a] = velocity.axis[a].data();
      b.angular_velocity_i[a] = rotation ? angular_i.axis[a].data() : nullptr;
      b.angular_velocity_j[a] = rotation ? angular_j.axis[a].data() : nullptr;
      b.force[a] = force.axis[a].data();
      b.couple[a] = couple.axis[a].data();
    }
    b.overlap = overlap.data();
    b.radius_i = radius_i.data();
    b.radius_j = radius_j.data();
    b.effective_mass = effective_mass.data();
    b.pair = with_pairs ? pair.data() : nullptr;
    for (std::uint32_t h = 0; h < history_count; ++h) b.history[h] = history[h].data();
    return b;
  }

  Columns3 normal, velocity, angular_i, angular_j, force, couple;
  Column overlap, radius_i, radius_j, effective_mass;
  std::vector<std::uint32_t> pair;
  std::array<Column, SIMILITUDE_MAX_HISTORY> history;
};

}  // namespace similitude::test
