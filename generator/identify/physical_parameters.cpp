// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/physical_parameters.hpp"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <memory>

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kLogCholesky = 10;  // numbers that make a 4 × 4 lower triangular matrix with positive diagonal
constexpr int kOthers = kParametersPerJoint - kInertialPerBody;

template <class T>
using Matrix4 = Eigen::Matrix<T, 4, 4>;

// Entries of (7.77) from the pseudo-inertia: Î = tr(Σ) E - Σ.
template <class T>
void inertial_entries(const Matrix4<T>& P, T* ten) {
  const T trace = P(0, 0) + P(1, 1) + P(2, 2);
  ten[0] = P(3, 3);
  for (int k = 0; k < 3; ++k) ten[1 + k] = P(k, 3);
  int at = 4;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) ten[at++] = (i == j ? trace : T(0)) - P(i, j);
  }
}

// Lower triangular, diagonal e^θ: the unit matrix for θ = 0.
template <class T>
Matrix4<T> triangular(const T* theta) {
  using std::exp;
  Matrix4<T> lower = Matrix4<T>::Zero();
  int at = 0;
  for (int i = 0; i < 4; ++i) {
    lower(i, i) = exp(theta[at++]);
    for (int j = 0; j < i; ++j) lower(i, j) = theta[at++];
  }
  return lower;
}

// One link and its joint: θ → thirteen parameters. θ = 0 is where the search starts: the file's values.
struct LinkShape {
  Matrix4d root;           // L of the file's pseudo-inertia
  double others[kOthers];  // I_m, F_v, F_s: positive by e^θ

  template <class T>
  void parameters(const T* theta, T* pi) const {
    const Matrix4<T> lower = root.cast<T>() * triangular(theta);
    inertial_entries<T>(lower * lower.transpose(), pi);
    for (int k = 0; k < kOthers; ++k) {
      using std::exp;
      pi[kInertialPerBody + k] = others[k] * exp(theta[kLogCholesky + k]);
    }
  }
};

// A pseudo-inertia that is positive definite beyond doubt: itself if it is; else no eigenvalue is below a small part of
// the largest one, and what has no mass is a small body.
Matrix4d made_definite(const Matrix4d& P) {
  constexpr double kSmallBody = 1e-4;  // kg, kg m²
  constexpr double kThin = 1e-9, kThick = 1e-4;
  const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(P);
  const double largest = eigen.eigenvalues().maxCoeff();
  if (largest > 0 && eigen.eigenvalues().minCoeff() > kThin * largest) return P;
  const double floor = largest > 0 ? kThick * largest : kSmallBody;
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(floor).asDiagonal() * eigen.eigenvectors().transpose();
}

// The rotor of a joint on the link that carries it adds I_m a aᵀ to the link's inertia.
struct CarriedRotor {
  std::size_t joint, carrier;
  Eigen::Vector3d axis;

  template <class T>
  void add_to(T* pi, double factor = 1) const {
    const T inertia = factor * pi[joint * kParametersPerJoint + static_cast<std::size_t>(Parameter::Im)];
    T* entry = pi + carrier * kParametersPerJoint + static_cast<std::size_t>(Parameter::Ixx);
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) *entry++ += inertia * (axis[i] * axis[j]);
    }
  }
};

std::vector<CarriedRotor> rotors_of(const Mechanism& mechanism) {
  std::vector<CarriedRotor> rotors;
  for (std::size_t j = 0; j < mechanism.bodies.size(); ++j) {
    const std::optional<Rotor>& rotor = mechanism.bodies[j].rotor;
    if (!rotor || rotor->carrier < 0) continue;
    const Eigen::Vector3d axis(nearest_double(rotor->axis[0]), nearest_double(rotor->axis[1]),
                               nearest_double(rotor->axis[2]));
    rotors.push_back({j, static_cast<std::size_t>(rotor->carrier), axis});
  }
  return rotors;
}

// Links as shapes, and the rotors that they carry.
struct Shapes {
  std::vector<LinkShape> links;
  std::vector<CarriedRotor> rotors;

  // theta[i]: of link i.
  template <class T, class Theta>
  std::vector<T> parameters(const Theta& theta) const {
    std::vector<T> pi(links.size() * kParametersPerJoint);
    for (std::size_t i = 0; i < links.size(); ++i) {
      links[i].parameters(&theta[i][0], pi.data() + i * kParametersPerJoint);
    }
    for (const CarriedRotor& rotor : rotors) rotor.add_to(pi.data());
    return pi;
  }
};

std::vector<LinkShape> shapes_of(const std::vector<double>& file, const std::vector<double>& scale) {
  std::vector<LinkShape> shapes;
  for (std::size_t at = 0; at < file.size(); at += kParametersPerJoint) {
    LinkShape shape;
    shape.root = Eigen::LLT<Matrix4d>(made_definite(pseudo_inertia(&file[at]))).matrixL();
    for (int k = 0; k < kOthers; ++k) {
      const std::size_t place = at + static_cast<std::size_t>(kInertialPerBody + k);
      shape.others[k] = file[place] > 0 ? file[place] : scale[place];
    }
    shapes.push_back(shape);
  }
  return shapes;
}

// K π - π_b in standard deviations, over all links.
struct BaseResidual {
  const Shapes& shapes;
  const MatrixXd& K;  // times the root of the information, as the target
  const VectorXd& target;

  template <class T>
  bool operator()(T const* const* theta, T* residual) const {
    const std::vector<T> pi = shapes.parameters<T>(theta);
    for (Index row = 0; row < K.rows(); ++row) {
      T sum = T(-target(row));
      for (Index k = 0; k < K.cols(); ++k) {
        if (K(row, k) != 0) sum += K(row, k) * pi[static_cast<std::size_t>(k)];
      }
      residual[row] = sum;
    }
    return true;
  }
};

// The distance from the file, times a weight that the search lets go to zero.
struct PriorResidual {
  const double& weight;

  template <class T>
  bool operator()(const T* theta, T* residual) const {
    const Matrix4<T> lower = triangular(theta);
    const Matrix4<T> difference = lower * lower.transpose() - Matrix4<T>::Identity();
    int at = 0;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j <= i; ++j) residual[at++] = weight * (i == j ? 1.0 : std::sqrt(2.0)) * difference(i, j);
    }
    for (int k = 0; k < kOthers; ++k) residual[at++] = weight * theta[kLogCholesky + k];
    return true;
  }
};

MatrixXd combination_matrix(const BaseParameters& base, Index columns) {
  MatrixXd K = MatrixXd::Zero(base.size(), columns);
  for (Index row = 0; row < K.rows(); ++row) {
    for (const auto& [index, coefficient] : base.combination[static_cast<std::size_t>(row)]) {
      K(row, index) = nearest_double(coefficient);
    }
  }
  return K;
}

class BodySearch {
 public:
  BodySearch(Shapes shapes, const MatrixXd& K, const VectorXd& target)
      : shapes_(std::move(shapes)), K_(K), target_(target), theta_(shapes_.links.size()) {
    constexpr int kParameters = kLogCholesky + kOthers, kStride = 13;
    using Dynamic = ceres::DynamicAutoDiffCostFunction<BaseResidual, kStride>;
    auto agreement = std::make_unique<Dynamic>(new BaseResidual{shapes_, K_, target_});
    std::vector<double*> blocks;
    for (auto& theta : theta_) {
      theta.fill(0);
      blocks.push_back(theta.data());
      agreement->AddParameterBlock(kParameters);
      problem_.AddResidualBlock(
          new ceres::AutoDiffCostFunction<PriorResidual, kParameters, kParameters>(new PriorResidual{weight_}), nullptr,
          theta.data());
    }
    agreement->SetNumResiduals(static_cast<int>(K_.rows()));
    if (K_.rows() > 0) problem_.AddResidualBlock(agreement.release(), nullptr, blocks);
    for (double* const theta : blocks) bound(theta);
  }

  // From a heavy prior to a light one: the last steps move only what π_b does not decide.
  bool run() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 1000;
    options.function_tolerance = 1e-10;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    for (const double weight : {1.0, 1e-1, 1e-2, 1e-3}) {
      weight_ = weight;
      ceres::Solve(options, &problem_, &summary);
    }
    return summary.termination_type == ceres::CONVERGENCE;
  }

  std::vector<double> parameters() const { return shapes_.parameters<double>(theta_); }

  // Where π_b is that of no body, the search would run off to where e^θ overflows.
  void bound(double* theta) {
    constexpr double kFarthest = 10;
    for (int k = 0; k < kLogCholesky + kOthers; ++k) {
      problem_.SetParameterLowerBound(theta, k, -kFarthest);
      problem_.SetParameterUpperBound(theta, k, kFarthest);
    }
  }

  double distance() const {
    double sum = 0;
    for (const auto& theta : theta_) {
      const Matrix4d lower = triangular(theta.data());
      sum += (lower * lower.transpose() - Matrix4d::Identity()).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(theta_.size()));
  }

 private:
  Shapes shapes_;
  const MatrixXd& K_;
  const VectorXd& target_;
  double weight_ = 1;
  std::vector<std::array<double, kLogCholesky + kOthers>> theta_;
  ceres::Problem problem_;
};

// Where a parameter that the file does not have begins: the size that π_b gives it, if it is a base parameter itself.
std::vector<double> scales(const BaseParameters& base, const VectorXd& pi_b, std::size_t count) {
  constexpr double kTiny = 1e-9;
  std::vector<double> result(count, kTiny);
  for (int k = 0; k < base.size(); ++k) {
    result[static_cast<std::size_t>(base.columns[static_cast<std::size_t>(k)])] = std::max(std::abs(pi_b(k)), kTiny);
  }
  return result;
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

// Combinations that are known to more digits than this count as known to this many: the search need not run along a
// knife's edge.
MatrixXd blunted(const MatrixXd& root_information, const VectorXd& values) {
  constexpr double kSharpest = 1e6;  // standard deviations in the size of a combination's terms
  const double largest = values.cwiseAbs().maxCoeff();
  const VectorXd size = root_information.cwiseAbs() * values.cwiseAbs().cwiseMax(largest / kSharpest);
  return (kSharpest / size.array()).min(1).matrix().asDiagonal() * root_information;
}

// Of K π = target, with the shapes to start from.
PhysicalParameters nearest(Shapes shapes, const MatrixXd& K, const VectorXd& target, const MatrixXd& root_information) {
  const MatrixXd root = blunted(root_information, target);
  const MatrixXd whitened = root * K;
  const VectorXd whitened_target = root * target;
  BodySearch search(std::move(shapes), whitened, whitened_target);
  PhysicalParameters result;
  result.converged = search.run();
  result.pi = search.parameters();
  const Eigen::Map<const VectorXd> pi(result.pi.data(), static_cast<Index>(result.pi.size()));
  if (root.rows() > 0) result.largest_misfit = (whitened * pi - whitened_target).cwiseAbs().maxCoeff();
  result.distance = search.distance();
  return result;
}

}  // namespace

PhysicalParameters physical_parameters(const Mechanism& mechanism, const BaseParameters& base,
                                       const Estimate& estimate) {
  std::vector<double> file;
  for (const Number& value : dynamic_parameters(mechanism)) file.push_back(nearest_double(value));
  const std::vector<CarriedRotor> rotors = rotors_of(mechanism);
  const MatrixXd K = combination_matrix(base, static_cast<Index>(file.size()));
  std::vector<double> bodies = file;
  for (const CarriedRotor& rotor : rotors) rotor.add_to(bodies.data(), -1);
  return nearest({shapes_of(bodies, scales(base, estimate.values, file.size())), rotors}, K, estimate.values,
                 estimate.root_information);
}

NearestBody nearest_body(const VectorXd& estimate, const MatrixXd& root_information) {
  std::vector<double> start(kParametersPerJoint, 0);
  std::copy(estimate.begin(), estimate.end(), start.begin());
  const MatrixXd K = MatrixXd::Identity(kInertialPerBody, kParametersPerJoint);
  const PhysicalParameters found =
      nearest({shapes_of(start, std::vector<double>(kParametersPerJoint, 1)), {}}, K, estimate, root_information);
  return {Eigen::Map<const VectorXd>(found.pi.data(), kInertialPerBody), found.largest_misfit};
}

}  // namespace flatdyn
