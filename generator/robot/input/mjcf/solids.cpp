// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/solids.hpp"

namespace flatdyn {

namespace {

Number square(const Number& a) { return a * a; }

Number ratio(int numerator, int denominator) { return Number(numerator) / denominator; }

MjcfSolid capsule(const Number& r, const Number& half) {
  const Number height = 2 * half, ends = ratio(4, 3) * r;  // the ends are a ball, as long as such a cylinder
  const Number of_ball = ends / (height + ends), of_cylinder = height / (height + ends);
  const Number across = of_cylinder * (square(height) / 12 + square(r) / 4) +
                        of_ball * (ratio(2, 5) * square(r) + square(height) / 4 + ratio(3, 8) * height * r);
  const Number along = of_cylinder * square(r) / 2 + of_ball * ratio(2, 5) * square(r);
  return {GiNaC::Pi * square(r) * (height + ends), {across, across, along}};
}

MjcfSolid cylinder(const Number& r, const Number& half) {
  const Number across = (3 * square(r) + 4 * square(half)) / 12;
  return {2 * GiNaC::Pi * square(r) * half, {across, across, square(r) / 2}};
}

Vec3 sums_of_squares(const Number& a, const Number& b, const Number& c) {
  return {square(b) + square(c), square(a) + square(c), square(a) + square(b)};
}

}  // namespace

std::size_t mjcf_size_count(const std::string& type) {
  if (type == "sphere") return 1;
  if (type == "capsule" || type == "cylinder") return 2;
  return type == "ellipsoid" || type == "box" ? 3 : 0;
}

MjcfSolid mjcf_solid(const std::string& type, const std::vector<Number>& sizes) {
  if (type == "sphere")
    return {ratio(4, 3) * GiNaC::Pi * square(sizes[0]) * sizes[0], ratio(2, 5) * square(sizes[0]) * Vec3{1, 1, 1}};
  if (type == "capsule") return capsule(sizes[0], sizes[1]);
  if (type == "cylinder") return cylinder(sizes[0], sizes[1]);
  const Number product = sizes[0] * sizes[1] * sizes[2];
  const Vec3 squares = sums_of_squares(sizes[0], sizes[1], sizes[2]);
  if (type == "box") return {8 * product, ratio(1, 3) * squares};
  return {ratio(4, 3) * GiNaC::Pi * product, ratio(1, 5) * squares};
}

}  // namespace flatdyn
