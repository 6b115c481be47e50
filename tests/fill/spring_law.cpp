#include "bed_of_springs.h"

SIMILITUDE_CONTACT_LAW(similitude::test::Spring, "test_spring", "1.0.0", "Linear spring with friction, for tests")

namespace similitude::test {

ContactModel spring_law(double stiffness, double friction) {
  const similitude_descriptor& descriptor = *similitude_plugin.descriptors[0];
  similitude_bed bed{};
  bed.struct_size = sizeof bed;
  const std::vector<similitude_value> values{{stiffness, nullptr}, {0.74, nullptr}, {friction, nullptr}};
  similitude_status status{};
  void* const instance = descriptor.create(nullptr, &bed, values.data(), 1, &status);
  if (!instance) throw std::runtime_error(status.text);
  return ContactModel(descriptor, instance);
}

}  // namespace similitude::test
