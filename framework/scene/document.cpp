#include "scene/document.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "scene/input_file.h"
#include "scene/messages.h"

namespace similitude {
namespace {

// An alias that contains itself would never end.
constexpr int k_deepest = 50;

SourceMark mark_of(const std::string& file, const YAML::Mark& mark) {
  if (file == "--set" || mark.is_null()) return {file, 0, 0};
  return {file, mark.line + 1, mark.column + 1};
}

std::string joined(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

DocumentNode convert(const YAML::Node& yaml, const std::string& file, const std::string& path, int depth) {
  DocumentNode node;
  node.mark = mark_of(file, yaml.Mark());
  if (depth > k_deepest) throw InputError(node.mark, path, "nested too deeply.", "Does an alias contain itself?");
  if (yaml.IsScalar()) {
    node.kind = DocumentNode::Kind::scalar;
    node.text = yaml.Scalar();
  } else if (yaml.IsSequence()) {
    node.kind = DocumentNode::Kind::list;
    for (const YAML::Node& item : yaml)
      node.items.push_back(convert(item, file, joined(path, std::to_string(node.items.size())), depth + 1));
  } else if (yaml.IsMap()) {
    node.kind = DocumentNode::Kind::map;
    for (const auto& entry : yaml) {
      const SourceMark mark = mark_of(file, entry.first.Mark());
      if (!entry.first.IsScalar()) throw InputError(mark, path, "a key must be a word.");
      const std::string key = entry.first.Scalar();
      for (const DocumentNode::Key& other : node.keys)
        if (other.name == key)
          throw InputError(mark, joined(path, key),
                           other.mark.line > 0
                               ? "this key was given before, in line " + std::to_string(other.mark.line) + "."
                               : "this key is given twice.",
                           "Keep one of the two.");
      node.keys.push_back({key, mark});
      node.items.push_back(convert(entry.second, file, joined(path, key), depth + 1));
    }
  }
  return node;
}

YAML::Node parse(const std::string& text, const std::string& file) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& problem) {
    throw InputError(mark_of(file, problem.mark), "", "this is not YAML: " + problem.msg + ".",
                     "Look for a missing bracket, colon or blank, or a tab used to indent.");
  }
}

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

/// The item of a list or map that one part of a path means, or null.
const DocumentNode* child(const DocumentNode& node, const std::string& part) {
  if (!node.is_list()) return node.find(part);
  const bool number = !part.empty() && part.size() < 6 &&
                      std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  const std::size_t index = number ? std::stoul(part) : node.items.size();
  return index < node.items.size() ? &node.items[index] : nullptr;
}

}  // namespace

const DocumentNode* DocumentNode::find(const std::string& key) const {
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (keys[i].name == key) return &items[i];
  return nullptr;
}

DocumentNode* DocumentNode::find(const std::string& key) {
  return const_cast<DocumentNode*>(static_cast<const DocumentNode*>(this)->find(key));
}

std::string DocumentNode::described() const {
  switch (kind) {
    case Kind::nothing:
      return "nothing";
    case Kind::scalar:
      return "\"" + text + "\"";
    case Kind::list:
      return "a list";
    case Kind::map:
      return "a map of keys";
  }
  return "";
}

namespace {

/// How many bytes follow this lead byte of UTF-8; -1 if it is none. RFC 3629, section 4.
int bytes_after(unsigned char lead) {
  if (lead < 0x80) return 0;
  if (lead >= 0xc2 && lead < 0xe0) return 1;
  if (lead >= 0xe0 && lead < 0xf0) return 2;
  return lead >= 0xf0 && lead < 0xf5 ? 3 : -1;
}

/// After some lead bytes the second may not be all of 0x80 to 0xbf: overlong forms, halves of UTF-16 pairs, beyond U+10FFFF.
bool second_fits(unsigned char lead, unsigned char second) {
  switch (lead) {
    case 0xe0: return second >= 0xa0;
    case 0xed: return second < 0xa0;
    case 0xf0: return second >= 0x90;
    case 0xf4: return second < 0x90;
    default: return true;
  }
}

/// Where the text stops being UTF-8, or npos.
std::size_t first_byte_that_is_not_utf8(const std::string& text) {
  const auto byte = [&text](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  for (std::size_t at = 0; at < text.size();) {
    const int more = bytes_after(byte(at));
    if (more < 0 || text.size() - at <= static_cast<std::size_t>(more)) return at;
    for (std::size_t n = 1; n <= static_cast<std::size_t>(more); ++n) {
      if ((byte(at + n) & 0xc0) != 0x80) return at;
    }
    if (more > 0 && !second_fits(byte(at), byte(at + 1))) return at;
    at += static_cast<std::size_t>(more) + 1;
  }
  return std::string::npos;
}

void refuse_other_encodings(const std::string& text, SourceMark mark) {
  const std::size_t bad = first_byte_that_is_not_utf8(text);
  if (bad == std::string::npos) return;
  if (mark.line > 0) {
    const std::size_t start = bad == 0 ? 0 : text.rfind('\n', bad - 1) + 1;   // npos + 1 is 0
    mark.line += static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad), '\n'));
    mark.column = static_cast<int>(bad - start) + 1;
  }
  throw InputError(mark, "", "this is not text in UTF-8.", "Save the file in UTF-8, or write the character without its accent.");
}

}  // namespace

Document::Document(const std::filesystem::path& file, const std::string& version_key) {
  std::error_code problem;
  refuse_folder(file, {version_key == "similitude" ? "case file" : "study file", {".yaml", ".yml"}, version_key + ":"});
  if (!std::filesystem::exists(file, problem)) throw InputError(file.string() + ": there is no such file.");
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad() || !stream.is_open())
    throw InputError(file.string() + ": this is no file that can be read as a case.",
                     "Give the path of a case file, such as configs/quickstart.yaml.");
  refuse_other_encodings(text, {file.string(), 1, 0});
  root_ = convert(parse(text, file.string()), file.string(), "", 0);
  root_.mark.file = file.string();
  if (!root_.is_map())
    throw InputError(root_.mark, "", "a case file is a map of keys, but this is " + root_.described() + ".",
                     "Start with the line similitude: 1.");
}

void Document::set(const std::string& assignment) {
  const SourceMark mark{"--set", 0, 0};
  refuse_other_encodings(assignment, mark);
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(mark, "", "\"" + assignment + "\" is not of the form key=value.",
                     "Write for example --set models.scaling.geometry=0.5.");
  const std::string path = assignment.substr(0, equals);
  DocumentNode* node = &root_;
  std::string walked;
  for (const std::string& part : split(path)) {
    if (part.empty())
      throw InputError(mark, path, "a part of this path is empty.", "Write for example models.scaling.geometry.");
    if (node->is_scalar()) {
      // The short form of a model: drag: gidaspow.
      if (!walked.starts_with("models."))
        throw InputError(mark, path, walked + " is \"" + node->text + "\" and has no keys below it.",
                         "Set " + walked + " itself.");
      DocumentNode id = *node;
      *node = {DocumentNode::Kind::map, mark, "", {{"id", id.mark}}, {id}};
    }
    if (node->kind == DocumentNode::Kind::nothing) *node = {DocumentNode::Kind::map, mark, "", {}, {}};
    auto* next = const_cast<DocumentNode*>(child(*node, part));
    if (next == nullptr) {
      if (node->is_list())
        throw InputError(
            mark, path,
            walked + " is a list of " + std::to_string(node->items.size()) + " and has no item " + part + ".",
            "Items are counted from 0.");
      node->keys.push_back({part, mark});
      node->items.push_back({DocumentNode::Kind::nothing, mark, "", {}, {}});
      next = &node->items.back();
    }
    node = next;
    walked = joined(walked, part);
  }
  *node = convert(parse(assignment.substr(equals + 1), "--set"), "--set", path, 0);
  node->mark = mark;
}

SourceMark Document::mark(const std::string& path) const {
  const DocumentNode* node = &root_;
  for (const std::string& part : split(path)) {
    const DocumentNode* next = child(*node, part);
    if (next == nullptr) break;
    node = next;
  }
  return node->mark;
}

}  // namespace similitude
