#include <cstring>

#include "creature.h"

/// Refuses to make a model: in words above 0.5, in a text without an end at 0.25, without a word below.
static void* refuse(const similitude_host*, const similitude_bed*, const similitude_value* values, uint32_t,
                    similitude_status* status) {
  status->code = 1;
  if (values[0].real > 0.5)
    std::strcpy(status->text, "the factor 0.75 does not fit a bed of 1 mm particles.\n  Use at most 0.5.");
  else if (values[0].real == 0.25)
    std::memset(status->text, 'x', sizeof status->text);
  return nullptr;
}

static constexpr similitude_descriptor stubborn() {
  similitude_descriptor model = zoo::sound_model("refuses");
  model.create = refuse;
  return model;
}

ZOO_TAG(zoo::sound_tag())
ZOO_ENTRY(stubborn())
