// Drag laws against the bare C boundary, where no header keeps the author from harm.
#include <similitude/plugin.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace {

void* create(const similitude_host*, const similitude_bed*, const similitude_value*, std::uint32_t, similitude_status*) {
  static int model;
  return &model;
}
void destroy(void*) {}

double stokes(const similitude_drag_block* b, std::uint32_t row) { return 9.42477796 * b->gas_viscosity[row] * b->diameter[row]; }

void fill(const similitude_drag_block* b) {
  for (std::uint32_t row = 0; row < b->rows; ++row) b->exchange[row] = stokes(b, row);
}

void writes_beyond(const void*, const similitude_drag_block* b, similitude_status*) {
  fill(b);
  b->exchange[b->rows] = 0;
}
void reads_before(const void*, const similitude_drag_block* b, similitude_status*) {
  fill(b);
  const volatile double* fractions = b->gas_fraction;
  b->exchange[0] += 0 * fractions[-1];
}
void writes_into_its_input(const void*, const similitude_drag_block* b, similitude_status*) {
  fill(b);
  const_cast<double*>(b->slip_speed)[1] = 0;
}
void leaves_rows_out(const void*, const similitude_drag_block* b, similitude_status*) {
  for (std::uint32_t row = 0; row + 1 < b->rows; ++row) b->exchange[row] = stokes(b, row);
}
__attribute__((no_sanitize("undefined"))) void uses_what_it_did_not_ask_for(const void*, const similitude_drag_block* b, similitude_status*) {
  for (std::uint32_t row = 0; row < b->rows; ++row) b->exchange[row] = stokes(b, row) * b->cell_size[row];
}
void looks_at_its_neighbour(const void*, const similitude_drag_block* b, similitude_status*) {
  for (std::uint32_t row = 0; row < b->rows; ++row) b->exchange[row] = stokes(b, row) * (row > 0 ? 1 + b->gas_fraction[row - 1] : 2);
}
void keeps_notes(const void*, const similitude_drag_block* b, similitude_status*) {
  static std::array<double, 1 << 16> notes;   // more than any block has rows
  for (std::uint32_t row = 0; row < b->rows; ++row) {
    notes[row] = stokes(b, row) * (2 - b->gas_fraction[row]);
    if (row == b->rows / 2) std::this_thread::yield();
  }
  for (std::uint32_t row = 0; row < b->rows; ++row) b->exchange[row] = notes[row];
}
void lets_an_exception_out(const void*, const similitude_drag_block*, similitude_status*) { throw std::runtime_error("ouch"); }
void gives_up(const void*, const similitude_drag_block*, similitude_status*) { std::abort(); }

void* throws_in_create(const similitude_host*, const similitude_bed*, const similitude_value*, std::uint32_t, similitude_status*) {
  throw std::runtime_error("no bed is good enough");
}
void* refuses_without_a_word(const similitude_host*, const similitude_bed*, const similitude_value* values, std::uint32_t,
                             similitude_status* status) {
  static int model;
  status->code = values[0].real == 1 ? 1 : 0;
  return values[0].real == 1 ? nullptr : &model;
}

constexpr similitude_parameter k_factor{sizeof(similitude_parameter), SIMILITUDE_REAL, 0, SIMILITUDE_SCALES_NOT, "factor", "1", "Multiplies.",
                                        nullptr, nullptr, nullptr, 0.5, 0, 1, 0, 0, nullptr};

template <void (*exchange)(const void*, const similitude_drag_block*, similitude_status*)>
constexpr similitude_drag_functions k_functions{sizeof(similitude_drag_functions), 0, nullptr, exchange};

constexpr void (*k_sound)(const void*, const similitude_drag_block*, similitude_status*) =
    [](const void*, const similitude_drag_block* b, similitude_status*) { fill(b); };

constexpr similitude_descriptor model(const char* id, const similitude_drag_functions& functions) {
  return {sizeof(similitude_descriptor), 0, "drag", id, "1.0.0", "Ill", nullptr, nullptr, nullptr, &functions, create, destroy};
}
constexpr similitude_descriptor with_create(similitude_descriptor one, decltype(similitude_descriptor::create) made) {
  one.create = made;
  one.parameter_count = 1;
  one.parameters = &k_factor;
  return one;
}

}  // namespace

SIMILITUDE_PLUGIN(model("writes_beyond", k_functions<writes_beyond>), model("reads_before", k_functions<reads_before>),
                  model("writes_into_its_input", k_functions<writes_into_its_input>),
                  model("leaves_rows_out", k_functions<leaves_rows_out>),
                  model("uses_what_it_did_not_ask_for", k_functions<uses_what_it_did_not_ask_for>),
                  model("looks_at_its_neighbour", k_functions<looks_at_its_neighbour>), model("keeps_notes", k_functions<keeps_notes>),
                  model("lets_an_exception_out", k_functions<lets_an_exception_out>), model("gives_up", k_functions<gives_up>),
                  with_create(model("throws_in_create", k_functions<k_sound>), throws_in_create),
                  with_create(model("refuses_without_a_word", k_functions<k_sound>), refuses_without_a_word))
