// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/turns.hpp"

#include <cmath>

#include "robot/input/common/quaternion.hpp"
#include "robot/model/exact_sign.hpp"
#include "robot/model/pose_product.hpp"

namespace flatdyn {

namespace {

constexpr int kDigitsOfTurn = 80;

Number decimal_of(const Number& number) { return exact_decimal(to_decimal(number, kDigitsOfTurn)); }

// The angle between the x axis and (x, y): a multiple of pi/12 where it is exactly that, else to many digits.
Number angle_of(const Number& x, const Number& y) {
  constexpr int kTwelfths = 12;
  if (vanishes(y) && vanishes(x)) return 0;
  const Number angle = decimal_of(GiNaC::atan2(y, x));
  static const Number kTwelfth = decimal_of(GiNaC::Pi) / kTwelfths;
  const double multiple = std::round(nearest_double(angle / kTwelfth));
  const Number nearest = static_cast<long>(multiple);
  static const GiNaC::numeric kSame = magnitude(exact_decimal("1e-70"));
  return magnitude(angle - nearest * kTwelfth) < kSame ? nearest * GiNaC::Pi / kTwelfths : angle;
}

// roll, pitch, yaw. A pitch that is within `tolerance` of a quarter turn counts as one: then the roll is 0.
Vec3 rpy_of(const TurnedAxes& axes, const Number& tolerance) {
  const Vec3& x = axes.x;
  const Vec3 z = cross(axes.x, axes.y);
  const Number across = x[0] * x[0] + x[1] * x[1], length = dot(x, x);
  if (magnitude(across) <= magnitude(tolerance * tolerance * length)) {
    const Number quarter = GiNaC::Pi / (is_positive(x[2]) ? -2 : 2);
    return {0, quarter, angle_of(axes.y[1], -axes.y[0])};
  }
  return {angle_of(z[2], axes.y[2] * decimal_of(GiNaC::sqrt(length))), angle_of(decimal_of(GiNaC::sqrt(across)), -x[2]),
          angle_of(x[0], x[1])};
}

}  // namespace

TurnedAxes turned_axes(const Number& w, const Vec3& v) {
  const auto& [x, y, z] = v;
  return {{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
          {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)}};
}

Displacements displacements_of(const TurnedAxes& axes, const Spot& spot, const std::string& written,
                               ReadContext& context) {
  using Kind = Displacement::Kind;
  const bool snaps = !context.options.snap_tolerance.is_zero();
  const Vec3 rpy = rpy_of(axes, snaps ? exact_decimal("1e-6") : Number(0));
  Displacements turns;
  for (const auto& [kind, angle] : {std::pair(Kind::rotation_z, rpy[2]), std::pair(Kind::rotation_y, rpy[1]),
                                    std::pair(Kind::rotation_x, rpy[0])}) {
    const Number snapped = is_rational(angle) ? snapped_angle(angle, written, spot, context) : angle;
    if (!snapped.is_zero()) turns.push_back({kind, zero_vector(), snapped});
  }
  return turns;
}

Displacement translation(const Vec3& by) { return {Displacement::Kind::translation, by, 0}; }

Displacements turn_about(const Vec3& axis, const Number& angle, const Spot& spot, const std::string& written,
                         ReadContext& context) {
  using Kind = Displacement::Kind;
  if (angle.is_zero()) return {};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!vanishes(axis[(i + 1) % 3]) || !vanishes(axis[(i + 2) % 3])) continue;
    const Kind kind = i == 0 ? Kind::rotation_x : i == 1 ? Kind::rotation_y : Kind::rotation_z;
    return {{kind, zero_vector(), is_positive(axis[i]) ? angle : -angle}};
  }
  const Number half = decimal_of(GiNaC::sin(angle / 2) / GiNaC::sqrt(dot(axis, axis)));
  return displacements_of(turned_axes(decimal_of(GiNaC::cos(angle / 2)), half * axis), spot, written, context);
}

// About z × direction, by the angle between them.
Displacements turn_from_z(const Vec3& direction, const Spot& spot, const std::string& written, ReadContext& context) {
  const Vec3 axis = {-direction[1], direction[0], 0};
  const Number across = dot(axis, axis);
  if (vanishes(across)) return turn_about({1, 0, 0}, angle_of(direction[2], 0), spot, written, context);
  return turn_about(axis, angle_of(direction[2], decimal_of(GiNaC::sqrt(across))), spot, written, context);
}

}  // namespace flatdyn
