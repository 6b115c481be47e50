#pragma once
/// Columns of doubles that end, or start, at memory that nobody may touch.

#include <cstddef>
#include <string>
#include <utility>

namespace similitude::doctor {

/// What lies beside the column: a forbidden page right after its last row, right before its first, or only far away.
enum class Edge { far, end, start };

class GuardedColumn {
 public:
  GuardedColumn() = default;
  /// `rows` zeros, 64-byte aligned at both ends if `rows` is a multiple of 8. Throws std::bad_alloc.
  GuardedColumn(std::string name, std::size_t rows, Edge edge);
  ~GuardedColumn();
  GuardedColumn(GuardedColumn&& other) noexcept { swap(other); }
  GuardedColumn& operator=(GuardedColumn&& other) noexcept {
    swap(other);
    return *this;
  }

  double* data() { return begin_; }
  const double* data() const { return begin_; }
  double& operator[](std::size_t row) { return begin_[row]; }
  double operator[](std::size_t row) const { return begin_[row]; }
  std::size_t rows() const { return rows_; }

  /// Reading stays allowed; a write ends the process. An input.
  void forbid_writing();
  void allow_writing();

 private:
  void swap(GuardedColumn& other) noexcept;

  double* begin_ = nullptr;
  std::size_t rows_ = 0;
  std::size_t place_ = 0;   // in the table of all columns
};

/// A touch of forbidden memory, told by the address. Plain data: filled while a signal is handled.
struct ForbiddenTouch {
  char column[48] = "";   // empty: no column is near
  long row = 0;           // the row it would have been; negative before the first
  std::size_t rows = 0;
};
ForbiddenTouch touch_at(const void* address);

}  // namespace similitude::doctor
