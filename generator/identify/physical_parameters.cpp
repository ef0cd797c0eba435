// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/physical_parameters.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <numbers>

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kOthers = kParametersPerJoint - kInertialPerBody;
using LinkVector = Eigen::Matrix<double, kParametersPerJoint, 1>;
using LinkMatrix = Eigen::Matrix<double, kParametersPerJoint, kParametersPerJoint>;

// Entries of (7.77) from the pseudo-inertia: Î = tr(Σ) E - Σ.
void inertial_entries(const Matrix4d& P, double* ten) {
  const double trace = P.topLeftCorner<3, 3>().trace();
  ten[0] = P(3, 3);
  for (int k = 0; k < 3; ++k) ten[1 + k] = P(k, 3);
  int at = 4;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) ten[at++] = (i == j ? trace : 0) - P(i, j);
  }
}

// Symmetric matrices as ten coordinates, of the same length.
constexpr double kSquareRootOf2 = std::numbers::sqrt2;

Matrix4d symmetric(const double* ten) {
  Matrix4d X;
  for (int i = 0, at = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j, ++at) X(i, j) = X(j, i) = i == j ? ten[at] : ten[at] / kSquareRootOf2;
  }
  return X;
}

void coordinates(const Matrix4d& X, double* ten) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j) *ten++ = i == j ? X(i, j) : X(i, j) * kSquareRootOf2;
  }
}

// One link and its joint: pseudo-inertia L S Sᵀ Lᵀ, with L Lᵀ that of the file, and I_m, F_v, F_s as multiples of the
// file's. The search starts at S = E and multiples of 1, and keeps S triangular with a positive diagonal.
struct LinkShape {
  Matrix4d L, S = Matrix4d::Identity();
  double others[kOthers] = {}, multiples[kOthers] = {1, 1, 1};

  void parameters(double* pi) const {
    const Matrix4d root = L * S;
    inertial_entries(root * root.transpose(), pi);
    for (int k = 0; k < kOthers; ++k) pi[kInertialPerBody + k] = others[k] * multiples[k];
  }

  // Columns: what each of thirteen coordinates y adds to the parameters; P changes by L S X Sᵀ Lᵀ, the others by parts
  // of themselves.
  LinkMatrix changes() const {
    LinkMatrix columns = LinkMatrix::Zero();
    const Matrix4d root = L * S;
    double unit[kInertialPerBody] = {};
    for (int k = 0; k < kInertialPerBody; ++k) {
      unit[k] = 1;
      inertial_entries(root * symmetric(unit) * root.transpose(), columns.col(k).data());
      unit[k] = 0;
    }
    for (int k = 0; k < kOthers; ++k) columns(kInertialPerBody + k, kInertialPerBody + k) = others[k] * multiples[k];
    return columns;
  }

  // The log-determinant divergence from the file: convex, 0 at the file, infinite where P is no body's.
  double divergence() const {
    double sum = S.squaredNorm() - 4 - 2 * S.diagonal().array().log().sum();
    for (const double multiple : multiples) sum += multiple - 1 - std::log(multiple);
    return sum;
  }

  // Its gradient in y; its second derivative is the unit matrix.
  LinkVector gradient() const {
    LinkVector result;
    coordinates(S.transpose() * S - Matrix4d::Identity(), result.data());
    for (int k = 0; k < kOthers; ++k) result(kInertialPerBody + k) = multiples[k] - 1;
    return result;
  }

  // The largest part of a step y that leaves P and the others positive, well within.
  double longest_step(const double* y) const {
    constexpr double kWithin = 0.9;
    const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(symmetric(y), Eigen::EigenvaluesOnly);
    double least = eigen.eigenvalues().minCoeff();
    for (int k = 0; k < kOthers; ++k) least = std::min(least, y[kInertialPerBody + k]);
    return least < -kWithin ? -kWithin / least : 1;
  }

  void move(const double* y, double part) {
    const Matrix4d X = Matrix4d::Identity() + part * symmetric(y);
    S = S * Eigen::LLT<Matrix4d>(X).matrixL();
    for (int k = 0; k < kOthers; ++k) multiples[k] *= 1 + part * y[kInertialPerBody + k];
  }
};

// What a link without mass or extent is taken for, relative to the largest of the robot.
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

// A pseudo-inertia that is positive definite beyond doubt: itself if it is; else the body is not thinner than a part of
// its length about its centre of mass, and what has no mass is a small body.
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

// The rotor of a joint on the link that carries it adds I_m a aᵀ to the link's inertia.
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

  // Without the rotors that links carry.
  VectorXd bodies() const {
    VectorXd pi(static_cast<Index>(links.size() * kParametersPerJoint));
    for (std::size_t i = 0; i < links.size(); ++i) links[i].parameters(pi.data() + i * kParametersPerJoint);
    return pi;
  }

  // K' with K' bodies() = K pi.
  MatrixXd of_bodies(const MatrixXd& K) const {
    MatrixXd adding = MatrixXd::Identity(K.cols(), K.cols());
    for (const CarriedRotor& rotor : rotors) {
      rotor.add_to(
          adding.col(static_cast<Index>(rotor.joint) * kParametersPerJoint + static_cast<Index>(Parameter::Im)).data());
    }
    return K * adding;
  }
};

std::vector<LinkShape> shapes_of(const std::vector<double>& file, const std::vector<double>& scale) {
  std::vector<LinkShape> shapes;
  const Sizes largest = sizes_of(file);
  for (std::size_t at = 0; at < file.size(); at += kParametersPerJoint) {
    LinkShape shape;
    shape.L = Eigen::LLT<Matrix4d>(made_definite(pseudo_inertia(&file[at]), largest)).matrixL();
    for (int k = 0; k < kOthers; ++k) {
      const std::size_t place = at + static_cast<std::size_t>(kInertialPerBody + k);
      shape.others[k] = file[place] > 0 ? file[place] : scale[place];
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

// The least of |K' bodies - target|² / 2 + μ divergence, by Newton's method with the divergence as its barrier. It is
// convex in the parameters, so that no step can lead into a corner.
class BodySearch {
 public:
  BodySearch(Shapes shapes, const MatrixXd& K, const VectorXd& target) : shapes_(std::move(shapes)) {
    const MatrixXd of_bodies = shapes_.of_bodies(K);
    file_ = shapes_.bodies();
    K_ = (1 - kOfTheFile) * of_bodies;
    target_ = target - kOfTheFile * of_bodies * file_;
  }

  // From a heavy divergence to a light one: the last steps move only what π_b does not decide.
  bool run() {
    constexpr double kLightest = 1e-3, kLighter = 0.1;
    double weight = std::max(1.0, residual(shapes_).squaredNorm() / static_cast<double>(file_.size()));
    bool converged = improve(weight);
    while (weight > kLightest) {
      weight = std::max(kLighter * weight, kLightest);
      converged = improve(weight);
    }
    return converged;
  }

  std::vector<double> parameters() const {
    const VectorXd bodies = (1 - kOfTheFile) * shapes_.bodies() + kOfTheFile * file_;
    std::vector<double> pi(bodies.begin(), bodies.end());
    for (const CarriedRotor& rotor : shapes_.rotors) rotor.add_to(pi.data());
    return pi;
  }

  double distance() const {
    double sum = 0;
    for (const LinkShape& link : shapes_.links) {
      sum += (link.S * link.S.transpose() - Matrix4d::Identity()).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(shapes_.links.size()));
  }

 private:
  // Bodies that π_b wants to be flat stay this much of the file's, so that they are bodies in double, too.
  static constexpr double kOfTheFile = 1e-9;

  VectorXd residual(const Shapes& shapes) const { return K_ * shapes.bodies() - target_; }

  double cost(const Shapes& shapes, double weight) const {
    double sum = residual(shapes).squaredNorm() / 2;
    for (const LinkShape& link : shapes.links) sum += weight * link.divergence();
    return sum;
  }

  // For one weight; whether it came to the end.
  bool improve(double weight) {
    constexpr int kMostSteps = 200;
    constexpr double kSmall = 1e-8, kRounding = 1e-13;
    for (int step = 0; step < kMostSteps; ++step) {
      const double before = cost(shapes_, weight);
      const auto [y, decrease] = newton_step(weight);
      if (decrease <= std::max(kSmall * weight, kRounding * before)) return true;
      if (!descend(y, decrease, before, weight)) return false;
    }
    return false;
  }

  // y, and the decrease of the cost per part of it.
  std::pair<VectorXd, double> newton_step(double weight) const {
    const Index size = file_.size(), rows = K_.rows();
    MatrixXd J(rows + size, size);
    VectorXd wanted(rows + size);
    const double root = std::sqrt(weight);
    J.bottomRows(size) = root * MatrixXd::Identity(size, size);
    wanted.head(rows) = -residual(shapes_);
    Index at = 0;
    for (const LinkShape& link : shapes_.links) {
      J.block(0, at, rows, kParametersPerJoint) = K_.middleCols(at, kParametersPerJoint) * link.changes();
      wanted.segment(rows + at, kParametersPerJoint) = -root * link.gradient();
      at += kParametersPerJoint;
    }
    const VectorXd y = J.householderQr().solve(wanted);
    return {y, (J * y).squaredNorm()};
  }

  // As far along y as the cost decreases as it should.
  bool descend(const VectorXd& y, double decrease, double before, double weight) {
    constexpr double kEnough = 1e-4, kShortest = 1e-12;
    double part = 1;
    for (std::size_t i = 0; i < shapes_.links.size(); ++i) {
      part = std::min(part, shapes_.links[i].longest_step(y.data() + i * kParametersPerJoint));
    }
    for (; part > kShortest; part /= 2) {
      Shapes moved = shapes_;
      for (std::size_t i = 0; i < moved.links.size(); ++i) {
        moved.links[i].move(y.data() + i * kParametersPerJoint, part);
      }
      if (cost(moved, weight) > before - kEnough * part * decrease) continue;
      shapes_ = std::move(moved);
      return true;
    }
    return false;
  }

  Shapes shapes_;
  MatrixXd K_;
  VectorXd target_, file_;
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
