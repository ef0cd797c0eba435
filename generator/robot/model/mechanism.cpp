// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/mechanism.hpp"

#include <algorithm>

#include "robot/model/spherical_joint.hpp"

namespace flatdyn {

int MechanismScene::contact_rows() const {
  int rows = 0;
  for (const Contact& contact : contacts) rows += contact.rows();
  return rows;
}

int MechanismScene::cone_rows() const {
  std::size_t rows = 0;
  for (const Contact& contact : contacts) rows += contact.cone.size();
  return static_cast<int>(rows);
}

std::vector<int> path_to(const BodyTree& tree, int body, int from) {
  std::vector<int> path;
  for (; body != from; body = tree.body(body).parent) path.push_back(body);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<int> Mechanism::bodies_on_one_axis() const {
  std::vector<int> result;
  for (int i = base_bodies(); i < body_count(); ++i) {
    if (!is_of_spherical(i)) result.push_back(i);
  }
  return result;
}

bool BodyTree::has_springs() const {
  return std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return !vanishes(body.stiffness); });
}

bool Mechanism::has_load_friction() const {
  return std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return !vanishes(body.dry.load); });
}

bool Mechanism::has_prismatic_joint() const {
  return std::any_of(bodies.begin() + base_bodies(), bodies.end(), [](const Body& body) { return body.prismatic; });
}

Rows Chart::rate_coupling() const {
  const auto count = static_cast<std::size_t>(base_bodies());
  Rows result;
  for (std::size_t i = 0; i < coupling.size(); ++i) {
    result.emplace_back(count, 0);
    if (i < count) result.back()[i] = 1;
    result.back().insert(result.back().end(), coupling[i].begin(), coupling[i].end());
  }
  return result;
}

std::vector<int> Mechanism::quaternions() const {
  std::vector<int> positions;
  for (const int first : spherical) positions.push_back(quaternion_of(first));
  return positions;
}

int Mechanism::spherical_up_to(int k) const {
  return static_cast<int>(std::upper_bound(spherical.begin(), spherical.end(), k) - spherical.begin());
}

int Mechanism::body_of_position(int position) const {
  int body = position + base_bodies();
  for (const int first : spherical) {
    if (body <= first) break;
    --body;  // w has no body of its own
  }
  return body;
}

Number Mechanism::position_factor(int i, int position) const {
  if (!is_coupled()) return position == position_of(i) ? 1 : 0;
  return coupling[static_cast<std::size_t>(i)][static_cast<std::size_t>(position)];
}

Number Mechanism::rate_factor(int i, int k) const {
  if (!is_coupled() || is_of_base(i) || is_of_base(k)) return i == k ? 1 : 0;
  return coupling[static_cast<std::size_t>(i)][static_cast<std::size_t>(k - base_bodies())];
}

std::vector<std::string> Mechanism::position_names() const {
  std::vector<std::string> names;
  for (int p = 0; p < position_count(); ++p) names.push_back(position_name(p));
  return names;
}

std::vector<std::string> Mechanism::joint_names() const {
  std::vector<std::string> names;
  for (const Body& body : joints()) names.push_back(body.joint);
  return names;
}

std::string Mechanism::position_name(int position) const {
  const std::string& joint = joint_at(position).joint;
  if (!is_of_quaternion(position)) return joint;
  const int first = quaternion_of(body_at(position));
  return spherical_joint_name(joint) + ".q" + "wxyz"[position - first];
}

}  // namespace flatdyn
