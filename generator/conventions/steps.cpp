// SPDX-License-Identifier: GPL-2.0-or-later
#include "conventions/steps.hpp"

#include <fmt/format.h>

#include "emit/writer.hpp"
#include "model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// Joints of one axis that follow each other, or a spherical joint: entries of v from `first` to before `last`. Entry k
// of v belongs to entry k + `shift` of q; for a spherical joint that of `first` is its quaternion's first.
struct JointSegment {
  int first = 0, last = 0, shift = 0;
  std::string spherical;  // the joint's name; empty for joints of one axis
};

std::vector<JointSegment> segments(const Mechanism& mechanism) {
  std::vector<JointSegment> found;
  int shift = pose_entries(mechanism) - mechanism.base_bodies(), next = mechanism.base_bodies();
  for (const int first : mechanism.spherical) {
    if (first > next) found.push_back({next, first, shift, ""});
    found.push_back({first, first + kSphericalBodies, shift, joint_name(mechanism.joint(first))});
    next = first + kSphericalBodies;
    ++shift;
  }
  if (next < mechanism.size()) found.push_back({next, mechanism.size(), shift, ""});
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
  if (!segment.spherical.empty()) {
    return statement(ball, fmt::format("{}", segment.first), fmt::format("{}", segment.first + segment.shift));
  }
  if (segment.last == segment.first + 1) {
    return statement(axis, fmt::format("{}", segment.first), fmt::format("{}", segment.first + segment.shift));
  }
  const std::string last =
      segment.last == mechanism.size() ? count_of_velocities(mechanism) : fmt::format("{}", segment.last);
  return fmt::format("for (int k = {}; k < {}; ++k) {}", segment.first, last,
                     statement(axis, "k", entry("k", segment.shift)));
}

std::vector<std::string> lines_of(const Mechanism& mechanism, const char* axis, const char* ball) {
  std::vector<std::string> lines;
  for (const JointSegment& segment : segments(mechanism)) {
    if (!segment.spherical.empty()) lines.push_back(fmt::format("// Joint \"{}\".", comment_text(segment.spherical)));
    lines.push_back(statement_of(segment, mechanism, axis, ball));
  }
  return lines;
}

}  // namespace

std::vector<std::string> integrate_joints(const Mechanism& mechanism) {
  return lines_of(mechanism, "q_next[{q}] = q[{q}] + v[{v}] * dt;",
                  "detail::turn_joint(q + {q}, v + {v}, dt, q_next + {q});");
}

std::vector<std::string> difference_joints(const Mechanism& mechanism) {
  return lines_of(mechanism, "v[{v}] = q_1[{q}] - q_0[{q}];", "detail::turn_between(q_0 + {q}, q_1 + {q}, v + {v});");
}

}  // namespace flatdyn
