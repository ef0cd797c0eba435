// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/equalities.hpp"

#include <algorithm>
#include <map>

#include "robot/input/common/poses.hpp"
#include "robot/input/mjcf/names.hpp"
#include "robot/input/mjcf/tendons.hpp"

namespace flatdyn {

namespace {

constexpr int kWorld = -1;

class EqualityReader {
 public:
  explicit EqualityReader(MjcfModel& model) : model_(model), values_(model.values), diagnostics_(model.diagnostics()) {}

  // Those that hold a joint come first, and those of tendons last: their joints may follow by the others.
  void read() {
    for (const Pass pass : {Pass::holds, Pass::joints, Pass::tendons}) {
      for (const FileNode* section : model_.root.elements("equality")) {
        for (const FileNode& element : section->children) {
          if (pass_of(element) == pass) read_equality(element);
        }
      }
    }
  }

 private:
  enum class Pass { holds, joints, tendons };

  static Pass pass_of(const FileNode& element) {
    if (element.name == "tendon") return Pass::tendons;
    return element.name == "joint" && element.attribute("joint2") != nullptr ? Pass::joints : Pass::holds;
  }

  void read_equality(const FileNode& element) {
    MjcfItem item = values_.item(element, kMainClass, "equality");
    item.what = "equality, " + item.what;
    if (!values_.flag(item, "active", true)) {
      diagnostics_.note(element.place, item.what + " is not active: it is not read",
                        "write active=\"true\" if it holds", "equalities that are not active");
    } else if (element.name == "joint") {
      read_joint(item);
    } else if (element.name == "tendon") {
      read_tendon(item);
    } else if (element.name == "connect") {
      read_connect(item);
    } else if (element.name == "weld") {
      read_weld(item);
    } else {
      refuse(item, "is not supported");
    }
  }

  void refuse(const MjcfItem& item, const std::string& message) {
    refuse_mjcf(item.element->place, item.what + " " + message, "equality", values_);
  }

  // The attribute that names a joint or tendon; nullptr, and an error, if it is missing.
  const FileAttribute* name_in(const MjcfItem& item, const char* key) {
    const FileAttribute* name = item.element->attribute(key);
    if (name == nullptr) {
      diagnostics_.error(item.element->place, item.what + " has no " + key, std::string("write ") + key + "=\"...\"");
    }
    return name;
  }

  // The joint that an attribute names; nullptr, and an error, if there is no such joint or it cannot move.
  Joint* joint_of(const MjcfItem& item, const char* key) {
    const FileAttribute* name = name_in(item, key);
    if (name == nullptr) return nullptr;
    Joint* joint = joint_in(model_.robot, name->text);
    if (joint != nullptr && joint->type == JointType::spherical) {
      diagnostics_.error(name->place, item.what + ": \"" + name->text + "\" is a ball joint",
                         "an equality holds or couples hinges and slides; --fix " + name->text + " holds a ball joint");
      return nullptr;
    }
    if (joint != nullptr && joint->type != JointType::fixed) return joint;
    report_missing_name(*name, item.what, "joint", joint_names(model_.robot), diagnostics_);
    return nullptr;
  }

  // The five of polycoef; nullopt, and an error, if they are not linear in the second joint or tendon.
  std::optional<std::vector<Number>> coefficients(const MjcfItem& item, bool is_alone) {
    std::vector<Number> c = {0, 1, 0, 0, 0};
    if (const auto found = values_.numbers(item, "polycoef", 1, 5)) {
      std::copy(found->numbers.begin(), found->numbers.end(), c.begin());
    }
    if (is_alone || std::all_of(c.begin() + 2, c.end(), [](const Number& each) { return vanishes(each); })) return c;
    refuse(item, "has a polycoef that is not linear, which is not supported");
    return std::nullopt;
  }

  // The tendon that an attribute names; nullptr, and an error, if there is no such tendon or its length is not linear.
  const MjcfTendon* tendon_of(const MjcfItem& item, const char* key) {
    const FileAttribute* name = name_in(item, key);
    if (name == nullptr) return nullptr;
    const MjcfTendon* tendon = mjcf_tendon(*name, item.what, model_);
    if (tendon == nullptr || tendon->is_fixed) return tendon;
    refuse(item, "names a spatial tendon, which is not supported");
    return nullptr;
  }

  // Σ a_j q_j = b
  struct LinearEquation {
    std::vector<Coupled::Term> terms;  // each joint once
    Number b = 0;
  };

  static void add_term(const Reference& joint, const Number& factor, LinearEquation& equation) {
    const auto same = std::find_if(equation.terms.begin(), equation.terms.end(),
                                   [&joint](const Coupled::Term& each) { return each.joint.name == joint.name; });
    if (same == equation.terms.end()) {
      equation.terms.push_back({joint, factor});
    } else {
      same->factor += factor;
    }
  }

  // Adds factor · (L - L at ref) to the left side.
  void add_length(const MjcfTendon& tendon, const Number& factor, LinearEquation& equation) const {
    for (const Coupled::Term& term : tendon.length.coupled->terms) {
      add_term(term.joint, factor * term.factor, equation);
      equation.b += factor * term.factor * model_.reference.at(term.joint.name);
    }
  }

  // L_1 - L_1(ref) = c_0 + c_1 (L_2 - L_2(ref))
  void read_tendon(const MjcfItem& item) {
    const bool is_alone = item.element->attribute("tendon2") == nullptr;
    const MjcfTendon* first = tendon_of(item, "tendon1");
    const MjcfTendon* second = is_alone ? nullptr : tendon_of(item, "tendon2");
    const std::optional<std::vector<Number>> c = coefficients(item, is_alone);
    if (first == nullptr || (!is_alone && second == nullptr) || !c) return;
    LinearEquation equation;
    equation.b = (*c)[0];
    add_length(*first, 1, equation);
    if (!is_alone) add_length(*second, -(*c)[1], equation);
    solve(equation, item);
  }

  bool is_held_still(const Joint& joint) const {
    return joint.type == JointType::fixed || is_held(joint.name, values_.context());
  }

  // Puts in the positions of joints that follow others, until none is left.
  void put_in_followers(LinearEquation& equation) const {
    for (std::size_t k = 0; k < equation.terms.size();) {
      const Coupled::Term term = equation.terms[k];
      const Joint& joint = *joint_in(model_.robot, term.joint.name);
      if (!joint.coupled || is_held_still(joint)) {
        ++k;
        continue;
      }
      equation.terms.erase(equation.terms.begin() + static_cast<std::ptrdiff_t>(k));
      equation.b -= term.factor * joint.coupled->offset;
      for (const Coupled::Term& leader : joint.coupled->terms)
        add_term(leader.joint, term.factor * leader.factor, equation);
      k = 0;
    }
    std::erase_if(equation.terms, [](const Coupled::Term& term) { return vanishes(term.factor); });
  }

  // The joint that follows: this one if it can, else the last one that nothing drives, else the last one; nullptr if
  // all are held.
  Joint* follower_of(const LinearEquation& equation, const std::string& wanted) const {
    Joint* follower = nullptr;
    for (const Coupled::Term& term : equation.terms) {
      Joint* joint = joint_in(model_.robot, term.joint.name);
      if (is_held_still(*joint)) continue;
      if (joint->name == wanted) return joint;
      if (follower == nullptr || !joint->driven || follower->driven) follower = joint;
    }
    return follower;
  }

  void solve(LinearEquation equation, const MjcfItem& item, const std::string& wanted = "") {
    put_in_followers(equation);
    if (equation.terms.empty()) {
      if (vanishes(equation.b)) return;  // others say the same
      diagnostics_.error(item.element->place, item.what + " contradicts others before it",
                         "delete one of them, or make them agree");
      return;
    }
    Joint* follower = follower_of(equation, wanted);
    if (follower == nullptr) {
      diagnostics_.note(item.element->place, item.what + " is not read: its joints are all held",
                        "whether they are held where it has them is not asked", "equalities of joints that are held");
      return;
    }
    Coupled coupled;
    coupled.place = item.element->place;
    Number own = 0;
    for (const Coupled::Term& term : equation.terms) {
      if (term.joint.name == follower->name) own = term.factor;
    }
    coupled.offset = equation.b / own;
    for (const Coupled::Term& term : equation.terms) {
      if (term.joint.name != follower->name) coupled.terms.push_back({term.joint, -term.factor / own});
    }
    if (coupled.terms.empty()) return hold(*follower, coupled.offset, item.element->place);
    follower->coupled = coupled;
    if (wanted == follower->name) return;
    diagnostics_.note(
        item.element->place, item.what + ": joint \"" + follower->name + "\" follows the others",
        "q has no entry of it; joints that an actuator drives, or that are held, are not taken if there is "
        "another",
        "joints that follow by equalities");
  }

  // q_1 - ref_1 = c_0 + c_1 (q_2 - ref_2)
  void read_joint(const MjcfItem& item) {
    Joint* follower = joint_of(item, "joint1");
    const bool is_alone = item.element->attribute("joint2") == nullptr;
    const Joint* leader = is_alone ? nullptr : joint_of(item, "joint2");
    if (follower == nullptr || (!is_alone && leader == nullptr)) return;
    const std::optional<std::vector<Number>> polynomial = coefficients(item, is_alone);
    if (!polynomial) return;
    const std::vector<Number>& c = *polynomial;
    const Number at_reference = model_.reference.at(follower->name) + c[0];
    if (is_alone) {
      hold(*follower, at_reference, item.element->place);
      return;
    }
    LinearEquation equation{{{{follower->name, item.element->place}, 1}}, at_reference};
    if (!vanishes(c[1])) {
      equation.b -= c[1] * model_.reference.at(leader->name);
      add_term({leader->name, item.element->place}, -c[1], equation);
    }
    solve(equation, item, follower->name);
  }

  void hold(const Joint& joint, const Number& position, const Place& place) {
    const auto [before, is_new] = held_.emplace(joint.name, position);
    if (!is_new && !vanishes(before->second - position)) {
      diagnostics_.error(place, "joint \"" + joint.name + "\" is held at two positions by equalities",
                         "delete one of them, or make them agree");
    }
    HeldJoint held;
    held.joint = joint.name;
    held.position = position;
    held.written = to_decimal(position, 6);
    held.is_decimal = false;
    held.place = place;
    values_.context().held_joints.push_back(held);
  }

  std::optional<int> body_of(const MjcfItem& item, const char* key) {
    const FileAttribute* name = item.element->attribute(key);
    if (name == nullptr || name->text == "world") return kWorld;
    const auto found = model_.body_of_name.find(name->text);
    if (found != model_.body_of_name.end()) return found->second;
    report_missing_name(*name, item.what, "body", body_names(model_), diagnostics_);
    return std::nullopt;
  }

  int link_of(int body) const { return body == kWorld ? 0 : model_.bodies[static_cast<std::size_t>(body)].link; }

  Reference reference_to(int link, const Place& place) const {
    return {model_.robot.links[static_cast<std::size_t>(link)].name, place};
  }

  // A body's place where all joints are at their ref.
  ExactPlace place_in_world(int body) const {
    ExactPlace place;
    for (; body != kWorld; body = model_.bodies[static_cast<std::size_t>(body)].parent) {
      const ExactPlace own = exact_place(model_.bodies[static_cast<std::size_t>(body)].pose);
      place = {own.R * place.R, own.R * place.p + own.p};
    }
    return place;
  }

  bool has_references() const {
    return std::any_of(model_.reference.begin(), model_.reference.end(),
                       [](const auto& each) { return !vanishes(each.second); });
  }

  void read_connect(const MjcfItem& item) {
    Loop loop;
    loop.place = item.element->place;
    loop.name = item.element->value("name");
    loop.is_marked = true;
    if (item.element->attribute("site1") != nullptr ? connect_sites(item, loop) : connect_bodies(item, loop)) {
      model_.robot.loops.push_back(loop);
    }
  }

  bool connect_sites(const MjcfItem& item, Loop& loop) {
    bool complete = true;
    for (std::size_t end = 0; end < 2; ++end) {
      const char* key = end == 0 ? "site1" : "site2";
      const FileAttribute* name = item.element->attribute(key);
      const auto site = model_.sites.find(name == nullptr ? "" : name->text);
      if (site == model_.sites.end()) {
        report_missing_name(name == nullptr ? FileAttribute{key, "", loop.place} : *name, item.what, "site", {},
                            diagnostics_);
        complete = false;
        continue;
      }
      loop.links[end] = reference_to(site->second.link, loop.place);
      loop.points[end] = exact_place(site->second.pose).p;
    }
    return complete;
  }

  // The anchor is in the first body's frame; the second body's point is where it is when all joints are at their ref.
  bool connect_bodies(const MjcfItem& item, Loop& loop) {
    if (item.element->attribute("body1") == nullptr || item.element->attribute("anchor") == nullptr) {
      diagnostics_.error(loop.place, item.what + " has no body1 or no anchor",
                         "write body1, body2 and anchor, or site1 and site2");
      return false;
    }
    const std::optional<int> first = body_of(item, "body1"), second = body_of(item, "body2");
    if (!first || !second) return false;
    loop.links = {reference_to(link_of(*first), loop.place), reference_to(link_of(*second), loop.place)};
    loop.points[0] = values_.length_vector(item, "anchor");
    loop.meets_at_zero = !has_references();
    if (loop.meets_at_zero) return true;
    const ExactPlace from = place_in_world(*first), to = place_in_world(*second);
    loop.points[1] = expanded(transpose(to.R) * (from.R * loop.points[0] + from.p - to.p));
    return true;
  }

  // A body that its own joints move against what stands still, welded to the world: these are held.
  void read_weld(const MjcfItem& item) {
    const FileAttribute* pose = item.element->attribute("relpose");
    if (item.element->attribute("site1") != nullptr || pose != nullptr) {
      refuse(item, "of sites, or with relpose, is not supported");
      return;
    }
    const std::optional<int> first = body_of(item, "body1"), second = body_of(item, "body2");
    if (!first || !second) return;
    if (*first != kWorld && *second != kWorld) {
      refuse(item, "of two bodies that are not the world is not supported");
      return;
    }
    const int welded = *first == kWorld ? *second : *first;
    if (welded == kWorld) return;
    const MjcfBody& body = model_.bodies[static_cast<std::size_t>(welded)];
    if (!body.moves) return;
    if (body.parent != kWorld && model_.bodies[static_cast<std::size_t>(body.parent)].moves) {
      refuse(item, "of a body on a moving one is not supported");
      return;
    }
    if (!body.free_joints.empty()) {
      if (!values_.context().options.floating_base.value_or(true)) return;
      diagnostics_.unsupported(item.element->place, item.what + " of a free body to the world is not supported",
                               "hold the body by --base fixed, or by --fix with the name of its joint");
      return;
    }
    for (const int j : body.joints) {
      const Joint& joint = model_.robot.joints[static_cast<std::size_t>(j)];
      hold(joint, model_.reference.at(joint.name), item.element->place);
    }
  }

  MjcfModel& model_;
  const MjcfValues& values_;
  Diagnostics& diagnostics_;
  std::map<std::string, Number> held_ = {};  // positions at which equalities hold joints
};

}  // namespace

void read_mjcf_equalities(MjcfModel& model) { EqualityReader(model).read(); }

}  // namespace flatdyn
