// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/readable_sum.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <tuple>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/notation/motion_names.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {
namespace {

// Calls visit(factor, exponent) for the factors of one expanded term, numbers included; reciprocals have exponent -k.
template <class Visit>
void for_factors(const Number& term, const Visit& visit) {
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (const Number& factor : term) for_factors(factor, visit);
  } else if (GiNaC::is_a<GiNaC::power>(term) && term.op(1).info(GiNaC::info_flags::integer)) {
    visit(term.op(0), GiNaC::ex_to<GiNaC::numeric>(term.op(1)).to_int());
  } else {
    visit(term, 1);
  }
}

template <class Visit>
void for_terms(const Number& expanded, const Visit& visit) {
  if (GiNaC::is_a<GiNaC::add>(expanded)) {
    for (const Number& term : expanded) visit(term);
  } else {
    visit(expanded);
  }
}

// The text of an angle, or of a sum under a fraction bar, with its terms sorted by text.
std::string plain_text(const Number& e) {
  std::ostringstream text;
  if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
    std::vector<std::string> parts;
    for (const Number& part : e) parts.push_back(plain_text(part));
    std::sort(parts.begin(), parts.end());
    const char* const join = GiNaC::is_a<GiNaC::add>(e) ? " + " : " ";
    for (std::size_t k = 0; k < parts.size(); ++k) text << (k == 0 ? "" : join) << parts[k];
  } else if (GiNaC::is_a<GiNaC::power>(e)) {
    text << plain_text(e.op(0)) << '^' << e.op(1);
  } else if (GiNaC::is_a<GiNaC::function>(e)) {
    text << GiNaC::ex_to<GiNaC::function>(e).get_name() << '(' << plain_text(e.op(0)) << ')';
  } else {
    text << e;
  }
  return text.str();
}

std::string factor_text(const Number& e) {
  return GiNaC::is_a<GiNaC::add>(e) ? "(" + plain_text(e) + ")" : plain_text(e);
}

// The key by which people sort names: (number at the end, letters between underscore and number, letters before).
auto natural_key(const std::string& name) {
  std::size_t digits = name.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(name[digits - 1])) != 0) --digits;
  const std::size_t underscore = std::min(name.find('_'), digits);
  const std::string number = name.substr(digits), tail = name.substr(underscore, digits - underscore);
  return std::tuple(number.size(), number, tail, name.substr(0, underscore), name);
}

bool contains(const Number& expression, const GiNaC::symbol& symbol) { return expression.has(symbol); }

bool contains(const Vec3& vector, const GiNaC::symbol& symbol) {
  return std::any_of(vector.begin(), vector.end(), [&](const Number& e) { return e.has(symbol); });
}

bool contains(const Mat3& matrix, const GiNaC::symbol& symbol) {
  return std::any_of(matrix.begin(), matrix.end(), [&](const Vec3& row) { return contains(row, symbol); });
}

// The kind of a symbol, by its place in the model: B is linear in masses and inertias.
FactorKind kind_of(const GiNaC::symbol& symbol, const Mechanism& mechanism) {
  if (contains(mechanism.gravity, symbol)) return FactorKind::gravity;
  bool is_length = false, is_dynamic = false;
  for (const Body& body : mechanism.bodies) {
    if (body.rotor && contains(body.rotor->gear_ratio, symbol)) return FactorKind::gear;
    if (contains(body.inertia.mass, symbol)) return FactorKind::dynamic;
    is_dynamic = is_dynamic || contains(body.armature, symbol) || contains(body.inertia.inertia, symbol) ||
                 (body.rotor && contains(body.rotor->inertia, symbol));
    is_length = is_length || contains(body.p, symbol) || contains(body.inertia.first_moment, symbol);
  }
  return is_dynamic && !is_length ? FactorKind::dynamic : FactorKind::other;
}

// All constants of a body that may be expressions.
std::vector<Number> constants_of(const Body& body) {
  const InertialParameters& inertia = body.inertia;
  std::vector<Number> constants = {
      body.viscous,          body.coulomb,    body.armature,      inertia.mass,   body.stiffness,
      body.spring_reference, body.dry.excess, body.dry.asymmetry, body.dry.speed, body.dry.stribeck_speed,
      body.dry.offset};
  for (const PlanarRotation& turn : {body.beta, body.alpha, body.theta}) {
    constants.push_back(turn.c);
    constants.push_back(turn.s);
  }
  const auto add = [&constants](const Vec3& v) { constants.insert(constants.end(), v.begin(), v.end()); };
  add(body.p);
  add(inertia.first_moment);
  for (const Vec3& row : inertia.inertia) add(row);
  if (body.rotor) {
    constants.push_back(body.rotor->gear_ratio);
    constants.push_back(body.rotor->inertia);
    add(body.rotor->axis);
  }
  return constants;
}

}  // namespace

std::strong_ordering Factor::operator<=>(const Factor& b) const {
  const auto joints = [](const std::vector<int>& a) {
    return std::count_if(a.begin(), a.end(), [](int k) { return k != 0; });
  };
  const bool both_turn = is_trigonometric() && b.is_trigonometric();  // s_1 c_2: the angle counts first
  if (const auto order = kind <=> b.kind; !both_turn && order != 0) return order;
  if (const auto order = index <=> b.index; order != 0) return order;
  if (const auto order = joints(angle) <=> joints(b.angle); order != 0) return order;
  if (const auto order = b.angle <=> angle; order != 0) return order;
  return kind <=> b.kind;
}

FactorNames::FactorNames(const Mechanism& mechanism, const ClosedForm& form) : form_(form) {
  for (const FreeSymbol& symbol : mechanism.symbols) {
    entries_.push_back({symbol.name, kind_of(symbol.symbol, mechanism), symbol.symbol});
  }
  add_names_of_motion(mechanism);
  const auto is_known = [&](const Number& factor) {
    const auto same = [&](const auto& known) { return known.is_equal(GiNaC::ex_to<GiNaC::basic>(factor)); };
    return GiNaC::is_a<GiNaC::numeric>(factor) || std::any_of(form.c.begin(), form.c.end(), same) ||
           std::any_of(form.s.begin(), form.s.end(), same) || std::any_of(form.d.begin(), form.d.end(), same) ||
           std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.expression.is_equal(factor); });
  };
  const auto learn = [&](const Number& expression) {
    for_terms(expression, [&](const Number& term) {
      for_factors(term, [&](const Number& factor, int) {
        if (!is_known(factor)) entries_.push_back({factor_text(factor), FactorKind::other, factor});
      });
    });
  };
  for (std::size_t i = 0; i < form.B.size(); ++i) {
    for (const Number& b : form.B[i]) learn(b);
    if (!form.c_ijk.empty()) {
      for (const Number& c : form.c_ijk[i]) learn(c);
    }
    learn(form.g[i]);
  }
  for (const Number& entry : mechanism.gravity) learn(entry.expand());
  for (const Body& body : mechanism.bodies) {
    for (const Number& entry : constants_of(body)) learn(entry.expand());
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return natural_key(a.name) < natural_key(b.name); });
  for (const Entry& entry : entries_) names_.push_back(entry.name);
}

// Adds the entries of quaternions and gravity in base axes.
void FactorNames::add_names_of_motion(const Mechanism& mechanism) {
  std::size_t next = 0;
  const std::vector<std::string> of_quaternions = quaternion_names(mechanism);
  for (const ClosedForm::Quaternion& quaternion : form_.quaternions) {
    for (const GiNaC::symbol& entry : quaternion) {
      entries_.push_back({of_quaternions[next++], FactorKind::quaternion, entry});
    }
  }
  const std::vector<std::string> of_gravity = base_gravity_names(mechanism);
  for (std::size_t k = 0; k < form_.g_b.size(); ++k) {
    entries_.push_back({of_gravity[k], FactorKind::gravity, form_.g_b[k]});
  }
}

void FactorNames::multiply(const Number& factor, int exponent, Monomial& monomial, Rational& coefficient) const {
  if (is_rational(factor)) {
    for (int k = 0; k < exponent; ++k) coefficient *= to_rational(factor);
    return;
  }
  const auto is_factor = [&factor](const GiNaC::symbol& s) { return factor.is_equal(s); };
  for (std::size_t i = 0; i < form_.c.size(); ++i) {
    std::vector<int> angle(form_.c.size(), 0);
    angle[i] = 1;
    if (is_factor(form_.c[i])) monomial[{FactorKind::cosine, 0, angle}] += exponent;
    if (is_factor(form_.s[i])) monomial[{FactorKind::sine, 0, angle}] += exponent;
    if (is_factor(form_.c[i]) || is_factor(form_.s[i])) return;
  }
  for (std::size_t i = 0; i < form_.d.size(); ++i) {
    if (!is_factor(form_.d[i])) continue;
    monomial[{FactorKind::coordinate, static_cast<int>(i), {}}] += exponent;
    return;
  }
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    if (!entries_[k].expression.is_equal(factor)) continue;
    monomial[{entries_[k].kind, static_cast<int>(k), {}}] += exponent;
    return;
  }
  throw Failure(FailureKind::unsupported, "the closed form has a factor that cannot be printed: " + plain_text(factor));
}

ReadableSum FactorNames::readable(const Number& expression) const {
  ReadableSum sum;
  for_terms(expression.expand(), [&](const Number& term) {
    Monomial monomial;
    Rational coefficient = 1;
    for_factors(term, [&](const Number& factor, int exponent) { multiply(factor, exponent, monomial, coefficient); });
    sum[monomial] += coefficient;
  });
  std::erase_if(sum, [](const auto& term) { return term.second == 0; });
  return sum;
}

}  // namespace flatdyn
