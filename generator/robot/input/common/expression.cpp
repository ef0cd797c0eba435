// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/expression.hpp"

#include <algorithm>

#include "base/diagnostics/characters.hpp"
#include "base/diagnostics/diagnostics.hpp"
#include "robot/input/common/exact_root.hpp"
#include "robot/model/exact_sign.hpp"

namespace flatdyn {

namespace {

constexpr std::size_t kLongestText = 10000;
constexpr int kDeepestNesting = 100;
constexpr int kLargestPower = 1000;
constexpr int kLargestSymbolicExponent = 20;  // the closed form expands powers
constexpr int kMostBits = 8192;               // of a numerator or denominator
constexpr double kLargestDegree = 400;        // of a power of powers
constexpr double kMostTerms = 40;             // of a sum, once all is multiplied out

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The size of an expression in symbols, multiplied out. A few nested powers are enough to fill any memory.
struct Growth {
  double terms = 1;   // at most
  double degree = 0;  // of the highest power
  double bits = 0;    // of the longest number
};

double bits_of(const GiNaC::numeric& number) {
  return std::max(number.numer().int_length(), number.denom().int_length());
}

Growth growth_of(const Number& value);

// n of m terms: C(m + n - 1, n).
Growth growth_of_power(const Growth& base, const Number& exponent) {
  const double times = GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(exponent)).to_double();
  double terms = 1;
  for (double k = 1; k <= times && terms <= kMostTerms; ++k) terms *= (base.terms + k - 1) / k;
  const bool is_below = exponent.info(GiNaC::info_flags::negative);  // what stands below is not multiplied out
  return {is_below ? 1 : terms, base.degree * times, base.bits * times};
}

Growth growth_of(const Number& value) {
  if (GiNaC::is_a<GiNaC::numeric>(value)) return {1, 0, bits_of(GiNaC::ex_to<GiNaC::numeric>(value))};
  if (!has_symbols(value)) return {};
  if (GiNaC::is_a<GiNaC::symbol>(value)) return {1, 1, 0};
  if (GiNaC::is_a<GiNaC::power>(value)) return growth_of_power(growth_of(value.op(0)), value.op(1));
  const bool is_sum = GiNaC::is_a<GiNaC::add>(value);
  Growth all{is_sum ? 0.0 : 1.0, 0, 0};
  for (const Number& part : value) {
    const Growth growth = growth_of(part);
    all.terms = is_sum ? all.terms + growth.terms : all.terms * growth.terms;
    all.degree = is_sum ? std::max(all.degree, growth.degree) : all.degree + growth.degree;
    all.bits = std::max(all.bits, growth.bits);
  }
  return all;
}

class Parser {
 public:
  Parser(std::string_view text, const SymbolLookup& symbol) : text_(text), symbol_(symbol) {}

  Number parse() {
    if (text_.size() > kLongestText) throw ExpressionError("the expression is too long", 1);
    const Number value = sum();
    if (peek() != '\0') fail("an operator (+ - * / ^) is expected before " + rest());
    return is_zero(limited(value)) ? Number(0) : value;
  }

 private:
  // The next character that is no blank; '\0' at the end.
  char peek() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t')) ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }

  bool take(char c) {
    if (peek() != c || position_ >= text_.size()) return false;
    ++position_;
    return true;
  }

  std::string rest() const { return "\"" + std::string(text_.substr(position_, 12)) + "\""; }

  [[noreturn]] void fail(const std::string& message) const { throw ExpressionError(message, position_ + 1); }

  Number bounded(const Number& value) const {
    if (!is_rational(value)) return value;
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(value);
    if (number.numer().int_length() > kMostBits || number.denom().int_length() > kMostBits) {
      fail("the number is too large or too long");
    }
    return value;
  }

  std::optional<int> sign_in_expression(const Number& value) const {
    std::optional<int> sign;
    try {
      sign = sign_of(value);
    } catch (const Failure&) {
      fail("the expression has too many roots");
    }
    if (!sign && !has_symbols(value)) fail("the exponents together are too large");
    return sign;
  }

  bool is_zero(const Number& value) const {
    const std::optional<int> sign = sign_in_expression(value);
    return sign ? *sign == 0 : vanishes(value);
  }

  const Number& limited(const Number& value) const {
    if (!has_symbols(value)) return value;
    refuse(growth_of(value));
    return value;
  }

  void refuse(const Growth& growth) const {
    if (growth.bits > kMostBits) fail("the number is too large or too long");
    if (growth.degree > kLargestDegree) fail("the exponents together are too large");
    if (growth.terms > kMostTerms)
      fail("multiplied out, the expression has too many terms: give a part of it a symbol");
  }

  Number sum() {
    Number value = product();
    while (true) {
      if (take('+')) {
        value = bounded(value + product());
      } else if (take('-')) {
        value = bounded(value - product());
      } else {
        return value;
      }
    }
  }

  Number product() {
    Number value = factor();
    while (true) {
      if (take('*')) {
        if (peek() == '*') fail("\"**\" is no operator: powers are written with ^");
        value = bounded(value * factor());
      } else if (take('/')) {
        const Number divisor = factor();
        if (is_zero(limited(divisor))) fail("division by zero");
        value = bounded(value / divisor);
      } else {
        return value;
      }
    }
  }

  Number factor() {
    const Nesting nesting(*this);
    if (take('-')) return -factor();
    if (take('+')) return factor();
    return power();
  }

  Number power() {
    const Number base = primary();
    if (!take('^')) return base;
    const Number exponent = factor();
    if (!exponent.info(GiNaC::info_flags::integer)) fail("an exponent must be an integer (roots: sqrt(...))");
    const int bound = has_symbols(base) ? kLargestSymbolicExponent : kLargestPower;
    if (GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(exponent)) > bound) fail("the exponent is too large");
    if (has_symbols(base)) refuse(growth_of_power(growth_of(base), exponent));
    const bool is_of_zero = is_zero(base);
    if (is_of_zero && exponent.is_zero()) fail("0^0 has no value");
    if (is_of_zero && exponent.info(GiNaC::info_flags::negative)) fail("division by zero");
    return bounded(GiNaC::pow(base, exponent));
  }

  Number primary() {
    const char next = peek();
    if (next == '\0') fail("the expression ends where a number, a name or \"(\" is expected");
    if (take('(')) return closed(sum());
    if (is_digit(next) || next == '.') return decimal();
    if (is_letter(next)) return name();
    fail("a number, a name or \"(\" is expected before " + rest());
  }

  Number closed(const Number& dot) {
    if (!take(')')) fail("\")\" is missing");
    return dot;
  }

  // Digits with a point and an exponent; "2e" is 2 followed by a name, which is refused where the name begins.
  Number decimal() {
    const std::size_t begin = position_;
    while (position_ < text_.size() && (is_digit(text_[position_]) || text_[position_] == '.')) ++position_;
    if (exponent_follows()) {
      position_ += 2;
      while (position_ < text_.size() && is_digit(text_[position_])) ++position_;
    }
    const std::string_view digits = text_.substr(begin, position_ - begin);
    try {
      return exact_decimal(digits);
    } catch (const std::invalid_argument& error) {
      position_ = begin;
      fail("\"" + std::string(digits) + "\": " + error.what());
    }
  }

  // 'e' and a digit, or 'e', a sign and a digit.
  bool exponent_follows() const {
    const auto at = [this](std::size_t offset) {
      return position_ + offset < text_.size() ? text_[position_ + offset] : '\0';
    };
    if (at(0) != 'e' && at(0) != 'E') return false;
    return is_digit(at(1)) || ((at(1) == '+' || at(1) == '-') && is_digit(at(2)));
  }

  Number name() {
    const std::size_t begin = position_;
    while (position_ < text_.size() &&
           (is_letter(text_[position_]) || is_digit(text_[position_]) || text_[position_] == '_')) {
      ++position_;
    }
    const std::string_view name = text_.substr(begin, position_ - begin);
    if (peek() == '(') return function(name, begin);
    if (name == "pi") return GiNaC::Pi;
    if (name == "sqrt") fail("\"(\" is expected after sqrt");
    if (name == "nan" || name == "inf") {
      position_ = begin;
      fail("the value must be a finite number");
    }
    return symbol_(name, begin + 1);
  }

  Number function(std::string_view name, std::size_t begin) {
    if (name != "sqrt") {
      position_ = begin;
      fail("\"" + std::string(name) + "\" is no known function (there is sqrt)");
    }
    take('(');
    const Number argument = closed(sum());
    if (has_symbols(argument)) fail("sqrt() of a symbol is not supported: give the root a name of its own");
    const int sign = *sign_in_expression(argument);
    if (sign < 0) fail("sqrt() of a negative number");
    return sign == 0 ? Number(0) : exact_root(argument);
  }

  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kDeepestNesting) parser_.fail("the expression is nested too deeply");
    }
    ~Nesting() { --parser_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Parser& parser_;
  };

  std::string_view text_;
  const SymbolLookup& symbol_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace

Number parse_expression(std::string_view text, const SymbolLookup& symbol) { return Parser(text, symbol).parse(); }

}  // namespace flatdyn
