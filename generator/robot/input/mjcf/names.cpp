// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/names.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

namespace {

using Words = std::vector<std::string>;

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Words kOrientation = {"pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"};

const Words kInBody = {"inertial", "joint", "freejoint", "geom",   "site",      "camera",   "light",
                       "body",     "frame", "replicate", "attach", "composite", "flexcomp", "plugin"};

const Words kOfJoint = {"name",
                        "class",
                        "type",
                        "group",
                        "pos",
                        "axis",
                        "springdamper",
                        "limited",
                        "actuatorfrclimited",
                        "solreflimit",
                        "solimplimit",
                        "solreffriction",
                        "solimpfriction",
                        "stiffness",
                        "range",
                        "margin",
                        "ref",
                        "springref",
                        "actuatorfrcrange",
                        "actuatorgravcomp",
                        "armature",
                        "damping",
                        "frictionloss",
                        "user"};

const Words kOfGeom = {"name",     "class",        "type",       "contype",   "conaffinity", "condim",
                       "group",    "priority",     "size",       "material",  "friction",    "mass",
                       "density",  "shellinertia", "solmix",     "solref",    "solimp",      "margin",
                       "gap",      "surfacevel",   "adhesion",   "fromto",    "hfield",      "mesh",
                       "fitscale", "rgba",         "fluidshape", "fluidcoef", "user"};

const Words kOfActuator = {
    "name",       "class",         "group",        "nsample",      "interp",     "delay",     "ctrlrange",
    "user",       "ctrllimited",   "forcelimited", "actlimited",   "forcerange", "actrange",  "lengthrange",
    "gear",       "damping",       "armature",     "cranklength",  "joint",      "tendon",    "slidersite",
    "cranksite",  "jointinparent", "site",         "refsite",      "body",       "actdim",    "input",
    "velrange",   "ffrange",       "posrange",     "dyntype",      "gaintype",   "biastype",  "dynprm",
    "gainprm",    "biasprm",       "actearly",     "kp",           "kv",         "dampratio", "timeconst",
    "ki",         "imax",          "slewmax",      "inheritrange", "area",       "diameter",  "bias",
    "tausmooth",  "range",         "force",        "scale",        "lmin",       "lmax",      "vmax",
    "fpmax",      "fvmax",         "gain",         "motorconst",   "resistance", "nominal",   "saturation",
    "inductance", "cogging",       "controller",   "thermal",      "lugre",      "plugin",    "instance"};

const Words kOfTendon = {
    "name",         "class",          "group",       "limited",          "actuatorfrclimited", "range",
    "margin",       "solreflimit",    "solimplimit", "actuatorfrcrange", "solreffriction",     "frictionloss",
    "springlength", "solimpfriction", "width",       "material",         "stiffness",          "damping",
    "armature",     "rgba",           "user"};

const Words kOfEquality = {"name", "class", "active", "solref", "solimp"};

// The names that an element knows; elements of other names in it are errors if `children` is given.
struct KnownElement {
  Words attributes;
  std::optional<Words> children;
};

const std::map<std::string, KnownElement>& known_elements() {
  static const std::map<std::string, KnownElement> kElements = {
      {"mujoco",
       {{"model"},
        Words{"compiler", "option", "size", "visual", "statistic", "default", "extension", "custom", "asset",
              "worldbody", "contact", "deformable", "equality", "tendon", "actuator", "sensor", "keyframe"}}},
      {"compiler",
       {{"autolimits",    "boundmass", "boundinertia", "settotalmass",    "balanceinertia",    "strippath",
         "coordinate",    "angle",     "fitaabb",      "eulerseq",        "meshdir",           "texturedir",
         "discardvisual", "usethread", "fusestatic",   "inertiafromgeom", "inertiagrouprange", "saveinertial",
         "assetdir",      "alignfree", "conflict",     "convexhull",      "exactmeshinertia"},
        Words{"lengthrange"}}},
      {"worldbody", {kOrientation + Words{"name", "childclass"}, kInBody}},
      {"body",
       {kOrientation + Words{"name", "childclass", "mocap", "gravcomp", "sleep", "simple", "fuse", "user"}, kInBody}},
      {"frame", {kOrientation + Words{"name", "childclass"}, kInBody}},
      {"replicate", {{"count", "offset", "euler", "sep", "childclass"}, kInBody}},
      {"attach", {{"model", "body", "frame", "prefix"}, Words{}}},
      {"inertial", {kOrientation + Words{"mass", "diaginertia", "fullinertia"}, Words{}}},
      {"joint", {kOfJoint, std::nullopt}},
      {"freejoint", {{"name", "group", "align"}, Words{}}},
      {"geom", {kOrientation + kOfGeom, Words{"plugin"}}},
      {"keyframe", {{}, Words{"key"}}},
      {"key", {{"name", "time", "qpos", "qvel", "act", "mpos", "mquat", "ctrl"}, Words{}}},
      {"actuator",
       {{},
        Words{"general", "motor", "position", "velocity", "intvelocity", "orientation", "pid", "damper", "cylinder",
              "muscle", "adhesion", "dcmotor", "plugin"}}},
      {"equality", {{}, Words{"connect", "weld", "joint", "tendon", "flex", "flexvert", "flexstrain", "distance"}}},
      {"tendon", {{}, Words{"spatial", "fixed"}}},
      {"deformable", {{}, Words{"flex", "skin"}}}};
  return kElements;
}

// Elements by the section that they are in, where their names mean something else than in a body.
const std::map<std::string, KnownElement>& known_in_sections() {
  static const std::map<std::string, KnownElement> kElements = {
      {"equality/connect", {kOfEquality + Words{"body1", "body2", "anchor", "site1", "site2"}, Words{}}},
      {"equality/weld",
       {kOfEquality + Words{"body1", "body2", "relpose", "anchor", "site1", "site2", "torquescale"}, Words{}}},
      {"equality/joint", {kOfEquality + Words{"joint1", "joint2", "polycoef"}, Words{}}},
      {"equality/tendon", {kOfEquality + Words{"tendon1", "tendon2", "polycoef"}, Words{}}},
      {"tendon/fixed", {kOfTendon, Words{"joint"}}},
      {"tendon/spatial", {kOfTendon, Words{"site", "geom", "pulley"}}}};
  return kElements;
}

class NameChecker {
 public:
  explicit NameChecker(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void check(const FileNode& element, const std::string& section) {
    const KnownElement* known = known_as(element, section);
    if (known == nullptr) return;
    for (const FileAttribute& attribute : element.attributes) {
      const Words& names = known->attributes;
      if (std::find(names.begin(), names.end(), attribute.name) != names.end()) continue;
      if (attribute.name.find(':') != std::string::npos) continue;
      diagnostics_.error(attribute.place, name_in_messages(element) + ": unknown attribute \"" + attribute.name + "\"",
                         names.empty() ? "delete it" : hint_for_unknown(attribute.name, names, "attributes"));
    }
    if (!known->children) return;
    for (const FileNode& child : element.children) {
      const Words& names = *known->children;
      if (std::find(names.begin(), names.end(), child.name) != names.end()) {
        check(child, element.name);
      } else {
        diagnostics_.error(child.place, name_in_messages(element) + ": unknown element <" + child.name + ">",
                           names.empty() ? "delete it" : hint_for_unknown(child.name, names, "elements"));
      }
    }
  }

 private:
  static const KnownElement* known_as(const FileNode& element, const std::string& section) {
    static const KnownElement kActuator = {kOfActuator, std::nullopt};
    if (section == "actuator") return &kActuator;
    const auto inside = known_in_sections().find(section + "/" + element.name);
    if (inside != known_in_sections().end()) return &inside->second;
    const auto found = known_elements().find(element.name);
    return found == known_elements().end() || section == "tendon" || section == "equality" || section == "fixed" ||
                   section == "spatial"
               ? nullptr
               : &found->second;
  }

  Diagnostics& diagnostics_;
};

// Attributes of defaults, of the elements that are read with them.
void check_default_names(const FileNode& defaults, Diagnostics& diagnostics) {
  for (const FileNode& child : defaults.children) {
    if (child.name == "default") {
      check_default_names(child, diagnostics);
    } else if (default_kind_of(child.name, "") == "general") {
      NameChecker(diagnostics).check(child, "actuator");
    } else if (child.name == "joint" || child.name == "geom") {
      NameChecker(diagnostics).check(child, "default");
    }
  }
}

}  // namespace

void check_mjcf_names(const FileNode& root, Diagnostics& diagnostics) {
  NameChecker(diagnostics).check(root, "");
  for (const FileNode* defaults : root.elements("default")) check_default_names(*defaults, diagnostics);
}

void refuse_mjcf(const Place& place, const std::string& message, const std::string& name, const MjcfValues& values) {
  values.diagnostics().unsupported(place, message, "--ignore " + name + " leaves it out");
}

}  // namespace flatdyn
