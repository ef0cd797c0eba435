// SPDX-License-Identifier: GPL-2.0-or-later
// The options that a caller has for the readers of robot files.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/input/common/sources.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

struct ReadOptions {
  Number snap_tolerance = exact_decimal("1e-5");  // rad; 0 turns snapping off
  std::optional<std::size_t> left_unsnapped;      // index of the one angle that keeps its decimal: what did it change?
  std::optional<std::string> tip;                 // --tip: name of the tip link
  std::string scene_file;                         // --scene; empty: none
  Scene scene;                                    // --gravity, --fix: goes before what the scene file says
  std::optional<bool> floating_base;              // --base; without it the file decides
  std::shared_ptr<Sources> sources = std::make_shared<Sources>();  // of the texts; --xacro
  std::vector<std::string> ignored = {};  // --ignore: elements and attributes of MJCF files that are left out
  std::optional<std::string> model{};     // --model: the model of an SDF with several
  std::optional<std::string> keyframe{};  // --keyframe: the one of an MJCF at which closed loops are assembled
};

// A number smaller than this fraction of its neighbours is dust: 1e-9, or less if that is asked of angles.
Number dust_part(const ReadOptions& options);

}  // namespace flatdyn
