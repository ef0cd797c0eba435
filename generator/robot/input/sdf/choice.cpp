// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

namespace {

class Chooser {
 public:
  Chooser(const SdfFile& file, SdfTree& tree, Robot& robot)
      : values_(file.values), diagnostics_(file.values.context().diagnostics), tree_(tree), robot_(robot) {
    collect(file.root, nullptr);
    for (const FileNode* world : file.root.elements("world")) collect(*world, world);
  }

  std::optional<SdfChoice> choose() {
    const std::optional<std::string>& wanted = values_.context().options.model;
    values_.context().model_was_chosen = true;
    return wanted ? choose(*wanted) : choose_only();
  }

 private:
  struct Included {
    const FileNode* include;
    const FileNode* world;
  };

  void collect(const FileNode& holder, const FileNode* world) {
    for (const FileNode* model : holder.elements("model")) choices_.push_back({{model, &values_}, world});
    for (const FileNode* include : holder.elements("include")) includes_.push_back({include, world});
  }

  // Files that an <include> names are read only as far as they are needed: a world's ground and sun are often not
  // there.
  std::optional<SdfChoice> choose(const std::string& name) {
    std::vector<std::string> known;
    for (const SdfChoice& choice : choices_) {
      known.push_back(name_of(choice.model));
      if (known.back() == name) return choice;
    }
    for (const Included& each : includes_) {
      const std::optional<Reference> own = values_.name(*each.include, "name", "include");
      if (own) known.push_back(own->name);
      if (own && own->name != name) continue;
      const std::optional<SdfModel> model = own || is_called(*each.include, name) ? included(each) : std::nullopt;
      if (model && name_of(*model) == name) return SdfChoice{*model, each.world};
      if (own && !model) return std::nullopt;
    }
    diagnostics_.error({}, "--model: there is no model \"" + name + "\"", hint_for_unknown(name, known, "models"));
    return std::nullopt;
  }

  // Whether the last part of the URI is the name.
  bool is_called(const FileNode& include, const std::string& name) const {
    const std::optional<Reference> uri = values_.name(include, "uri", "include");
    return uri && uri->name.ends_with(name);
  }

  std::optional<SdfModel> included(const Included& each) {
    return model_of_include(*each.include, values_, {values_.file()}, tree_, robot_);
  }

  std::optional<SdfChoice> choose_only() {
    const std::size_t before = diagnostics_.all().size();
    const std::vector<SdfChoice> own = moving_choices();
    for (const Included& each : includes_) {
      if (const std::optional<SdfModel> model = included(each)) choices_.push_back({*model, each.world});
    }
    if (diagnostics_.all().size() > before && diagnostics_.has_errors()) {
      tell_of_own(own);
      return std::nullopt;
    }
    const std::vector<SdfChoice> moving = moving_choices();
    const std::vector<SdfChoice>& all = moving.empty() ? choices_ : moving;
    if (all.size() == 1) {
      note_static(all.front());
      return all.front();
    }
    refuse(all);
    return std::nullopt;
  }

  std::vector<SdfChoice> moving_choices() const {
    std::vector<SdfChoice> moving;
    for (const SdfChoice& choice : choices_) {
      if (!is_static(choice.model)) moving.push_back(choice);
    }
    return moving;
  }

  // Where files of others are missing.
  void tell_of_own(const std::vector<SdfChoice>& own) {
    if (own.empty()) return;
    diagnostics_.note(
        own.front().model.element->place,
        fmt::format("this file itself has the {} {}", own.size() == 1 ? "model" : "models", name_list(own)),
        "--model NAME reads one model, without what is included beside it");
  }

  static std::string name_list(const std::vector<SdfChoice>& all) {
    std::vector<std::string> names;
    for (const SdfChoice& choice : all) names.push_back("\"" + name_of(choice.model) + "\"");
    return fmt::format("{}", fmt::join(names, ", "));
  }

  void note_static(const SdfChoice& choice) {
    if (choices_.size() == 1) return;
    diagnostics_.note(choice.model.element->place,
                      fmt::format("the robot is model \"{}\"; {} static ones beside it are left out",
                                  name_of(choice.model), choices_.size() - 1),
                      "--model NAME chooses another one");
  }

  void refuse(const std::vector<SdfChoice>& all) {
    if (all.empty()) {
      diagnostics_.error({values_.file(), 0}, "there is no <model> in this file",
                         "an SDF file of a robot is <sdf version=\"1.9\"> <model name=\"...\"> ... </model> </sdf>");
      return;
    }
    diagnostics_.error(all[1].model.element->place,
                       fmt::format("there are {} models in this file: {}", all.size(), name_list(all)),
                       "choose one by --model NAME");
  }

  const SdfValues& values_;
  Diagnostics& diagnostics_;
  SdfTree& tree_;
  Robot& robot_;
  std::vector<SdfChoice> choices_;
  std::vector<Included> includes_;
};

}  // namespace

std::optional<SdfChoice> choose_sdf_model(const SdfFile& file, SdfTree& tree, Robot& robot) {
  return Chooser(file, tree, robot).choose();
}

}  // namespace flatdyn
