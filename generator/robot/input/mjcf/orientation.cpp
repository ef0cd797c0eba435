// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/orientation.hpp"

#include <algorithm>

#include "robot/input/common/units.hpp"
#include "robot/input/common/words.hpp"
#include "robot/model/pose_product.hpp"
#include "robot/model/rational_rotation.hpp"
#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {

namespace {

bool is_zero(const Vec3& vector) { return vanishes(dot(vector, vector)); }

void report_zero(const Spot& spot, Diagnostics& diagnostics) {
  diagnostics.error(spot.place, spot.what + " has no direction", "write numbers that are not all 0");
}

class OrientationReader {
 public:
  OrientationReader(const MjcfItem& item, const MjcfValues& values, const MjcfSettings& settings)
      : item_(item), values_(values), settings_(settings), context_(values.context()) {}

  Displacements read() {
    const char* form = this->form();
    if (form == nullptr) return {};
    const std::string name = form;
    const std::size_t count = name == "xyaxes" ? 6 : name == "quat" || name == "axisangle" ? 4 : 3;
    const auto found = values_.numbers(item_, form, count, count);
    if (!found) return {};
    if (name == "quat") return by_quaternion(*found);
    if (name == "axisangle") return by_axis_and_angle(*found);
    if (name == "xyaxes") return by_axes(*found);
    return name == "zaxis" ? by_z(*found) : by_euler(*found);
  }

 private:
  // The one attribute that gives the orientation; nullptr if there is none. An element's quat does not replace another
  // form in its class.
  const char* form() {
    const char* found = nullptr;
    bool is_own = false;
    for (const char* name : {"axisangle", "xyaxes", "zaxis", "euler", "quat"}) {
      if (values_.find(item_, name) == nullptr) continue;
      const bool own = values_.is_own(item_, name);
      if (found == nullptr) {
        found = name;
        is_own = own;
      } else if (own && is_own) {
        context_.diagnostics.error(values_.find(item_, name)->place, item_.what + " has both " + found + " and " + name,
                                   "keep one orientation");
      } else if (std::string_view(name) != "quat") {
        context_.diagnostics.unsupported(
            values_.find(item_, name)->place,
            item_.what + ": " + found + " and " + name + ", one of them by its class, are not supported",
            "give the orientation in one form");
      }
    }
    return found;
  }

  Displacements by_quaternion(const FileNumbers& q) {
    const Vec3 v = {q.numbers[1], q.numbers[2], q.numbers[3]};
    if (is_zero(v) && vanishes(q.numbers[0])) {
      report_zero(q.spot, context_.diagnostics);
      return {};
    }
    return displacements_of(turned_axes(q.numbers[0], v), q.spot, joined_words(q.written), context_);
  }

  Number angle(const FileNumbers& found, std::size_t i) {
    const Number angle = decimal_angle(found.numbers[i], found.written[i], settings_.angles, found.spot, context_);
    if (!settings_.angles.degrees && may_be_degrees(angle)) {
      warn_of_degrees(angle, found.spot, "if so, write <compiler angle=\"degree\"/>", context_.diagnostics);
    }
    return angle;
  }

  Displacements by_axis_and_angle(const FileNumbers& found) {
    const Vec3 axis = as_vector(found.numbers);
    if (is_zero(axis)) {
      report_zero(found.spot, context_.diagnostics);
      return {};
    }
    return turn_about(axis, angle(found, 3), found.spot, joined_words(found.written), context_);
  }

  Displacements by_euler(const FileNumbers& found) {
    using Kind = Displacement::Kind;
    Displacements turns;
    for (std::size_t i = 0; i < 3; ++i) {
      const char letter = settings_.euler_sequence[i];
      const char axis = static_cast<char>(letter | 0x20);
      const Kind kind = axis == 'x' ? Kind::rotation_x : axis == 'y' ? Kind::rotation_y : Kind::rotation_z;
      const Displacement turn{kind, zero_vector(), angle(found, i)};
      if (!turn.angle.is_zero()) turns.insert(letter == axis ? turns.end() : turns.begin(), turn);
    }
    return turns;
  }

  // The second axis is made perpendicular to the first.
  Displacements by_axes(const FileNumbers& found) {
    const Vec3 x = as_vector(found.numbers), other = {found.numbers[3], found.numbers[4], found.numbers[5]};
    if (is_zero(cross(x, other))) {
      report_zero(found.spot, context_.diagnostics);
      return {};
    }
    const Vec3 y = other - (dot(x, other) / dot(x, x)) * x;
    return displacements_of({x, y}, found.spot, joined_words(found.written), context_);
  }

  Displacements by_z(const FileNumbers& found) {
    const Vec3 z = as_vector(found.numbers);
    if (!is_zero(z)) return turn_from_z(z, found.spot, joined_words(found.written), context_);
    report_zero(found.spot, context_.diagnostics);
    return {};
  }

  const MjcfItem& item_;
  const MjcfValues& values_;
  const MjcfSettings& settings_;
  ReadContext& context_;
};

}  // namespace

std::vector<Displacement> mjcf_orientation(const MjcfItem& item, const MjcfValues& values,
                                           const MjcfSettings& settings) {
  return OrientationReader(item, values, settings).read();
}

Pose mjcf_pose(const MjcfItem& item, const MjcfValues& values, const MjcfSettings& settings) {
  Pose pose{{}, item.element->place};
  const Vec3 position = values.length_vector(item, "pos");
  if (!is_zero(position)) pose.displacements.push_back(translation(position));
  for (const Displacement& turn : mjcf_orientation(item, values, settings)) pose.displacements.push_back(turn);
  return pose;
}

}  // namespace flatdyn
