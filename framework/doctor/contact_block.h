#pragma once
/// A block of contacts that the doctor fills, asks and reads, row by row.

#include <similitude/vec3.h>

#include <array>
#include <cstdint>
#include <vector>

#include "doctor/guarded_column.h"
#include "loader/catalogue.h"

namespace similitude::doctor {

using Vector = Vec3<double>;
using Memory = std::array<double, SIMILITUDE_MAX_HISTORY>;

struct ContactRow {
  Vector normal{1, 0, 0};          // [-], from j toward i
  double overlap = 0;              // [m]
  Vector velocity{0, 0, 0};        // [m/s], of i relative to j at the contact, without spin if the law does not rotate
  Vector spin_i{0, 0, 0}, spin_j{0, 0, 0};   // [rad/s]
  double radius_i = 0, radius_j = 0;         // [m]
  double effective_mass = 0;                 // [kg]
  std::uint32_t pair = 0;
};

struct ContactAnswer {
  Vector force, couple;   // [N], [N m], on i
};

class ContactBlock {
 public:
  /// `rows` is made a multiple of 8; rows that are not set are copies of row 0. `with_pairs`: the block names its pairs.
  ContactBlock(const ContactModel& law, std::size_t rows, Edge edge = Edge::far, bool with_pairs = false);

  void set(std::size_t row, const ContactRow& contact);
  void forbid_writing();
  /// One call of the law. What each row remembers stays in the block for the next call. Throws Complaint.
  void advance(double dt);
  ContactAnswer answer(std::size_t row) const;
  Memory memory(std::size_t row) const;
  void forget(std::size_t row);

  std::size_t rows() const { return rows_; }
  const similitude_contact_needs& needs() const { return needs_; }

 private:
  struct Three {
    std::array<GuardedColumn, 3> axis;
    void set(std::size_t row, const Vector& v);
    Vector get(std::size_t row) const { return {axis[0][row], axis[1][row], axis[2][row]}; }
  };

  const ContactModel& law_;
  similitude_contact_needs needs_{};
  std::size_t rows_;
  bool with_pairs_;
  Three normal_, velocity_, spin_i_, spin_j_, force_, couple_;
  GuardedColumn overlap_, radius_i_, radius_j_, effective_mass_;
  std::vector<std::uint32_t> pair_;
  std::array<GuardedColumn, SIMILITUDE_MAX_HISTORY> memory_;
};

/// The law of a file with its trial values.
ContactModel made_contact(const PluginEntry& plugin);

similitude_contact_needs needs_of(const ContactModel& law);
double reach_of(const ContactModel& law, double diameter);   // [m]

}  // namespace similitude::doctor
