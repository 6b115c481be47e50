#pragma once
/// A plugin's library as a test sees it: opened by path, models made and called through the boundary's C structures.

#include <dlfcn.h>

#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <similitude/abi.h>

namespace similitude::test {

/// A number, or the text of a choice.
struct Value {
  Value(double number = 0) : real(number) {}
  Value(int number) : real(number) {}
  Value(const char* choice) : text(choice) {}
  operator double&() { return real; }
  double real = 0;
  const char* text = nullptr;
};

/// Values by name; what is left out takes its default.
using Values = std::map<std::string, Value>;

inline const similitude_entry& open_plugin(const std::string& file) {
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(dlerror());
  const void* symbol = dlsym(library, SIMILITUDE_ENTRY_SYMBOL);
  if (!symbol) throw std::runtime_error(file + " has no " SIMILITUDE_ENTRY_SYMBOL);
  return *static_cast<const similitude_entry*>(symbol);
}

/// Alumina of 1 mm in air, the bed of the reference tables.
inline similitude_bed alumina_bed() {
  similitude_bed bed{};
  bed.struct_size = sizeof bed;
  bed.dimension = 3;
  bed.gravity = 9.81;
  bed.gas_density = 1.225;
  bed.gas_viscosity = 1.79e-5;
  bed.particle_diameter = bed.drag_diameter = 1e-3;
  bed.particle_density = 1040;
  return bed;
}

/// A model made from a descriptor, as the host makes it.
template <class Functions>
class TestModel {
 public:
  TestModel(const similitude_descriptor& descriptor, const std::vector<Values>& sets,
            const similitude_bed& bed = alumina_bed())
      : descriptor_(descriptor) {
    std::vector<similitude_value> values;
    for (const Values& set : sets) {
      for (const auto& given : set) {
        if (!has_parameter(given.first)) throw std::runtime_error("the model has no parameter " + given.first);
      }
      for (std::uint32_t p = 0; p < descriptor.parameter_count; ++p) values.push_back(value_of(descriptor.parameters[p], set));
    }
    similitude_status status{};
    instance_ = descriptor.create(nullptr, &bed, values.data(), static_cast<std::uint32_t>(sets.size()), &status);
    if (!instance_) throw std::runtime_error(status.text);
  }
  TestModel(const std::string& file, const std::vector<Values>& sets, const similitude_bed& bed = alumina_bed())
      : TestModel(*open_plugin(file).descriptors[0], sets, bed) {}
  ~TestModel() { descriptor_.destroy(instance_); }
  TestModel(const TestModel&) = delete;
  TestModel& operator=(const TestModel&) = delete;

  const Functions& functions() const { return *static_cast<const Functions*>(descriptor_.functions); }
  const void* instance() const { return instance_; }

 private:
  bool has_parameter(const std::string& name) const {
    for (std::uint32_t p = 0; p < descriptor_.parameter_count; ++p) {
      if (name == descriptor_.parameters[p].name) return true;
    }
    return false;
  }
  static similitude_value value_of(const similitude_parameter& parameter, const Values& set) {
    const auto given = set.find(parameter.name);
    if (given != set.end()) return {given->second.real, given->second.text};
    if (parameter.required) throw std::runtime_error(std::string("a value is missing: ") + parameter.name);
    return {parameter.default_value, parameter.default_text};
  }

  const similitude_descriptor& descriptor_;
  void* instance_ = nullptr;
};

}  // namespace similitude::test
