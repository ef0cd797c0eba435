// SPDX-License-Identifier: GPL-2.0-or-later
// The files of a folder that builds for a microcontroller as it is, in addition to a robot's C header and source: the
// self test, its vectors, start-up code and a makefile.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "code/languages/emit.hpp"
#include "delivery/firmware/target.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

struct FirmwareFile {
  std::string name, text;
};

// Throws Failure(unsupported) for functions that have no reference values.
std::vector<FirmwareFile> firmware_files(const Robot& robot, const Mechanism& mechanism,
                                         const std::vector<Function>& functions, const EmitOptions& options,
                                         const FirmwareTarget& target, Progress& progress);

}  // namespace flatdyn
