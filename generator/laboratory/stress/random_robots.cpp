// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/random_robots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/system/temporary_folder.hpp"
#include "laboratory/stress/one_robot.hpp"
#include "laboratory/stress/robot_group.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kMostFailures = 3;
constexpr std::size_t kGroup = 25;  // robots that are compiled together

bool is_chain(const PlainRobot& robot) {
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    if (robot.links[k].parent != static_cast<int>(k)) return false;
  }
  return true;
}

bool is_one_in(unsigned seed, int times) { return times > 0 && seed % static_cast<unsigned>(times) == 0; }

class RandomRobots {
 public:
  RandomRobots(const RandomRobotsOptions& options, Progress& progress) : options_(options), progress_(progress) {
    report_.options = options;
    report_.worst.assign(options.functions.size(), 0);
  }

  RandomRobotsReport run() {
    for (unsigned k = 0; k < static_cast<unsigned>(options_.robots) && is_going_on(); ++k) {
      if (k % kGroup == 0) progress_.step(fmt::format("random robot {} of {}", k + 1, options_.robots));
      look_at(options_.seed + k);
      if (waiting_.size() == kGroup) compile();
    }
    if (!waiting_.empty()) compile();
    finish_group();
    return std::move(report_);
  }

 private:
  bool is_going_on() const { return report_.failures.size() < kMostFailures; }

  void look_at(unsigned seed) {
    PlainRobot drawn = plain_robot(seed);
    ++report_.robots;
    report_.joints += static_cast<int>(drawn.links.size());
    report_.chains += is_chain(drawn) ? 1 : 0;
    report_.usual += is_one_in(seed, options_.usual_one_in) ? 1 : 0;
    std::unique_ptr<OneRobot> robot = made(drawn, seed);
    if (const std::optional<RandomRobotFault> fault = fault_of(*robot, options_, report_)) {
      add_failure(seed, *fault, drawn);
    } else if (is_one_in(seed, options_.compiled_one_in)) {
      waiting_.push_back({seed, std::move(drawn), std::move(robot)});
    }
  }

  std::unique_ptr<OneRobot> made(const PlainRobot& robot, unsigned seed) const {
    const bool is_usual = is_one_in(seed, options_.usual_one_in);
    return std::make_unique<OneRobot>(robot, seed, is_usual, options_, folder_.path());
  }

  // ---- text that is compiled while the next robots are derived

  void compile() {
    finish_group();
    group_ = std::make_unique<RobotGroup>(std::move(waiting_));
    waiting_.clear();
  }

  void finish_group() {
    if (!group_) return;
    for (std::size_t m = 0; m < group_->members().size() && is_going_on(); ++m) {
      const RobotGroup::Member& member = group_->members()[m];
      ++report_.compiled;
      const auto fault = compiled_fault(*member.robot, group_->entries(m), report_);
      if (fault) add_failure(member.seed, *fault, member.drawn);
    }
    group_.reset();
  }

  std::optional<RandomRobotFault> compiled_fault(const OneRobot& robot, const std::vector<PlainEntry>& entries,
                                                 RandomRobotsReport& report) const {
    for (const State& state : robot.states()) {
      for (std::size_t k = 0; k < entries.size(); ++k) {
        const std::vector<double> values = called(entries[k], robot.functions()[k], state);
        if (auto fault = fault_of(robot, k, state, values, RandomRobotFault::How::compiled, options_, report))
          return fault;
      }
    }
    return std::nullopt;
  }

  // ---- simplification of failing robots

  // The fault of a simpler robot; none if its file is refused.
  std::optional<RandomRobotFault> fault_of_simpler(const PlainRobot& simpler, unsigned seed, bool is_compiled) const {
    RandomRobotsReport unused;
    unused.worst.assign(options_.functions.size(), 0);
    try {
      std::unique_ptr<OneRobot> robot = made(simpler, seed);
      if (auto fault = fault_of(*robot, options_, unused)) return fault;
      if (!is_compiled) return std::nullopt;
      std::vector<RobotGroup::Member> alone;
      alone.push_back({seed, simpler, std::move(robot)});
      RobotGroup group(std::move(alone));
      return compiled_fault(*group.members().front().robot, group.entries(0), unused);
    } catch (const Failure& failure) {
      if (failure.kind() != FailureKind::input && failure.kind() != FailureKind::unsupported) throw;
      return std::nullopt;
    }
  }

  void add_failure(unsigned seed, const RandomRobotFault& fault, const PlainRobot& drawn) {
    progress_.step(fmt::format("making robot {} smaller: {}", seed, to_string(fault)));
    const bool is_compiled = fault.how == RandomRobotFault::How::compiled;
    PlainRobot smallest = drawn;
    RandomRobotFault last = fault;
    std::vector<PlainRobot> simpler = simpler_robots(smallest);
    // After a success the loop goes on from there, since a change that failed before seldom succeeds later; it ends
    // when no change succeeds.
    for (std::size_t next = 0, refused = 0; refused < simpler.size(); ++next) {
      const PlainRobot& candidate = simpler[next % simpler.size()];
      const std::optional<RandomRobotFault> still = fault_of_simpler(candidate, seed, is_compiled);
      if (!still || !still->is_like(fault)) {
        ++refused;
        continue;
      }
      last = *still;
      smallest = PlainRobot(candidate);
      simpler = simpler_robots(smallest);
      refused = 0;
    }
    const std::vector<std::string> comment = {
        "SPDX-License-Identifier: BSD-3-Clause",
        fmt::format("Made small from what flatdyn stress --family random --seed {} --robots 1 draws: {}", seed,
                    to_string(last))};
    report_.failures.push_back({seed, fault, last, drawn, smallest, robot_file(smallest, comment)});
  }

  const RandomRobotsOptions& options_;
  Progress& progress_;
  TemporaryFolder folder_;
  RandomRobotsReport report_;
  std::vector<RobotGroup::Member> waiting_;
  std::unique_ptr<RobotGroup> group_;
};

}  // namespace

std::string to_string(const RandomRobotFault& fault) {
  const std::string size = fmt::format("scaled error {:.2g}", fault.error);
  if (fault.how == RandomRobotFault::How::witness) return "against the witness: " + size;
  return fmt::format("{}, {}: {}", fault.function, fault.how == RandomRobotFault::How::text ? "text" : "compiled",
                     size);
}

RandomRobotsReport stress_random_robots(const RandomRobotsOptions& options, Progress& progress) {
  return RandomRobots(options, progress).run();
}

}  // namespace flatdyn
