// SPDX-License-Identifier: GPL-2.0-or-later
// The reference's robot as one of MuJoCo. Its file has only the tree; the numbers are put into the model afterwards,
// since MuJoCo's principal axes of inertia are accurate to only nine digits, and since it refuses links that are not
// physically consistent. A floating base is at the origin, with the world's axes: there MuJoCo's velocity of a free
// body (of its origin in the world's axes, then angular in its own) is flatdyn's twist, and its linear acceleration has
// omega x v beside the derivative of the twist's components.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Eigenvalues>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/system/temporary_folder.hpp"
#include "support/joint_dynamics_peer.hpp"

namespace flatdyn::testing {

class MujocoTree : public JointDynamicsPeer {
 public:
  explicit MujocoTree(const reference::Robot<double>& robot) : robot_(robot), model_(loaded(), mj_deleteModel) {
    for (int axis = 0; axis < 3; ++axis) model_->opt.gravity[axis] = robot.gravity[axis];
    if (robot_.floating_base) place_body(1, robot_.root, {});
    for (const Joint& joint : robot_.joints) place(joint);
    count_entries();
    // These flags would make MuJoCo skip terms that are zero for the file's numbers.
    std::fill_n(model_->body_simple, model_->nbody, mjtByte(0));
    std::fill_n(model_->body_sameframe, model_->nbody, mjtByte(0));
    std::fill_n(model_->dof_simplenum, model_->nv, 0);
    for (int body = model_->nbody - 1; body > 0; --body) {
      model_->body_subtreemass[body] += model_->body_mass[body];
      model_->body_subtreemass[model_->body_parentid[body]] += model_->body_subtreemass[body];
    }
    data_.reset(mj_makeData(model_.get()));
  }

  Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) override {
    set_positions(q);
    set(data_->qvel, qd);
    set(data_->qacc, with_turning_base(qd, qdd, 1));
    mj_inverse(model_.get(), data_.get());
    return by_joint(data_->qfrc_inverse);
  }

  Matrix inertia_matrix(const Vector& q) override {
    const int n = model_->nv;
    set_positions(q);
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_crb(model_.get(), data_.get());
    std::vector<double> full(static_cast<std::size_t>(n * n));
    mj_fullM(model_.get(), full.data(), data_->qM);
    Matrix B(n, n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) B(i, j) = full[static_cast<std::size_t>(address(i) * n + address(j))];
    }
    return B;
  }

  Vector gravity(const Vector& q) override {
    const Vector still = Vector::Zero(model_->nv);
    return inverse_dynamics(q, still, still);
  }

  Vector forward_dynamics(const Vector& q, const Vector& qd, const Vector& tau) override {
    set_positions(q);
    set(data_->qvel, qd);
    set(data_->qfrc_applied, tau);
    mj_forward(model_.get(), data_.get());
    set(data_->qfrc_applied, Vector::Zero(model_->nv));
    return with_turning_base(qd, by_joint(data_->qacc), -1);
  }

 private:
  using Joint = reference::Joint<double>;
  using Inertial = reference::Inertial<double>;
  struct Frame {
    reference::Matrix3<double> R = reference::Matrix3<double>::Identity();
    reference::Vector3<double> p = reference::Vector3<double>::Zero();
  };

  static std::string name_of(int link) { return "link" + std::to_string(link); }

  // The addresses in MuJoCo's q and velocities, which count depth first, of the entries of q and q̇.
  void count_entries() {
    for (int k = 0; k < robot_.base_size(); ++k) velocity_of_.push_back(k);
    for (const Joint& joint : robot_.joints) {
      if (joint.index < 0) continue;
      const int found = mj_name2id(model_.get(), mjOBJ_JOINT, name_of_joint(joint).c_str());
      const bool is_ball = joint.type == reference::JointType::spherical;
      for (int k = 0; k < joint.size(); ++k) velocity_of_.push_back(model_->jnt_dofadr[found] + k);
      for (int k = 0; k < (is_ball ? 4 : 1); ++k) position_of_.push_back(model_->jnt_qposadr[found] + k);
    }
  }

  static std::string name_of_joint(const Joint& joint) { return "joint" + std::to_string(joint.index); }

  int address(int velocity) const { return velocity_of_.at(static_cast<std::size_t>(velocity)); }

  // The base stays where the file puts it.
  void set_positions(const Vector& q) const {
    for (std::size_t k = 0; k < position_of_.size(); ++k) data_->qpos[position_of_[k]] = q[static_cast<int>(k)];
  }
  void set(double* to, const Vector& v) const {
    for (std::size_t k = 0; k < velocity_of_.size(); ++k) to[velocity_of_[k]] = v[static_cast<int>(k)];
  }
  Vector by_joint(const double* from) const {
    Vector v(model_->nv);
    for (std::size_t k = 0; k < velocity_of_.size(); ++k) v[static_cast<int>(k)] = from[velocity_of_[k]];
    return v;
  }

  // Accelerations, with sign · omega x v added to the linear ones of a floating base.
  Vector with_turning_base(const Vector& v, Vector a, double sign) const {
    if (!robot_.floating_base) return a;
    const reference::Vector3<double> linear = v.head<3>(), angular = v.segment<3>(3);
    a.head<3>() += sign * angular.cross(linear);
    return a;
  }

  std::string body(const Joint& joint) {
    std::string text = "<body name='" + name_of(joint.child) + "'><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>";
    if (joint.index >= 0) {
      text += "<joint name='" + name_of_joint(joint) + "' type='" + type_of(joint) + "'/>";
    }
    return text + carried_by(joint.child) + "</body>";
  }

  static const char* type_of(const Joint& joint) {
    if (joint.type == reference::JointType::spherical) return "ball";
    return joint.type == reference::JointType::prismatic ? "slide" : "hinge";
  }

  // The root with a free joint if the base floats, else what is on it.
  std::string tree() {
    if (!robot_.floating_base) return carried_by(robot_.root);
    return "<body><freejoint/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>" + carried_by(robot_.root) +
           "</body>";
  }

  std::string carried_by(int link) {
    std::string text;
    for (const Joint& joint : robot_.joints) {
      if (joint.parent == link) text += body(joint);
    }
    return text;
  }

  mjModel* loaded() {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "tree.xml").string();
    std::ofstream(path) << "<mujoco><option><flag constraint='disable' contact='disable'/></option><worldbody>"
                        << tree() << "</worldbody></mujoco>";
    char error[1000] = "";
    mjModel* model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
    if (model == nullptr) throw std::runtime_error(error);
    return model;
  }

  // The frame of a link in MuJoCo's body, which is the joint's frame.
  Frame frame_of(int link) const {
    for (const Joint& joint : robot_.joints) {
      if (joint.child == link) return {joint.R_1, joint.p_1};
    }
    return {};
  }

  static void put(double* to, const reference::Vector3<double>& v) { std::copy(v.begin(), v.end(), to); }
  static void put(double* to, const reference::Matrix3<double>& R) {
    const Eigen::Quaterniond turn(R);
    const double quaternion[] = {turn.w(), turn.x(), turn.y(), turn.z()};
    std::copy(std::begin(quaternion), std::end(quaternion), to);
  }

  void place(const Joint& joint) {
    const int body = mj_name2id(model_.get(), mjOBJ_BODY, name_of(joint.child).c_str());
    const Frame parent = frame_of(joint.parent);
    put(model_->body_pos + 3 * body, reference::Vector3<double>(parent.p + parent.R * joint.p_0));
    put(model_->body_quat + 4 * body, reference::Matrix3<double>(parent.R * joint.R_0));
    if (joint.size() == 1) put(model_->jnt_axis + 3 * model_->body_jntadr[body], joint.axis);
    place_body(body, joint.child, {joint.R_1, joint.p_1});
  }

  // `link`: its frame in MuJoCo's body.
  void place_body(int body, int number, const Frame& link) {
    const Inertial whole = together(robot_.links[static_cast<std::size_t>(number)].inertials);
    const reference::Matrix3<double> central = link.R * whole.inertia * link.R.transpose();
    const Eigen::SelfAdjointEigenSolver<reference::Matrix3<double>> principal(central);
    reference::Matrix3<double> axes = principal.eigenvectors();
    if (axes.determinant() < 0) axes = -axes;
    model_->body_mass[body] = whole.mass;
    model_->body_subtreemass[body] = 0;
    put(model_->body_ipos + 3 * body, reference::Vector3<double>(link.p + link.R * whole.r_C));
    put(model_->body_iquat + 4 * body, axes);
    put(model_->body_inertia + 3 * body, reference::Vector3<double>(principal.eigenvalues()));
  }

  static Inertial together(const std::vector<Inertial>& parts) {
    Inertial whole;
    for (const Inertial& part : parts) {
      whole.mass += part.mass;
      whole.r_C += part.mass * part.r_C;
    }
    if (whole.mass > 0) whole.r_C /= whole.mass;
    for (const Inertial& part : parts) {
      const reference::Vector3<double> d = part.r_C - whole.r_C;
      const reference::Matrix3<double> square = d.squaredNorm() * reference::Matrix3<double>::Identity();
      whole.inertia += part.inertia + part.mass * (square - d * d.transpose());
    }
    return whole;
  }

  const reference::Robot<double>& robot_;
  std::unique_ptr<mjModel, void (*)(mjModel*)> model_;
  std::vector<int> position_of_, velocity_of_;  // addresses, by entries of q and q̇
  struct Delete {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjData, Delete> data_;
};

}  // namespace flatdyn::testing
