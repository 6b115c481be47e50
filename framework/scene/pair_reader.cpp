#include "scene/pair_reader.h"

#include <algorithm>

#include "scene/case_keys.h"
#include "scene/material_pairs.h"
#include "scene/messages.h"
#include "scene/model_reader.h"
#include "scene/section.h"

namespace similitude {
namespace {

/// The key `pair` of one case: what may be written there, and what is.
class PairTable {
 public:
  PairTable(const DocumentNode& node, std::string path, const ModelChoice& common, const similitude_descriptor& model,
            const RealScene& scene)
      : node_(node), path_(std::move(path)), common_(common), model_(model), classes_(scene.particles),
        pairs_(material_pairs(scene.particles.size())), written_(pairs_.size(), k_not_written) {}

  std::vector<ModelChoice> read(const Document& document, std::vector<std::string>& warnings) {
    check_is_needed();
    check_is_map();
    check_class_names(document);
    for (std::size_t n = 0; n < node_.keys.size(); ++n) take(n);
    check_complete();
    std::vector<ModelChoice> sets;
    for (const std::size_t n : written_) sets.push_back(set(n, warnings));
    return sets;
  }

 private:
  static constexpr std::size_t k_not_written = ~std::size_t{0};

  std::string own_path(std::size_t n) const { return path_ + "." + node_.keys[n].name; }

  std::string spelled(std::size_t place) const { return pair_name(classes_, pairs_[place]); }
  std::string spelled_backwards(std::size_t place) const {
    const auto name = [&](std::size_t material) {
      return material < classes_.size() ? classes_[material].name : std::string(k_wall_material);
    };
    return name(pairs_[place].second) + "-" + name(pairs_[place].first);
  }

  std::vector<std::string> materials() const {
    std::vector<std::string> names;
    for (const ParticleClass& one : classes_) names.push_back(one.name);
    names.emplace_back(k_wall_material);
    return names;
  }

  /// The place of the pair that is written so, or pairs_.size().
  std::size_t place_of(const std::string& name) const {
    for (std::size_t place = 0; place < pairs_.size(); ++place)
      if (name == spelled(place) || name == spelled_backwards(place)) return place;
    return pairs_.size();
  }

  void check_is_needed() const {
    if (!classes_.empty()) return;
    throw InputError(node_.mark, path_, "there are no classes of particles to make pairs of.", "Remove this key.");
  }

  void check_is_map() const {
    if (node_.is_map()) return;
    throw InputError(node_.mark, path_, "a map of pairs is needed, but this is " + node_.described() + ".",
                     "Write for example " + std::string(contact_pair_key().name) + ": {" + spelled(0) + ": " + sample() + "}.");
  }

  /// A pair is known by its spelling, so no two may be spelled alike.
  void check_class_names(const Document& document) const {
    const auto refuse = [&](const ParticleClass& one, const std::string& what) {
      const std::string path = "scene.particles." + one.name;
      throw InputError(document.mark(path), path, what, "Give this class another name.");
    };
    for (const ParticleClass& one : classes_)
      if (one.name == k_wall_material)
        refuse(one, std::string("in ") + path_ + " " + k_wall_material + " means every wall, baffle and inlet, not a class.");
    for (std::size_t place = 0; place < pairs_.size(); ++place)
      for (const std::string& name : {spelled(place), spelled_backwards(place)}) {
        const std::size_t first = place_of(name);
        if (first == place) continue;
        const ParticleClass& one = classes_[pairs_[place].second < classes_.size() ? pairs_[place].second : pairs_[place].first];
        refuse(one, "in " + path_ + " the name " + name + " could mean two different pairs of materials.");
      }
  }

  void take(std::size_t n) {
    const DocumentNode::Key& key = node_.keys[n];
    const std::size_t place = place_of(key.name);
    if (place == pairs_.size()) throw_unknown(n);
    if (written_[place] != k_not_written) {
      const DocumentNode::Key& other = node_.keys[written_[place]];
      throw InputError(key.mark, own_path(n),
                       "this pair was given before, as " + other.name +
                           (other.mark.line > 0 ? " in line " + std::to_string(other.mark.line) : "") + ".",
                       "Keep one of the two.");
    }
    written_[place] = n;
  }

  [[noreturn]] void throw_unknown(std::size_t n) const {
    const DocumentNode::Key& key = node_.keys[n];
    const std::string wall = k_wall_material;
    if (key.name == wall + "-" + wall)
      throw InputError(key.mark, own_path(n), "walls do not move, so no two of them meet.", "Remove this key.");
    const std::vector<std::string> known = materials();
    const std::string list = "Materials: " + listed(known) + ". A pair is two of them joined by a hyphen.";
    // Where one of the two is known, the other one is at fault.
    for (const std::string& material : known) {
      std::string other;
      if (key.name.starts_with(material + "-")) other = key.name.substr(material.size() + 1);
      if (key.name.ends_with("-" + material)) other = key.name.substr(0, key.name.size() - material.size() - 1);
      if (other.empty()) continue;
      throw InputError(key.mark, own_path(n), "there is no material " + other + ".", did_you_mean(other, known) + list);
    }
    std::vector<std::string> spellings;
    for (std::size_t place = 0; place < pairs_.size(); ++place) {
      spellings.push_back(spelled(place));
      spellings.push_back(spelled_backwards(place));
    }
    throw InputError(key.mark, own_path(n), "this is no pair of materials.", did_you_mean(key.name, spellings) + list);
  }

  void check_complete() const {
    std::vector<std::string> missing;
    for (std::size_t place = 0; place < pairs_.size(); ++place)
      if (written_[place] == k_not_written) missing.push_back(spelled(place));
    if (missing.empty()) return;
    const std::size_t count = classes_.size();
    throw InputError(node_.mark, path_,
                     listed(missing) + (missing.size() == 1 ? " is" : " are") + " missing: " + std::to_string(count) +
                         (count == 1 ? " class of particles makes " : " classes of particles make ") +
                         std::to_string(pairs_.size()) + " pairs with the walls.",
                     "Add for example " + missing[0] + ": " + sample() + ".");
  }

  /// What could be written for a pair: as for the first that is there, else what it must give.
  std::string sample() const {
    std::string text;
    const auto add = [&](const std::string& name, const std::string& value) {
      text += (text.empty() ? "" : ", ") + name + ": " + value;
    };
    for (const DocumentNode& pair : node_.items)
      if (text.empty() && pair.is_map())
        for (std::size_t k = 0; k < pair.keys.size(); ++k)
          if (pair.items[k].is_scalar()) add(pair.keys[k].name, pair.items[k].text);
    for (std::size_t k = 0; text.empty() && k < common_.parameters.size(); ++k) {
      const similitude_parameter& row = model_.parameters[k];
      if (row.required != 0 && !common_.parameters[k].given) add(row.name, example_of_parameter(row));
    }
    return "{" + text + "}";
  }

  ModelChoice set(std::size_t n, std::vector<std::string>& warnings) const {
    const DocumentNode& pair = node_.items[n];
    const bool empty = pair.kind == DocumentNode::Kind::nothing;
    if (!pair.is_map() && !empty)
      throw InputError(pair.mark, own_path(n), "a map of parameters is needed, but this is " + pair.described() + ".",
                       "Write for example " + node_.keys[n].name + ": " + sample() + ".");
    const SourceMark mark = empty ? node_.keys[n].mark : pair.mark;
    ModelChoice choice{common_.kind, common_.id, read_parameters(model_, pair, own_path(n), warnings), mark};
    for (std::size_t k = 0; k < choice.parameters.size(); ++k) {
      ModelParameter& parameter = choice.parameters[k];
      if (parameter.given) continue;
      const similitude_parameter& row = model_.parameters[k];
      if (row.required != 0 && !common_.parameters[k].given)
        throw InputError(mark, own_path(n),
                         choice.id + " needs the parameter " + row.name + " (" + doc_of_parameter(row) +
                             "), and it is neither here nor common to all pairs.",
                         "Add for example " + std::string(row.name) + ": " + example_of_parameter(row) + ", here or beside " +
                             std::string(contact_pair_key().name) + ".");
      parameter = common_.parameters[k];
      parameter.given = false;  // by the pair itself
    }
    return choice;
  }

  const DocumentNode& node_;
  std::string path_;
  const ModelChoice& common_;
  const similitude_descriptor& model_;
  const std::vector<ParticleClass>& classes_;
  std::vector<MaterialPair> pairs_;
  std::vector<std::size_t> written_;  // by place: which key
};

}  // namespace

void read_contact(const DocumentNode& node, const std::string& path, const Catalogue& catalogue, const Document& document,
                  RealScene& scene, std::vector<std::string>& warnings) {
  const std::string kind = "contact", key(contact_pair_key().name);
  const DocumentNode* pair = node.find(key);
  Models& models = scene.models;
  if (pair == nullptr || pair->kind == DocumentNode::Kind::nothing) {
    models.contact = read_model(kind, node, path, catalogue, {key}, warnings);
    return;
  }
  models.contact = read_common_parameters(kind, node, path, catalogue, {key}, warnings);
  const similitude_descriptor& model = *catalogue.find(kind, models.contact.id)->descriptor;
  models.contact_pairs = PairTable(*pair, path + "." + key, models.contact, model, scene).read(document, warnings);
}

}  // namespace similitude
