// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/error_groups.hpp"

#include <algorithm>
#include <cmath>

namespace flatdyn {
namespace {

constexpr std::size_t kMostComponents = 3;  // vectors in space
constexpr std::size_t kNearby = 12;         // number of recent groups that a derivative may join
constexpr double kWorthwhile = 1e-3;        // least gain, relative to the cost of separate bounds

double sum_of(const AlikeErrors& errors) {
  double sum = 0;
  for (const ErrorTerm& term : errors) sum += term.error;
  return sum;
}

// A group under construction. Its cost is a bound of its contribution to the output's error.
struct GroupDraft {
  std::vector<const ErrorsByDerivative*> parts;
  std::vector<int> derivatives;
  // Lengths of the vector of errors, and of the vector of the derivatives' separate bounds.
  double error = 0, apart = 0;
  double cost = 0;

  GroupDraft with(const ErrorsByDerivative& part, Norms& norms) const {
    GroupDraft result = *this;
    result.parts.push_back(&part);
    result.derivatives.push_back(part.derivative);
    result.error = std::hypot(error, sum_of(part.errors));
    result.apart = std::hypot(apart, part.sensitivity);
    const double length = parts.empty() ? INFINITY : norms.largest_length(result.derivatives, kLittleEffort);
    result.cost = result.error * std::min(result.apart, length);
    return result;
  }
};

ErrorGroup group_of(const std::vector<const ErrorsByDerivative*>& parts, double error, double sensitivity) {
  ErrorGroup result;
  for (const ErrorsByDerivative* part : parts) result.components.push_back(part->errors);
  std::reverse(result.components.begin(), result.components.end());
  result.sensitivity = rounded_up(sensitivity, kBoundDigits);
  result.bound = error * result.sensitivity * kRoundingMargin;
  return result;
}

// Finishes a group; its parts are bounded separately if that is no worse after all.
void finish(const GroupDraft& draft, Norms& norms, std::vector<ErrorGroup>& groups) {
  std::vector<ErrorGroup> apart;
  double bound = 0;
  for (const ErrorsByDerivative* part : draft.parts) {
    apart.push_back(group_of({part}, sum_of(part->errors), part->sensitivity));
    bound += apart.back().bound;
  }
  if (apart.size() > 1) {
    const double length = std::min(draft.apart * kRoundingMargin, norms.largest_length(draft.derivatives));
    const ErrorGroup together = group_of(draft.parts, draft.error, length);
    if (together.bound < bound) apart = {together};
  }
  groups.insert(groups.end(), apart.begin(), apart.end());
}

bool may_rotate_together(const GroupDraft& draft, int derivative, Norms& norms) {
  return std::any_of(draft.derivatives.begin(), draft.derivatives.end(),
                     [&](int other) { return norms.may_rotate_together(other, derivative); });
}

// Adds the part to the draft that gains most by it, or to a new one.
void add(const ErrorsByDerivative& part, Norms& norms, std::vector<GroupDraft>& drafts) {
  const GroupDraft alone = GroupDraft{}.with(part, norms);
  double most = kWorthwhile * alone.cost;
  GroupDraft best = alone;
  std::size_t into = drafts.size();
  for (std::size_t back = 1; back <= std::min(drafts.size(), kNearby); ++back) {
    const std::size_t k = drafts.size() - back;
    const GroupDraft& draft = drafts[k];
    if (draft.parts.size() == kMostComponents || !may_rotate_together(draft, part.derivative, norms)) continue;
    GroupDraft together = draft.with(part, norms);
    const double gained = draft.cost + alone.cost - together.cost;
    if (gained <= most) continue;
    most = gained;
    best = std::move(together);
    into = k;
  }
  if (into == drafts.size()) drafts.emplace_back();
  drafts[into] = std::move(best);
}

}  // namespace

std::vector<ErrorGroup> grouped(const std::vector<ErrorsByDerivative>& errors, Norms& norms) {
  std::vector<GroupDraft> drafts;
  for (const ErrorsByDerivative& part : errors) add(part, norms, drafts);
  std::vector<ErrorGroup> groups;
  for (const GroupDraft& draft : drafts) finish(draft, norms, groups);
  std::reverse(groups.begin(), groups.end());
  return groups;
}

}  // namespace flatdyn
