// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/inertia_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "robot/model/physical_inertia.hpp"
#include "robot/model/rounded_up.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

constexpr int kNone = -1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double length_of(const Vec3& v) { return std::hypot(nearest_double(v[0]), nearest_double(v[1]), nearest_double(v[2])); }

// The contributions of a link and its joint to the energies.
struct LinkBounds {
  double mass = 0;
  double least_moment = 0, largest_moment = 0;  // about the centre of mass, and axes about which the link can turn
  double moment_at_joint = 0;                   // about the axis of its own joint, if that is revolute
  double drive = 0;                             // rotor and armature, kg m² or kg at the joint
  double sure_drive = 0;                        // what is left of it when coupling has taken from the rotor's carrier
  double centre = 0;                            // |r_C|
  double offset = 0;                            // to the frame from the parent's, at most
  double offset_from_axis = 0;                  // the same, from the axis of the parent's joint
  bool is_planar = false;                       // turns about its frame's z axis only
  int turned_by = kNone;                        // the last body on the way to it whose joint is revolute
};

// The largest distance that a joint slides; without limits it is `unlimited`.
double travel_of(const Body& body, double unlimited) {
  if (!body.prismatic) return 0;
  if (!body.limits.lower || !body.limits.upper) return unlimited;
  return std::max(std::abs(nearest_double(body.limits.lower->number)),
                  std::abs(nearest_double(body.limits.upper->number)));
}

void add_inertia(const InertialParameters& body, LinkBounds& link) {
  const Mat3 central = central_tensor(body);
  const std::array<double, 3> moments = principal_moments(central);
  // Rounding errors of eigenvalues are a share of the largest.
  constexpr double kEigenvalueError = 1e-12;
  const double about_axis = nearest_double(central[2][2]);
  link.mass = nearest_double(body.mass);
  link.centre = length_of(centre_of_mass(body));
  link.least_moment = link.is_planar ? about_axis : moments[2] - kEigenvalueError * moments[0];
  link.largest_moment = link.is_planar ? about_axis : moments[0];
  link.moment_at_joint = nearest_double(body.inertia[2][2]);
}

// Twice the kinetic energy, from below and from above.
class EnergyBounds {
 public:
  // `unlimited`: how far a prismatic joint without limits slides.
  EnergyBounds(const Mechanism& mechanism, double unlimited)
      : mechanism_(mechanism), rate_coupling_(mechanism.rate_coupling()), unlimited_(unlimited) {
    for (int k = 0; k < mechanism.body_count(); ++k) add_link(k);
    for (int k = 0; k < mechanism.body_count(); ++k) add_rotor(k);
    for (int k = 0; k < mechanism.body_count(); ++k) diagonal_.push_back(largest_diagonal(k));
  }

  // A bound of b_kk for an entry of q̇, which may move several joints: (Σ_k |n_k| sqrt(b_kk))².
  double diagonal_of(int rate) const {
    if (!mechanism_.is_coupled()) return diagonal_[at(rate)];
    double root = 0;
    for (std::size_t k = 0; k < links_.size(); ++k) root += factor(k, rate) * std::sqrt(diagonal_[k]);
    return root * root * kRoundingMargin;
  }

  // Whether a prismatic joint lies beyond a joint that an entry of q̇ turns.
  bool slides_beyond(int rate) const {
    for (int j = 0; j < mechanism_.body_count(); ++j) {
      if (!mechanism_.bodies[at(j)].prismatic) continue;
      for (int k = parent(j); k != kNone; k = parent(k)) {
        const bool is_moved = mechanism_.is_coupled() ? factor(at(k), rate) > 0 : k == rate;
        if (is_moved && !mechanism_.bodies[at(k)].prismatic) return true;
      }
    }
    return false;
  }

  // Whether q̇ᵀ B q̇ >= share Σ b_ii q̇_i²: whether c_k ω_k² and m_k v_k² cover what the rates of the joints ask for.
  bool cover(double share) const {
    Supply rest = supply();
    if (mechanism_.floating_base) take_for_base(share, rest);
    for (int position = 0; position < mechanism_.position_count(); ++position) {
      if (mechanism_.is_of_quaternion(position)) continue;
      const int k = mechanism_.body_at(position);
      if (!turns_as_its_coordinate(k, position)) return false;
      const double diagonal = diagonal_of(mechanism_.is_coupled() ? mechanism_.base_bodies() + position : k);
      if (diagonal == 0) return false;  // the joint moves nothing
      const double needed = share * diagonal - links_[at(k)].sure_drive;
      if (!(needed > 0)) continue;
      if (mechanism_.bodies[at(k)].prismatic) {
        take_for_sliding(k, needed, rest);
      } else {
        take_for_turning(k, needed, rest);
      }
    }
    for (const int first : mechanism_.spherical) {
      if (!take_for_spherical_joint(first, share, rest)) return false;
    }
    const auto is_enough = [](double left) { return left >= 0; };
    return std::all_of(rest.turning.begin(), rest.turning.end(), is_enough) &&
           std::all_of(rest.moving.begin(), rest.moving.end(), is_enough);
  }

 private:
  // Whether the rate of joint k is that of its entry of q alone: not so for position = "c - 100*b".
  bool turns_as_its_coordinate(int k, int position) const {
    if (!mechanism_.is_coupled()) return true;
    for (int i = 0; i < mechanism_.position_count(); ++i) {
      if (!mechanism_.coupling[at(k)][at(i)].is_equal(i == position ? 1 : 0)) return false;
    }
    return true;
  }

  // Coefficients of ω_k² and v_k².
  struct Supply {
    std::vector<double> turning, moving;
  };

  int parent(int k) const { return mechanism_.bodies[at(k)].parent; }
  int turned_by(int k) const { return k == kNone ? kNone : links_[at(k)].turned_by; }

  void add_link(int k) {
    const Body& body = mechanism_.bodies[at(k)];
    LinkBounds link;
    const bool is_parallel = vanishes(body.alpha.s);
    link.is_planar = turned_by(parent(k)) == kNone || (is_parallel && links_[at(parent(k))].is_planar);
    link.turned_by = body.prismatic ? turned_by(parent(k)) : k;
    if (body.prismatic && link.turned_by != kNone && !is_parallel) link.is_planar = false;
    add_inertia(body.inertia, link);
    link.drive = link.sure_drive = nearest_double(body.armature);
    const double travel = travel_of(body, unlimited_);
    link.offset = length_of(body.p) + travel;
    link.offset_from_axis = std::hypot(nearest_double(body.p[0]), nearest_double(body.p[1])) + travel;
    links_.push_back(link);
  }

  // k_r² I_m q̇² + 2 k_r I_m q̇ (ω · z_m) >= k_r² I_m q̇² / 2 - 2 I_m ω², with ω of the carrier.
  void add_rotor(int k) {
    const auto& rotor = mechanism_.bodies[at(k)].rotor;
    if (!rotor) return;
    const double inertia = nearest_double(rotor->inertia), ratio = nearest_double(rotor->gear_ratio);
    const double drive = ratio * ratio * inertia;
    const int carrier = turned_by(rotor->carrier);
    links_[at(k)].drive += drive;
    links_[at(k)].sure_drive += carrier == kNone ? drive : drive / 2;
    if (carrier != kNone) links_[at(carrier)].least_moment -= 2 * inertia;
  }

  // A bound of b_kk of the tree: links that follow are as far from the joint's axis as they can be.
  double largest_diagonal(int k) const {
    const bool is_prismatic = mechanism_.bodies[at(k)].prismatic;
    std::vector<double> distance(links_.size(), -1);  // of origins from the axis; negative: not moved
    distance[at(k)] = 0;
    double sum = is_prismatic ? links_[at(k)].mass : links_[at(k)].moment_at_joint;
    for (int j = k + 1; j < static_cast<int>(links_.size()); ++j) {
      if (parent(j) == kNone || distance[at(parent(j))] < 0) continue;
      const LinkBounds& link = links_[at(j)];
      distance[at(j)] = distance[at(parent(j))] + (parent(j) == k ? link.offset_from_axis : link.offset);
      const double reach = distance[at(j)] + link.centre;
      sum += is_prismatic ? link.mass : link.largest_moment + (link.mass > 0 ? link.mass * reach * reach : 0);
    }
    return (sum + links_[at(k)].drive) * kRoundingMargin;
  }

  double factor(std::size_t k, int rate) const { return std::abs(nearest_double(rate_coupling_[k][at(rate)])); }

  Supply supply() const {
    Supply result{std::vector<double>(links_.size()), {}};
    for (const LinkBounds& link : links_) {
      result.moving.push_back(link.mass);
      if (link.turned_by != kNone) result.turning[at(link.turned_by)] += link.least_moment;
    }
    return result;
  }

  // With v_C = v + ω × r_C of the base link, |v|² is at most 2 v_C² + 2 r_C² ω². Three diagonal entries are the whole
  // mass; the other three are at most the largest of them each, and the sum of the ω_i² is ω².
  void take_for_base(double share, Supply& rest) const {
    constexpr int kLinear = 0, kAngular = 3;
    const int base = mechanism_.base_bodies() - 1;
    const double centre = links_[at(base)].centre, of_mass = 2 * share * diagonal_[kLinear];
    const auto turns = diagonal_.begin() + kAngular;
    rest.moving[at(base)] -= of_mass;
    rest.turning[at(base)] -= of_mass * centre * centre + share * *std::max_element(turns, turns + 3);
  }

  // q̇_k² is ω_k² if nothing turns the parent, else at most 2 ω_k² + 2 ω_parent².
  void take_for_turning(int k, double needed, Supply& rest) const {
    const int before = turned_by(parent(k));
    if (before == kNone) {
      rest.turning[at(k)] -= needed;
      return;
    }
    for (const int end : {k, before}) rest.turning[at(end)] -= 2 * needed;
  }

  // |w|² of a spherical joint is at most 2 ω² + 2 ω_parent², and the sum of its diagonal entries times squared rates at
  // most the largest of them times |w|². Returns whether the joint moves anything.
  bool take_for_spherical_joint(int first, double share, Supply& rest) const {
    const auto own = diagonal_.begin() + first;
    const auto [least, most] = std::minmax_element(own, own + kSphericalBodies);
    if (*least == 0) return false;
    const int last = first + kSphericalBodies - 1, before = turned_by(parent(first));
    const double needed = share * *most;
    rest.turning[at(last)] -= before == kNone ? needed : 2 * needed;
    if (before != kNone) rest.turning[at(before)] -= 2 * needed;
    return true;
  }

  // |q̇_k| is at most v_k + v_parent + ω_parent d, with v of the centres of mass and d the distance between them.
  void take_for_sliding(int k, double needed, Supply& rest) const {
    if (parent(k) == kNone) {
      rest.moving[at(k)] -= needed;
      return;
    }
    const LinkBounds &link = links_[at(k)], &before = links_[at(parent(k))];
    const int turning = before.turned_by;
    const double terms = turning == kNone ? 2 : 3;
    for (const int end : {k, parent(k)}) rest.moving[at(end)] -= terms * needed;
    const double between = before.centre + link.offset + link.centre;
    if (turning != kNone) rest.turning[at(turning)] -= terms * needed * between * between;
  }

  const Mechanism& mechanism_;
  Rows rate_coupling_;
  double unlimited_;
  std::vector<LinkBounds> links_;
  std::vector<double> diagonal_;
};

}  // namespace

double scaled_inertia_bound(const Mechanism& mechanism) {
  constexpr double kSmallest = 0x1p-60;
  if (!mechanism.symbols.empty() || mechanism.has_loops()) return 0;
  const EnergyBounds bounds(mechanism, HUGE_VAL);
  if (!bounds.cover(kSmallest)) return 0;
  double proven = kSmallest, failed = 1;
  for (int k = 0; k < 40; ++k) {
    const double between = std::sqrt(proven * failed);
    (bounds.cover(between) ? proven : failed) = between;
  }
  return proven / kRoundingMargin;
}

std::string positions_of_inertia_bound(const Mechanism& mechanism) {
  return mechanism.has_prismatic_joint() ? "within the limits of prismatic joints" : "at every position";
}

std::vector<DiagonalBound> diagonal_bounds(const Mechanism& mechanism) {
  if (!mechanism.symbols.empty()) return {};
  const EnergyBounds bounds(mechanism, 0);
  std::vector<DiagonalBound> result;
  // With loops, of all entries of q, after those of a floating base.
  const int count = mechanism.has_loops() ? mechanism.base_bodies() + mechanism.position_count() : mechanism.size();
  for (int k = 0; k < count; ++k) result.push_back({bounds.diagonal_of(k), !bounds.slides_beyond(k)});
  return result;
}

}  // namespace flatdyn
