#pragma once
/// What a sound plugin consists of, written against the bare C boundary so that each creature can spoil one piece of
/// it.

#include <similitude/abi.h>
#include <similitude/layout.h>

#include <limits>

namespace zoo {

constexpr similitude_tag sound_tag() {
  return {SIMILITUDE_TAG_MAGIC,
          sizeof(similitude_tag),
          SIMILITUDE_ABI_MAJOR,
          SIMILITUDE_ABI_MINOR,
          similitude::abi::layout_hash(),
          0,
          "zoo 1.0.0",
          "x86-64"};
}

inline void no_exchange(const void*, const similitude_drag_block*, similitude_status*) {}
inline constexpr similitude_drag_functions k_functions{sizeof(similitude_drag_functions), 0, nullptr, no_exchange};

inline void* create(const similitude_host*, const similitude_bed*, const similitude_value*, uint32_t,
                    similitude_status*) {
  static int model;
  return &model;
}
inline void destroy(void*) {}

inline constexpr double k_open = std::numeric_limits<double>::infinity();
inline constexpr similitude_parameter k_factor{sizeof(similitude_parameter),
                                               SIMILITUDE_REAL,
                                               0,
                                               SIMILITUDE_SCALES_NOT,
                                               "factor",
                                               "1",
                                               "multiplies the drag",
                                               nullptr,
                                               nullptr,
                                               nullptr,
                                               0.5,
                                               0,
                                               1,
                                               0,
                                               0,
                                               nullptr};

constexpr similitude_descriptor sound_model(const char* id) {
  return {sizeof(similitude_descriptor),
          1,
          "drag",
          id,
          "1.0.0",
          "A creature of the zoo",
          nullptr,
          nullptr,
          &k_factor,
          &k_functions,
          create,
          destroy};
}

}  // namespace zoo

#define ZOO_TAG(tag) \
  __attribute__((section(SIMILITUDE_TAG_SECTION), used)) static constexpr similitude_tag zoo_tag = tag;

#define ZOO_ENTRY(model)                                                                                \
  static constexpr similitude_descriptor zoo_model = model;                                             \
  static constexpr const similitude_descriptor* zoo_models[] = {&zoo_model};                            \
  extern "C" __attribute__((visibility("default"), used)) constexpr similitude_entry similitude_plugin{ \
      sizeof(similitude_entry), 1, nullptr, zoo_models};
