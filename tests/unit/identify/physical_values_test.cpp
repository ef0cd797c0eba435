// SPDX-License-Identifier: GPL-2.0-or-later
// The further parameters that go with links that a body can have.
#include <gtest/gtest.h>

#include "laboratory/identify/identification.hpp"

namespace flatdyn {
namespace {

// One parameter of the links, one of friction and the correction of its speed, whose columns are nearly parallel: the
// log tells their sum well, and either of them 10^4 times worse.
Identification with_parallel_columns() {
  Identification found;
  found.estimate.values = Eigen::Vector3d(2, 5, 0);
  found.estimate.root_information.resize(2, 3);
  found.estimate.root_information << 10, 10, 10.001,  //
      0.001, 0, 0.001;
  found.physical.pi_b = Eigen::VectorXd::Constant(1, 2.1);
  return found;
}

TEST(PhysicalValues, KeepCorrectionsAsTheyAre) {
  Identification found = with_parallel_columns();
  found.corrections = 1;
  const Eigen::VectorXd values = found.physical_values();
  EXPECT_EQ(values(0), 2.1);
  EXPECT_NEAR(values(1), 4.9, 1e-12);
  EXPECT_EQ(values(2), 0);
}

TEST(PhysicalValues, MoveAllFurtherParametersElse) {
  const Eigen::VectorXd values = with_parallel_columns().physical_values();
  EXPECT_EQ(values(0), 2.1);
  EXPECT_NEAR(values(1), 5.00001, 1e-9);
  EXPECT_NEAR(values(2), -0.1, 1e-9);
}

}  // namespace
}  // namespace flatdyn
