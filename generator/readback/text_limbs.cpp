// SPDX-License-Identifier: GPL-2.0-or-later
// Statements that compute limbs together: each is read once per lane.
#include <algorithm>

#include "readback/text_reader.hpp"

namespace flatdyn {
namespace {

constexpr int kMostLanes = 8;

}  // namespace

// Reads using Limbs4 = detail::Limbs<Scalar, 4>;
void TextReader::type_of_limbs() {
  if (!notation_.is_cpp || current_ != &written_) fail("an unknown statement");
  expect("using");
  const std::string name = take();
  expect_all({"=", "detail", "::", "Limbs", "<", "Scalar", ","});
  const int lanes = index();
  expect_all({">", ";"});
  const bool is_power = lanes >= 2 && lanes <= kMostLanes && (lanes & (lanes - 1)) == 0;
  if (!is_power || name != "Limbs" + std::to_string(lanes)) fail("an unknown type");
  if (!types_of_limbs_.emplace(name, lanes).second) fail("a type made twice");
}

// Reads Limbs4 x = {q[0], -q[3], q[6], -q[9]}; or Limbs4 x = sum;
void TextReader::limbs() {
  const int lanes = types_of_limbs_.at(take());
  const std::string name = take();
  refuse_known(name);
  expect("=");
  std::vector<int> values = is("{") ? gathered_limbs(lanes) : computed_limbs(lanes);
  expect(";");
  limbs_.emplace(name, std::move(values));
}

std::vector<int> TextReader::gathered_limbs(int lanes) {
  std::vector<int> values;
  for (int lane = 0; lane < lanes; ++lane) {
    expect(lane == 0 ? "{" : ",");
    values.push_back(sum());
  }
  expect("}");
  return values;
}

// Reads the same expression for one lane after the other. Scalars are the same in all lanes.
std::vector<int> TextReader::computed_limbs(int lanes) {
  std::vector<int> values;
  const std::size_t begin = at_;
  const int named_before = limbs_named_;
  lanes_ = lanes;
  for (lane_ = 0; lane_ < lanes; ++lane_) {
    at_ = begin;
    values.push_back(sum());
  }
  lane_ = kNoLane;
  if (limbs_named_ == named_before) fail("a scalar where limbs are expected");
  return values;
}

// Reads the rest of x in an expression of limbs, or of x[2] in one of scalars.
int TextReader::value_of_limb(const std::vector<int>& values) {
  if (lane_ == kNoLane) {
    expect("[");
    const int lane = index();
    expect("]");
    if (lane >= static_cast<int>(values.size())) fail("no such limb");
    return values[static_cast<std::size_t>(lane)];
  }
  if (is("[") || static_cast<int>(values.size()) != lanes_) fail("another number of limbs");
  ++limbs_named_;
  return values[static_cast<std::size_t>(lane_)];
}

// Reads the argument of a function of scalars, after the opening bracket.
int TextReader::scalar_in_brackets() {
  const int named_before = limbs_named_;
  const int value = in_brackets();
  if (limbs_named_ != named_before) fail("a function of limbs");
  return value;
}

}  // namespace flatdyn
