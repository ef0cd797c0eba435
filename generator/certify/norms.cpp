// SPDX-License-Identifier: GPL-2.0-or-later
#include "certify/norms.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

constexpr const char* kMayOverflow = "it may overflow";

using Form = std::vector<std::pair<int, Rational>>;

double size_of(const Rational& x) { return std::abs(x.convert_to<double>()) * kUpward; }

Form times(Form form, const Rational& c) {
  if (c == 0) return {};
  for (auto& [atom, coefficient] : form) coefficient *= c;
  return form;
}

// a + c b.
Form sum(const Form& a, const Rational& c, const Form& b) {
  Form result;
  result.reserve(a.size() + b.size());
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() || j != b.end()) {
    if (j == b.end() || (i != a.end() && i->first < j->first)) {
      result.push_back(*i++);
    } else if (i == a.end() || j->first < i->first) {
      result.emplace_back(j->first, c * j->second);
      ++j;
    } else {
      Rational total = i->second + c * j->second;
      if (total != 0) result.emplace_back(i->first, std::move(total));
      ++i, ++j;
    }
  }
  return result;
}

bool is_number(const Form& form) { return form.empty() || (form.size() == 1 && form[0].first < 0); }

bool is_opposite(const Form& a, const Form& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.first == y.first && x.second == -y.second; });
}

}  // namespace

Norms::Norms(const StraightLine& lines, int executed, RoundingModel model, InputLimits limits)
    : lines_(lines), executed_(executed), model_(std::move(model)), limits_(std::move(limits)) {}

std::size_t Norms::HashOfVector::operator()(const Vector& v) const {
  std::size_t hash = v.size();
  const auto mix = [&hash](std::size_t x) { hash = (hash ^ x) * 0x9e3779b97f4a7c15u + (hash >> 29); };
  for (const Form& form : v) {
    mix(form.size());
    for (const auto& [atom, coefficient] : form) {
      mix(static_cast<std::size_t>(atom + 1));
      mix(std::hash<double>()(coefficient.convert_to<double>()));
    }
  }
  return hash;
}

// Sign changes are exact, and products with a power of two that is at least 1.
bool Norms::is_rounded(int k) const {
  const Operation& operation = lines_[k];
  if (k >= executed_) return false;
  if (operation.step == Step::add || operation.step == Step::subtract) return true;
  if (operation.step != Step::multiply) return false;
  const auto is_power = [this](int factor) {
    int exponent = 0;
    const double value = std::abs(lines_[factor].value);
    return lines_[factor].step == Step::constant && value >= 1 && std::frexp(value, &exponent) == 0.5;
  };
  return !is_power(operation.a) && !is_power(operation.b);
}

const Norms::Turned* Norms::turned(int atom) const {
  const auto found = turned_.find(atom);
  return found == turned_.end() ? nullptr : &found->second;
}

const Norms::Expansion& Norms::expansion(int k) {
  const auto known = expansions_.find(k);
  if (known != expansions_.end()) return known->second;
  Expansion result = unrounded(k);
  if (is_rounded(k)) {
    result.before_rounding = rounded_up(norm({result.form}) + result.slack);
    if (!(result.before_rounding <= model_.format.most)) throw Failure(ExitCode::unsupported, kMayOverflow);
    result.own_error = model_.format.half_ulp(result.before_rounding);
  }
  result.slack += result.own_error;
  return expansions_.emplace(k, std::move(result)).first->second;
}

Norms::Expansion Norms::unrounded(int k) {
  const Operation& operation = lines_[k];
  switch (operation.step) {
    case Step::constant: {
      Expansion result;
      const double value = k < executed_ ? model_.format.rounded(operation.value) : operation.value;
      if (!std::isfinite(value)) throw Failure(ExitCode::unsupported, kMayOverflow);
      if (value != 0) result.form = {{kOne, Rational(value)}};
      if (k < executed_) result.own_error = model_.constant_error(operation.value);
      return result;
    }
    case Step::sine:
    case Step::cosine:
      turned_[k] = {operation.input.index, operation.step == Step::cosine, kOne};
      // A sine differs from that of another angle by less than the angles do.
      return {{{k, 1}}, 0, 0, model_.sine_error + (operation.a < 0 ? 0 : expansion(operation.a).slack)};
    case Step::negate: {
      const Expansion& of = expansion(operation.a);
      return {times(of.form, -1), of.slack, 0, 0};
    }
    case Step::add:
    case Step::subtract: {
      const Expansion a = expansion(operation.a);
      const Expansion& b = expansion(operation.b);
      return {sum(a.form, operation.step == Step::add ? 1 : -1, b.form), a.slack + b.slack, 0, 0};
    }
    case Step::multiply:
      return product(k);
    case Step::divide:
      throw Failure(ExitCode::unsupported, "it divides", "certify bounds sums and products only");
    case Step::sqrt:
      throw Failure(ExitCode::unsupported, "it takes a square root", "certify bounds sums and products only");
    case Step::sign:
      if (expansion(operation.a).slack > 0) {
        throw Failure(ExitCode::unsupported, "it takes the sign of a rounded value");
      }
      break;
    case Step::input:
      break;
  }
  return {{{k, 1}}, 0, 0, 0};
}

Norms::Expansion Norms::scaled(const Rational& c, double error_of_c, int k) {
  const Expansion of = expansion(k);
  const double error = error_of_c > 0 ? error_of_c * largest(k) : 0;
  return {times(of.form, c), size_of(c) * of.slack + error, 0, 0};
}

// With a number; with a sine or cosine; of two unknowns.
Norms::Expansion Norms::product(int k) {
  for (const auto& [x, y] : {std::pair(lines_[k].a, lines_[k].b), std::pair(lines_[k].b, lines_[k].a)}) {
    const Expansion of_x = expansion(x);
    if (is_number(of_x.form)) return scaled(of_x.form.empty() ? Rational(0) : of_x.form[0].second, of_x.slack, y);
  }
  for (const auto& [x, y] : {std::pair(lines_[k].a, lines_[k].b), std::pair(lines_[k].b, lines_[k].a)}) {
    const Expansion of_x = expansion(x);
    const Turned* turn = of_x.form.size() == 1 ? turned(of_x.form[0].first) : nullptr;
    if (turn == nullptr || turn->factor != kOne) continue;
    turned_[k] = {turn->joint, turn->is_cosine, y};
    return {{{k, of_x.form[0].second}}, of_x.slack * largest(y), 0, 0};
  }
  return {{{k, 1}}, 0, 0, 0};
}

double Norms::largest(int k) {
  if (k == kOne) return 1;
  const auto known = largest_.find(k);
  if (known != largest_.end()) return known->second;
  const Expansion& of = expansion(k);
  const double size = is_rounded(k) ? of.before_rounding + of.own_error : norm({of.form}) + of.slack;
  return largest_[k] = size * kUpward;
}

Norms::Form Norms::written_out(const std::vector<std::pair<int, Rational>>& terms, double& slack) {
  Form result;
  for (const auto& [k, coefficient] : terms) {
    if (k == kOne) {
      result = sum(result, coefficient, {{kOne, 1}});
      continue;
    }
    const Expansion& of = expansion(k);
    result = sum(result, coefficient, of.form);
    slack += size_of(coefficient) * of.slack;
  }
  return result;
}

// The same vector in a form in which it is found again: entries without zeros, first coefficients positive, sorted.
double Norms::norm(Vector v) {
  std::erase_if(v, [](const Form& form) { return form.empty(); });
  if (v.empty()) return 0;
  for (Form& form : v) {
    if (form[0].second < 0) form = times(std::move(form), -1);
  }
  std::sort(v.begin(), v.end());
  const auto known = known_.find(v);
  if (known != known_.end()) return known->second;
  const double result = norm_of_canonical(v);
  known_.emplace(std::move(v), result);
  return result;
}

double Norms::norm_of_canonical(const Vector& v) {
  int latest = kOne;
  for (const Form& form : v) {
    for (const auto& [atom, coefficient] : form) {
      const bool is_product = atom != kOne && (turned(atom) != nullptr || lines_[atom].step == Step::multiply);
      if (is_product) latest = std::max(latest, atom);
    }
  }
  if (latest == kOne) return norm_of_inputs(v);
  if (const Turned* turn = turned(latest)) return norm_by_rotation(v, turn->joint);
  const int a = lines_[latest].a, b = lines_[latest].b;
  const double by_a = norm_by_product(v, a);
  return a == b ? by_a : std::min(by_a, norm_by_product(v, b));
}

double Norms::norm_of_inputs(const Vector& v) const {
  double squares = 0;
  for (const Form& form : v) {
    double entry = 0;
    for (const auto& [atom, coefficient] : form) {
      const bool is_input = atom != kOne && lines_[atom].step == Step::input;
      entry += size_of(coefficient) * (is_input ? limits_(lines_[atom].input) : 1);
    }
    squares += entry * entry;
  }
  return std::sqrt(squares) * kUpward;
}

double Norms::norm_by_rotation(const Vector& v, int joint) {
  Split split;
  std::vector<std::pair<Form, Form>> turning;  // factors of the cosine and of the sine
  double slack = 0;
  for (const Form& form : v) {
    Form cosine, sine, rest;
    for (const auto& [atom, coefficient] : form) {
      const Turned* turn = turned(atom);
      if (turn == nullptr || turn->joint != joint) {
        rest.emplace_back(atom, coefficient);
      } else {
        (turn->is_cosine ? cosine : sine).emplace_back(turn->factor, coefficient);
      }
    }
    if (cosine.empty() && sine.empty()) {
      split.kept.push_back(std::move(rest));
    } else {
      turning.emplace_back(written_out(cosine, slack), written_out(sine, slack));
      split.rest.push_back(std::move(rest));
    }
  }
  std::set<std::size_t> paired;
  for (std::size_t i = 0; i < turning.size(); ++i) {
    if (paired.count(i) != 0) continue;
    const auto& [A, B] = turning[i];
    for (std::size_t j = i + 1; j < turning.size(); ++j) {
      const auto& [C, D] = turning[j];
      const bool is_turned = (is_opposite(C, B) && D == A) || (C == B && is_opposite(D, A));
      if (paired.count(j) != 0 || !is_turned) continue;
      paired.insert(j);
      break;
    }
    split.kept.push_back(A);
    split.kept.push_back(B);
  }
  return (norm(std::move(split.kept)) + norm(std::move(split.rest)) + slack) * kUpward;
}

double Norms::norm_by_product(const Vector& v, int factor) {
  Split split;
  Vector cofactors;
  double slack = 0;
  for (const Form& form : v) {
    Form others, rest;
    for (const auto& [atom, coefficient] : form) {
      const bool is_product = atom != kOne && turned(atom) == nullptr && lines_[atom].step == Step::multiply;
      if (is_product && (lines_[atom].a == factor || lines_[atom].b == factor)) {
        others.emplace_back(lines_[atom].a == factor ? lines_[atom].b : lines_[atom].a, coefficient);
      } else {
        rest.emplace_back(atom, coefficient);
      }
    }
    cofactors.push_back(written_out(others, slack));
    split.rest.push_back(std::move(rest));
  }
  return (largest(factor) * (norm(std::move(cofactors)) + slack) + norm(std::move(split.rest))) * kUpward;
}

}  // namespace flatdyn
