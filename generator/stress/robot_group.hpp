// SPDX-License-Identifier: GPL-2.0-or-later
// The emitted text of many robots, compiled together: most of a compiler's time for one goes into starting.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "stress/one_robot.hpp"
#include "system/shared_library.hpp"
#include "system/temporary_folder.hpp"
#include "verify/compiled.hpp"

namespace flatdyn {

class RobotGroup {
 public:
  struct Member {
    unsigned seed = 0;
    PlainRobot drawn;
    std::unique_ptr<OneRobot> robot;
  };

  // Starts to compile, beside what the program does meanwhile: exact numbers have no part in it.
  explicit RobotGroup(std::vector<Member> members);

  const std::vector<Member>& members() const { return members_; }
  // By function of that member. Waits for the compiler; throws as SharedLibrary does.
  std::vector<PlainEntry> entries(std::size_t member);

 private:
  TemporaryFolder folder_;
  std::vector<Member> members_;
  std::future<std::unique_ptr<SharedLibrary>> compiling_;
  std::unique_ptr<SharedLibrary> library_;
};

}  // namespace flatdyn
