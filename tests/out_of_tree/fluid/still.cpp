// A gas at rest, which needs nothing of the framework but shows that a fluid plugin can: it names its faces.
#include <fluid/grid.h>
#include <similitude/plugin.h>

#include <stdexcept>
#include <string>

namespace {

struct Still {
  void prepare() {
    if (similitude::face_name({similitude::Axis::z, similitude::Side::high}) != "top")
      throw std::logic_error("the top is not the top.");
  }
};

void initialise(void*, const similitude_grid*, const similitude_gas_step*, similitude_status*) {}
void advance(void*, const similitude_gas_step*, similitude_gas_report*, similitude_status*) {}

constexpr similitude_fluid_functions k_functions{
    sizeof(similitude_fluid_functions), 0, initialise, advance, nullptr, nullptr, nullptr, nullptr};

}  // namespace

SIMILITUDE_PLUGIN(similitude::describe_model<Still>("fluid", &k_functions,
                                                    {"org.example.still", "1.0.0", "A gas at rest"}))
