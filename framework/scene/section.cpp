#include "scene/section.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "scene/messages.h"
#include "scene/units.h"

namespace similitude {
namespace {

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

const char* sign_text(Sign sign) { return sign == Sign::positive ? " must be above zero." : " must not be negative."; }

bool fits(double value, Sign sign) {
  return sign == Sign::any || value > 0 || (value == 0 && sign == Sign::not_negative);
}

void check_names(const DocumentNode& node, const std::string& path, KeyTable table) {
  std::vector<std::string> known;
  for (const CaseKey& key : table) known.emplace_back(key.name);
  for (const DocumentNode::Key& key : node.keys) {
    bool found = false;
    for (const std::string& name : known) found |= name == key.name;
    if (found) continue;
    throw InputError(key.mark, joined(path, key.name), "there is no such key.",
                     did_you_mean(key.name, known) + "Keys " + (path.empty() ? "of a case file" : "of " + path) + ": " +
                         listed(known) + ".");
  }
}

/// How a required value could be written.
std::string example(const CaseKey& key) {
  const std::string unit(key.unit);
  switch (key.form) {
    case Form::quantity:
    case Form::quantity_or_auto:
      return "1 " + unit;
    case Form::box:
      return "[1 " + unit + ", 1 " + unit + ", 1 " + unit + "]";
    case Form::box_or_cube:
      return "1 " + unit;
    case Form::positions:
      return "[1 " + unit + "]";
    case Form::integer:
      return "1";
    case Form::choice:
      return std::string(key.choices.substr(0, key.choices.find('|')));
    default:
      return "";
  }
}

}  // namespace

std::vector<std::string> split_choices(std::string_view choices) {
  std::vector<std::string> words;
  while (!choices.empty()) {
    const std::size_t bar = choices.find('|');
    words.emplace_back(choices.substr(0, bar));
    choices = bar == std::string_view::npos ? std::string_view{} : choices.substr(bar + 1);
  }
  return words;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(word, known);
  return nearest.empty() ? "" : "Did you mean \"" + nearest + "\"?\n";
}

double read_quantity(const DocumentNode& node, const std::string& path, std::string_view unit, Sign sign) {
  const std::string wanted = dimension_name(parse_unit(unit).value_or(Unit{}).dimension);
  if (!node.is_scalar())
    throw InputError(node.mark, path, wanted + " is needed, but this is " + node.described() + ".",
                     "Write for example " + (unit == "1" ? "1" : "1 " + std::string(unit)) + ".");
  try {
    const double value = parse_quantity(node.text, unit);
    if (!fits(value, sign))
      throw InputError(node.mark, path, node.text + " is out of range: " + wanted + " here" + sign_text(sign));
    return value;
  } catch (const QuantityError& error) {
    throw InputError(node.mark, path, error.what, error.fix);
  }
}

std::int64_t read_integer(const DocumentNode& node, const std::string& path, Sign sign) {
  std::int64_t value = 0;
  const char* const end = node.text.data() + node.text.size();
  const auto [last, problem] = std::from_chars(node.text.data(), end, value);
  if (!node.is_scalar() || problem != std::errc{} || last != end)
    throw InputError(node.mark, path, node.described() + " is not a whole number.",
                     "Write digits only, for example 461000.");
  if (!fits(static_cast<double>(value), sign))
    throw InputError(node.mark, path, node.text + " is out of range: this number" + sign_text(sign));
  return value;
}

bool read_flag(const DocumentNode& node, const std::string& path) {
  if (node.is_text("true")) return true;
  if (node.is_text("false")) return false;
  throw InputError(node.mark, path, node.described() + " is neither true nor false.", "Write true or false.");
}

std::string read_choice(const DocumentNode& node, const std::string& path, const std::vector<std::string>& choices) {
  for (const std::string& choice : choices)
    if (node.is_text(choice.c_str())) return choice;
  throw InputError(node.mark, path, node.described() + " is not possible here.",
                   did_you_mean(node.text, choices) + "Possible: " + listed(choices) + ".");
}

std::string read_text(const DocumentNode& node, const std::string& path) {
  if (!node.is_scalar()) throw InputError(node.mark, path, "a text is needed, but this is " + node.described() + ".");
  return node.text;
}

Section::Section(const DocumentNode* node, std::string path, KeyTable table, const SourceMark& parent)
    : node_(node), path_(std::move(path)), table_(table), mark_(node != nullptr ? node->mark : parent) {
  if (node_ != nullptr && node_->kind == DocumentNode::Kind::nothing) node_ = nullptr;
  if (node_ != nullptr) {
    if (!node_->is_map()) {
      std::vector<std::string> known;
      for (const CaseKey& key : table_) known.emplace_back(key.name);
      throw InputError(mark_, path_, "a map of keys is needed, but this is " + node_->described() + ".",
                       "Keys of " + path_ + ": " + listed(known) + ".");
    }
    check_names(*node_, path_, table_);
  }
  for (const CaseKey& key : table_) {
    if (!key.required || given(key.name)) continue;
    const std::string sample = example(key);
    throw InputError(mark_, path_, "the key " + std::string(key.name) + " is missing (" + std::string(key.doc) + ").",
                     sample.empty() ? "" : "Add for example " + std::string(key.name) + ": " + sample + ".");
  }
}

const CaseKey& Section::key(std::string_view name) const {
  for (const CaseKey& key : table_)
    if (key.name == name) return key;
  throw std::logic_error("no key " + std::string(name) + " in the table of " + path_);
}

const DocumentNode* Section::node(std::string_view name) const {
  const DocumentNode* found = node_ == nullptr ? nullptr : node_->find(std::string(name));
  return found != nullptr && found->kind != DocumentNode::Kind::nothing ? found : nullptr;
}

bool Section::given(std::string_view name) const { return node(name) != nullptr; }

SourceMark Section::mark(std::string_view name) const {
  const DocumentNode* found = node(name);
  return found != nullptr ? found->mark : mark_;
}

std::string Section::path(std::string_view name) const { return joined(path_, name); }

DocumentNode Section::value(const CaseKey& key) const {
  const DocumentNode* found = node(key.name);
  if (found != nullptr) return *found;
  return {DocumentNode::Kind::scalar, mark_, std::string(key.default_text), {}, {}};
}

double Section::quantity_of(const CaseKey& key, const DocumentNode& node, const std::string& path) const {
  return read_quantity(node, path, key.unit, key.sign);
}

std::string Section::text(std::string_view name) const { return read_text(value(key(name)), path(name)); }

std::int64_t Section::integer(std::string_view name) const {
  return read_integer(value(key(name)), path(name), key(name).sign);
}

bool Section::flag(std::string_view name) const { return read_flag(value(key(name)), path(name)); }

std::string Section::choice(std::string_view name) const {
  return read_choice(value(key(name)), path(name), split_choices(key(name).choices));
}

double Section::quantity(std::string_view name) const { return quantity_of(key(name), value(key(name)), path(name)); }

std::optional<double> Section::quantity_or_auto(std::string_view name) const {
  const DocumentNode node = value(key(name));
  if (node.is_text("auto")) return std::nullopt;
  return quantity_of(key(name), node, path(name));
}

std::vector<double> Section::quantities(std::string_view name, const DocumentNode& list) const {
  std::vector<double> values;
  for (const DocumentNode& item : list.items)
    values.push_back(quantity_of(key(name), item, path(name) + "." + std::to_string(values.size())));
  return values;
}

std::array<double, 2> Section::interval(std::string_view name) const {
  const DocumentNode node = value(key(name));
  const std::string unit(key(name).unit);
  if (!node.is_list() || node.items.size() != 2)
    throw InputError(node.mark, path(name),
                     "two ends are needed, but this is " +
                         (node.is_list() ? "a list of " + std::to_string(node.items.size()) : node.described()) + ".",
                     "Write for example [10 " + unit + ", 20 " + unit + "].");
  const std::vector<double> ends = quantities(name, node);
  if (!(ends[0] < ends[1]))
    throw InputError(node.mark, path(name),
                     "the first end, " + node.items[0].text + ", is not below the second, " + node.items[1].text + ".",
                     ends[0] > ends[1] ? "Write [" + node.items[1].text + ", " + node.items[0].text + "]." : "");
  return {ends[0], ends[1]};
}

std::array<double, 3> Section::box(std::string_view name) const {
  const DocumentNode node = value(key(name));
  const Form form = key(name).form;
  if (node.is_scalar() && form != Form::box) {
    const double single = quantity_of(key(name), node, path(name));
    if (form == Form::gravity) return {0, 0, single == 0 ? 0 : -single};
    return {single, single, single};
  }
  const std::string unit(key(name).unit);
  if (!node.is_list() || node.items.size() != 3)
    throw InputError(node.mark, path(name),
                     "three values (x, y, z) are needed, but this is " +
                         (node.is_list() ? "a list of " + std::to_string(node.items.size()) : node.described()) + ".",
                     "Write for example [1 " + unit + ", 1 " + unit + ", 1 " + unit + "].");
  const std::vector<double> values = quantities(name, node);
  return {values[0], values[1], values[2]};
}

std::vector<double> Section::positions(std::string_view name) const {
  const DocumentNode node = value(key(name));
  if (!node.is_list()) return {quantity_of(key(name), node, path(name))};
  if (node.items.empty())
    throw InputError(node.mark, path(name), "this list is empty.", "Give a value, or leave the key out.");
  return quantities(name, node);
}

double Section::every(std::string_view name) const {
  DocumentNode node = value(key(name));
  const bool none_allowed = key(name).form == Form::every_or_none;
  if (none_allowed && node.is_text("none")) return 0;
  const std::string word = "every ";
  if (!node.is_scalar() || !node.text.starts_with(word))
    throw InputError(node.mark, path(name), node.described() + " is not an interval.",
                     std::string("Write for example every 50 ms") + (none_allowed ? ", or none." : "."));
  node.text = node.text.substr(word.size());
  return quantity_of(key(name), node, path(name));
}

std::vector<std::string> Section::texts(std::string_view name) const {
  const DocumentNode* list = node(name);
  if (list == nullptr) return {};
  if (!list->is_list())
    throw InputError(list->mark, path(name), "a list is needed, but this is " + list->described() + ".",
                     "Write it in brackets: [" + list->text + "].");
  std::vector<std::string> words;
  for (const DocumentNode& item : list->items)
    words.push_back(read_text(item, path(name) + "." + std::to_string(words.size())));
  return words;
}

Section Section::section(std::string_view name) const { return {node(name), path(name), key(name).table(), mark_}; }

std::vector<std::pair<std::string, Section>> Section::named(std::string_view name) const {
  std::vector<std::pair<std::string, Section>> sections;
  const DocumentNode* map = node(name);
  if (map == nullptr) return sections;
  if (!map->is_map())
    throw InputError(map->mark, path(name), "a map of names is needed, but this is " + map->described() + ".",
                     "Give each a name: " + std::string(name) + ": {some_name: {…}}.");
  for (std::size_t i = 0; i < map->keys.size(); ++i) {
    const std::string& own = map->keys[i].name;
    if (own.empty() || own.find_first_of(". \t") != std::string::npos)
      throw InputError(map->keys[i].mark, path(name),
                       "\"" + own + "\" is not a name: it may hold no dot and no blank.");
    const DocumentNode& item = map->items[i];
    sections.emplace_back(own, Section(&item, path(name) + "." + own, key(name).table(), map->keys[i].mark));
  }
  return sections;
}

}  // namespace similitude
