#include "doctor/guarded_column.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <new>

namespace similitude::doctor {
namespace {

/// All columns of this process. A fixed table, because a signal handler reads it. Blocks are made by one thread.
struct Known {
  char name[48] = "";
  char* map = nullptr;      // forbidden page, readable pages, forbidden page
  std::size_t bytes = 0;    // of the map
  double* begin = nullptr;
  std::size_t rows = 0;
};
constexpr std::size_t k_most_columns = 1024;
std::array<Known, k_most_columns> known_columns;

std::size_t page_size() {
  static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return size;
}

std::size_t free_place() {
  for (std::size_t place = 0; place < k_most_columns; ++place)
    if (known_columns[place].map == nullptr) return place;
  throw std::bad_alloc();
}

}  // namespace

GuardedColumn::GuardedColumn(std::string name, std::size_t rows, Edge edge) : rows_(rows), place_(free_place()) {
  const std::size_t page = page_size(), bytes = rows * sizeof(double);
  // Far from the edges there is a page of room on both sides.
  const std::size_t room = ((bytes + page - 1) / page + (edge == Edge::far ? 2 : 0)) * page;
  void* map = mmap(nullptr, room + 2 * page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (map == MAP_FAILED) throw std::bad_alloc();
  char* const readable = static_cast<char*>(map) + page;
  if (mprotect(readable, room, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
  char* const first = edge == Edge::end ? readable + room - bytes : edge == Edge::start ? readable : readable + page;
  begin_ = reinterpret_cast<double*>(first);
  Known& entry = known_columns[place_];
  std::strncpy(entry.name, name.c_str(), sizeof entry.name - 1);
  entry.map = static_cast<char*>(map);
  entry.bytes = room + 2 * page;
  entry.begin = begin_;
  entry.rows = rows;
}

GuardedColumn::~GuardedColumn() {
  if (begin_ == nullptr) return;
  Known& entry = known_columns[place_];
  munmap(entry.map, entry.bytes);
  entry = Known{};
}

void GuardedColumn::swap(GuardedColumn& other) noexcept {
  std::swap(begin_, other.begin_);
  std::swap(rows_, other.rows_);
  std::swap(place_, other.place_);
}

void GuardedColumn::forbid_writing() {
  const Known& entry = known_columns[place_];
  mprotect(entry.map + page_size(), entry.bytes - 2 * page_size(), PROT_READ);
}

void GuardedColumn::allow_writing() {
  const Known& entry = known_columns[place_];
  mprotect(entry.map + page_size(), entry.bytes - 2 * page_size(), PROT_READ | PROT_WRITE);
}

ForbiddenTouch touch_at(const void* address) {
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  ForbiddenTouch touch;
  for (const Known& column : known_columns) {
    const auto low = reinterpret_cast<std::uintptr_t>(column.map);
    if (column.map == nullptr || at < low || at >= low + column.bytes) continue;
    std::memcpy(touch.column, column.name, sizeof touch.column);
    const auto distance = static_cast<std::intptr_t>(at - reinterpret_cast<std::uintptr_t>(column.begin));
    constexpr auto width = static_cast<std::intptr_t>(sizeof(double));
    touch.row = (distance < 0 ? distance - width + 1 : distance) / width;
    touch.rows = column.rows;
  }
  return touch;
}

}  // namespace similitude::doctor
