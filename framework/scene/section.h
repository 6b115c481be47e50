#pragma once
/// One map of the case file, read by its table of keys: unknown, missing, mistyped and out-of-range values end here,
/// with their place and a fix.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/case_keys.h"
#include "scene/document.h"

namespace similitude {

/// A quantity in `unit`, in SI. The free functions are for values that stand in no table (a plugin's parameters).
/// All throw InputError.
double read_quantity(const DocumentNode& node, const std::string& path, std::string_view unit, Sign sign);
std::int64_t read_integer(const DocumentNode& node, const std::string& path, Sign sign);
bool read_flag(const DocumentNode& node, const std::string& path);
std::string read_choice(const DocumentNode& node, const std::string& path, const std::vector<std::string>& choices);
std::string read_text(const DocumentNode& node, const std::string& path);

/// "a|b|c" as three words.
std::vector<std::string> split_choices(std::string_view choices);
/// "a, b, c"
std::string listed(const std::vector<std::string>& words);
/// "Did you mean "near"?\n" or nothing, for a fix.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

class Section {
 public:
  /// `node` null: the section was left out and every value is its default.
  Section(const DocumentNode* node, std::string path, KeyTable table, const SourceMark& parent);

  bool given(std::string_view key) const;
  /// Null if left out.
  const DocumentNode* node(std::string_view key) const;
  SourceMark mark() const { return mark_; }
  /// Of the value of `key`, or of this section.
  SourceMark mark(std::string_view key) const;
  const std::string& path() const { return path_; }
  std::string path(std::string_view key) const;

  // Values of the key's form, or its default. Lengths, times, … in SI.
  std::string text(std::string_view key) const;
  std::int64_t integer(std::string_view key) const;
  bool flag(std::string_view key) const;
  std::string choice(std::string_view key) const;
  double quantity(std::string_view key) const;
  std::optional<double> quantity_or_auto(std::string_view key) const;
  std::array<double, 2> interval(std::string_view key) const;
  std::array<double, 3> box(std::string_view key) const;
  std::vector<double> positions(std::string_view key) const;
  /// 0 for none.
  double every(std::string_view key) const;
  std::vector<std::string> texts(std::string_view key) const;

  Section section(std::string_view key) const;
  /// The named sections below `key`, in the order of the file.
  std::vector<std::pair<std::string, Section>> named(std::string_view key) const;

 private:
  const CaseKey& key(std::string_view name) const;
  /// The node of `name`, or one made of the default's text.
  DocumentNode value(const CaseKey& key) const;
  std::vector<double> quantities(std::string_view key, const DocumentNode& list) const;
  double quantity_of(const CaseKey& key, const DocumentNode& node, const std::string& path) const;

  const DocumentNode* node_;
  std::string path_;
  KeyTable table_;
  SourceMark mark_;
};

}  // namespace similitude
