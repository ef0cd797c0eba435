// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/contact_definitions.hpp"

#include <utility>

#include "truth/definition/elimination_over_field.hpp"
#include "truth/definition/rules.hpp"

namespace flatdyn::definitions {
namespace {

constexpr int kBaseRows = 6;

template <class F>
Matrix<F> transpose_of(const Matrix<F>& A) {
  Matrix<F> result(A.cols(), A.rows());
  for (int i = 0; i < A.rows(); ++i) {
    for (int k = 0; k < A.cols(); ++k) result(k, i) = A(i, k);
  }
  return result;
}

// Rows and columns from `first` on.
template <class F>
Matrix<F> trailing(const Matrix<F>& A, int first) {
  Matrix<F> result(A.rows() - first, A.cols() - first);
  for (int i = first; i < A.rows(); ++i) {
    for (int k = first; k < A.cols(); ++k) result(i - first, k - first) = A(i, k);
  }
  return result;
}

template <class F>
std::vector<F> negative(std::vector<F> values) {
  for (F& value : values) value = -value;
  return values;
}

template <class F>
std::vector<F> sum_of(std::vector<F> a, const std::vector<F>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}

// m / Σ M_kk / d_k, where 1 / d_k is the first diagonal entry of the inverse of M's rows and columns from k on.
template <class F>
F condition_of(const Matrix<F>& M) {
  F sum(0);
  for (int k = 0; k < M.rows(); ++k) {
    std::vector<F> unit(static_cast<std::size_t>(M.rows() - k), F(0));
    unit.front() = F(1);
    sum += M(k, k) * solution(trailing(M, k), unit).front();
  }
  return F(static_cast<std::uint64_t>(M.rows())) / sum;
}

// The contacts at a point: J, B^-1 Jᵀ and M = J B^-1 Jᵀ + λ² 1.
template <class Point>
class ContactDefinition {
 public:
  using F = typename Point::F;
  using Values = typename Point::Values;

  explicit ContactDefinition(Point& point) : point_(point), J_(jacobian_of(point)) {}

  Values jacobian() const { return J_.entries(); }

  Values positions() const {
    Values result;
    for (const FieldFrame<F>& contact : point_.lagrangian.mechanism().contacts) {
      const Vector3<F> p = point_.lagrangian.pose(contact).p;
      result.insert(result.end(), p.begin(), p.end());
    }
    return result;
  }

  Values drift() const {
    Values result;
    for (std::size_t k = 0; k < point_.mechanism.contacts.size(); ++k) {
      const Values all = point_.jacobian_dot_qd(point_.lagrangian.mechanism().contacts[k]);
      result.insert(result.end(), all.begin(), all.begin() + point_.mechanism.contacts[k].rows());
    }
    return result;
  }

  // -M^-1 of the contacts' accelerations or velocities without forces.
  Values forces() const { return solution(mobility(), negative(sum_of(times(J_, free_accelerations()), drift()))); }
  Values accelerations() const { return sum_of(free_accelerations(), moved_by(forces())); }
  Values impulses() const { return solution(mobility(), negative(times(J_, point_.qd()))); }
  Values velocities_after() const { return sum_of(point_.qd(), moved_by(impulses())); }
  F condition() const { return condition_of(mobility()); }

  // Each row in the axes t_1, t_2, n of its contact.
  Values cones() const {
    const int cols = point_.mechanism.contact_rows();
    Values entries;
    int first = 0;
    for (std::size_t c = 0; c < point_.mechanism.contacts.size(); ++c) {
      const Contact& contact = point_.mechanism.contacts[c];
      for (const ConeRow& row : contact.cone) {
        const Matrix3<F> R = contact.is_against_gravity ? against_gravity() : point_.lagrangian.pose(frames()[c]).R;
        Values all(static_cast<std::size_t>(cols), F(0));
        for (int k = 0; k < contact.rows(); ++k) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const F value = point_.arithmetic.constant(to_rational(row[axis + (k < 3 ? 0 : 3)]));
            all[static_cast<std::size_t>(first + k)] += R[static_cast<std::size_t>(k % 3)][axis] * value;
          }
        }
        entries.insert(entries.end(), all.begin(), all.end());
      }
      first += contact.rows();
    }
    return entries;
  }

  // The smallest forces that carry the base: Aᵀ (A Aᵀ)^-1 w with A = the base's rows of Jᵀ.
  Values smallest_forces() const {
    const Matrix<F> A = rows_of_base();
    const Values all = point_.inverse_dynamics();
    const Values needed(all.begin(), all.begin() + kBaseRows);
    return times(transpose_of(A), solution(times(A, transpose_of(A)), needed));
  }

  Values joint_torques() const {
    return sum_of(point_.inverse_dynamics(), negative(times(transpose(), smallest_forces())));
  }

  // That of the rotations' part of A Aᵀ once the translations are eliminated.
  F condition_of_support() const {
    const Matrix<F> A = rows_of_base(), M = times(A, transpose_of(A));
    Matrix<F> about_mean(3, 3);
    const F per_point = F(1) / M(0, 0);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        about_mean(i, k) = M(i + 3, k + 3);
        for (int j = 0; j < 3; ++j) about_mean(i, k) += -(M(i + 3, j) * M(j, k + 3) * per_point);
      }
    }
    return condition_of(about_mean);
  }

 private:
  const std::vector<FieldFrame<F>>& frames() const { return point_.lagrangian.mechanism().contacts; }

  // The columns H e_x, H e_y, n, with H x = x - v (v·x) / (1 - σ n_z) and v = n - σ e_z, a mirror as σ is a sign.
  Matrix3<F> against_gravity() const {
    const auto [n, down] = normal();
    const Vector3<F> v = {n[0], n[1], n[2] + -down};
    const F share = F(1) / (F(1) + -(down * n[2]));
    Matrix3<F> axes;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 2; ++k) axes[i][k] = F(i == k ? 1 : 0) + -(share * v[i] * v[k]);
      axes[i][2] = n[i];
    }
    return axes;
  }

  // -g_b / |g_b|, and the sign of g_b along z. That of numbers is along an axis, and has no root to be drawn.
  std::pair<Vector3<F>, F> normal() const {
    const F half = F(1) / F(2);
    if (point_.mechanism.has_base_gravity()) {
      const Vector3<F>& g = point_.lagrangian.mechanism().gravity;
      const F length = point_.arithmetic.sqrt(dot(g, g));
      return {{-(g[0] / length), -(g[1] / length), -(g[2] / length)},
              point_.arithmetic.sign(point_.arithmetic.sign(g[2]) + half)};
    }
    Vector3<F> n;
    F down(1);
    for (std::size_t k = 0; k < 3; ++k) {
      const double g = nearest_double(point_.mechanism.gravity[k]);
      n[k] = g < 0 ? F(1) : g > 0 ? -F(1) : F(0);
      if (k == 2 && g < 0) down = -F(1);
    }
    return {n, down};
  }

  static Matrix<F> jacobian_of(Point& point) {
    Matrix<F> J(point.mechanism.contact_rows(), point.mechanism.size());
    int first = 0;
    for (std::size_t c = 0; c < point.mechanism.contacts.size(); ++c) {
      const Matrix<F> all = point.lagrangian.jacobian(point.lagrangian.mechanism().contacts[c]);
      const int rows = point.mechanism.contacts[c].rows();
      for (int i = 0; i < rows; ++i) {
        for (int k = 0; k < J.cols(); ++k) J(first + i, k) = all(i, k);
      }
      first += rows;
    }
    return J;
  }

  Matrix<F> transpose() const { return transpose_of(J_); }

  Matrix<F> rows_of_base() const {
    Matrix<F> A(kBaseRows, J_.rows());
    for (int i = 0; i < kBaseRows; ++i) {
      for (int k = 0; k < J_.rows(); ++k) A(i, k) = J_(k, i);
    }
    return A;
  }

  Matrix<F> mobility() const {
    Matrix<F> M = times(J_, solution(point_.lagrangian.inertia(), transpose()));
    const F damping = point_.arithmetic.constant(point_.mechanism.contact_damping);
    for (int i = 0; i < M.rows(); ++i) M(i, i) += damping * damping;
    return M;
  }

  Values free_accelerations() const { return solution(point_.lagrangian.inertia(), point_.net_torques()); }
  Values moved_by(const Values& forces) const {
    return solution(point_.lagrangian.inertia(), times(transpose(), forces));
  }

  Point& point_;
  Matrix<F> J_;
};

template <class Point>
ContactDefinition<Point> contacts_at(Point& point) {
  return ContactDefinition<Point>(point);
}

// M is of as many rows as the contacts hold directions, each over det B, and so is what it is solved for.
double contact_degree(const Mechanism& mechanism, const Function&) {
  return 4.0 * (mechanism.contact_rows() + 1) * (mechanism.size() + 2);
}

// Sums of products of up to six rows over a determinant of six.
double support_degree(const Mechanism&, const Function&) { return 32; }

template <class Generic>
constexpr Definition of_contacts(Generic expected, double (*degree)(const Mechanism&, const Function&)) {
  return {rules(expected), kOwnValues, degree};
}

}  // namespace

constinit const Definition contact_jacobian = defined_as([](auto& at, const Output& output) {
  return output.name == "p_c" ? contacts_at(at).positions() : contacts_at(at).jacobian();
});

constinit const Definition contact_bias = defined_as([](auto& at, const Output&) { return contacts_at(at).drift(); });

constinit const Definition constrained_forward_dynamics = of_contacts(
    [](auto& at, const Output& output) {
      const auto contacts = contacts_at(at);
      if (output.name == "condition") return std::vector{contacts.condition()};
      return output.name == "f_c" ? contacts.forces() : contacts.accelerations();
    },
    contact_degree);

constinit const Definition contact_inverse_dynamics = of_contacts(
    [](auto& at, const Output& output) {
      const auto contacts = contacts_at(at);
      if (output.name == "condition") return std::vector{contacts.condition_of_support()};
      return output.name == "f_c" ? contacts.smallest_forces() : contacts.joint_torques();
    },
    support_degree);

constinit const Definition contact_impact = of_contacts(
    [](auto& at, const Output& output) {
      const auto contacts = contacts_at(at);
      if (output.name == "condition") return std::vector{contacts.condition()};
      return output.name == "impulse" ? contacts.impulses() : contacts.velocities_after();
    },
    contact_degree);

constinit const Definition friction_cones = defined_as([](auto& at, const Output&) { return contacts_at(at).cones(); });

}  // namespace flatdyn::definitions
