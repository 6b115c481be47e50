#pragma once
/// A case file as a tree in which everything knows where it was written. Nothing here knows what a bed is.

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace similitude {

/// A value of the file: nothing, a scalar, a list or a map. In a map `keys[i]` names `items[i]`.
struct DocumentNode {
  enum class Kind { nothing, scalar, list, map };
  struct Key {
    std::string name;
    SourceMark mark;
  };

  Kind kind = Kind::nothing;
  SourceMark mark;
  std::string text;  // of a scalar
  std::vector<Key> keys;
  std::vector<DocumentNode> items;

  bool is_scalar() const { return kind == Kind::scalar; }
  bool is_list() const { return kind == Kind::list; }
  bool is_map() const { return kind == Kind::map; }
  bool is_text(const char* word) const { return is_scalar() && text == word; }
  /// Of a map; null if the key is missing or this is no map.
  const DocumentNode* find(const std::string& key) const;
  DocumentNode* find(const std::string& key);
  /// "a list", "the text "abc"", … for messages.
  std::string described() const;
};

class Document {
 public:
  /// Throws InputError: the file cannot be read, is no YAML, repeats a key, or is empty. `version_key` is the key that such a file
  /// starts with, to name one in a folder that was given in its place.
  explicit Document(const std::filesystem::path& file, const std::string& version_key = "similitude");

  /// One --set: "models.scaling.geometry=0.5". Maps on the way are made as needed; "models.drag=x" written in short
  /// form becomes {id: x} when a key below it is set. The mark of what was set is "--set".
  void set(const std::string& assignment);

  const DocumentNode& root() const { return root_; }
  DocumentNode& root() { return root_; }
  /// Of the value at a dotted path, or of the deepest part of the path that was written.
  SourceMark mark(const std::string& path) const;

 private:
  DocumentNode root_;
};

}  // namespace similitude
