// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/steps.hpp"

#include <fmt/format.h>

#include "code/emit/writer.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// Joints of one axis whose entries follow each other in v and in q, or a spherical joint: entries of v from `first` to
// before `last`. Entry k of v belongs to entry k + `shift` of q; for a spherical joint that of `first` is its
// quaternion's first.
struct JointSegment {
  int first = 0, last = 0, shift = 0;
  bool is_spherical = false;
};

std::vector<JointSegment> segments(const Mechanism& mechanism) {
  std::vector<JointSegment> found;
  const int pose = pose_entries(mechanism);
  int next = mechanism.base_bodies();
  const auto shift_of = [&](int k) { return pose + mechanism.position_of(k) - k; };
  const auto add_axes_before = [&](int end) {
    while (next < end) {
      const int first = next++;
      while (next < end && shift_of(next) == shift_of(first)) ++next;
      found.push_back({first, next, shift_of(first)});
    }
  };
  for (const int first : mechanism.spherical) {
    add_axes_before(first);
    next = first + kSphericalBodies;
    found.push_back({first, next, pose + mechanism.quaternion_of(first) - first, true});
  }
  add_axes_before(mechanism.size());
  return found;
}

// "7", "k + 1".
std::string entry(const char* index, int shift) {
  return shift == 0 ? std::string(index) : fmt::format("{} + {}", index, shift);
}

// The statement for a segment: `axis` is that for an entry "{v}" of v and "{q}" of q, `ball` that for a spherical joint
// whose first entries are these.
std::string statement_of(const JointSegment& segment, const Mechanism& mechanism, const char* axis, const char* ball) {
  const auto statement = [](const char* text, const std::string& v, const std::string& q) {
    return with_replaced(with_replaced(text, "{v}", v), "{q}", q);
  };
  if (segment.is_spherical || segment.last == segment.first + 1) {
    return statement(segment.is_spherical ? ball : axis, std::to_string(segment.first),
                     std::to_string(segment.first + segment.shift));
  }
  const std::string last =
      segment.last == mechanism.size() ? count_of_velocities(mechanism) : std::to_string(segment.last);
  return fmt::format("for (int k = {}; k < {}; ++k) {}", segment.first, last,
                     statement(axis, "k", entry("k", segment.shift)));
}

std::vector<std::string> lines_of(const Mechanism& mechanism, const char* axis, const char* ball) {
  std::vector<std::string> lines;
  for (const JointSegment& segment : segments(mechanism)) {
    if (segment.is_spherical) {
      lines.push_back(fmt::format("// Joint \"{}\".", comment_text(joint_name(mechanism.joint(segment.first)))));
    }
    lines.push_back(statement_of(segment, mechanism, axis, ball));
  }
  return lines;
}

}  // namespace

std::vector<std::string> integrate_joints(const Mechanism& mechanism) {
  std::vector<std::string> lines = lines_of(mechanism, "q_next[{q}] = q[{q}] + v[{v}] * dt;",
                                            "detail::turn_joint(q + {q}, v + {v}, dt, q_next + {q});");
  for (const LoopClosure& loop : mechanism.loops) {
    for (const int p : loop.dependent)
      lines.push_back(fmt::format("q_next[{0}] = q[{0}];", pose_entries(mechanism) + p));
  }
  return lines;
}

std::vector<std::string> difference_joints(const Mechanism& mechanism) {
  return lines_of(mechanism, "v[{v}] = q_1[{q}] - q_0[{q}];", "detail::turn_between(q_0 + {q}, q_1 + {q}, v + {v});");
}

}  // namespace flatdyn
