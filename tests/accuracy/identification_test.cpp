// SPDX-License-Identifier: GPL-2.0-or-later
#include "support/identified_arm.hpp"

namespace flatdyn::testing {
namespace {

class Identification : public ::testing::TestWithParam<const char*> {};

TEST_P(Identification, RecoversEveryBaseParameterFromNoiseFreeMotion) { expect_recovery(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Robots, Identification,
                         ::testing::Values("rx90.toml", "ur5.urdf", "panda.urdf", "quadruped12.urdf"));

}  // namespace
}  // namespace flatdyn::testing
