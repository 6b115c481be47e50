#include <stdexcept>

#include "creature.h"

static void* explode(const similitude_host*, const similitude_bed*, const similitude_value*, uint32_t, similitude_status*) {
  throw std::runtime_error("the fuse was short.");
}

static constexpr similitude_descriptor explosive() {
  similitude_descriptor model = zoo::sound_model("throws_in_create");
  model.create = explode;
  return model;
}

ZOO_TAG(zoo::sound_tag())
ZOO_ENTRY(explosive())
