#pragma once
/// Quantities with units, as people write them: "5 mm", "1.79e-5 Pa s", "1040 kg/m^3", "10 1/s", "2 GPa". SI comes out.

#include <optional>
#include <string>
#include <string_view>

namespace similitude {

/// Exponents of metre, kilogram, second and kelvin.
struct Dimension {
  int length = 0, mass = 0, time = 0, temperature = 0;
  bool operator==(const Dimension&) const = default;
};

/// SI value = number x 10^decimal x factor. The power of ten is kept apart so that it can join the number's own exponent
/// before rounding: 5 mm, 0.5 cm and 0.005 m are the same bits.
struct Unit {
  Dimension dimension;
  int decimal = 0;
  double factor = 1;
};

/// Products by blank, '*', '.' or '·'; quotients by '/', "kg/(m s)" with brackets; powers "m^3" or "m³". Nothing if the
/// text is no unit. "1" is the unit of pure numbers. "kg/m s" is refused: it can be read in two ways.
std::optional<Unit> parse_unit(std::string_view text);

/// What is wrong with a quantity, without the place: the reader of the file adds that.
struct QuantityError {
  std::string what, fix;
};

/// The SI value of `text`, which must have the dimension of `unit`; `unit` also serves the examples in error texts.
/// Throws QuantityError.
double parse_quantity(std::string_view text, std::string_view unit);

/// "kg m^-1 s^-1": the coherent unit of a dimension; "1" for pure numbers.
std::string base_units(Dimension dimension);

/// "a length", "a velocity", …; "a quantity in kg m^-4" if the dimension has no common name.
std::string dimension_name(Dimension dimension);

/// An SI value in `unit` for messages, six digits: "67.5 mm". The unit is left out for pure numbers.
std::string format_quantity(double si, std::string_view unit);

/// The shortest decimal that reads back as the same bits.
std::string exact_number(double value);

}  // namespace similitude
