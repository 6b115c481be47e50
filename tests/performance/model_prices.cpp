/// What a drag or contact law costs: nanoseconds per particle and per contact, one thread, blocks as the framework makes them. All
/// laws that are installed.
///
///   model_prices [--benchmark_filter=drag|contact] [--benchmark_format=json] …   (Google Benchmark's options)

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "columns.h"
#include "small_bed.h"

namespace {
using namespace similitude;
using test::Column;

constexpr std::size_t k_rows = 128;   // of a block; all columns lie in the first-level cache, as they do in a run

const std::map<std::string, std::string> k_parameters{
    {"linear_spring", "stiffness: 500 N/m, restitution: 0.8, friction: 0.3"},
    {"fluent_dem", "stiffness: 500 N/m, restitution: 0.8"},
    {"hertz_mindlin", "youngs_modulus: 10 MPa, poisson_ratio: 0.25, restitution: 0.8, friction: 0.3"},
    {"hertz_thornton", "youngs_modulus: 10 MPa, poisson_ratio: 0.25, restitution: 0.8, friction: 0.3"},
};

std::unique_ptr<Assembly> bed_with(const std::string& kind, const std::string& id) {
  std::map<std::string, std::string> models{{"drag", "gidaspow"}, {"contact", "linear_spring"}};
  models[kind] = id;
  for (auto& [_, model] : models) {
    if (const auto given = k_parameters.find(model); given != k_parameters.end()) model = fmt::format("{{id: {}, {}}}", model, given->second);
  }
  return std::make_unique<Assembly>(assemble(test::case_of(fmt::format(R"(
similitude: 1
scene:
  domain:    {{size: [20 mm, 20 mm, 40 mm], cell: 5 mm}}
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{alumina: {{diameter: 1 mm, density: 1040 kg/m^3, count: 1000}}}}
models: {{drag: {}, contact: {}, fluid: prescribed}}
time: {{end: 1 s}}
)",
                                                                       models["drag"], models["contact"])).scene,
                                             test::built_plugins()));
}

void drag(benchmark::State& state, const std::string& id) {
  const auto bed = bed_with("drag", id);
  Column diameter(k_rows, 1e-3), gas_fraction(k_rows), slip(k_rows), density(k_rows, 1.225), viscosity(k_rows, 1.79e-5);
  Column sauter(k_rows, 1e-3), cell(k_rows, 5e-3), exchange(k_rows);
  for (std::size_t n = 0; n < k_rows; ++n) {   // from the packed annulus to the spout
    const double place = static_cast<double>(n) / k_rows;
    gas_fraction[n] = 0.4 + 0.59 * place;
    slip[n] = 0.2 + 5 * place;
  }
  const similitude_drag_block block{.struct_size = sizeof(similitude_drag_block),
                                    .rows = k_rows,
                                    .diameter = diameter.data(),
                                    .gas_fraction = gas_fraction.data(),
                                    .slip_speed = slip.data(),
                                    .gas_density = density.data(),
                                    .gas_viscosity = viscosity.data(),
                                    .sauter_diameter = sauter.data(),
                                    .cell_size = cell.data(),
                                    .exchange = exchange.data()};
  similitude_status status{};
  for (auto _ : state) {
    bed->drag.functions().exchange(bed->drag.instance(), &block, &status);
    benchmark::ClobberMemory();
  }
  state.counters["per_particle"] = benchmark::Counter(static_cast<double>(k_rows), benchmark::Counter::kIsIterationInvariantRate |
                                                                                       benchmark::Counter::kInvert);
}

void contact(benchmark::State& state, const std::string& id) {
  const auto bed = bed_with("contact", id);
  const similitude_contact_needs& needs = bed->contact_needs;
  test::ContactColumns columns(k_rows);
  for (std::size_t n = 0; n < k_rows; ++n) {
    const double turn = static_cast<double>(n);
    columns.normal.set(n, {std::cos(turn), std::sin(turn), 0});
    columns.velocity.set(n, {0.1 * std::sin(3 * turn), 0.1 * std::cos(5 * turn), 0.02});
    columns.overlap[n] = 2e-6 * (1 + std::sin(7 * turn) * 0.9);
    columns.radius_i[n] = columns.radius_j[n] = 0.5e-3;
    columns.effective_mass[n] = 2.7e-7;
  }
  const similitude_contact_block block = columns.block(1e-9, needs.history_count, needs.rotation != 0);
  similitude_status status{};
  for (auto _ : state) {
    bed->contact.functions().forces(bed->contact.instance(), &block, &status);
    benchmark::ClobberMemory();
  }
  state.counters["per_contact"] = benchmark::Counter(static_cast<double>(k_rows), benchmark::Counter::kIsIterationInvariantRate |
                                                                                      benchmark::Counter::kInvert);
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::string& id : test::built_plugins().ids("drag")) benchmark::RegisterBenchmark(("drag/" + id).c_str(), drag, id);
  for (const std::string& id : test::built_plugins().ids("contact")) {
    if (id == "linear_spring" || k_parameters.contains(id)) benchmark::RegisterBenchmark(("contact/" + id).c_str(), contact, id);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
