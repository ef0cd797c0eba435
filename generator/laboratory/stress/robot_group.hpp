// SPDX-License-Identifier: GPL-2.0-or-later
// Compiles the emitted text of many robots together: most of the time for a single one is start-up.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "base/system/shared_library.hpp"
#include "base/system/temporary_folder.hpp"
#include "laboratory/stress/one_robot.hpp"
#include "proof/verify/compiled.hpp"

namespace flatdyn {

class RobotGroup {
 public:
  struct Member {
    unsigned seed = 0;
    PlainRobot drawn;
    std::unique_ptr<OneRobot> robot;
  };

  // Starts the compiler, which runs in parallel with this program; the members' exact numbers are not needed.
  explicit RobotGroup(std::vector<Member> members);

  const std::vector<Member>& members() const { return members_; }
  // The entry points of that member, one per function. Waits for the compiler; throws as SharedLibrary does.
  std::vector<PlainEntry> entries(std::size_t member);

 private:
  TemporaryFolder folder_;
  std::vector<Member> members_;
  std::future<std::unique_ptr<SharedLibrary>> compiling_;
  std::unique_ptr<SharedLibrary> library_;
};

}  // namespace flatdyn
