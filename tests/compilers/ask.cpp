// ask FILE...: the same questions to the law of every file, all loaded at once. A line per file: the largest difference of its
// answers from the first file's, relative to the answer's size; the compiler by its tag; the file.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>
#include <vector>

#include "doctor/contact_block.h"
#include "doctor/trial_values.h"
#include "loader/tag.h"

namespace {

using namespace similitude;
using doctor::Vector;

/// K over gas fractions and slips, each an answer of one number.
std::vector<Vector> asked_drag(const PluginEntry& plugin) {
  const DragModel law = create_model<similitude_drag_functions>(plugin, doctor::trial_bed(), doctor::trial_values(*plugin.descriptor));
  constexpr std::size_t rows = 512;
  alignas(64) static double diameter[rows], fraction[rows], slip[rows], density[rows], viscosity[rows], exchange[rows];
  for (std::size_t n = 0; n < rows; ++n) {
    diameter[n] = 1e-3;
    fraction[n] = 0.3 + 0.7 * static_cast<double>(n % 32) / 31;
    slip[n] = std::pow(10, -3 + 0.25 * static_cast<double>(n / 32));   // [m/s], a millimetre to tens of metres
    density[n] = 1.2;
    viscosity[n] = 1.8e-5;
  }
  const similitude_drag_block block = {sizeof block, rows, diameter, fraction, slip, density, viscosity, nullptr, nullptr, exchange};
  similitude_status status{};
  law.functions().exchange(law.instance(), &block, &status);
  if (status.code != 0) throw PluginError(status.text);
  std::vector<Vector> answers;
  for (const double k : exchange) answers.push_back({k, 0, 0});
  return answers;
}

/// Forces over twenty steps of 64 contacts that slide, stick and roll, so that what is remembered counts too.
std::vector<Vector> asked_contact(const PluginEntry& plugin) {
  const ContactModel law = doctor::made_contact(plugin);
  constexpr std::size_t rows = 64;
  doctor::ContactBlock block(law, rows);
  std::vector<Vector> answers;
  for (int step = 0; step < 20; ++step) {
    for (std::size_t n = 0; n < rows; ++n) {
      const double a = 0.7 * static_cast<double>(n), turn = 0.01 * step;
      doctor::ContactRow c;
      c.normal = {std::cos(a + turn) * std::cos(2 * a), std::cos(a + turn) * std::sin(2 * a), std::sin(a + turn)};
      c.overlap = 1e-5 * (1 + std::sin(3 * a)) + 1e-7 * step;
      c.velocity = std::pow(10, -0.05 * static_cast<double>(n)) * Vector{std::sin(5 * a), std::cos(7 * a), std::sin(11 * a)};
      c.spin_i = {10 * std::sin(a), 5, 3};
      c.spin_j = {2, 8 * std::cos(a), 1};
      c.radius_i = 5e-4;
      c.radius_j = n % 5 == 0 ? INFINITY : 4e-4;
      c.effective_mass = 2.5e-7;
      block.set(n, c);
    }
    block.advance(2e-6);
    for (std::size_t n = 0; n < rows; ++n) answers.push_back(block.answer(n).force);
  }
  return answers;
}

double size(const Vector& v) { return std::sqrt(dot(v, v)); }

}  // namespace

int main(int count, char** files) {
  try {
    std::vector<Vector> first;
    for (int n = 1; n < count; ++n) {
      const Catalogue file = Catalogue::of_file(files[n]);
      if (file.plugins().size() != 1) throw PluginError(file.refused().empty() ? "no model" : file.refused().front().reason);
      const PluginEntry& plugin = file.plugins().front();
      const std::vector<Vector> answers = std::string(plugin.descriptor->kind) == "drag" ? asked_drag(plugin) : asked_contact(plugin);
      if (n == 1) first = answers;
      double worst = 0;
      for (std::size_t k = 0; k < answers.size(); ++k) {
        const double scale = std::max(size(answers[k]), size(first[k]));
        if (!std::isfinite(scale)) throw PluginError("an answer is not finite");
        if (scale > 0) worst = std::max(worst, size(answers[k] - first[k]) / scale);
      }
      const auto tag = read_tag(files[n]);
      std::printf("%.3g %s %s\n", worst, std::get<similitude_tag>(tag).compiler, files[n]);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
