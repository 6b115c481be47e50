#pragma once
/// The way from a C++ type to the tables of abi.h, common to all kinds of plugin. Authors use the macro of their kind:
/// SIMILITUDE_CONTACT_LAW (contact_law.h), SIMILITUDE_DRAG_LAW, SIMILITUDE_SCALING_LAW, SIMILITUDE_EFFECT. A library of
/// several models writes SIMILITUDE_PLUGIN once, with a list:
///
///   SIMILITUDE_PLUGIN(similitude::contact_law<Soft>({"org.example.soft", "1.0.0", "Soft spheres"}),
///                     similitude::drag_law<Light>({"org.example.light", "1.0.0", "Light drag"}))
///
/// A model type may have
///   static void parameters(similitude::Parameters<T>&)   its parameter table (parameters.h)
///   void prepare() or void prepare(const similitude::Bed&)   called once when the parameters are in
/// An exception from either refuses the model; its text is what the user reads: what is wrong and, on an indented line,
/// how to mend it.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <vector>

#include <similitude/abi.h>
#include <similitude/known_here.h>
#include <similitude/layout.h>
#include <similitude/parameters.h>
#include <similitude/tag.h>

namespace similitude {

/// The bed a model is made for. What an older host does not know is zero.
using Bed = similitude_bed;

/// Who a model is. Third parties put a domain of theirs before the id.
struct About {
  const char* id = nullptr;
  const char* version = nullptr;
  const char* title = nullptr;
  const char* authors = nullptr;
  const char* reference = nullptr;
};

/// A model as the host holds it: one T per parameter set, and the host it was made by, which may be null.
template <class T>
struct Made {
  std::vector<T> sets;
  const similitude_host* host;
  bool half_loaded = false;   // load_state threw: it must not go on
};

template <class T>
const std::vector<T>& sets_of(const void* model) {
  return static_cast<const Made<T>*>(model)->sets;
}

/// The model of a kind that has one parameter set: everything but contact laws.
template <class T>
const T& model_of(const void* model) {
  return sets_of<T>(model).front();
}
template <class T>
T& model_of(void* model) {
  return static_cast<Made<T>*>(model)->sets.front();
}

inline void refuse(similitude_status* status, const char* why, std::int32_t row = -1) {
  if (!status) return;
  status->code = 1;
  status->row = row;
  std::snprintf(status->text, sizeof status->text, "%s", why);
}

/// Runs the author's code; an exception ends here and becomes the status.
template <class Work>
void guarded(similitude_status* status, const std::int32_t& row, Work&& work) noexcept {
  try {
    work();
  } catch (const std::exception& problem) {
    refuse(status, problem.what(), row);
  } catch (...) {
    refuse(status, "the model threw something that is not a std::exception.", row);
  }
}

/// For functions that have no status: what the author throws goes to the host's log under the function's name. False: it threw.
template <class T, class Work>
bool told(const void* model, const char* function, Work&& work) noexcept {
  similitude_status status{};
  guarded(&status, -1, work);
  if (status.code == 0) return true;
  const similitude_host* host = static_cast<const Made<T>*>(model)->host;
  char words[sizeof status.text + 64];
  std::snprintf(words, sizeof words, "%s: %s", function, status.text);
  if (host && host->log) host->log(1, words);
  return false;
}

/// The answer of such a function that throws is not a number, which the host refuses.
template <class T, class Work>
double number_or_nan(const void* model, const char* function, Work&& work) noexcept {
  double answer = not_given;
  return told<T>(model, function, [&] { answer = work(); }) ? answer : not_given;
}

template <class T>
void prepare_model(T& model, const Bed& bed) {
  if constexpr (requires { model.prepare(bed); }) {
    model.prepare(bed);
  } else if constexpr (requires { model.prepare(); }) {
    model.prepare();
  }
}

template <class T>
void* create_sets(const similitude_host* host, const similitude_bed* bed, const similitude_value* values, std::uint32_t sets,
                  similitude_status* status) noexcept {
  void* made = nullptr;
  std::int32_t row = -1;
  guarded(status, row, [&] {
    const Parameters<T>& parameters = parameters_of<T>();
    const Bed known = as_known_here(bed);
    auto models = std::make_unique<Made<T>>(Made<T>{std::vector<T>(sets), host, false});
    for (T& model : models->sets) {
      ++row;
      parameters.read(values + static_cast<std::size_t>(row) * parameters.table().size(), model);
      prepare_model(model, known);
    }
    made = models.release();
  });
  return made;
}

template <class T>
void destroy_sets(void* model) noexcept {
  delete static_cast<Made<T>*>(model);
}

/// Creates a model and asks each of its sets, once, what the host will ask by functions that have no status: here a refusal still has
/// words.
template <class T, class Ask>
void* create_and_ask(const similitude_host* host, const similitude_bed* bed, const similitude_value* values, std::uint32_t sets,
                     similitude_status* status, Ask&& ask) noexcept {
  void* model = create_sets<T>(host, bed, values, sets, status);
  if (!model) return nullptr;
  std::int32_t row = -1;
  similitude_status asked{};
  guarded(&asked, row, [&] {
    for (const T& one : sets_of<T>(model)) {
      ++row;
      ask(one);
    }
  });
  if (asked.code == 0) return model;
  if (status) *status = asked;
  destroy_sets<T>(model);
  return nullptr;
}

/// A descriptor of any kind. `functions` is the similitude_<kind>_functions and lives for ever.
template <class T>
similitude_descriptor describe_model(const char* kind, const void* functions, const About& about) {
  const std::vector<similitude_parameter>& table = parameters_of<T>().table();
  similitude_descriptor d{};
  d.struct_size = sizeof d;
  d.parameter_count = static_cast<std::uint32_t>(table.size());
  d.kind = kind;
  d.id = about.id;
  d.version = about.version;
  d.title = about.title;
  d.authors = about.authors;
  d.reference = about.reference;
  d.parameters = table.data();
  d.functions = functions;
  d.create = &create_sets<T>;
  d.destroy = &destroy_sets<T>;
  return d;
}

/// What this file is compiled with and for.
constexpr const char* compiler() { return SIMILITUDE_COMPILER; }
constexpr const char* instruction_set() { return SIMILITUDE_INSTRUCTION_SET; }

template <std::size_t N>
constexpr void copy_text(const char* from, char (&to)[N]) {
  std::size_t length = 0;
  for (; from[length] != 0 && length + 1 < N; ++length) to[length] = from[length];
  while (length > 0 && to[length - 1] == ' ') to[--length] = 0;   // clang's version ends in a space
}

constexpr similitude_tag make_tag() {
  similitude_tag tag{};
  copy_text(SIMILITUDE_TAG_MAGIC, tag.magic);
  tag.struct_size = sizeof tag;
  tag.abi_major = SIMILITUDE_ABI_MAJOR;
  tag.abi_minor = SIMILITUDE_ABI_MINOR;
  tag.layout_hash = abi::layout_hash();
  copy_text(compiler(), tag.compiler);
  copy_text(instruction_set(), tag.instruction_set);
  return tag;
}

template <std::size_t N>
constexpr std::array<const similitude_descriptor*, N> addresses_of(const similitude_descriptor (&descriptors)[N]) {
  std::array<const similitude_descriptor*, N> all{};
  for (std::size_t i = 0; i < N; ++i) all[i] = &descriptors[i];
  return all;
}

}  // namespace similitude

/// Once per library, in the global namespace: the tag, the descriptors and the one exported symbol. The tag is plain
/// bytes in a section of its own, for a loader that looks before it maps.
#define SIMILITUDE_PLUGIN(...)                                                                            \
  namespace {                                                                                             \
  __attribute__((section(SIMILITUDE_TAG_SECTION), used)) constexpr similitude_tag similitude_plugin_tag = \
      similitude::make_tag();                                                                             \
  const similitude_descriptor similitude_plugin_models[] = {__VA_ARGS__};                                 \
  constexpr auto similitude_plugin_list = similitude::addresses_of(similitude_plugin_models);             \
  }                                                                                                       \
  extern "C" {                                                                                            \
  SIMILITUDE_EXPORT extern const similitude_entry similitude_plugin;                                      \
  }                                                                                                       \
  constinit const similitude_entry similitude_plugin = {                                                  \
      sizeof(similitude_entry), static_cast<std::uint32_t>(similitude_plugin_list.size()),                \
      &similitude_plugin_tag, similitude_plugin_list.data()};
