// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/limbs.hpp"

#include <map>
#include <string>

namespace flatdyn {
namespace {

class Tree {
 public:
  explicit Tree(const Mechanism& mechanism) : mechanism_(mechanism) {}

  // Adds the sets of limbs that hang on a body, or on the base (-1), or further out.
  void add_sets(int body, std::vector<Limbs>& sets) const {
    std::map<std::string, std::vector<int>> by_shape;
    for (const int child : children(body)) by_shape[shape(child)].push_back(child);
    for (const int child : children(body)) {
      const std::vector<int>& alike = by_shape.at(shape(child));
      if (alike.size() == 1 || alike.size() > kMostLimbs) {
        add_sets(child, sets);
      } else if (alike.front() == child) {
        sets.push_back(set_of(alike));
      }
    }
  }

 private:
  static constexpr std::size_t kMostLimbs = 8;  // lanes of the widest vectors of doubles

  std::vector<int> children(int body) const {
    std::vector<int> found;
    for (int k = 0; k < mechanism_.body_count(); ++k) {
      if (mechanism_.bodies[static_cast<std::size_t>(k)].parent == body) found.push_back(k);
    }
    return found;
  }

  std::string shape(int body) const {
    std::string text = mechanism_.bodies[static_cast<std::size_t>(body)].prismatic ? "(p" : "(r";
    for (const int child : children(body)) text += shape(child);
    return text + ")";
  }

  void add_joints(int body, std::vector<int>& joints) const {
    joints.push_back(body - mechanism_.base_bodies());
    for (const int child : children(body)) add_joints(child, joints);
  }

  Limbs set_of(const std::vector<int>& roots) const {
    Limbs set{{}, mechanism_.base_bodies()};
    for (const int root : roots) add_joints(root, set.joints.emplace_back());
    return set;
  }

  const Mechanism& mechanism_;
};

}  // namespace

int Limbs::lanes() const {
  int lanes = 1;
  while (lanes < count()) lanes *= 2;
  return lanes;
}

std::vector<Limbs> limbs_of(const Mechanism& mechanism) {
  std::vector<Limbs> sets;
  if (mechanism.is_joint_by_joint()) Tree(mechanism).add_sets(mechanism.base_bodies() - 1, sets);
  return sets;
}

}  // namespace flatdyn
