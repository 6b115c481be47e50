#include "loader/parameter_check.h"

#include <cmath>
#include <sstream>

#include "loader/number_text.h"
#include "loader/spelling.h"

namespace similitude {
namespace {

std::string check_choice(const similitude_parameter& parameter) {
  if (parameter.choices == nullptr || *parameter.choices == '\0') return "it is a choice without choices";
  if (parameter.required != 0) return {};
  if (parameter.default_text == nullptr) return "it is neither required nor has it a default";
  if (!is_choice(parameter.choices, parameter.default_text))
    return "default \"" + std::string(parameter.default_text) + "\" is not one of " + parameter.choices;
  return {};
}

std::string check_number(const similitude_parameter& parameter) {
  if (!(parameter.minimum <= parameter.maximum))
    return "its range " + range_text(parameter.minimum, parameter.maximum) + " is empty";
  if (!(parameter.typical_minimum <= parameter.typical_maximum))
    return "its typical range " + range_text(parameter.typical_minimum, parameter.typical_maximum) + " is empty";
  const double value = parameter.default_value;
  if (parameter.required != 0 || std::isnan(value)) return {};
  if (value < parameter.minimum || value > parameter.maximum)
    return "default " + number_text(value) + " is outside its range " +
           range_text(parameter.minimum, parameter.maximum);
  if (parameter.type != SIMILITUDE_REAL && value != std::floor(value))
    return "default " + number_text(value) + " is not a whole number";
  return {};
}

}  // namespace

bool is_choice(const std::string& choices, const std::string& word) {
  std::istringstream words(choices);
  for (std::string choice; std::getline(words, choice, '|');)
    if (choice == word) return true;
  return false;
}

std::string check_parameter(const similitude_parameter& parameter) {
  if (parameter.struct_size != sizeof parameter)  // rows of a table follow each other at this distance
    return "its row has " + std::to_string(parameter.struct_size) + " bytes, this program reads " +
           std::to_string(sizeof parameter);
  if (parameter.name == nullptr) return "it has no name";
  if (!is_lower_snake(parameter.name)) return "the name is not lower_snake";
  if (parameter.type < SIMILITUDE_REAL || parameter.type > SIMILITUDE_CHOICE)
    return "there is no type " + std::to_string(parameter.type);
  if (parameter.scales_as < SIMILITUDE_SCALES_NOT || parameter.scales_as > SIMILITUDE_SCALES_REFUSED)
    return "there is no way of scaling " + std::to_string(parameter.scales_as);
  if (parameter.unit == nullptr) return "it has no unit";
  if (parameter.type == SIMILITUDE_REAL && *parameter.unit == '\0')
    return "it has no unit; write \"1\" for a pure number";
  if (parameter.doc == nullptr) return "it has no text that says what it is";
  return parameter.type == SIMILITUDE_CHOICE ? check_choice(parameter) : check_number(parameter);
}

}  // namespace similitude
