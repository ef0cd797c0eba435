// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/scene_reader.hpp"

#include <algorithm>

#include "robot/input/scene_frames.hpp"
#include "robot/input/toml/held_joints.hpp"
#include "robot/input/toml/parts.hpp"
#include "robot/model/exact_sign.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {

namespace {

std::optional<Vec3> read_gravity(TomlTable& table, Diagnostics& diagnostics) {
  if (!table.is_text("gravity")) {
    const Vec3 given = table.vector("gravity", Quantity::acceleration, zero_vector());
    return table.has("gravity") ? std::optional<Vec3>(given) : std::nullopt;
  }
  const std::optional<std::string> text = table.text("gravity");
  if (text != "off") {
    diagnostics.error(table.place_of("gravity"), "gravity: " + quoted(*text) + " is no gravity",
                      "write \"off\", or [x, y, z] in m/s^2");
  }
  return zero_vector();
}

std::optional<ScenePayload> read_payload(TomlTable& table, Diagnostics& diagnostics) {
  std::optional<TomlTable> payload = table.table("payload");
  if (!payload) return std::nullopt;
  const std::optional<Reference> link = payload->reference("link");
  const std::optional<Inertial> inertial = read_inertial(*payload, diagnostics);
  payload->reject_unknown_keys();
  if (inertial) return ScenePayload{link, *inertial};
  diagnostics.error(payload->place(), "payload: it has neither mass nor inertia",
                    "give its mass (kg), com (m) and inertia, or leave [payload] out");
  return std::nullopt;
}

// Limits are left in the file's unit, since it is not known yet whether their joints turn.
std::vector<SceneLimits> read_all_limits(TomlTable table, const Units& units) {
  const JointType type = units.degrees ? JointType::prismatic : JointType::revolute;
  std::vector<SceneLimits> all;
  for (const std::string& joint : table.keys()) {
    std::optional<TomlTable> limits = table.table(joint);
    if (limits) all.push_back({{joint, table.place_of(joint)}, read_limits(*limits, type)});
  }
  return all;
}

std::vector<SceneGain> read_gains(TomlTable table, Diagnostics& diagnostics) {
  std::vector<SceneGain> all;
  for (const std::string& joint : table.keys()) {
    const std::optional<Value> gain = read_gain(table, joint, diagnostics);
    if (gain) all.push_back({{joint, table.place_of(joint)}, *gain});
  }
  return all;
}

// Limits of a floating base, each of which must be positive.
std::optional<BaseLimits> read_base_limits(TomlTable& table, Diagnostics& diagnostics) {
  std::optional<TomlTable> given = table.table("base_limits");
  if (!given) return std::nullopt;
  const auto read = [&](const char* key, Quantity quantity) {
    std::optional<Value> limit = given->limit(key, quantity, Bound::magnitude);
    if (limit && !is_positive(limit->number)) {
      diagnostics.error(limit->place, std::string("base_limits: ") + key + " is not positive",
                        "it is the largest size of each component; leave it out if it is not known");
    }
    return limit;
  };
  const auto read_range = [&](const char* key, Quantity quantity, Limits& limits) {
    limits.upper = limits.lower = read(key, quantity);
    if (limits.lower) limits.lower->number = -limits.lower->number;
  };
  BaseLimits limits;
  limits.place = given->place();
  read_range("displacement", Quantity::length, limits.linear);
  read_range("turn", Quantity::angle, limits.angular);
  limits.linear.velocity = read("linear_velocity", Quantity::length);
  limits.linear.acceleration = read("linear_acceleration", Quantity::length);
  limits.linear.effort = read("force", Quantity::other);
  limits.angular.velocity = read("angular_velocity", Quantity::angle);
  limits.angular.acceleration = read("angular_acceleration", Quantity::angle);
  limits.angular.effort = read("moment", Quantity::other);
  given->reject_unknown_keys();
  return limits;
}

std::optional<Number> read_friction(TomlTable& table, Diagnostics& diagnostics) {
  const std::optional<std::vector<Value>> friction = table.numbers("friction", 1);
  if (!friction) return std::nullopt;
  if (nearest_double(friction->front().number) > 0) return friction->front().number;
  diagnostics.error(table.place_of("friction"), "contact: friction is not positive",
                    "write the coefficient of friction: friction = 0.6; without it, forces have no limit");
  return std::nullopt;
}

// Length and width of a surface whose friction is limited.
void read_size(TomlTable& table, SceneContact& contact, Diagnostics& diagnostics) {
  const auto size = table.has("size") ? table.numbers("size", 2) : std::nullopt;
  if (!contact.is_surface || !contact.friction) {
    if (!table.has("size")) return;
    diagnostics.error(table.place_of("size"), "contact: only a surface with friction has a size",
                      "write type = \"surface\" and friction = 0.6, or leave it out");
    return;
  }
  if (!table.has("size")) {
    diagnostics.error(contact.place, "contact: the surface has friction, but no size",
                      "write its length along x and its width along y of the link, m: size = [0.2, 0.1]");
    return;
  }
  if (!size) return;
  for (std::size_t k = 0; k < 2; ++k) {
    contact.size[k] = (*size)[k].number;
    if (nearest_double(contact.size[k]) > 0) continue;
    diagnostics.error(table.place_of("size"), "contact: the size of the surface is not positive",
                      "write its length along x and its width along y of the link, m: size = [0.2, 0.1]");
    return;
  }
}

void read_cone(TomlTable& table, SceneContact& contact, Diagnostics& diagnostics) {
  contact.friction = read_friction(table, diagnostics);
  read_size(table, contact, diagnostics);
  const bool is_given = table.has("normal");
  const std::string normal = read_choice(table, "normal", {"gravity", "link"}, diagnostics);
  contact.is_against_gravity = !contact.is_surface && normal != "link";
  if (is_given && !contact.friction && !table.has("friction")) {
    diagnostics.error(table.place_of("normal"), "contact: a normal without friction has no effect",
                      "write friction = 0.6, too, or leave it out");
  }
  if (is_given && contact.is_surface && normal == "gravity") {
    diagnostics.error(table.place_of("normal"), "contact: the normal of a surface is the z axis of its link",
                      "leave it out; where the link has other axes, name a [[frame]] as the link");
  }
}

// A point, in the link's frame, or a surface.
SceneContact read_contact(TomlTable& table, Diagnostics& diagnostics) {
  SceneContact contact;
  contact.place = table.place();
  const std::optional<Reference> link = table.reference("link");
  contact.link = link.value_or(Reference{"", contact.place});
  if (!link) diagnostics.error(contact.place, "contact: it has no link", "name the link that touches: link = \"foot\"");
  contact.name = table.text("name").value_or(contact.link.name);
  const auto is_control = [](unsigned char c) { return c < ' '; };
  if (link && (contact.name.empty() || std::any_of(contact.name.begin(), contact.name.end(), is_control))) {
    diagnostics.error(table.place_of("name"), "contact: its name is empty or has control characters",
                      "write name = \"left_heel\", or leave it out for the link's name");
  }
  contact.position = table.vector("position", Quantity::length, zero_vector());
  contact.is_surface = read_choice(table, "type", {"point", "surface"}, diagnostics) == "surface";
  read_cone(table, contact, diagnostics);
  table.reject_unknown_keys();
  return contact;
}

std::vector<SceneContact> read_contacts(TomlTable& table, Diagnostics& diagnostics) {
  std::vector<SceneContact> all;
  for (TomlTable& each : table.tables("contact")) {
    const SceneContact contact = read_contact(each, diagnostics);
    const auto has_its_name = [&](const SceneContact& other) { return other.name == contact.name; };
    if (std::any_of(all.begin(), all.end(), has_its_name)) {
      diagnostics.error(contact.place, "contact: " + quoted(contact.name) + " is there twice",
                        "give each a name of its own: name = \"left_heel\"");
    }
    all.push_back(contact);
  }
  return all;
}

std::vector<SceneFrame> read_frames(TomlTable& table, Diagnostics& diagnostics) {
  std::vector<SceneFrame> all;
  for (TomlTable& each : table.tables("frame")) {
    SceneFrame frame;
    frame.place = each.place();
    frame.name = each.text("name").value_or("");
    if (const std::string problem = problem_of_frame_name(frame.name); !problem.empty()) {
      diagnostics.error(frame.place, "frame: " + problem, "name it: name = \"tool\"");
    }
    const std::optional<Reference> link = each.reference("link");
    frame.link = link.value_or(Reference{"", frame.place});
    if (!link) diagnostics.error(frame.place, "frame: it has no link", "name the one it is on: link = \"hand\"");
    frame.xyz = each.vector("xyz", Quantity::length, zero_vector());
    frame.rpy = each.vector("rpy", Quantity::angle, zero_vector());
    each.reject_unknown_keys();
    all.push_back(frame);
  }
  return all;
}

Orientation read_orientation(TomlTable& table, Diagnostics& diagnostics) {
  const std::optional<std::string> text = table.text("orientation");
  if (!text) return Orientation::angular_velocity;
  if (text == "zyz") return Orientation::zyz;
  if (text == "rpy") return Orientation::rpy;
  diagnostics.error(table.place_of("orientation"), "orientation: " + quoted(*text) + " are no angles",
                    "write \"zyz\" or \"rpy\", or leave it out for the angular velocity");
  return Orientation::angular_velocity;
}

Rational read_damping(TomlTable& table, const char* key, Diagnostics& diagnostics) {
  const std::optional<Value> damping = table.number(key, Quantity::other);
  if (!damping) return 0;
  if (is_rational(damping->number) && to_rational(damping->number) >= 0) return to_rational(damping->number);
  diagnostics.error(table.place_of(key), std::string(key) + ": it is not a rational number from 0",
                    "lambda of (J B^-1 J^T + lambda^2 1)^-1, 0.01 for instance");
  return 0;
}

// Rows of the Jacobian by the names that people give them.
std::vector<int> read_rows(TomlTable& table, Orientation orientation, Diagnostics& diagnostics) {
  const bool has_angles = orientation != Orientation::angular_velocity;
  const std::vector<std::string> names = has_angles ? std::vector<std::string>{"x", "y", "z", "phi", "theta", "psi"}
                                                    : std::vector<std::string>{"x", "y", "z", "rx", "ry", "rz"};
  std::vector<int> rows;
  for (const Reference& direction : table.references("task")) {
    const auto found = std::find(names.begin(), names.end(), direction.name);
    if (found == names.end()) {
      diagnostics.error(direction.place, "task: " + quoted(direction.name) + " is no direction",
                        has_angles ? "x, y, z for the tip's velocity, phi, theta, psi for the rates of its angles"
                                   : "x, y, z for the tip's velocity, rx, ry, rz for its rotation, in the base frame; "
                                     "with `orientation` phi, theta, psi");
      continue;
    }
    rows.push_back(static_cast<int>(found - names.begin()));
  }
  std::sort(rows.begin(), rows.end());
  if (std::adjacent_find(rows.begin(), rows.end()) != rows.end()) {
    diagnostics.error(table.place_of("task"), "task: a direction is there twice", "name it once");
  }
  return rows;
}

void require_some(const std::vector<Reference>& list, const Place& place, const std::string& what,
                  Diagnostics& diagnostics) {
  if (list.empty()) diagnostics.error(place, what + ": nothing is asked for", "name what is needed, or leave it out");
}

std::vector<SceneOutputs> read_outputs(TomlTable table, Diagnostics& diagnostics) {
  std::vector<SceneOutputs> all;
  for (const std::string& function : table.keys()) {
    const Place place = table.place_of(function);
    all.push_back({{function, place}, table.references(function)});
    if (table.is_list(function)) require_some(all.back().entries, place, "outputs, " + function, diagnostics);
  }
  return all;
}

std::optional<ErrorBudget> read_error_budget(TomlTable& table, Diagnostics& diagnostics) {
  const std::optional<std::string> text = table.text("error_budget");
  if (!text) return std::nullopt;
  std::optional<ErrorBudget> budget = error_budget(*text);
  if (!budget) {
    diagnostics.error(table.place_of("error_budget"), "error_budget: " + quoted(*text) + " is no error budget",
                      kErrorBudgetHint);
  }
  return budget;
}

// With `functions`, what is asked of another function would have no effect.
void check_outputs_are_made(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.functions.empty()) return;
  for (const SceneOutputs& outputs : scene.outputs) {
    const bool is_made =
        std::any_of(scene.functions.begin(), scene.functions.end(),
                    [&outputs](const Reference& function) { return function.name == outputs.function.name; });
    if (is_made) continue;
    diagnostics.error(outputs.function.place,
                      "outputs: function " + quoted(outputs.function.name) + " is not among `functions`",
                      "add it there, or take it out here");
  }
}

}  // namespace

Scene read_scene(const std::string& file, ReadContext& context) {
  Scene scene;
  scene.file = file;
  Diagnostics& diagnostics = context.diagnostics;
  const std::optional<std::string> text = file_text(file, diagnostics);
  if (!text) return scene;
  TomlSource source(*text, file, context, "docs/scene-format.md");
  const std::optional<toml::table> root = source.parse();
  if (!root) return scene;
  TomlTable table(*root, "", source);
  table.text("description");
  const Units units{read_choice(table, "angles", {"rad", "deg"}, diagnostics) == "deg", false, true};
  source.set_units(units);
  scene.degrees = units.degrees;
  scene.gravity = read_gravity(table, diagnostics);
  if (const std::optional<TomlTable> locked = table.table("locked")) scene.locked = read_locked(*locked);
  scene.payload = read_payload(table, diagnostics);
  if (const std::optional<TomlTable> limits = table.table("limits")) scene.limits = read_all_limits(*limits, units);
  if (const std::optional<TomlTable> gains = table.table("current_to_torque")) {
    scene.gains = read_gains(*gains, diagnostics);
  }
  scene.base_limits = read_base_limits(table, diagnostics);
  scene.at_rest = table.boolean("static").value_or(false);
  scene.friction = table.boolean("friction").value_or(true);
  scene.springs = table.boolean("springs").value_or(true);
  scene.error_budget = read_error_budget(table, diagnostics);
  scene.task.orientation = read_orientation(table, diagnostics);
  scene.task.damping = read_damping(table, "damping", diagnostics);
  scene.task.rows = read_rows(table, scene.task.orientation, diagnostics);
  if (table.is_list("task")) require_some(table.references("task"), table.place_of("task"), "task", diagnostics);
  scene.frames = read_frames(table, diagnostics);
  scene.contacts = read_contacts(table, diagnostics);
  scene.contact_damping = read_damping(table, "contact_damping", diagnostics);
  scene.functions = table.references("functions");
  if (table.is_list("functions")) {
    require_some(scene.functions, table.place_of("functions"), "functions", diagnostics);
  }
  if (const std::optional<TomlTable> outputs = table.table("outputs")) {
    scene.outputs = read_outputs(*outputs, diagnostics);
  }
  check_outputs_are_made(scene, diagnostics);
  table.reject_unknown_keys();
  return scene;
}

}  // namespace flatdyn
