// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/plan_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/toml/parts.hpp"

namespace flatdyn {
namespace {

constexpr const char* kDocumentation = "docs/trajectory-format.md";
constexpr double kHighestRate = 1e6, kLongest = 1e5;  // Hz, s

class PlanReader {
 public:
  PlanReader(const Mechanism& mechanism, Diagnostics& diagnostics) : mechanism_(mechanism), diagnostics_(diagnostics) {}

  TrajectoryPlan read(TomlTable table) {
    TrajectoryPlan plan;
    plan.file = table.place().file;
    table.text("description");
    units_.degrees = choice(table, "angles", {"rad", "deg"}) == "deg";
    plan.rate = positive(table, "rate", kHighestRate).value_or(plan.rate);
    if (table.has("start")) {
      plan.start = posture(table, "start");
    } else {
      diagnostics_.error(table.place(), "start is missing", "start = [q_1, ...]: where the motion begins");
    }
    plan.tip_force = tip_force(table);
    for (TomlTable& each : table.tables("segment")) plan.segments.push_back(segment(each));
    if (plan.segments.empty() && (!table.has("segment") || table.is_list("segment"))) {
      diagnostics_.error(table.place(), "no [[segment]]: nothing moves",
                         "e.g. [[segment]] with by, profile and duration");
    }
    table.reject_unknown_keys();
    return plan;
  }

 private:
  std::size_t joints() const { return static_cast<std::size_t>(mechanism_.size()); }

  double real(const Value& value, const std::string& what) {
    if (!has_symbols(value.number)) return nearest_double(value.number);
    diagnostics_.error(value.place, what + ": a symbol has no value here", "write a number");
    return 0;
  }

  std::string choice(TomlTable& table, const std::string& key, const std::vector<std::string>& known) {
    return read_choice(table, key, known, diagnostics_);
  }

  std::optional<double> positive(TomlTable& table, const std::string& key, double most) {
    const std::optional<Value> value = table.number(key, Quantity::other);
    if (!value) return std::nullopt;
    const double number = real(*value, key);
    if (number > 0 && number <= most) return number;
    diagnostics_.error(value->place, fmt::format("{} is {:g}", key, number),
                       fmt::format("greater than 0, at most {:g}", most));
    return std::nullopt;
  }

  Eigen::Vector3d vector(TomlTable& table, const std::string& key) {
    const Vec3 v = table.vector(key, Quantity::other, zero_vector());
    Eigen::Vector3d result;
    for (int i = 0; i < 3; ++i) result[i] = real({v[static_cast<std::size_t>(i)], table.place_of(key)}, key);
    return result;
  }

  // Reads a list with a number for each joint, or a table by joint names, in which joints may be missing.
  JointPosture of_joints(TomlTable& table, const std::string& key) {
    JointPosture values(joints());
    if (table.is_table(key)) {
      by_name(*table.table(key), key, values);
      return values;
    }
    const std::optional<std::vector<Value>> list = table.numbers(key);
    if (!list) return values;
    if (list->size() != joints()) {
      diagnostics_.error(table.place_of(key),
                         fmt::format("{}: {} numbers, but the robot has {} joints", key, list->size(), joints()),
                         "one for each, in the order of flatdyn inspect; or a table, { JOINT = NUMBER, ... }");
      return values;
    }
    for (std::size_t i = 0; i < joints(); ++i) values[i] = position((*list)[i], key, i);
    return values;
  }

  // Reads a joint's position or displacement, rad or m.
  double position(const Value& value, const std::string& key, std::size_t joint) {
    const Body& body = mechanism_.joints()[joint];
    const Spot spot{value.place, key + ", joint " + quoted(body.joint)};
    return real({position_in_si(value.number, body, units_, spot, diagnostics_), value.place}, key);
  }

  void by_name(TomlTable table, const std::string& key, JointPosture& values) {
    const std::vector<std::string> names = mechanism_.joint_names();
    for (const std::string& joint : table.keys()) {
      const auto found = std::find(names.begin(), names.end(), joint);
      if (found == names.end()) {
        diagnostics_.error(table.place_of(joint), table.what() + ": no joint " + quoted(joint) + " that moves",
                           hint_for_unknown(joint, names, "joints"));
        continue;
      }
      const auto i = static_cast<std::size_t>(found - names.begin());
      const std::optional<Value> value = table.number(joint, Quantity::other);
      if (value) values[i] = position(*value, key, i);
    }
  }

  Posture posture(TomlTable& table, const std::string& key) {
    if (!table.is_table(key)) return of_joints(table, key);
    TomlTable dot = *table.table(key);
    if (!dot.has("tip")) return of_joints(table, key);
    TipPosture posture{vector(dot, "tip"), {}, {}, dot.place()};
    const std::string elbow = choice(dot, "elbow", {"down", "up"});
    if (!elbow.empty()) posture.elbow = elbow == "down" ? Elbow::down : Elbow::up;
    const JointPosture guess = of_joints(dot, "guess");
    if (dot.has("guess")) posture.guess = guess;
    dot.reject_unknown_keys();
    return posture;
  }

  std::optional<TipForce> tip_force(TomlTable& table) {
    std::optional<TomlTable> dot = table.table("tip_force");
    if (!dot) return std::nullopt;
    TipForce force;
    const Eigen::Vector3d f = vector(*dot, "force"), mu = vector(*dot, "moment");
    for (std::size_t i = 0; i < 3; ++i) {
      force.h_e[i] = f[static_cast<Eigen::Index>(i)];
      force.h_e[3 + i] = mu[static_cast<Eigen::Index>(i)];
    }
    force.in_tip_axes = choice(*dot, "axes", {"base", "tip"}) == "tip";
    if (!dot->has("axes")) {
      diagnostics_.error(dot->place(), "tip_force: axes is missing", "axes = \"base\" or axes = \"tip\"");
    }
    dot->reject_unknown_keys();
    return force;
  }

  // Reads a profile. Speeds and accelerations of joints are in degrees if the file's angles are.
  PlacedProfile profile(TomlTable& table, bool of_joints) {
    PlacedProfile profile;
    profile.place = table.place();
    const std::string shape = choice(table, "profile", {"triangular", "trapezoidal"});
    if (!table.has("profile")) {
      diagnostics_.error(table.place(), "profile is missing", "profile = \"triangular\" or \"trapezoidal\"");
    }
    profile.shape = shape == "trapezoidal" ? VelocityShape::trapezoidal : VelocityShape::triangular;
    for (const std::string key : {"duration", "acceleration", "speed", "acceleration_time"}) {
      const bool is_angle = of_joints && (key == "acceleration" || key == "speed");
      const std::vector<double> values = magnitudes(table, key, of_joints, is_angle);
      if (!table.has(key)) continue;
      profile.places[key] = table.place_of(key);
      profile.given[key] = values;
    }
    return profile;
  }

  std::vector<double> magnitudes(TomlTable& table, const std::string& key, bool of_joints, bool is_angle) {
    const std::size_t count = of_joints ? joints() : 1;
    std::vector<double> values(count, 1);
    std::optional<std::vector<Value>> written;
    if (of_joints && table.is_list(key)) {
      written = table.numbers(key);
    } else if (const std::optional<Value> one = table.number(key, Quantity::other)) {
      written.emplace(count, *one);
    }
    if (!written) return values;
    if (written->size() != count) {
      diagnostics_.error(table.place_of(key),
                         fmt::format("{}: {} numbers, but the robot has {} joints", key, written->size(), count),
                         "one number for all, or one for each");
      return values;
    }
    for (std::size_t i = 0; i < count; ++i) {
      Value value = (*written)[i];
      if (is_angle) {
        const Body& body = mechanism_.joints()[i];
        value.number = rate_in_si(value.number, body, units_, {value.place, key}, diagnostics_);
      }
      values[i] = real(value, key);
    }
    return values;
  }

  static constexpr const char* kKinds[] = {"to", "by", "line_to", "line_by", "dwell"};

  Segment segment(TomlTable& table) {
    std::vector<std::string> kinds;
    for (const char* kind : kKinds) {
      if (table.has(kind)) kinds.emplace_back(kind);
    }
    Segment result{Dwell{}, table.place()};
    if (kinds.size() != 1) {
      const std::string what =
          kinds.empty() ? "it says nothing of where to go" : fmt::format("it has {}", fmt::join(kinds, " and "));
      diagnostics_.error(table.place(), "segment: " + what, fmt::format("it needs one of {}", fmt::join(kKinds, ", ")));
      return result;
    }
    const std::string& kind = kinds.front();
    if (kind == "dwell") {
      result.motion = Dwell{positive(table, kind, kLongest).value_or(0)};
    } else if (kind == "to" || kind == "by") {
      const bool relative = kind == "by";
      Posture to = relative ? Posture(of_joints(table, kind)) : posture(table, kind);
      result.motion = JointMove{std::move(to), relative, profile(table, true)};
    } else {
      const std::string orientation = choice(table, "orientation", {"free", "held"});
      result.motion = LineMove{vector(table, kind), kind == "line_by", orientation == "held", profile(table, false)};
    }
    table.reject_unknown_keys();
    return result;
  }

  const Mechanism& mechanism_;
  Diagnostics& diagnostics_;
  Units units_;
};

}  // namespace

TrajectoryPlan read_plan(const std::filesystem::path& path, const Mechanism& mechanism, Diagnostics& diagnostics) {
  const ReadOptions options;
  ReadContext context{options, diagnostics, SymbolTable(path.string()), {}, 0, {}, {}};
  const std::optional<std::string> text = file_text(path.string(), diagnostics);
  if (!text) return {};
  const TomlSource source(*text, path.string(), context, kDocumentation);
  const std::optional<toml::table> root = source.parse();
  if (!root) return {};
  return PlanReader(mechanism, diagnostics).read(TomlTable(*root, "", source));
}

}  // namespace flatdyn
