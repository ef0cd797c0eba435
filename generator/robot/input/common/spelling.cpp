// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/spelling.hpp"

#include <algorithm>
#include <set>

namespace flatdyn {

namespace {

using WordSet = std::set<std::string, std::less<>>;

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

char small(char c) { return is_capital(c) ? static_cast<char>(c | 0x20) : c; }

std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool has_word_among(const std::vector<std::string>& words, const WordSet& among) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return among.contains(word); });
}

// Whether a name is about what a motor makes of current and voltage, how large they may be, or how it is called:
// nothing of that moves a robot another way.
bool is_of_motor_only(const std::vector<std::string>& words) {
  static const WordSet kElectrical = {"resistance", "inductance", "voltage",    "current", "currents", "emf",
                                      "backemf",    "winding",    "electrical", "kt",      "ke",       "kv",
                                      "encoder",    "encoders",   "pole",       "poles",   "power"};
  static const WordSet kMotors = {"motor", "motors", "rotor", "torque", "speed", "velocity"};
  static const WordSet kHandling = {"constant", "id",    "ids",    "name", "names",
                                    "type",     "model", "serial", "port", "channel"};
  static const WordSet kOfMotion = {"inertia", "inertias", "mass",   "damping",   "friction",  "viscous",  "coulomb",
                                    "gear",    "ratio",    "spring", "stiffness", "reduction", "reflected"};
  if (has_word_among(words, kOfMotion)) return false;
  return has_word_among(words, kElectrical) || (has_word_among(words, kMotors) && has_word_among(words, kHandling));
}

}  // namespace

std::string folded_name(std::string_view name) {
  std::string folded(without_prefix(name));
  std::transform(folded.begin(), folded.end(), folded.begin(), small);
  return folded;
}

std::vector<std::string> words_of_name(std::string_view name) {
  constexpr std::string_view kBetween = "_-. ";
  std::vector<std::string> words = {""};
  bool was_capital = true;
  for (const char c : without_prefix(name)) {
    const bool separates = kBetween.find(c) != std::string_view::npos;
    if ((separates || (is_capital(c) && !was_capital)) && !words.back().empty()) words.emplace_back();
    if (!separates) words.back() += small(c);
    was_capital = is_capital(c);
  }
  return words;
}

std::string joined_name(std::string_view name) {
  std::string joined;
  for (const std::string& word : words_of_name(name)) joined += word;
  return joined;
}

std::string known_spelling_of(std::string_view name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return "";
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&](const std::string& each) { return joined_name(each) == joined_name(name); });
  return found == known.end() ? "" : *found;
}

bool is_dynamics_name(std::string_view name) {
  static const WordSet kWords = {
      "spring",    "springs",   "viscous",  "viscosity", "damping",    "damper",  "friction",    "dynamics",
      "stiffness", "coulomb",   "stribeck", "bushing",   "rotor",      "rotors",  "motor",       "motors",
      "armature",  "reflected", "inertia",  "inertias",  "mass",       "masses",  "payload",     "gravity",
      "gear",      "gears",     "gearbox",  "reduction", "reductions", "loop",    "loops",       "equality",
      "cable",     "cables",    "belt",     "pulley",    "tendon",     "tendons", "constraint",  "constraints",
      "mimic",     "follow",    "follows",  "follower",  "coupling",   "coupled", "springdamper"};
  static const WordSet kOfOthers = {"sensor", "sensors", "controller", "controllers", "interface", "plugin"};
  const std::vector<std::string> words = words_of_name(name);
  if (has_word_among(words, kOfOthers) || is_of_motor_only(words)) return false;
  return has_word_among(words, kWords) || joined_name(name) == "forceelement";
}

bool is_force_or_constraint_name(std::string_view name) {
  if (name == "force_element" || name == "cable" || name == "drake:joint") return true;
  static const std::vector<std::string_view> kOfDrake = {"constraint", "spring", "bushing", "cable"};
  return name.starts_with("drake:") && std::any_of(kOfDrake.begin(), kOfDrake.end(), [name](std::string_view part) {
           return name.find(part) != std::string_view::npos;
         });
}

bool is_rotor_name(std::string_view name) {
  static const WordSet kWords = {"rotor", "inertia", "inerta", "armature", "gear", "ratio", "reduction", "reflected"};
  const std::vector<std::string> words = words_of_name(name);
  return has_word_among(words, kWords) && !is_of_motor_only(words);
}

}  // namespace flatdyn
