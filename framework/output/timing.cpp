#include "output/timing.h"

#include <nlohmann/json.hpp>

#include "output/whole_file.h"

namespace similitude {

void write_timing(const OutputDirectory& directory, const Timing& timing) {
  using json = nlohmann::ordered_json;
  const bool timed = timing.wall_s > 0;
  json stages = json::array();
  double accounted = 0;
  const auto add = [&](const std::string& name, double seconds) {
    stages.push_back({{"name", name}, {"seconds", seconds}, {"share", timed ? seconds / timing.wall_s : 0}});
    accounted += seconds;
  };
  for (const StageTime& stage : timing.stages) add(stage.name, stage.seconds);
  if (accounted < timing.wall_s) add("other", timing.wall_s - accounted);

  const auto steps = static_cast<double>(timing.particle_steps);
  const json out = {{"wall_s", timing.wall_s},
                    {"simulated_s", timing.simulated_s},
                    {"particle_steps", timing.particle_steps},
                    {"particle_steps_per_s", timed ? steps / timing.wall_s : 0},
                    {"stages", stages}};
  write_whole_file(directory.file("timing.json"), out.dump(2) + "\n");
}

}  // namespace similitude
