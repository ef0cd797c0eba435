// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/derive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/closed_form/closed_form.hpp"
#include "derivation/notation/coupled_text.hpp"
#include "derivation/notation/exact_text.hpp"
#include "derivation/notation/latex.hpp"
#include "robot/model/field_mechanism.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

constexpr int kLongestChain = 8;  // joints from base to tip: each one triples the number of terms

void refuse_long_chains(const Mechanism& mechanism) {
  if (mechanism.has_loops()) {
    throw Failure(FailureKind::unsupported, "with closed loops, the equations of motion have no closed form",
                  "flatdyn generate makes code of them: of Phi_q, G with dq/dt = G qd, B, C and g");
  }
  std::vector<int> depth;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const int parent = mechanism.bodies[at(i)].parent, own = mechanism.is_of_base(i) ? 0 : 1;
    depth.push_back((parent < 0 ? 0 : depth[at(parent)]) + own);
  }
  const int longest = depth.empty() ? 0 : *std::max_element(depth.begin(), depth.end());
  if (longest <= kLongestChain) return;
  throw Failure(FailureKind::unsupported,
                fmt::format("the closed form of a chain of {} joints has millions of terms", longest),
                fmt::format("derive takes robots with at most {} joints in a row{}", kLongestChain,
                            mechanism.has_spherical_joints() ? ", of which a spherical one counts as three" : ""));
}

// A sum as text or, if it is too long, its number of terms.
struct Readable {
  ReadableSum sum;
  int terms = 0;
  bool left_out = false;
};

class Deriver {
 public:
  Deriver(const Mechanism& mechanism, const DeriveOptions& options, Notation notation)
      : mechanism_(mechanism),
        options_(options),
        form_(closed_form(mechanism)),
        names_(mechanism, form_),
        angles_(mechanism),
        formatter_(names_, joint_count(mechanism), notation, options.digits, mechanism.angles),
        entries_(entry_names(mechanism, formatter_)) {}

  DerivedModel run() {
    add_conventions();
    add_joints();
    add_coupled_joints();
    add_inertia();
    if (model_.has_quasi_velocities) {
      add_velocity_terms();
    } else {
      add_christoffel_symbols();
    }
    for (int i = 0; i < n(); ++i) {
      g_.push_back(readable(form_.g[at(i)]));
      model_.gravity.push_back(line("g" + index({i}), g_.back(), GroupBy::motion));
    }
    for (int i = 0; i < n(); ++i) add_equation(i);
    add_notes();
    return std::move(model_);
  }

 private:
  int n() const { return mechanism_.size(); }
  std::string index(const std::vector<int>& entries) const { return formatter_.subscript(entries, n()); }

  void add_conventions() {
    model_.has_quasi_velocities = mechanism_.has_quasi_velocities();
    if (!model_.has_quasi_velocities) return;
    formatter_.begin_with_positive_terms();
    model_.entries = entries_;
    SumFormatter plain(names_, joint_count(mechanism_), Notation::text, options_.digits);
    model_.conventions = motion_conventions(mechanism_, entry_names(mechanism_, plain));
  }

  Readable readable(const Number& expression) const {
    constexpr int kLargestReduction = 4;  // rewriting angles seldom saves more than this factor
    const int terms = GiNaC::is_a<GiNaC::add>(expression) ? static_cast<int>(expression.nops()) : 1;
    if (terms > kLargestReduction * options_.max_terms) return {{}, terms, true};
    ReadableSum sum = angles_.rewritten(names_.readable(expression));
    const int left = static_cast<int>(sum.size());
    return {left > options_.max_terms ? ReadableSum{} : std::move(sum), left, left > options_.max_terms};
  }

  static std::string left_out_text(int terms) { return fmt::format("({} terms, left out)", terms); }

  DerivedLine line(const std::string& name, const Readable& value, GroupBy group_by) {
    if (value.left_out) return {name, left_out_text(value.terms), value.terms, true};
    return {name, formatter_.text(value.sum, group_by), value.terms, false};
  }

  void add_joints() {
    for (int i = mechanism_.base_bodies(); i < n(); ++i) {
      const Body& body = mechanism_.joint(i);
      const int joint = form_.joints[at(i)];
      if (body.spherical == 1) {
        model_.joints.push_back({quaternion_of(joint), joint_name(body) + " (spherical)", 0, false});
      }
      if (body.spherical > 0) continue;
      const bool slides = (body.prismatic || moves_a_slide(joint)) && !formatter_.long_names();
      const std::string type = body.prismatic ? "prismatic" : body.continuous ? "continuous" : "revolute";
      model_.joints.push_back(
          {formatter_.coordinate("q", joint) + (slides ? " = " + formatter_.coordinate("d", joint) : ""),
           fmt::format("{} ({})", body.joint, type), 0, false});
    }
  }

  // "w_2, x_2, y_2, z_2".
  std::string quaternion_of(int joint) const {
    const std::vector<std::string> all = quaternion_names(mechanism_);
    std::vector<std::string> own;
    const std::string number = "_" + std::to_string(joint + 1);
    for (const std::string& name : all) {
      if (!name.ends_with(number)) continue;
      own.push_back(formatter_.notation() == Notation::latex ? latex_name(name) : name);
    }
    return fmt::format("{}", fmt::join(own, ", "));
  }

  // Whether a prismatic joint follows coordinate k.
  bool moves_a_slide(int k) const {
    for (std::size_t i = 0; i < mechanism_.coupling.size(); ++i) {
      if (mechanism_.bodies[i].prismatic && !vanishes(mechanism_.coupling[i][at(k)])) return true;
    }
    return false;
  }

  void add_coupled_joints() {
    const auto coordinate = [this](int k) { return formatter_.coordinate("q", k); };
    model_.coupled = coupled_joint_texts(mechanism_, coordinate);
    for (const std::string& text : tendon_texts(mechanism_, coordinate)) model_.coupled.push_back(text);
  }

  void add_inertia() {
    b_.assign(at(n()), {});
    for (int i = 0; i < n(); ++i) {
      for (int j = 0; j < n(); ++j) {
        b_[at(i)].push_back(j < i ? b_[at(j)][at(i)] : readable(form_.B[at(i)][at(j)]));
        if (j < i) continue;
        const std::string name = "b" + index({i, j});
        model_.inertia.push_back(
            line(i == j ? name : name + " = b" + index({j, i}), b_[at(i)].back(), GroupBy::parameters));
      }
    }
  }

  static ReadableSum negated(ReadableSum sum) {
    for (auto& term : sum) term.second = -term.second;
    return sum;
  }

  // Adds all symbols with j <= k that are not zero, in order; symbols that share a value, up to sign, get one name.
  void add_christoffel_symbols() {
    std::map<ReadableSum, int> uses;  // uses of a value in the form in which it first occurs
    c_.assign(at(n()), {});
    const auto known = [&uses](const ReadableSum& sum) {
      const auto same = uses.find(sum);
      return same != uses.end() ? same : uses.find(negated(sum));
    };
    std::vector<const ReadableSum*> in_order;
    for (int i = 0; i < n(); ++i) {
      for (int j = 0; j < n(); ++j) {
        for (int k = j; k < n(); ++k) {
          const Readable& c = c_[at(i)][{j, k}] = readable(form_.christoffel(i, j, k));
          if (c.left_out || c.sum.empty()) continue;
          const auto same = known(c.sum);
          if (same != uses.end()) {
            ++same->second;
          } else {
            in_order.push_back(&uses.emplace(c.sum, 1).first->first);
          }
        }
      }
    }
    std::erase_if(in_order, [&](const ReadableSum* sum) { return uses[*sum] < 2; });
    std::map<ReadableSum, std::string> names;
    for (std::size_t k = 0; k < in_order.size(); ++k) {
      const std::string name = shared_name() + (in_order.size() == 1 ? "" : index({static_cast<int>(k)}));
      names[*in_order[k]] = name;
      const int terms = static_cast<int>(in_order[k]->size());
      model_.shared.push_back({name, formatter_.text(*in_order[k], GroupBy::parameters), terms, false});
    }
    for (int i = 0; i < n(); ++i) {
      for (int j = 0; j < n(); ++j) {
        for (int k = j; k < n(); ++k) add_christoffel_line(i, j, k, names);
      }
    }
  }

  void add_christoffel_line(int i, int j, int k, const std::map<ReadableSum, std::string>& names) {
    const Readable& c = c_[at(i)][{j, k}];
    if (c.sum.empty() && !c.left_out) return;
    std::string name = "c" + index({i, j, k});
    if (j != k) name += " = c" + index({i, k, j});
    DerivedLine result = line(name, c, GroupBy::parameters);
    if (const auto same = names.find(c.sum); same != names.end()) {
      result.text = same->second;
    } else if (const auto opposite = names.find(negated(c.sum)); opposite != names.end()) {
      result.text = "-" + opposite->second;
    }
    model_.christoffel.push_back(std::move(result));
  }

  // The name of shared values: "h", as in 7.3.2, unless the robot has such a symbol.
  std::string shared_name() const {
    std::string name = "h";
    const auto taken = [&](const std::string& symbol) { return symbol == name || symbol.rfind(name + "_", 0) == 0; };
    while (std::any_of(names_.all().begin(), names_.all().end(), taken)) name += "h";
    return name;
  }

  // Adds all coefficients h_kij that are not zero; a sum that is that of an earlier one, up to sign, refers to it.
  void add_velocity_terms() {
    const std::string letter = shared_name();
    std::map<ReadableSum, std::string> known;
    for (int k = 0; k < n(); ++k) {
      h_.emplace_back();
      for (const auto& [entries, coefficient] : form_.h[at(k)]) {
        const auto [i, j] = entries;
        const Readable& h = h_.back()[entries] = readable(coefficient);
        DerivedLine result = line(letter + index({k, i, j}), h, GroupBy::parameters);
        if (const auto same = known.find(h.sum); same != known.end()) {
          result.text = same->second;
        } else if (const auto opposite = known.find(negated(h.sum)); opposite != known.end()) {
          result.text = "-" + opposite->second;
        } else if (h.sum.size() > 1) {
          known[h.sum] = result.name;
        }
        model_.velocity_terms.push_back(std::move(result));
      }
    }
  }

  // Adds the equation Σ b_ij qdd_j + Σ c_ijj qd_j² + Σ 2 c_ijk qd_j qd_k + friction + springs + g_i = tau_i; with
  // quasi-velocities Σ h_ijk v_j v_k instead of the Christoffel symbols.
  void add_equation(int i) {
    std::vector<SignedTerm> pieces;
    int terms = 0;
    bool complete = true;
    const auto add = [&](const Readable& value, int factor, const std::string& suffix, GroupBy group_by) {
      terms += value.terms;
      complete = complete && !value.left_out;
      if (value.sum.empty()) return;
      ReadableSum sum = value.sum;
      for (auto& term : sum) term.second *= factor;
      const std::vector<SignedTerm> summands = formatter_.pieces(sum, group_by);
      if (suffix.empty()) {
        pieces.insert(pieces.end(), summands.begin(), summands.end());
      } else {
        pieces.push_back(SumFormatter::times(summands, suffix));
      }
    };
    for (int j = 0; j < n(); ++j) add(b_[at(i)][at(j)], 1, entries_[at(j)].acceleration, GroupBy::parameters);
    const bool has_symbols = !model_.has_quasi_velocities;
    for (const auto& [entries, c] : has_symbols ? c_[at(i)] : h_[at(i)]) {
      const auto [j, k] = entries;
      const std::string first = entries_[at(j)].velocity;
      const std::string rates = j == k ? first + "^2" : first + " " + entries_[at(k)].velocity;
      add(c, has_symbols && j != k ? 2 : 1, rates, GroupBy::parameters);
    }
    for (const auto& [factor, friction] : friction_of(i)) add(readable(friction), 1, factor, GroupBy::parameters);
    for (const auto& [factor, spring] : springs_of(i)) add(readable(spring), 1, factor, GroupBy::parameters);
    add(g_[at(i)], 1, "", GroupBy::motion);
    const bool left_out = !complete || terms > options_.max_terms;
    model_.equations.push_back(
        {entries_[at(i)].torque, left_out ? left_out_text(terms) : SumFormatter::joined(pieces), terms, left_out});
  }

  // The friction terms of equation i: functions of velocity, each with its coefficient.
  std::vector<std::pair<std::string, Number>> friction_of(int i) {
    if (!mechanism_.is_coupled()) {
      const Body& body = mechanism_.joint(i);
      const std::string& rate = entries_[at(i)].velocity;
      std::vector<std::pair<std::string, Number>> terms = {{rate, body.viscous}};
      add_dry_friction(body, rate, 1, terms);
      return terms;
    }
    std::vector<std::pair<std::string, Number>> terms;
    const Rows A = mechanism_.rate_coupling();
    for (int k = 0; k < n(); ++k) {
      Number viscous = 0;
      for (std::size_t r = 0; r < A.size(); ++r) viscous += A[r][at(i)] * A[r][at(k)] * mechanism_.bodies[r].viscous;
      terms.emplace_back(entries_[at(k)].velocity, viscous);
    }
    for (std::size_t r = 0; r < A.size(); ++r) {
      add_dry_friction(mechanism_.bodies[r], rate_text(A[r]), A[r][at(i)], terms);
    }
    return terms;
  }

  // Adds the terms of a joint's dry friction, times a factor.
  void add_dry_friction(const Body& body, const std::string& rate, const Number& factor,
                        std::vector<std::pair<std::string, Number>>& terms) {
    const DryFriction& dry = body.dry;
    const std::string s = direction_of(dry, rate), still = dry.is_smooth() ? tanh_of(value_text(dry.offset), dry) : "";
    terms.emplace_back(vanishes(dry.at_rest) ? s : "(" + s + " - " + still + ")", factor * body.coulomb);
    if (dry.has_excess()) {
      const std::string ratio = in_brackets(rate) + "/" + value_text(dry.stribeck_speed);
      terms.emplace_back(s + "/(1 + (" + ratio + ")^2)", factor * dry.excess);
    }
    terms.emplace_back(s + "^2", factor * dry.asymmetry);
  }

  std::string direction_of(const DryFriction& dry, const std::string& rate) {
    if (!dry.is_smooth()) return sign_of(rate);
    return tanh_of(vanishes(dry.offset) ? rate : rate + " + " + value_text(dry.offset), dry);
  }

  std::string tanh_of(const std::string& shifted, const DryFriction& dry) {
    const char* const name = formatter_.notation() == Notation::latex ? "\\tanh(" : "tanh(";
    return name + in_brackets(shifted) + "/" + value_text(dry.speed) + ")";
  }

  std::string value_text(const Number& value) {
    return in_brackets(formatter_.text(readable(value).sum, GroupBy::parameters));
  }

  // In brackets, if it is more than one word.
  static std::string in_brackets(const std::string& text) {
    return text.find(' ') == std::string::npos ? text : "(" + text + ")";
  }

  // The terms of springs of equation i: functions of position, each with its coefficient.
  std::vector<std::pair<std::string, Number>> springs_of(int i) {
    std::vector<std::pair<std::string, Number>> terms;
    std::vector<Number> stiffness(at(n()), 0);
    Number rest = 0;
    for (int r = 0; r < mechanism_.body_count(); ++r) {
      const Body& body = mechanism_.body(r);
      const auto factor = [&](int k) { return mechanism_.rate_factor(r, k); };
      for (int k = 0; k < n(); ++k) stiffness[at(k)] += factor(i) * factor(k) * body.stiffness;
      rest -= factor(i) * body.stiffness * body.spring_reference;
    }
    for (int k = 0; k < n(); ++k) {
      if (vanishes(stiffness[at(k)])) continue;
      terms.emplace_back(formatter_.coordinate("q", form_.joints[at(k)]), stiffness[at(k)]);
    }
    if (!vanishes(rest)) terms.emplace_back("", rest);
    return terms;
  }

  // A joint's rate as text: "qd_2 - qd_1".
  std::string rate_text(const std::vector<Number>& factors) {
    std::vector<SignedTerm> pieces;
    for (std::size_t k = 0; k < factors.size(); ++k) {
      if (vanishes(factors[k])) continue;
      const bool negative = nearest_double(factors[k]) < 0;
      const Number magnitude = negative ? -factors[k] : factors[k];
      const std::string times = magnitude.is_equal(1) ? "" : formatter_.number(to_rational(magnitude), true) + " ";
      pieces.push_back({negative, times + entries_[k].velocity});
    }
    return SumFormatter::joined(pieces);
  }

  std::string sign_of(const std::string& rate) const {
    return rate.front() == '\\' ? "\\operatorname{sgn}(" + rate + ")" : "sgn(" + rate + ")";
  }

  std::string rounding_note() const {
    if (options_.digits != kExactDigits) return fmt::format("numbers are rounded to {} digits", options_.digits);
    return fmt::format(
        "numbers that end in ... are rounded to {} digits: they have no end within 60 places, and are no short "
        "fractions; "
        "all others are exact",
        kRoundedDigits);
  }

  bool has_friction_or_springs() const {
    return std::any_of(mechanism_.bodies.begin(), mechanism_.bodies.end(), [](const Body& body) {
      return !vanishes(body.viscous) || body.has_dry_friction() || !vanishes(body.stiffness);
    });
  }

  void add_notes_on_names() {
    int turns = 0;
    for (int i = 0; i < mechanism_.body_count(); ++i) {
      turns += mechanism_.bodies[at(i)].prismatic || mechanism_.is_around_pose(i) ? 0 : 1;
    }
    const bool is_short = turns > 0 && !formatter_.long_names();
    if (model_.has_quasi_velocities) {
      if (is_short) model_.notes.emplace_back("c_1 = cos(q_1), s_1 = sin(q_1), c_12 = cos(q_1 + q_2)");
      model_.notes.emplace_back(
          "there are no Christoffel symbols: they belong to coordinates, and v is not the derivative of any; the terms "
          "of Boltzmann and Hamel are part of h");
      if (has_friction_or_springs()) {
        model_.notes.emplace_back("the equations of motion also have the friction and the springs of joints");
      }
    } else if (is_short) {
      model_.notes.emplace_back(
          "c_1 = cos(q_1), s_1 = sin(q_1), c_12 = cos(q_1 + q_2); c_ijk to the left of = is a "
          "Christoffel symbol");
    }
  }

  void add_notes() {
    add_notes_on_names();
    if (formatter_.rounded()) model_.notes.push_back(rounding_note());
    int count = 0, terms = 0;
    for (const auto* lines :
         {&model_.inertia, &model_.christoffel, &model_.velocity_terms, &model_.gravity, &model_.equations}) {
      for (const DerivedLine& line : *lines) {
        count += line.left_out ? 1 : 0;
        terms += line.left_out ? line.terms : 0;
      }
    }
    if (count > 0) {
      model_.notes.push_back(
          fmt::format("{} expressions with {} terms in all are left out: they have more than {} each", count, terms,
                      options_.max_terms));
    }
  }

  const Mechanism& mechanism_;
  const DeriveOptions& options_;
  ClosedForm form_;
  FactorNames names_;
  AngleRewriter angles_;
  SumFormatter formatter_;
  std::vector<EntryNames> entries_;
  DerivedModel model_;
  std::vector<std::vector<Readable>> b_;
  std::vector<std::map<std::pair<int, int>, Readable>> c_, h_;
  std::vector<Readable> g_;
};

}  // namespace

DerivedModel derive_model(const Mechanism& mechanism, const DeriveOptions& options, Notation notation) {
  refuse_long_chains(mechanism);
  return Deriver(mechanism, options, notation).run();
}

}  // namespace flatdyn
