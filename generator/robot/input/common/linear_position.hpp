// SPDX-License-Identifier: GPL-2.0-or-later
// The position of a coupled joint as TOML files write it: "finger_left", "elbow - shoulder", "2*drive + pi/4".
#pragma once

#include <optional>
#include <string>

#include "robot/input/common/context.hpp"

namespace flatdyn {

// The names are those of joints; whether there are such joints is not asked here. nullopt, and a diagnostic, if the
// text is no linear expression of names with numbers as factors.
std::optional<Coupled> read_linear_position(const std::string& text, JointType type, const Units& units,
                                            const Spot& spot, ReadContext& context);

}  // namespace flatdyn
