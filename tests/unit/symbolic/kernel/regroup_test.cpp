// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/kernel/regroup.hpp"

#include <gtest/gtest.h>

#include "robot/model/mechanism.hpp"
#include "support/robots.hpp"

namespace flatdyn::testing {
namespace {

TEST(IsLever, OnlyAnArmThatIsOne) {
  const Number next_to_nothing = exact_decimal("1e-41");
  EXPECT_TRUE(can_balance({exact_decimal("0.01"), 0, 1}, Balance::x));
  EXPECT_FALSE(can_balance({exact_decimal("0.01"), 0, 1}, Balance::y));
  EXPECT_FALSE(can_balance({exact_decimal("0.01"), 0, 1}, Balance::no));
  EXPECT_FALSE(can_balance({next_to_nothing, 0, 1}, Balance::x));
  EXPECT_FALSE(can_balance({0, -next_to_nothing, 1}, Balance::y));
  EXPECT_FALSE(can_balance({next_to_nothing, 0, 0}, Balance::x));
  const GiNaC::symbol a("a");
  EXPECT_TRUE(can_balance({a, 0, 1}, Balance::x));
}

// A case that random robots found: rational rotations put frames of links next to each other, 1e-41 m apart.
TEST(Regrouped, MassesStayWithinReason) {
  for (const char* arm : {"1e-41", "-1e-41", "0.3"}) {
    Mechanism mechanism = make_mechanism(random_tree(3, 3, true));
    mechanism.bodies[2].p = {exact_decimal(arm), 0, exact_decimal("0.5")};
    mechanism.bodies[2].prismatic = false;
    for (const Balance balance : kBalances) {
      const Mechanism moved =
          regrouped(mechanism, std::vector<JointGrouping>(mechanism.bodies.size(), {Grouping::i_yy, balance}));
      for (const Body& body : moved.bodies) EXPECT_LT(std::abs(nearest_double(body.inertia.mass)), 1e4) << arm;
    }
  }
}

}  // namespace
}  // namespace flatdyn::testing
