// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/physical_parameters.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "laboratory/identify/body_search.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The sizes given to a link without mass or extent, relative to the largest of the robot.
struct Sizes {
  double mass = 0, inertia = 0;
};

Sizes sizes_of(const std::vector<double>& file) {
  Sizes largest;
  for (std::size_t at = 0; at < file.size(); at += kParametersPerJoint) {
    const Matrix4d P = pseudo_inertia(&file[at]);
    largest.mass = std::max(largest.mass, P(3, 3));
    largest.inertia = std::max(largest.inertia, P.topLeftCorner<3, 3>().trace());
  }
  if (largest.mass <= 0) largest.mass = 1;                   // kg
  if (largest.inertia <= 0) largest.inertia = largest.mass;  // kg m²
  return largest;
}

// A pseudo-inertia that is safely positive definite: P if it is. Otherwise the body is made at least a fraction of its
// length thick about its centre of mass, and a body without mass becomes a small one.
Matrix4d made_definite(const Matrix4d& P, const Sizes& largest) {
  constexpr double kSmall = 1e-4, kThin = 1e-9, kThick = 1e-4;
  const bool has_mass = P(3, 3) > 0;
  const double mass = has_mass ? P(3, 3) : kSmall * largest.mass;
  const Eigen::Vector3d moment = has_mass ? Eigen::Vector3d(P.block<3, 1>(0, 3)) : Eigen::Vector3d::Zero();
  const Eigen::Matrix3d about_com = P.topLeftCorner<3, 3>() - moment * moment.transpose() / mass;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(about_com);
  const double length = eigen.eigenvalues().maxCoeff();
  if (has_mass && length > 0 && eigen.eigenvalues().minCoeff() > kThin * length) return P;
  const double floor = length > 0 ? kThick * length : kSmall * largest.inertia * std::min(mass / largest.mass, 1.0);
  Matrix4d result;
  result.topLeftCorner<3, 3>() =
      eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(floor).asDiagonal() * eigen.eigenvectors().transpose() +
      moment * moment.transpose() / mass;
  result.block<3, 1>(0, 3) = moment;
  result.block<1, 3>(3, 0) = moment.transpose();
  result(3, 3) = mass;
  return result;
}

// A rotor that a link carries: it adds I_m a aᵀ to the link's inertia.
struct CarriedRotor {
  std::size_t joint, carrier;
  Eigen::Vector3d axis;

  void add_to(double* pi, double factor = 1) const {
    const double inertia = factor * pi[joint * kParametersPerJoint + static_cast<std::size_t>(Parameter::Im)];
    double* entry = pi + carrier * kParametersPerJoint + static_cast<std::size_t>(Parameter::Ixx);
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) *entry++ += inertia * (axis[i] * axis[j]);
    }
  }
};

// Joints and carriers count from body `first`.
std::vector<CarriedRotor> rotors_of(const Mechanism& mechanism, std::size_t first) {
  std::vector<CarriedRotor> rotors;
  for (std::size_t j = first; j < mechanism.bodies.size(); ++j) {
    const std::optional<Rotor>& rotor = mechanism.bodies[j].rotor;
    if (!rotor || rotor->carrier < 0) continue;
    const Eigen::Vector3d axis(nearest_double(rotor->axis[0]), nearest_double(rotor->axis[1]),
                               nearest_double(rotor->axis[2]));
    rotors.push_back({j - first, static_cast<std::size_t>(rotor->carrier) - first, axis});
  }
  return rotors;
}

// K' with K' bodies = K π, where bodies are the links without the rotors that they carry.
MatrixXd of_bodies(const MatrixXd& K, const std::vector<CarriedRotor>& rotors) {
  MatrixXd adding = MatrixXd::Identity(K.cols(), K.cols());
  for (const CarriedRotor& rotor : rotors) {
    rotor.add_to(
        adding.col(static_cast<Index>(rotor.joint) * kParametersPerJoint + static_cast<Index>(Parameter::Im)).data());
  }
  return K * adding;
}

std::vector<LinkShape> shapes_of(const std::vector<double>& file, const VectorXd& starts) {
  std::vector<LinkShape> shapes;
  const Sizes largest = sizes_of(file);
  for (std::size_t at = 0; at < file.size(); at += kParametersPerJoint) {
    LinkShape shape;
    shape.L = Eigen::LLT<Matrix4d>(made_definite(pseudo_inertia(&file[at]), largest)).matrixL();
    for (int k = 0; k < LinkShape::kOthers; ++k) {
      const std::size_t place = at + static_cast<std::size_t>(kInertialPerBody + k);
      shape.in_file[k] = file[place] > 0;
      shape.others[k] = shape.in_file[k] ? file[place] : starts(static_cast<Index>(place));
    }
    shapes.push_back(shape);
  }
  return shapes;
}

MatrixXd combination_matrix(const BaseParameters& base, Index columns) {
  MatrixXd K = MatrixXd::Zero(base.size(), columns);
  for (Index row = 0; row < K.rows(); ++row) {
    for (const auto& [index, coefficient] : base.combination[static_cast<std::size_t>(row)]) {
      K(row, index) = nearest_double(coefficient);
    }
  }
  return K;
}

}  // namespace

Matrix4d pseudo_inertia(const double* ten) {
  Matrix4d P;
  P.topLeftCorner<3, 3>() << ten[4], ten[5], ten[6], ten[5], ten[7], ten[8], ten[6], ten[8], ten[9];
  const double trace = P.topLeftCorner<3, 3>().trace();
  P.topLeftCorner<3, 3>() = trace / 2 * Eigen::Matrix3d::Identity() - P.topLeftCorner<3, 3>().eval();
  P.block<3, 1>(0, 3) = Eigen::Map<const Eigen::Vector3d>(ten + 1);
  P.block<1, 3>(3, 0) = P.block<3, 1>(0, 3).transpose();
  P(3, 3) = ten[0];
  return P;
}

namespace {

// The root information with rows scaled down such that no combination is known more sharply than kSharpest: the search
// then need not follow a narrow valley.
MatrixXd blunted(const MatrixXd& root_information, const VectorXd& values) {
  constexpr double kSharpest = 1e6;  // standard deviations per size of a combination's terms
  const double largest = values.cwiseAbs().maxCoeff();
  const VectorXd size = root_information.cwiseAbs() * values.cwiseAbs().cwiseMax(largest / kSharpest);
  return (kSharpest / size.array()).min(1).matrix().asDiagonal() * root_information;
}

// The values from which the search starts with I_m, F_v and F_s that the file lacks, for every place in π: what π_b has
// beyond the file's links in the base parameter that the missing one is a term of, at least a small share of that base
// parameter, and no less than the motion shows. A value that the motion does not determine stays as good as zero.
VectorXd starts_of_missing(const MatrixXd& K, const VectorXd& file, const Estimate& estimate) {
  constexpr double kTiny = 1e-9, kShare = 0.01;
  const VectorXd& pi_b = estimate.values;
  const VectorXd excess = pi_b - K * file;
  const double largest = pi_b.cwiseAbs().maxCoeff();
  const VectorXd information = blunted(estimate.root_information, pi_b).colwise().norm();
  VectorXd starts = VectorXd::Constant(K.cols(), kTiny);
  for (Index row = 0; row < K.rows(); ++row) {
    const bool is_told = information(row) * largest > 1;
    const double least = is_told ? std::max(kShare * std::abs(pi_b(row)), 1 / information(row)) : 0;
    for (Index column = 0; column < K.cols(); ++column) {
      const double coefficient = K(row, column);
      if (coefficient == 0) continue;
      starts(column) = std::max({starts(column), excess(row) / coefficient, least / std::abs(coefficient)});
    }
  }
  return starts;
}

// The parameters nearest to the file that satisfy K π = target, from the links to start with and the rotors they carry.
PhysicalParameters nearest(std::vector<LinkShape> links, const std::vector<CarriedRotor>& rotors, const MatrixXd& K,
                           const VectorXd& target, const MatrixXd& root_information) {
  const MatrixXd root = blunted(root_information, target);
  const MatrixXd whitened = root * K;
  const VectorXd whitened_target = root * target;
  BodySearch search(std::move(links), of_bodies(whitened, rotors), whitened_target);
  PhysicalParameters result;
  result.converged = search.run();
  const VectorXd bodies = search.bodies();
  result.pi.assign(bodies.begin(), bodies.end());
  for (const CarriedRotor& rotor : rotors) rotor.add_to(result.pi.data());
  const Eigen::Map<const VectorXd> pi(result.pi.data(), static_cast<Index>(result.pi.size()));
  result.pi_b = K * pi;
  if (root.rows() > 0) result.largest_misfit = (whitened * pi - whitened_target).cwiseAbs().maxCoeff();
  result.divergence = search.divergence_from_file();
  return result;
}

}  // namespace

// The bodies before a floating base's link are its motion, and have no parameters.
PhysicalParameters physical_parameters(const Mechanism& mechanism, const BaseParameters& base,
                                       const Estimate& estimate) {
  const auto first = static_cast<std::size_t>(std::max(0, mechanism.base_bodies() - 1));
  const auto without = static_cast<std::ptrdiff_t>(first * kParametersPerJoint);
  std::vector<double> file;
  for (const Number& value : dynamic_parameters(mechanism)) file.push_back(nearest_double(value));
  const MatrixXd K =
      combination_matrix(base, static_cast<Index>(file.size())).rightCols(static_cast<Index>(file.size()) - without);
  file.erase(file.begin(), file.begin() + without);
  const std::vector<CarriedRotor> rotors = rotors_of(mechanism, first);
  std::vector<double> bodies = file;
  for (const CarriedRotor& rotor : rotors) rotor.add_to(bodies.data(), -1);
  const VectorXd starts = starts_of_missing(K, Eigen::Map<const VectorXd>(file.data(), K.cols()), estimate);
  PhysicalParameters found = nearest(shapes_of(bodies, starts), rotors, K, estimate.values, estimate.root_information);
  found.pi.insert(found.pi.begin(), static_cast<std::size_t>(without), 0);
  // The search gives bodies without links small masses, which no equation has.
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    if (!has_no_link(mechanism.bodies[i])) continue;
    const auto its = found.pi.begin() + static_cast<std::ptrdiff_t>(i * kParametersPerJoint);
    std::fill(its, its + kInertialPerBody, 0);
  }
  return found;
}

NearestBody nearest_body(const VectorXd& estimate, const MatrixXd& root_information) {
  std::vector<double> start(kParametersPerJoint, 0);
  std::copy(estimate.begin(), estimate.end(), start.begin());
  const MatrixXd K = MatrixXd::Identity(kInertialPerBody, kParametersPerJoint);
  const PhysicalParameters found =
      nearest(shapes_of(start, VectorXd::Ones(kParametersPerJoint)), {}, K, estimate, root_information);
  return {Eigen::Map<const VectorXd>(found.pi.data(), kInertialPerBody), found.largest_misfit};
}

}  // namespace flatdyn
