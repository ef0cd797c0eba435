// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "code/emit/writer.hpp"
#include "derivation/notation/coupled_text.hpp"
#include "derivation/notation/number_text.hpp"
#include "robot/model/loop_closure.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

std::string merged_text(const Mechanism& mechanism) {
  return fmt::format(" Links without a joint of their own, part of those that carry them: {}.",
                     fmt::join(mechanism.merged, ", "));
}

std::string coupled_text(const std::vector<std::string>& joints) {
  return fmt::format(" Coupled joints, rad or m: {}; q, qd, qdd and tau are those of the joints above.",
                     fmt::join(joints, ", "));
}

std::string loop_text(const Mechanism& mechanism) {
  constexpr const char* kAxes =
      " Where axes meet, a_lk is the one end's, e_lk are two directions across the other's, n_lk the moments of the "
      "one "
      "about the others, and M_lk minors of the determinant.";
  std::vector<std::string> dependent;
  for (const LoopClosure& loop : mechanism.loops) {
    for (const std::string& joint : dependent_joint_names(mechanism, loop)) dependent.push_back(joint);
  }
  const bool floats = mechanism.floating_base;
  return fmt::format(
      " Closed loops make {} follow from the other joints: q has the positions of all of them, {} those of the others. "
      "Functions hold where q closes the loops. Names with lk belong to loop k: R_lk, p_lk "
      "and r_lk to the way from its carrier to its two ends, Phi_lk to its closure's derivative by q, inv_lk is the "
      "reciprocal of the determinant that its joints are found with, and regular_lk is positive unless the loop is "
      "singular.{} A_i_j is how joint i moves with the joint of {}, drift how it accelerates if that one does not.",
      fmt::join(dependent, ", "), floats ? "v, a and tau, after the base's entries, are" : "qd, qdd and tau are",
      aligns_axes(mechanism) ? kAxes : "", floats ? "v[j + 5]" : "qd[j - 1]");
}

std::string gravity_text(const Mechanism& mechanism) {
  return fmt::format("Gravity is {} m/s^2 in the base frame.", NumberText(mechanism, 17)(mechanism.gravity));
}

}  // namespace

std::string floating_base_text(const Mechanism& mechanism) {
  const std::string text = fmt::format(
      "The base floats. The first entries of v are the velocity of the origin of link \"{}\" (v[0] to v[2], m/s) and "
      "the link's angular velocity (v[3] to v[5], rad/s), both in the link's axes; the joints' rates follow. a has the "
      "derivatives of these numbers: the acceleration of the origin is (a[0], a[1], a[2]) + omega x v. tau begins with "
      "the force on the link (N) and its moment about the link's origin (N m), in the link's axes.",
      mechanism.base_link().link);
  if (!mechanism.has_base_gravity()) return text + " There is no gravity.";
  return text + " g_b is gravity in the link's axes, m/s^2: R^T g_0 with R from these axes to the world's.";
}

std::string spherical_joints_text(const Mechanism& mechanism) {
  std::string text;
  for (const int first : mechanism.spherical) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(first)];
    const int q = mechanism.quaternion_of(first);
    text += fmt::format("{} {} has q[{}] to q[{}] and v[{}] to v[{}]", text.empty() ? "Spherical joints:" : ";",
                        spherical_joint_name(body.joint), q, q + 3, first, first + 2);
  }
  return text +
         ". For each of them, q has a unit quaternion (w, x, y, z), which turns the child's axes into the parent's, "
         "both those of the joint. v has the angular velocity of the child relative to the parent in the child's axes, "
         "rad/s, a the derivatives of these numbers, and tau the moment on the child in its axes, N m. Quaternions are "
         "used as they are: if |q|^2 is 1 + e, rotations are wrong by up to 2 |e|, as the norm of a matrix.";
}

std::string facts_of(const Mechanism& mechanism, const std::string& scene) {
  std::string text = mechanism.floating_base ? floating_base_text(mechanism) : gravity_text(mechanism);
  if (!mechanism.tip.link.empty()) text += fmt::format(" The tip belongs to link \"{}\".", mechanism.tip.link);
  if (!mechanism.merged.empty()) text += merged_text(mechanism);
  const auto by_index = [](int k) { return fmt::format("q[{}]", k); };
  const std::vector<std::string> coupled = coupled_joint_texts(mechanism, by_index);
  if (!coupled.empty()) text += coupled_text(coupled);
  const std::vector<std::string> tendons = tendon_texts(mechanism, by_index);
  if (!tendons.empty())
    text += fmt::format(" Tendons act on the joints that they run over: {}.", fmt::join(tendons, ", "));
  if (mechanism.has_spherical_joints()) text += " " + spherical_joints_text(mechanism);
  if (mechanism.has_loops()) text += loop_text(mechanism);
  if (!scene.empty()) text += " " + scene;
  return comment_text(text);
}

}  // namespace flatdyn
