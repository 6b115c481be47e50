#pragma once
/// Every key of a case file, once: the reader, the JSON Schema and the tests of the reference page all go by these tables.

#include <span>
#include <string_view>

namespace similitude {

/// How a value is written.
enum class Form {
  text,
  integer,
  flag,
  choice,           // one of `choices`
  quantity,         // in the dimension of `unit`
  quantity_or_auto,
  interval,         // [low, high]
  box,              // [x, y, z]
  box_or_cube,      // [x, y, z], or one for all three
  gravity,          // [x, y, z], or one, downward
  positions,        // [a, b, …], or one
  every,            // every 50 ms
  every_or_none,
  axes,             // [x, y]
  texts,            // [a, b, …]
  section,          // a map with the keys of `table`
  named_sections,   // a map of names, each with the keys of `table`
  model,            // an id, or a map of id and parameters; `choices` holds the kind
  effects,          // auto, or a list of models
};

/// Which values of a quantity or integer make sense.
enum class Sign { any, not_negative, positive };

struct CaseKey;
using KeyTable = std::span<const CaseKey>;

struct CaseKey {
  std::string_view name;
  Form form = Form::text;
  std::string_view unit = "";           // of quantities, as people write them
  Sign sign = Sign::any;
  bool required = false;
  std::string_view default_text = "";   // as it would be written; empty if the doc says what happens
  std::string_view doc = "";
  std::string_view choices = "";        // "a|b|c"
  KeyTable (*table)() = nullptr;
};

/// The version of the format, the value of the key `similitude`.
inline constexpr int k_case_version = 1;

KeyTable case_keys();         // the whole file
KeyTable scene_keys();
KeyTable domain_keys();
KeyTable gas_keys();
KeyTable particle_keys();     // of one class
KeyTable bed_keys();
KeyTable patch_keys();
KeyTable baffle_keys();
KeyTable wall_keys();
KeyTable models_keys();
KeyTable coupling_keys();
KeyTable time_keys();
KeyTable output_keys();
KeyTable profile_keys();
KeyTable probe_keys();

/// models.scaling.stiffness: a key of the framework that stands among the scaling law's own parameters.
const CaseKey& simulated_stiffness_key();

/// models.contact.pair: a key of the framework that stands among the contact model's own parameters.
const CaseKey& contact_pair_key();

}  // namespace similitude
