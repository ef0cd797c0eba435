// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/norms.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

constexpr double kMuchLess = 0.9;
constexpr const char* kMayOverflow = "it may overflow";

double product_of_sizes(double a, double b) {
  return a > 0 && b > 0 ? std::max(a * b * kRoundingMargin, Norms::kLeastSize) : 0;
}

std::optional<double> number_of(const std::vector<std::pair<int, double>>& form) {
  if (form.empty()) return 0;
  if (form.size() == 1 && form[0].first == Atoms::kOne) return form[0].second;
  return std::nullopt;
}

}  // namespace

Norms::Norms(const StraightLine& lines, int executed, RoundingModel model, InputLimits limits,
             const MotionRecogniser* motions, int effort)
    : lines_(lines),
      executed_(executed),
      model_(std::move(model)),
      limits_(std::move(limits)),
      motions_(motions),
      effort_(effort) {}

// Whether all terms are products of sines, few enough to be multiplied out.
bool Norms::is_purely_trigonometric(const Form& form) const {
  constexpr std::size_t kMost = 4;
  return form.size() <= kMost && std::all_of(form.begin(), form.end(), [this](const auto& term) {
           return atoms_.is_purely_trigonometric(term.first);
         });
}

double Norms::largest_of(int atom) {
  const auto known = largest_of_atoms_.find(atom);
  if (known != largest_of_atoms_.end()) return known->second;
  const Atom& of = atoms_[atom];
  double result = 1;
  switch (of.kind) {
    case Atom::Kind::one:
      break;
    case Atom::Kind::given:
      if (lines_[of.a].step == Step::input) result = limits_(lines_[of.a].input);
      if (lines_[of.a].is_sum_or_product()) result = largest(of.a);
      break;
    case Atom::Kind::result:
      result = largest(of.a);
      break;
    case Atom::Kind::turned:
      result = largest_of(of.a);
      break;
    case Atom::Kind::product:
      result = product_of_sizes(largest_of(of.a), largest_of(of.b));
      break;
  }
  return largest_of_atoms_[atom] = result;
}

Norms::Factor Norms::factor(int k) {
  const Expansion& of = expansion(k);
  if (of.form.size() == 1 && of.slack == 0) return {of.form[0].first, of.form[0].second};
  return {atoms_.result(k), 1};
}

// Adds c form to `to`, and to its slack what is lost by rounding coefficients.
void Norms::add(Expansion& to, double c, const Form& form) {
  constexpr double kCancelled = 0x1p-50;
  Form result;
  result.reserve(to.form.size() + form.size());
  auto i = to.form.begin();
  for (const auto& [atom, coefficient] : form) {
    while (i != to.form.end() && i->first < atom) result.push_back(*i++);
    const double added = c * coefficient;
    double total = added, lost = std::abs(std::fma(c, coefficient, -added));
    if (i != to.form.end() && i->first == atom) {
      total += i->second;
      const double part = total - added;  // Knuth's exact rounding error of a sum
      lost += std::abs((added - (total - part)) + (i->second - part));
      if (std::abs(total) <= kCancelled * std::abs(added)) lost += std::abs(std::exchange(total, 0));
      ++i;
    }
    if (total != 0) result.emplace_back(atom, total);
    if (lost > 0) to.slack += lost * largest_of(atom) * kRoundingMargin;
  }
  result.insert(result.end(), i, to.form.end());
  to.form = std::move(result);
}

// Whether the operation rounds. Sign changes are exact, products with a power of two that is at least 1, and those of
// fused multiply-adds.
bool Norms::is_rounded(int k) const {
  const Operation& operation = lines_[k];
  if (k >= executed_ || !operation.is_sum_or_product() || operation.is_exact) return false;
  if (operation.step != Step::multiply) return true;
  const auto is_power = [this](int factor) {
    int exponent = 0;
    const double value = std::abs(lines_[factor].value);
    return lines_[factor].step == Step::constant && value >= 1 && std::frexp(value, &exponent) == 0.5;
  };
  return !is_power(operation.a) && !is_power(operation.b);
}

const Norms::Expansion& Norms::expansion(int k) {
  const auto known = expansions_.find(k);
  if (known != expansions_.end()) return known->second;
  Expansion result = unrounded(k);
  if (lines_[k].is_sum_or_product()) bound(k, result);
  if (!result.has_all_errors) result.slack += result.own_error;
  return expansions_.emplace(k, std::move(result)).first->second;
}

// Bounds a result by its operation and by the motion that it computes. If the latter is much smaller, the result
// becomes an atom: its terms can then no longer cancel with others. If neither a rounding nor a motion requires a
// bound, none is set.
void Norms::bound(int k, Expansion& expansion) {
  const double of_motion = largest_of_motion(k);
  if (k >= executed_ && !std::isfinite(of_motion)) return;
  const double by_form = norm(expansion.form) + expansion.slack;
  const double by_operation = k < executed_ ? std::min(by_form, largest_by_operands(k)) : by_form;
  const double size = rounded_up(std::min(by_operation, of_motion), kBoundDigits);
  if (k < executed_ && !(size <= model_.format.most)) throw Failure(FailureKind::unsupported, kMayOverflow);
  if (is_rounded(k)) {
    expansion.before_rounding = size;
    expansion.own_error = model_.format.half_ulp(size);
  }
  if (of_motion > kMuchLess * by_operation) return;
  largest_[k] = (size + expansion.own_error) * kRoundingMargin;
  expansion.form = {{atoms_.given(k), 1}};
  expansion.slack = 0;
  expansion.has_all_errors = true;
}

// The bound of the motion that the operation computes; infinite if it computes none. The computed result differs from
// the motion by the effect of the operands' errors.
double Norms::largest_of_motion(int k) {
  if (motions_ == nullptr || motions_->group(k) < 0) return INFINITY;
  return std::max(motions_->largest(k) + deviation_before_rounding(k).error, kLeastSize);
}

Norms::Deviation Norms::deviation_before_rounding(int k) {
  const Deviation a = deviation(lines_[k].a), b = deviation(lines_[k].b);
  if (lines_[k].step != Step::multiply)
    return {(a.size + b.size) * kRoundingMargin, (a.error + b.error) * kRoundingMargin};
  return {product_of_sizes(a.size, b.size),
          (product_of_sizes(a.error, b.size) + product_of_sizes(a.size, b.error)) * kRoundingMargin};
}

const Norms::Deviation& Norms::deviation(int k) {
  const auto known = deviations_.find(k);
  if (known != deviations_.end()) return known->second;
  Deviation result;
  if (lines_[k].is_sum_or_product()) {
    result = deviation_before_rounding(k);
    if (motions_->group(k) >= 0) result.size = std::min(result.size, motions_->largest(k) + result.error);
    if (k < executed_) {
      const double own = expansion(k).own_error;
      result.size = std::min(result.size, largest(k)) + own;
      result.error += own;
    }
  } else if (lines_[k].step == Step::negate) {
    result = deviation(lines_[k].a);
  } else {
    result = {largest(k), expansion(k).own_error};
  }
  return deviations_[k] = {result.size * kRoundingMargin, result.error * kRoundingMargin};
}

double Norms::largest_by_operands(int k) {
  const double a = largest(lines_[k].a), b = largest(lines_[k].b);
  return lines_[k].step == Step::multiply ? product_of_sizes(a, b) : (a + b) * kRoundingMargin;
}

Norms::Expansion Norms::unrounded(int k) {
  const Operation& operation = lines_[k];
  switch (operation.step) {
    case Step::constant: {
      Expansion result;
      const double value = k < executed_ ? model_.format.rounded(operation.value) : operation.value;
      if (!std::isfinite(value)) throw Failure(FailureKind::unsupported, kMayOverflow);
      if (value != 0) result.form = {{Atoms::kOne, value}};
      if (k < executed_) result.own_error = model_.constant_error(operation.value);
      return result;
    }
    case Step::sine:
    case Step::cosine: {
      // The sines of two angles differ by less than the angles do.
      const double of_angle = operation.a < 0 ? 0 : expansion(operation.a).slack;
      const int sine = atoms_.sine(operation.input.index, operation.step == Step::cosine);
      return {{{sine, 1}}, 0, 0, model_.sine_error + of_angle};
    }
    case Step::negate:
      return scaled(-1, 0, operation.a);
    case Step::add:
    case Step::subtract: {
      Expansion result = scaled(1, 0, operation.a);
      const Expansion& b = expansion(operation.b);
      result.slack += b.slack;
      add(result, operation.step == Step::add ? 1 : -1, b.form);
      return result;
    }
    case Step::multiply:
      return product(k);
    case Step::divide:
    case Step::sqrt:
      throw Failure(FailureKind::unsupported, "it divides or takes a square root",
                    "certify bounds sums and products only");
    case Step::sign:
      if (expansion(operation.a).slack > 0 || expansion(operation.a).has_all_errors) {
        throw Failure(FailureKind::unsupported, "it takes the sign of a rounded value");
      }
      break;
    case Step::input:
      break;
  }
  return {{{atoms_.given(k), 1}}, 0, 0, 0};
}

Norms::Expansion Norms::scaled(double c, double error_of_c, int k) {
  const Expansion& of = expansion(k);
  Expansion result;
  result.slack = std::abs(c) * of.slack;
  if (error_of_c > 0) result.slack += error_of_c * largest(k);
  if (c != 0) add(result, c, of.form);
  return result;
}

// (c_0 + Σ c_i S_i) x = c_0 x + Σ c_i (S_i x), with products S_i of sines. x is expanded into its terms if both factors
// are sums of sines of different joints, without coefficients, as in the sine of a sum of angles.
Norms::Expansion Norms::distributed(const Expansion& sines, int k) {
  const Expansion& x = expansion(k);
  const Factor whole = factor(k);
  Expansion result;
  if (sines.slack > 0) result.slack = sines.slack * largest(k);
  for (const auto& term_of_sines : sines.form) {
    const int sine = term_of_sines.first;
    const double c = term_of_sines.second;
    const bool is_apart = is_purely_trigonometric(x.form) && std::abs(c) == 1 &&
                          std::all_of(x.form.begin(), x.form.end(), [&](const auto& term) {
                            return std::abs(term.second) == 1 && atoms_.have_no_joint_in_common(sine, term.first);
                          });
    if (sine == Atoms::kOne || is_apart) {
      result.slack += std::abs(c) * x.slack * kRoundingMargin;
      for (const auto& [atom, d] : x.form) add(result, c, {{atoms_.product(sine, atom), d}});
    } else {
      add(result, c, {{atoms_.product(sine, whole.atom), whole.coefficient}});
    }
  }
  return result;
}

// A product with a number, with sines, or of two unknowns.
Norms::Expansion Norms::product(int k) {
  const int a = lines_[k].a, b = lines_[k].b;
  for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
    const Expansion& of_x = expansion(x);
    if (const std::optional<double> number = number_of(of_x.form)) return scaled(*number, of_x.slack, y);
  }
  for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
    const Expansion& of_x = expansion(x);
    if (is_purely_trigonometric(of_x.form)) return distributed(of_x, y);
  }
  const Factor x = factor(a), y = factor(b);
  Expansion result;
  add(result, x.coefficient, {{atoms_.product(x.atom, y.atom), y.coefficient}});
  return result;
}

// A known bound takes effect at the first call only, since vectors are scaled by the bounds of their atoms.
double Norms::largest(int k, double known) {
  const auto kept = largest_.find(k);
  if (kept != largest_.end()) return std::min(kept->second, known);
  const Expansion& of = expansion(k);
  if (const auto found = largest_.find(k); found != largest_.end()) return std::min(found->second, known);
  const double size = is_rounded(k) ? of.before_rounding + of.own_error : norm(of.form) + of.slack;
  return largest_[k] = std::min(size * kRoundingMargin, known);
}

}  // namespace flatdyn
