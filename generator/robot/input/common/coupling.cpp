// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/coupling.hpp"

#include <algorithm>
#include <map>

namespace flatdyn {
namespace {

bool says_same(const Coupled& a, const Coupled& b) {
  const auto factors_of = [](const Coupled& coupled) {
    std::map<std::string, Number> factors;
    for (const Coupled::Term& term : coupled.terms) factors[term.joint.name] += term.factor;
    return factors;
  };
  const auto first = factors_of(a), second = factors_of(b);
  return vanishes(a.offset - b.offset) &&
         std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const auto& x, const auto& y) { return x.first == y.first && vanishes(x.second - y.second); });
}

}  // namespace

void couple_joint(Joint& joint, const Coupled& coupled, const std::string& what, Diagnostics& diagnostics) {
  if (!joint.coupled) {
    joint.coupled = coupled;
  } else if (!says_same(*joint.coupled, coupled)) {
    diagnostics.error(coupled.place,
                      what + ": line " + std::to_string(joint.coupled->place.line) + " lets joint \"" + joint.name +
                          "\" follow in another way",
                      "make them agree, or delete one of them");
  }
}

}  // namespace flatdyn
