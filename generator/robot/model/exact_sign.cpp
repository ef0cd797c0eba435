// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/exact_sign.hpp"

#include <cln/cln.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/enclosing_interval.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {
namespace {

constexpr long kFirstBits = 128;
constexpr long kBitsOfMostNumbers = 1024;  // what is smaller is probably 0
constexpr long kMostBits = 1L << 22;
constexpr std::size_t kMostRoots = 12;
constexpr std::size_t kMostTerms = 2000;  // of a polynomial that is squared

[[noreturn]] void fail_undecided(const Number& a) {
  constexpr std::size_t kShown = 60;
  std::ostringstream text;
  text << a;
  const std::string shown = text.str();
  throw Failure(FailureKind::unsupported,
                "whether this number is 0 is not decided, as it has too many roots: " + shown.substr(0, kShown) +
                    (shown.size() > kShown ? "..." : ""),
                "write it with fewer roots, or as a decimal");
}

// The exponent of a root or a power, numerator over denominator, if it is of a size that is computed.
struct Exponent {
  long above = 1;
  unsigned long below = 1;
};

std::optional<Exponent> exponent_of(const Number& power) {
  constexpr long kLargest = 1L << 40;
  if (!is_rational(power.op(1))) return std::nullopt;
  const Rational exponent = to_rational(power.op(1));
  if (abs(exponent) > kLargest || denominator(exponent) > kLargest) return std::nullopt;
  return Exponent{numerator(exponent).get_si(), denominator(exponent).get_ui()};
}

// A root whose square is a polynomial in pi, as `pi`, and in the roots before it.
struct SquareRoot {
  GiNaC::symbol root;
  Number square;
};

// pi and roots as symbols, by which equations between them are polynomials.
class RootTower {
 public:
  // The numerator of a number that is written as a polynomial over another one; nothing if it has other functions.
  std::optional<Number> numerator_of(const Number& a) {
    const std::optional<Number> fraction = rewritten(a);
    if (!fraction) return std::nullopt;
    return fraction->numer().expand();
  }

  // A polynomial P = A + B r in its last root r is 0 if A² - B² r² is 0, and it is not its conjugate, A - B r, that
  // vanishes: then P is 2 A. Powers of pi are independent.
  bool is_zero(const Number& polynomial, std::size_t roots) {
    if (polynomial.is_zero()) return true;
    while (roots > 0 && !polynomial.has(roots_[roots - 1].root)) --roots;
    if (roots == 0) return false;
    const auto& [root, square] = roots_[roots - 1];
    Number even = 0, odd = 0;
    for (int k = 0; k <= polynomial.degree(root); ++k) {
      (k % 2 == 0 ? even : odd) += polynomial.coeff(root, k) * GiNaC::pow(square, k / 2);
    }
    even = even.expand();
    odd = odd.expand();
    if (odd.is_zero()) return is_zero(even, roots - 1);
    if (std::max(even.nops(), odd.nops()) > kMostTerms) fail_undecided(polynomial);
    if (!is_zero((even * even - odd * odd * square).expand(), roots - 1)) return false;
    return is_zero(even, roots - 1) || is_nearer_to_zero(even + odd * root, 2 * even);
  }

  std::size_t size() const { return roots_.size(); }

  const GiNaC::symbol& pi() const { return pi_; }
  const std::vector<SquareRoot>& roots() const { return roots_; }

 private:
  std::optional<Number> rewritten(const Number& a);
  std::optional<Number> rewritten_power(const Number& a);
  std::optional<Number> root_of(const Number& a);
  // The polynomial is either 0 or the other one, which is not 0.
  bool is_nearer_to_zero(const Number& polynomial, const Number& other) const;
  int sign_of_polynomial(const Number& polynomial);

  GiNaC::symbol pi_{"pi"};
  std::vector<SquareRoot> roots_;
};

// Evaluates numbers, and polynomials in the symbols of a tower.
class Evaluation {
 public:
  explicit Evaluation(long bits, const RootTower* tower = nullptr) : bits_(bits), tower_(tower) {
    if (tower == nullptr) return;
    for (const SquareRoot& each : tower->roots()) {
      const std::optional<EnclosingInterval> square = value(each.square);
      roots_.push_back(square ? square->root(2) : std::nullopt);
    }
  }

  std::optional<EnclosingInterval> value(const Number& a) const {
    if (GiNaC::is_a<GiNaC::numeric>(a)) return of_numeric(GiNaC::ex_to<GiNaC::numeric>(a));
    if (a.is_equal(GiNaC::Pi)) return EnclosingInterval::of_pi(bits_);
    if (GiNaC::is_a<GiNaC::symbol>(a)) return of_symbol(a);
    if (GiNaC::is_a<GiNaC::power>(a)) return of_power(a);
    const bool is_sum = GiNaC::is_a<GiNaC::add>(a);
    if (!is_sum && !GiNaC::is_a<GiNaC::mul>(a)) return std::nullopt;
    EnclosingInterval result = EnclosingInterval::of(is_sum ? 0 : 1, bits_);
    for (const Number& part : a) {
      const std::optional<EnclosingInterval> operand = value(part);
      if (!operand) return std::nullopt;
      result = is_sum ? result + *operand : result * *operand;
    }
    return result;
  }

  // 0 if it is not known.
  int sign(const Number& a) const {
    const std::optional<EnclosingInterval> interval = value(a);
    return interval ? interval->sign() : 0;
  }

 private:
  std::optional<EnclosingInterval> of_numeric(const GiNaC::numeric& number) const {
    if (!number.is_real()) return std::nullopt;
    const cln::cl_RA exact = cln::rational(cln::the<cln::cl_R>(number.to_cl_N()));
    return EnclosingInterval::of(to_rational(GiNaC::numeric(cln::cl_N(exact))), bits_);
  }

  std::optional<EnclosingInterval> of_symbol(const Number& symbol) const {
    if (tower_ == nullptr) return std::nullopt;
    if (symbol.is_equal(tower_->pi())) return EnclosingInterval::of_pi(bits_);
    for (std::size_t k = 0; k < roots_.size(); ++k) {
      if (symbol.is_equal(tower_->roots()[k].root)) return roots_[k];
    }
    return std::nullopt;
  }

  std::optional<EnclosingInterval> of_power(const Number& power) const {
    const std::optional<Exponent> exponent = exponent_of(power);
    std::optional<EnclosingInterval> base = exponent ? value(power.op(0)) : std::nullopt;
    if (base && exponent->below != 1) base = base->root(exponent->below);
    return base ? base->power(exponent->above) : std::nullopt;
  }

  long bits_;
  const RootTower* tower_;
  std::vector<std::optional<EnclosingInterval>> roots_;
};

// The number is not 0.
int sign_by_intervals(const Number& a, const RootTower* tower, long bits) {
  for (; bits <= kMostBits; bits *= 2) {
    if (const int sign = Evaluation(bits, tower).sign(a)) return sign;
  }
  fail_undecided(a);
}

bool RootTower::is_nearer_to_zero(const Number& polynomial, const Number& other) const {
  for (long bits = kFirstBits; bits <= kMostBits; bits *= 2) {
    const Evaluation at(bits, this);
    if (at.sign(polynomial) != 0) return false;
    if (at.sign(polynomial - other) != 0) return true;
  }
  fail_undecided(polynomial);
}

std::optional<Number> RootTower::rewritten(const Number& a) {
  if (is_rational(a)) return a;
  if (a.is_equal(GiNaC::Pi)) return pi_;
  if (GiNaC::is_a<GiNaC::power>(a)) return rewritten_power(a);
  const bool is_sum = GiNaC::is_a<GiNaC::add>(a);
  if (!is_sum && !GiNaC::is_a<GiNaC::mul>(a)) return std::nullopt;
  Number result = is_sum ? 0 : 1;
  for (const Number& part : a) {
    const std::optional<Number> operand = rewritten(part);
    if (!operand) return std::nullopt;
    result = is_sum ? result + *operand : result * *operand;
  }
  return result;
}

std::optional<Number> RootTower::rewritten_power(const Number& a) {
  const std::optional<Exponent> exponent = exponent_of(a);
  std::optional<Number> base = exponent ? rewritten(a.op(0)) : std::nullopt;
  for (unsigned long below = exponent ? exponent->below : 1; base && below > 1; below /= 2) {
    base = below % 2 == 0 ? root_of(*base) : std::nullopt;
  }
  if (!base) return std::nullopt;
  return GiNaC::pow(*base, GiNaC::numeric(exponent->above));
}

// sqrt(N/D) = ±sqrt(N D)/D, with D's sign.
std::optional<Number> RootTower::root_of(const Number& a) {
  const Number fraction = a.numer_denom();
  const Number below = fraction.op(1), square = (fraction.op(0) * below).expand();
  const Number factor = sign_of_polynomial(below) / below;
  for (const SquareRoot& each : roots_) {
    if (each.square.is_equal(square)) return factor * each.root;
  }
  if (roots_.size() == kMostRoots) fail_undecided(a);
  roots_.push_back({GiNaC::symbol("r" + std::to_string(roots_.size())), square});
  return factor * roots_.back().root;
}

int RootTower::sign_of_polynomial(const Number& polynomial) {
  return is_zero(polynomial.expand(), roots_.size()) ? 0 : sign_by_intervals(polynomial, this, kFirstBits);
}

std::optional<int> sign_near_zero(const Number& a) {
  if (a.expand().is_zero()) return 0;
  RootTower tower;
  const std::optional<Number> numerator = tower.numerator_of(a);
  if (!numerator) return std::nullopt;
  if (tower.is_zero(*numerator, tower.size())) return 0;
  return sign_by_intervals(a, nullptr, 2 * kBitsOfMostNumbers);
}

}  // namespace

std::optional<int> sign_of(const Number& a) {
  if (GiNaC::is_a<GiNaC::numeric>(a)) return GiNaC::ex_to<GiNaC::numeric>(a).csgn();
  if (has_symbols(a)) return std::nullopt;
  for (long bits = kFirstBits; bits <= kBitsOfMostNumbers; bits *= 2) {
    const std::optional<EnclosingInterval> interval = Evaluation(bits).value(a);
    if (interval && interval->sign() != 0) return interval->sign();
  }
  return sign_near_zero(a);
}

bool is_negative(const Number& a) { return sign_of(a).value_or(0) < 0; }

bool is_positive(const Number& a) { return sign_of(a).value_or(0) > 0; }

bool is_below(const Number& a, const Number& b) { return is_positive(b - a); }

Number absolute(const Number& a) { return is_negative(a) ? Number(-a) : a; }

}  // namespace flatdyn
