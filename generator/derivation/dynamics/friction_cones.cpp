// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/friction_cones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/contacts.hpp"
#include "derivation/dynamics/kinematics.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kAxes = 3;

[[noreturn]] void refuse_normal(const std::string& why) {
  throw Failure(FailureKind::unsupported, "friction_cones: a contact's normal is against gravity, " + why,
                "write normal = \"link\" in [[contact]]: the z axis of its link, or of a [[frame]]");
}

class Cones {
 public:
  explicit Cones(DerivationContext& context) : context_(context), d_(context.derivation) {}

  Rows rows() {
    Rows all;
    std::size_t first = 0;
    for (const Contact& contact : context_.mechanism.contacts) {
      const std::array<Vec3, kAxes> axes = contact.cone.empty()         ? std::array<Vec3, kAxes>{}
                                           : contact.is_against_gravity ? axes_against_gravity()
                                                                        : axes_of_link(contact);
      for (const ConeRow& row : contact.cone) {
        all.emplace_back(static_cast<std::size_t>(context_.mechanism.contact_rows()), 0);
        add_row(row, axes, first, contact.is_surface, all.back());
      }
      first += static_cast<std::size_t>(contact.rows());
    }
    return all;
  }

  // g_b has a direction.
  Conditions conditions() {
    if (!square_) return {};
    return {{context_.node(*square_)}, {}};
  }

 private:
  // The row by forces, then by moments, in base axes.
  void add_row(const ConeRow& row, const std::array<Vec3, kAxes>& axes, std::size_t first, bool has_moments,
               std::vector<Number>& all) const {
    for (std::size_t k = 0; k < kAxes; ++k) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        all[first + k] += row[axis] * axes[axis][k];
        if (has_moments) all[first + kAxes + k] += row[kAxes + axis] * axes[axis][k];
      }
    }
  }

  std::array<Vec3, kAxes> axes_of_link(const Contact& contact) const {
    const Mat3 R = transpose(pose(context_.frames, contact.frame).R);
    return {R[0], R[1], R[2]};
  }

  std::array<Vec3, kAxes> axes_against_gravity() {
    if (against_gravity_) return *against_gravity_;
    const auto [n, down] = normal();
    // With v = n - σ e_z: H x = x - v (v·x) 2 / v·v, and v·v / 2 = 1 - σ n_z = 1 + |n_z|.
    const Vec3 v = d_.named(n - Vec3{0, 0, down}, "v_n");
    const Number share = d_.quotient(1, d_.named(1 - down * n[2], "v2_n"), "inv_v2_n");
    const auto mirrored = [&](std::size_t k, const std::string& name) {
      Vec3 axis = zero_vector();
      axis[k] = 1;
      return d_.named(axis - d_.named(v[k] * share, name + "_v") * v, name);
    };
    against_gravity_ = {mirrored(0, "t_1"), mirrored(1, "t_2"), n};
    return *against_gravity_;
  }

  struct Normal {
    Vec3 n;
    Number down;  // σ, the sign of g_b along z, 1 for zero
  };

  Normal normal() {
    const Vec3 g = context_.gravity();
    if (std::all_of(g.begin(), g.end(), vanishes)) refuse_normal("and there is none");
    if (!context_.mechanism.has_base_gravity()) return normal_of_numbers(g);
    square_ = d_.named(dot(g, g), "g2");
    const Number inverse = d_.quotient(1, d_.sqrt(*square_, "g"), "inv_g");
    const Number sign = d_.sign(g[2], "sgn_g");
    return {d_.named(Number(-1) * inverse * g, "n"), d_.sign(sign + Number(1) / 2, "down")};
  }

  static Normal normal_of_numbers(const Vec3& g) {
    const auto along = std::count_if(g.begin(), g.end(), [](const Number& entry) { return !vanishes(entry); });
    if (along != 1) refuse_normal("which is along no axis of the base");
    if (!std::all_of(g.begin(), g.end(), is_rational)) refuse_normal("which has a free symbol");
    Vec3 n = zero_vector();
    for (std::size_t k = 0; k < kAxes; ++k) {
      if (!vanishes(g[k])) n[k] = nearest_double(g[k]) < 0 ? 1 : -1;
    }
    return {n, n[2].is_equal(1) ? -1 : 1};
  }

  DerivationContext& context_;
  Derivation& d_;
  std::optional<std::array<Vec3, kAxes>> against_gravity_;
  std::optional<Number> square_;  // g_b · g_b
};

// "left_foot: 4 rows, right_foot: 4 rows".
std::string words_for_rows(const std::vector<Contact>& contacts) {
  std::string text;
  for (const Contact& contact : contacts) {
    if (contact.cone.empty()) continue;
    text += fmt::format("{}{}: {} rows", text.empty() ? "" : ", ", contact.name, contact.cone.size());
  }
  return text;
}

}  // namespace

Function derive_friction_cones(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, at_the_contacts(choices, mechanism), [](DerivationContext& context) {
    Cones cones(context);
    const Rows rows = cones.rows();
    const std::string meaning =
        fmt::format("contacts hold where A_c f_c <= 0 in every row; {}; columns: {}, base axes",
                    words_for_rows(context.mechanism.contacts), contact_text(context.mechanism.contacts));
    Function function = finished(context,
                                 {matrix_output("A_c", context.mechanism.cone_rows(), context.mechanism.contact_rows(),
                                                context.nodes(rows), meaning)},
                                 cones.conditions());
    if (!function.validity_conditions.empty()) function.inverted = "g_b^T g_b";
    return function;
  });
}

}  // namespace flatdyn
