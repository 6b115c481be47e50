#include "scene/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace similitude {
namespace {

struct Symbol {
  std::string_view name;
  Unit unit;
  bool prefixed;  // takes k, m, …
};

constexpr double k_degree = std::numbers::pi / 180;

const std::array<Symbol, 17> k_symbols{{
    {"1", {{0, 0, 0}, 0, 1}, false},
    {"m", {{1, 0, 0}, 0, 1}, true},
    {"g", {{0, 1, 0}, -3, 1}, true},
    {"s", {{0, 0, 1}, 0, 1}, true},
    {"K", {{0, 0, 0, 1}, 0, 1}, true},
    {"N", {{1, 1, -2}, 0, 1}, true},
    {"Pa", {{-1, 1, -2}, 0, 1}, true},
    {"J", {{2, 1, -2}, 0, 1}, true},
    {"W", {{2, 1, -3}, 0, 1}, true},
    {"Hz", {{0, 0, -1}, 0, 1}, true},
    {"bar", {{-1, 1, -2}, 5, 1}, false},
    {"mbar", {{-1, 1, -2}, 2, 1}, false},
    {"min", {{0, 0, 1}, 0, 60}, false},
    {"h", {{0, 0, 1}, 0, 3600}, false},
    {"rad", {{0, 0, 0}, 0, 1}, false},
    {"deg", {{0, 0, 0}, 0, k_degree}, false},
    {"%", {{0, 0, 0}, -2, 1}, false},
}};

struct Prefix {
  std::string_view name;
  int decimal;
};
// The micro sign comes in two spellings of Unicode, U+00B5 and U+03BC.
constexpr std::array<Prefix, 9> k_prefixes{
    {{"G", 9}, {"M", 6}, {"k", 3}, {"c", -2}, {"m", -3}, {"u", -6}, {"\u00b5", -6}, {"\u03bc", -6}, {"n", -9}}};

std::optional<Unit> find_symbol(std::string_view name) {
  for (const Symbol& symbol : k_symbols)
    if (symbol.name == name) return symbol.unit;
  for (const Prefix& prefix : k_prefixes) {
    if (!name.starts_with(prefix.name)) continue;
    for (const Symbol& symbol : k_symbols) {
      if (!symbol.prefixed || symbol.name != name.substr(prefix.name.size())) continue;
      Unit unit = symbol.unit;
      unit.decimal += prefix.decimal;
      return unit;
    }
  }
  return std::nullopt;
}

Unit power(const Unit& base, int exponent) {
  Unit result{{base.dimension.length * exponent, base.dimension.mass * exponent, base.dimension.time * exponent,
               base.dimension.temperature * exponent},
              base.decimal * exponent,
              1};
  for (int i = 0; i < std::abs(exponent); ++i) result.factor *= exponent > 0 ? base.factor : 1 / base.factor;
  return result;
}

Unit product(const Unit& a, const Unit& b) {
  return {{a.dimension.length + b.dimension.length, a.dimension.mass + b.dimension.mass,
           a.dimension.time + b.dimension.time, a.dimension.temperature + b.dimension.temperature},
          a.decimal + b.decimal,
          a.factor * b.factor};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// unit := term { product-sign term } { '/' term }, or only quotients: what follows a quotient cannot be misread.
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : rest_(text) {}

  std::optional<Unit> whole() {
    auto unit = expression();
    skip_blanks();
    return unit && rest_.empty() ? unit : std::nullopt;
  }

 private:
  std::optional<Unit> expression() {
    skip_blanks();
    Unit unit;
    if (!rest_.starts_with('/')) {
      const auto first = term();
      if (!first) return std::nullopt;
      unit = *first;
    }
    bool divided = false;
    while (true) {
      const bool blank = skip_blanks();
      if (rest_.empty() || rest_.front() == ')') return unit;
      if (take("/")) {
        divided = true;
        skip_blanks();
        const auto divisor = term();
        if (!divisor) return std::nullopt;
        unit = product(unit, power(*divisor, -1));
        continue;
      }
      if (!(take("*") || take("\u00b7") || take(".") || blank) || divided) return std::nullopt;
      skip_blanks();
      const auto factor = term();
      if (!factor) return std::nullopt;
      unit = product(unit, *factor);
    }
  }

  std::optional<Unit> term() {
    std::optional<Unit> unit;
    if (take("(")) {
      unit = expression();
      skip_blanks();
      if (!unit || !take(")")) return std::nullopt;
    } else {
      std::size_t length = 0;
      while (length < rest_.size() && std::string_view(" \t*/.^()").find(rest_[length]) == std::string_view::npos &&
             (rest_[0] == '1' || !is_digit(rest_[length])) && !superscript(rest_.substr(length)) &&
             !rest_.substr(length).starts_with("\u00b7") && !(length > 0 && rest_[length] == '-'))
        ++length;
      unit = find_symbol(rest_.substr(0, length));
      rest_.remove_prefix(length);
      if (!unit) return std::nullopt;
    }
    if (const int raised = superscript(rest_)) {
      rest_.remove_prefix(2);  // both are two bytes of UTF-8
      return power(*unit, raised);
    }
    if (!take("^")) return unit;
    int exponent = 0;
    const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), exponent);
    if (problem != std::errc{} || exponent == 0 || std::abs(exponent) > 9) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return power(*unit, exponent);
  }

  static int superscript(std::string_view text) {
    if (text.starts_with("\u00b2")) return 2;
    if (text.starts_with("\u00b3")) return 3;
    return 0;
  }
  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  bool skip_blanks() {
    bool any = false;
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) {
      rest_.remove_prefix(1);
      any = true;
    }
    return any;
  }

  std::string_view rest_;
};

struct SplitNumber {
  std::string mantissa;  // sign, digits, point
  int exponent = 0;
  std::string_view unit;  // what follows, trimmed
};

std::optional<SplitNumber> split_number(std::string_view text) {
  SplitNumber split;
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) {
    if (text[i] == '-') split.mantissa = "-";
    ++i;
  }
  bool digits = false;
  for (bool point = false; i < text.size() && (is_digit(text[i]) || (text[i] == '.' && !point)); ++i) {
    digits |= is_digit(text[i]);
    point |= text[i] == '.';
    split.mantissa += text[i];
  }
  if (!digits) return std::nullopt;
  if (i + 1 < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    const std::size_t sign = text[i + 1] == '+' || text[i + 1] == '-' ? 1 : 0;
    if (i + 1 + sign < text.size() && is_digit(text[i + 1 + sign])) {
      const char* from = text.data() + i + 1 + (text[i + 1] == '+' ? 1 : 0);
      const auto [end, problem] = std::from_chars(from, text.data() + text.size(), split.exponent);
      if (problem != std::errc{} || std::abs(split.exponent) > 400) return std::nullopt;
      i = static_cast<std::size_t>(end - text.data());
    }
  }
  while (i < text.size() && (text[i] == ' ' || text[i] == '\t')) ++i;
  split.unit = text.substr(i);
  return split;
}

std::string six_digits(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  // 1e+05 reads as the people who write case files would write it: 100000; below a million no exponent.
  if (std::abs(value) >= 1e5 && std::abs(value) < 1e6) std::snprintf(buffer, sizeof buffer, "%.0f", value);
  return buffer;
}

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit == "1" || unit.empty() ? number : number + " " + std::string(unit);
}

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

struct NamedDimension {
  Dimension dimension;
  const char* name;
};
constexpr std::array<NamedDimension, 21> k_dimension_names{{
    {{0, 0, 0}, "a pure number"},
    {{1, 0, 0}, "a length"},
    {{2, 0, 0}, "an area"},
    {{3, 0, 0}, "a volume"},
    {{0, 1, 0}, "a mass"},
    {{0, 0, 1}, "a time"},
    {{0, 0, -1}, "a rate"},
    {{1, 0, -1}, "a velocity"},
    {{1, 0, -2}, "an acceleration"},
    {{-3, 1, 0}, "a density"},
    {{-1, 1, -1}, "a dynamic viscosity"},
    {{2, 0, -1}, "a kinematic viscosity"},
    {{-1, 1, -2}, "a pressure"},
    {{0, 1, -2}, "a stiffness (force per length)"},
    {{1, 1, -2}, "a force"},
    {{2, 1, -2}, "an energy"},
    {{0, 1, -1}, "a mass flow or damping coefficient"},
    {{2, 1, -3}, "a power"},
    {{0, 0, 0, 1}, "a temperature"},
    {{2, 0, -2, -1}, "a heat capacity"},
    {{1, 1, -3, -1}, "a heat conductivity"},
}};

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) { return UnitParser(text).whole(); }

std::string base_units(Dimension dimension) {
  std::string text;
  const auto append = [&](const char* symbol, int exponent) {
    if (exponent == 0) return;
    if (!text.empty()) text += ' ';
    text += symbol;
    if (exponent != 1) text += std::string("^").append(std::to_string(exponent));
  };
  append("kg", dimension.mass);
  append("m", dimension.length);
  append("s", dimension.time);
  append("K", dimension.temperature);
  return text.empty() ? "1" : text;
}

std::string dimension_name(Dimension dimension) {
  for (const NamedDimension& known : k_dimension_names)
    if (known.dimension == dimension) return known.name;
  return "a quantity in " + base_units(dimension);
}

namespace {

bool is_celsius(std::string_view unit) {
  return unit == "C" || unit == "°C" || unit == "degC" || unit == "deg C" || unit == "Celsius" || unit == "celsius";
}

/// A number of degrees Celsius: its zero lies elsewhere, so that no factor makes kelvin of it.
std::string in_kelvin(const SplitNumber& celsius) {
  constexpr double k_freezing = 273.15;   // [K]
  return format_quantity(std::strtod((celsius.mantissa + "e" + std::to_string(celsius.exponent)).c_str(), nullptr) + k_freezing, "K");
}

}  // namespace

double parse_quantity(std::string_view text, std::string_view unit) {
  const auto expected = parse_unit(unit);
  if (!expected) throw QuantityError{"the unit " + quoted(unit) + " that is asked for here is unknown.", ""};
  const std::string needed = dimension_name(expected->dimension);
  const bool pure = expected->dimension == Dimension{};
  const auto split = split_number(text);
  if (!split)
    throw QuantityError{
        quoted(text) + " is not " + (pure ? "a number." : "a number with a unit; " + needed + " is needed."),
        "Write for example " + with_unit("1", unit) + "."};
  const std::string number(text.substr(0, text.size() - split->unit.size()));
  const std::string trimmed = number.substr(0, number.find_last_not_of(" \t") + 1);
  const std::string example = with_unit(trimmed, unit);

  Unit given;
  if (split->unit.empty()) {
    if (!pure)
      throw QuantityError{trimmed + " has no unit; " + needed + " is needed.", "Write for example " + example + "."};
  } else {
    const auto parsed = parse_unit(split->unit);
    if (!parsed) {
      const std::size_t slash = split->unit.find('/');
      const bool two_ways = slash != std::string_view::npos && split->unit.find(' ', slash) != std::string_view::npos;
      if (expected->dimension == Dimension{0, 0, 0, 1} && is_celsius(split->unit))
        throw QuantityError{quoted(split->unit) + " is not a unit.", "Write " + in_kelvin(*split) + "."};
      throw QuantityError{quoted(split->unit) + (two_ways ? " can be read in two ways." : " is not a unit."),
                          two_ways ? "Use brackets, for example kg/(m s)."
                                   : "Here " + needed + " is needed, for example " + example + "."};
    }
    given = *parsed;
  }
  if (!(given.dimension == expected->dimension)) {
    const std::string what =
        std::string(text) + " is " + dimension_name(given.dimension) + "; " + needed + " is needed.";
    throw QuantityError{
        what, pure ? "Write it without a unit, for example " + trimmed + "." : "Write for example " + example + "."};
  }
  const std::string decimal = split->mantissa + "e" + std::to_string(split->exponent + given.decimal);
  double value = 0;
  const auto [end, problem] = std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
  value *= given.factor;
  if (problem != std::errc{} || end != decimal.data() + decimal.size() || !std::isfinite(value))
    throw QuantityError{std::string(text) + " is beyond the range of numbers.", ""};
  return value;
}

std::string format_quantity(double si, std::string_view unit) {
  const Unit parsed = parse_unit(unit).value_or(Unit{});
  // Dividing by a power of ten that a double holds exactly keeps 0.0675 m at 67.5 mm.
  const double scale = std::pow(10.0, std::abs(parsed.decimal));
  const double number = (parsed.decimal < 0 ? si * scale : si / scale) / parsed.factor;
  return with_unit(six_digits(number), unit);
}

std::string exact_number(double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

}  // namespace similitude
