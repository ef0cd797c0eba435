// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

namespace flatdyn {

// The frames to which names of parameters refer: those of the links in the robot file, or those of the mechanism.
enum class ParameterFrames : std::uint8_t { file, canonical };

}  // namespace flatdyn
