// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/motion_recogniser.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "proof/certify/combinations.hpp"
#include "proof/certify/motion_samples.hpp"
#include "proof/certify/rounding.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using F = FieldPoint::Scalar;

constexpr int kMore = 10;  // samples beyond those that a combination needs: one holds by chance with probability 2^-600
constexpr int kSamples = MotionBasis::kSize + kMore;

bool has_only_revolute_joints(const Mechanism& mechanism) {
  return !mechanism.has_prismatic_joint() && mechanism.is_joint_by_joint() && mechanism.symbols.empty();
}

}  // namespace

class MotionRecogniser::Implementation {
 public:
  Implementation(const Mechanism& mechanism, const InputLimits& limits, ExactConstants constants)
      : mechanism_(mechanism), limits_(limits), constants_(std::move(constants)) {}

  void recognise(const StraightLine& lines, std::optional<int> joint) {
    if (real_.empty()) start(lines);
    for (auto& sample : real_) sample.evaluate(lines);
    for (auto& sample : field_) sample.evaluate(lines);
    for (int k = static_cast<int>(links_.size()); k < lines.size(); ++k) {
      links_.push_back(link_of(lines[k]));
      if (links_.back() >= 0 && lines[k].is_sum_or_product()) recognise(k, joint);
    }
  }

  int group(int operation) const {
    const auto found = known_.find(operation);
    return found == known_.end() ? -1 : found->second.group;
  }
  double largest(int operation) const {
    const auto found = known_.find(operation);
    return found == known_.end() ? INFINITY : found->second.largest;
  }
  double largest_length(const std::vector<int>& operations, const MatrixXd& rows) const {
    const Group& group = groups_[static_cast<std::size_t>(known_.at(operations.front()).group)];
    MatrixXd combined = MatrixXd::Zero(rows.rows(), group.sizes.size());
    double error_bound = 0;
    for (std::size_t k = 0; k < operations.size(); ++k) {
      const Combinations::Found& found = known_.at(operations[k]).found;
      const auto column = rows.col(static_cast<Index>(k));
      combined += column * found.coefficients.transpose();
      error_bound += column.norm() * found.error_bound * group.sizes.norm();
    }
    return (bound(group, combined) + error_bound) * kRoundingMargin;
  }

 private:
  static constexpr int kMixed = -2;  // of no single link: it depends on links of different branches, or on other inputs

  struct Group {
    int joint;  // -1: the link's motion itself; else the motion by this joint's acceleration
    int link;
    Combinations combinations;
    VectorXd sizes;  // bounds of the entries
  };
  struct Known {
    int group;
    Combinations::Found found;
    double largest;
  };

  void start(const StraightLine& lines) {
    ReadInputs read;
    for (int k = 0; k < lines.size(); ++k) {
      if (lines[k].step == Step::input) read.insert({lines[k].input.kind, lines[k].input.index});
    }
    bounds_.emplace(mechanism_, [&](const Input& input) {
      return read.count({input.kind, input.index}) != 0 ? limits_(input) : 0;
    });
    for (int k = 0; k < kSamples; ++k) {
      const auto seed = static_cast<std::uint64_t>(k);
      real_.emplace_back(mechanism_, RealPoint(seed), read);
      field_.emplace_back(mechanism_, FieldPoint(seed, constants_), read);
    }
  }

  bool is_behind(int link, int other) const {
    while (link > other) link = mechanism_.bodies[static_cast<std::size_t>(link)].parent;
    return link == other;
  }
  // The link with this motion as an argument.
  int link_of(const Input& input) const {
    const int base = mechanism_.base_bodies() - 1;
    if (argument_row(input.kind).is_reference) return kMixed;
    switch (argument_row(input.kind).quantity) {
      case ArgumentQuantity::position:
        return mechanism_.base_bodies() + input.index;
      case ArgumentQuantity::velocity:
      case ArgumentQuantity::acceleration:
        return std::max(base, input.index);
      case ArgumentQuantity::gravity:
        return base;
      default:
        return kMixed;
    }
  }
  // The outermost link whose joint the operation depends on; -1: it depends on none.
  int later(int a, int b) const {
    if (a == kMixed || b == kMixed) return kMixed;
    if (a < b) std::swap(a, b);
    return is_behind(a, b) || b < 0 ? a : kMixed;
  }
  int link_of(const Operation& operation) const {
    const auto of = [this](int k) { return k < 0 ? -1 : links_[static_cast<std::size_t>(k)]; };
    if (operation.step == Step::constant) return -1;
    if (operation.is_sine_or_cosine() && operation.a < 0) return link_of({InputKind::q, operation.input.index});
    if (operation.step == Step::input) return link_of(operation.input);
    return later(of(operation.a), of(operation.b));
  }

  void recognise(int k, std::optional<int> joint) {
    const int link = links_[static_cast<std::size_t>(k)];
    if (joint && (link < *joint || !is_behind(link, *joint))) return;
    std::vector<F> y;
    VectorXd real(kSamples);
    for (int s = 0; s < kSamples; ++s) {
      y.push_back(field_[static_cast<std::size_t>(s)].value(k));
      real(s) = real_[static_cast<std::size_t>(s)].value(k);
    }
    const int number = group_of(joint.value_or(-1), link);
    const Group& group = groups_[static_cast<std::size_t>(number)];
    std::optional<Combinations::Found> found = group.combinations.of(y, real);
    if (!found) return;
    const double size =
        (bound(group, found->coefficients.transpose()) + found->error_bound * group.sizes.norm()) * kRoundingMargin;
    known_.emplace(k, Known{number, std::move(*found), size});
  }

  int group_of(int joint, int link) {
    const auto [place, is_new] = number_.emplace(std::pair(joint, link), static_cast<int>(groups_.size()));
    if (!is_new) return place->second;
    const auto entries = [joint, link](const auto& sample) {
      return joint < 0 ? sample.entries_of_motion(link) : sample.entries_of_axis(joint, link);
    };
    std::vector<std::vector<F>> D;
    MatrixXd real(kSamples, joint < 0 ? MotionBasis::kSize : MotionBasis::kSizeOfAxis);
    for (int s = 0; s < kSamples; ++s) {
      D.push_back(entries(field_[static_cast<std::size_t>(s)]));
      const std::vector<double> row = entries(real_[static_cast<std::size_t>(s)]);
      for (Index column = 0; column < real.cols(); ++column) real(s, column) = row[static_cast<std::size_t>(column)];
    }
    Group group{joint, link, Combinations(D, real), VectorXd(real.cols())};
    for (Index k = 0; k < real.cols(); ++k) {
      group.sizes(k) = bound(group, VectorXd::Unit(real.cols(), k).transpose());
    }
    groups_.push_back(std::move(group));
    return place->second;
  }

  double bound(const Group& group, const MatrixXd& rows) const {
    return group.joint < 0 ? bounds_->of_motion(group.link, rows) : bounds_->of_axis(group.joint, group.link, rows);
  }

  const Mechanism& mechanism_;
  InputLimits limits_;
  ExactConstants constants_;
  std::optional<MotionBounds> bounds_;
  std::vector<MotionSample<RealPoint>> real_;
  std::vector<MotionSample<FieldPoint>> field_;
  std::vector<int> links_;  // by operation
  std::vector<Group> groups_;
  std::map<std::pair<int, int>, int> number_;  // by joint and link
  std::map<int, Known> known_;
};

MotionRecogniser::MotionRecogniser(const Mechanism& mechanism, const InputLimits& limits, ExactConstants constants) {
  if (has_only_revolute_joints(mechanism)) {
    implementation_ = std::make_unique<Implementation>(mechanism, limits, std::move(constants));
  }
}
MotionRecogniser::~MotionRecogniser() = default;

void MotionRecogniser::recognise(const StraightLine& lines, std::optional<int> joint) {
  if (implementation_) implementation_->recognise(lines, joint);
}
int MotionRecogniser::group(int operation) const { return implementation_ ? implementation_->group(operation) : -1; }
double MotionRecogniser::largest(int operation) const {
  return implementation_ ? implementation_->largest(operation) : INFINITY;
}
double MotionRecogniser::largest_length(const std::vector<int>& operations, const MatrixXd& rows) const {
  return implementation_->largest_length(operations, rows);
}

}  // namespace flatdyn
