// SPDX-License-Identifier: GPL-2.0-or-later
// TOML robot files (docs/robot-format.md): DH tables or placed links, or motors and friction over a URDF file.
#pragma once

#include <optional>
#include <string>

#include "input/context.hpp"

namespace flatdyn {

// What a TOML file says about the whole robot, which can be applied only when the tree is known.
struct Attachments {
  struct Payload {
    std::optional<Reference> link;  // the tip's if it is not given
    Inertial inertial;
  };
  std::optional<Reference> tip;
  Pose tip_offset;
  std::optional<Payload> payload;
};

// Reads the text of a TOML file (and of the robot file that it names) into `robot`; nothing checked but what is needed to
// read on. `file` names it in diagnostics, and its folder is where that robot file is looked for.
Attachments read_toml(const std::string& text, const std::string& file, ReadContext& context, Robot& robot);

// Index of the link of this name, or nullopt and a diagnostic; `what` says who refers to it.
std::optional<int> find_link(const Robot& robot, const Reference& link, const std::string& what,
                             Diagnostics& diagnostics);

}  // namespace flatdyn
