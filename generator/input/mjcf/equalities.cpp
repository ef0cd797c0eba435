// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/mjcf/equalities.hpp"

#include <algorithm>

#include "input/mjcf/names.hpp"
#include "input/mjcf/tendons.hpp"
#include "input/urdf/mimics.hpp"

namespace flatdyn {

namespace {

constexpr int kWorld = -1;

class EqualityReader {
 public:
  explicit EqualityReader(MjcfModel& model) : model_(model), values_(model.values), diagnostics_(model.diagnostics()) {}

  void read() {
    for (const MjcfElement* section : model_.root.elements("equality")) {
      for (const MjcfElement& element : section->children) read_equality(element);
    }
  }

 private:
  void read_equality(const MjcfElement& element) {
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

  // The joint that an attribute names; nullptr, and an error, if there is none that moves.
  Joint* joint_of(const MjcfItem& item, const char* key) {
    const MjcfAttribute* name = item.element->attribute(key);
    if (name == nullptr) {
      diagnostics_.error(item.element->place, item.what + " has no " + key, std::string("write ") + key + "=\"...\"");
      return nullptr;
    }
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

  // The tendon that an attribute names; nullptr, and an error, if there is none with a length that is linear.
  const MjcfTendon* tendon_of(const MjcfItem& item, const char* key) {
    const MjcfAttribute* name = item.element->attribute(key);
    if (name == nullptr) {
      diagnostics_.error(item.element->place, item.what + " has no " + key, std::string("write ") + key + "=\"...\"");
      return nullptr;
    }
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

  // Adds factor · (L - L at ref) to the left side.
  void add_length(const MjcfTendon& tendon, const Number& factor, LinearEquation& equation) {
    for (const Coupled::Term& term : tendon.length.coupled->terms) {
      const Number a = factor * term.factor;
      equation.b += a * model_.reference.at(term.joint.name);
      const auto same = std::find_if(equation.terms.begin(), equation.terms.end(),
                                     [&term](const Coupled::Term& each) { return each.joint.name == term.joint.name; });
      if (same == equation.terms.end()) {
        equation.terms.push_back({term.joint, a});
      } else {
        same->factor += a;
      }
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
    std::erase_if(equation.terms, [](const Coupled::Term& term) { return vanishes(term.factor); });
    solve(equation, item);
  }

  // The last joint follows the others, if nothing drives it and it follows none yet; else the last one that can.
  void solve(const LinearEquation& equation, const MjcfItem& item) {
    Joint* follower = nullptr;
    Number own = 0;
    for (const Coupled::Term& term : equation.terms) {
      Joint* joint = joint_in(model_.robot, term.joint.name);
      if (joint->coupled || (follower != nullptr && joint->driven && !follower->driven)) continue;
      follower = joint;
      own = term.factor;
    }
    if (follower == nullptr) return refuse(item, "of joints that follow others already is not supported");
    if (equation.terms.size() == 1) return hold(*follower, equation.b / own, item.element->place);
    Coupled coupled;
    coupled.place = item.element->place;
    coupled.offset = equation.b / own;
    for (const Coupled::Term& term : equation.terms) {
      if (term.joint.name != follower->name) coupled.terms.push_back({term.joint, -term.factor / own});
    }
    follower->coupled = coupled;
    diagnostics_.note(item.element->place, item.what + ": joint \"" + follower->name + "\" follows the others",
                      "q has no entry of it; a joint that an actuator drives is not taken if there is another",
                      "joints that follow by tendons");
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
    if (is_alone || vanishes(c[1])) {
      hold(*follower, at_reference, item.element->place);
      return;
    }
    Coupled coupled;
    coupled.place = item.element->place;
    coupled.offset = at_reference - c[1] * model_.reference.at(leader->name);
    coupled.terms.push_back({{leader->name, coupled.place}, c[1]});
    couple_joint(*follower, coupled, item.what, diagnostics_);
  }

  void hold(const Joint& joint, const Number& position, const Place& place) {
    HeldJoint held;
    held.joint = joint.name;
    held.position = position;
    held.written = to_decimal(position, 6);
    held.is_decimal = false;
    held.place = place;
    values_.context().held_joints.push_back(held);
  }

  std::optional<int> body_of(const MjcfItem& item, const char* key) {
    const MjcfAttribute* name = item.element->attribute(key);
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
  MjcfPlace place_in_world(int body) const {
    MjcfPlace place;
    for (; body != kWorld; body = model_.bodies[static_cast<std::size_t>(body)].parent) {
      const MjcfPlace own = exact_place(model_.bodies[static_cast<std::size_t>(body)].pose);
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
    loop.name = item.element->text("name");
    loop.is_marked = true;
    if (item.element->attribute("site1") != nullptr ? connect_sites(item, loop) : connect_bodies(item, loop)) {
      model_.robot.loops.push_back(loop);
    }
  }

  bool connect_sites(const MjcfItem& item, Loop& loop) {
    bool complete = true;
    for (std::size_t end = 0; end < 2; ++end) {
      const char* key = end == 0 ? "site1" : "site2";
      const MjcfAttribute* name = item.element->attribute(key);
      const auto site = model_.sites.find(name == nullptr ? "" : name->text);
      if (site == model_.sites.end()) {
        report_missing_name(name == nullptr ? MjcfAttribute{key, "", loop.place} : *name, item.what, "site", {},
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
    const MjcfPlace from = place_in_world(*first), to = place_in_world(*second);
    loop.points[1] = expanded(transpose(to.R) * (from.R * loop.points[0] + from.p - to.p));
    return true;
  }

  // A body that its own joints move against what stands still, welded to the world: these are held.
  void read_weld(const MjcfItem& item) {
    const MjcfAttribute* pose = item.element->attribute("relpose");
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
};

}  // namespace

void read_mjcf_equalities(MjcfModel& model) { EqualityReader(model).read(); }

}  // namespace flatdyn
