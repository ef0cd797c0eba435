// SPDX-License-Identifier: GPL-2.0-or-later
#include "passes/share_sums.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include "passes/like_terms.hpp"
#include "passes/polynomials.hpp"
#include "passes/share_products.hpp"

namespace flatdyn {
namespace {

// The cost of one operation in the unit of savings: when one of u terms that use a product goes, 1/u of the product is
// saved.
constexpr int kOperation = 60;

// How savings are estimated. Neither policy is always the best, so both are tried.
struct Policy {
  bool count_shared_products;  // whether a use of a shared product counts as a part of its cost, or as nothing
};

int is_multiplication(const Rational& coefficient) { return coefficient == 1 || coefficient == -1 ? 0 : kOperation; }

class SumSharing {
 public:
  SumSharing(const Function& flat, Policy policy) : p_(flat), policy_(policy) {}

  Function run() {
    for (int k = 0; k < static_cast<int>(p_.polynomials.size()); ++k) index_polynomial(k);
    touched_.clear();
    for (std::size_t k = 0; k < kernels_.size(); ++k) push(static_cast<int>(k));
    while (!queue_.empty()) extract_next();
    return p_.finish();
  }

 private:
  // In a very long sum only terms this close to each other are paired, so that the work stays linear.
  static constexpr std::size_t kWindow = 48;

  struct Occurrence {  // an occurrence: polynomial = … + c · factor · (a + ratio · b)
    int polynomial;
    MonomialId factor;
    MonomialId first, second;  // the products factor · a and factor · b
    auto operator<=>(const Occurrence&) const = default;
  };
  struct Kernel {  // the partial sum a + ratio · b, a < b, without a common factor
    MonomialId a, b;
    Rational ratio;
    std::vector<Occurrence> where;  // the occurrences when they were examined
  };
  struct Candidate {
    int priority, kernel;
    bool operator<(const Candidate& other) const {
      return std::tie(priority, other.kernel) < std::tie(other.priority, kernel);
    }
  };
  // The savings of extracting a kernel, and the multiple of it that is best made the new node.
  struct Plan {
    int savings = 0;
    Rational scale = 1;
    int existing = -1;  // the polynomial that is the kernel already
  };

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  const PolynomialTerm* find(const Polynomial& polynomial, MonomialId monomial) const {
    for (const PolynomialTerm& term : polynomial.terms) {
      if (term.monomial == monomial) return &term;
    }
    return nullptr;
  }

  void index_pair(int polynomial, const PolynomialTerm& first, const PolynomialTerm& second) {
    const MonomialId factor = p_.monomials.common(first.monomial, second.monomial);
    MonomialId a = p_.monomials.quotient(first.monomial, factor);
    MonomialId b = p_.monomials.quotient(second.monomial, factor);
    Occurrence occurrence = {polynomial, factor, first.monomial, second.monomial};
    Rational ratio = second.coefficient / first.coefficient;
    if (a > b) {
      std::swap(a, b);
      std::swap(occurrence.first, occurrence.second);
      ratio = 1 / ratio;
    }
    const auto [it, is_new] = kernel_ids_.emplace(std::make_tuple(a, b, ratio), static_cast<int>(kernels_.size()));
    if (is_new) kernels_.push_back({a, b, ratio, {}});
    kernels_[at(it->second)].where.push_back(occurrence);
    touched_.push_back(it->second);
  }

  void index_polynomial(int k) {
    const std::vector<PolynomialTerm> terms = p_.polynomials[at(k)].terms;
    for (std::size_t j = 1; j < terms.size(); ++j) {
      for (std::size_t i = j > kWindow ? j - kWindow : 0; i < j; ++i) index_pair(k, terms[i], terms[j]);
    }
  }

  // The coefficient c of an occurrence; nullptr if the occurrence is gone.
  const Rational* coefficient(const Kernel& kernel, const Occurrence& occurrence) {
    const Polynomial& polynomial = p_.polynomials[at(occurrence.polynomial)];
    const PolynomialTerm* first = find(polynomial, occurrence.first);
    if (first == nullptr) return nullptr;
    const PolynomialTerm* second = find(polynomial, occurrence.second);
    if (second == nullptr || second->coefficient != kernel.ratio * first->coefficient) return nullptr;
    return &first->coefficient;
  }

  int coefficient_cost(const Rational& coefficient, MonomialId monomial) const {
    return p_.monomials.degree(monomial) == 0 ? 0 : is_multiplication(coefficient);
  }

  // The share of a product's cost that one term bears.
  int product_cost(MonomialId monomial) {
    const int degree = p_.monomials.degree(monomial), uses = p_.uses_of(monomial);
    if (degree < 2) return 0;
    if (uses <= 1) return (degree - 1) * kOperation;
    return policy_.count_shared_products ? (degree - 1) * kOperation / uses : 0;
  }

  // The cost of the new node's own two products, if no sum has them as they are.
  int new_products_cost(const Kernel& kernel) {
    for (const Occurrence& occurrence : kernel.where) {
      if (p_.monomials.degree(occurrence.factor) == 0) return 0;
    }
    int total = 0;
    for (const MonomialId monomial : {kernel.a, kernel.b}) {
      if (p_.uses_of(monomial) == 0) total += std::max(p_.monomials.degree(monomial) - 1, 0) * kOperation;
    }
    return total;
  }

  // The savings at one occurrence without the coefficient of the new term, which depends on the kernel's scale.
  int savings_at(const Kernel& kernel, const Occurrence& occurrence, const Rational& c) {
    const int before =
        kOperation + coefficient_cost(c, occurrence.first) + coefficient_cost(c * kernel.ratio, occurrence.second);
    const int degree = p_.monomials.degree(occurrence.factor);
    if (degree == 0) return before;
    return before + product_cost(occurrence.first) + product_cost(occurrence.second) - degree * kOperation;
  }

  // Whether a partial sum with one use saves nothing because neither a coefficient nor a factor is taken out.
  bool is_hopeless(const Kernel& kernel, const Occurrence& only) const {
    return p_.monomials.degree(only.factor) == 0 && is_multiplication(kernel.ratio) != 0;
  }

  Plan plan(Kernel& kernel) {
    auto& where = kernel.where;
    std::sort(where.begin(), where.end());
    where.erase(std::unique(where.begin(), where.end()), where.end());
    std::erase_if(where, [&](const Occurrence& o) { return coefficient(kernel, o) == nullptr; });
    Plan best;
    if (where.empty() || (where.size() == 1 && is_hopeless(kernel, where[0]))) return best;
    int savings = 0;
    std::vector<Rational> coefficients;
    for (const Occurrence& occurrence : where) {
      const Rational c = *coefficient(kernel, occurrence);
      const bool is_kernel =
          p_.monomials.degree(occurrence.factor) == 0 && p_.polynomials[at(occurrence.polynomial)].terms.size() == 2;
      if (is_kernel && best.existing < 0) {
        best.existing = occurrence.polynomial;
        best.scale = c;
        continue;
      }
      savings += savings_at(kernel, occurrence, c);
      coefficients.push_back(c);
    }
    if (best.existing >= 0) {
      best.savings = coefficients.empty() ? 0 : savings - scaling_cost(coefficients, best.scale);
      return best;
    }
    savings -= kOperation + new_products_cost(kernel);
    choose_scale(kernel, coefficients, best);
    best.savings += savings;
    return best;
  }

  static int scaling_cost(const std::vector<Rational>& coefficients, const Rational& scale) {
    int total = 0;
    for (const Rational& c : coefficients) total += is_multiplication(c / scale);
    return total;
  }

  // Chooses the scale: the kernel may be made as scale · (a + ratio · b) for any scale.
  void choose_scale(const Kernel& kernel, const std::vector<Rational>& coefficients, Plan& best) const {
    std::vector<Rational> scales = {1, 1 / kernel.ratio};
    for (std::size_t k = 0; k < std::min<std::size_t>(coefficients.size(), 4); ++k) scales.push_back(coefficients[k]);
    bool is_first = true;
    for (const Rational& scale : scales) {
      const int savings = -scaling_cost(coefficients, scale) - coefficient_cost(scale, kernel.a) -
                          coefficient_cost(scale * kernel.ratio, kernel.b);
      if (!is_first && savings <= best.savings) continue;
      is_first = false;
      best.savings = savings;
      best.scale = scale;
    }
  }

  // Among equal savings, partial sums of products that several sums have go first: taking a factor out of one of these
  // sums would hide them.
  int priority(const Plan& plan, const Kernel& kernel) const {
    int result = plan.savings;
    if (result <= 0 || kernel.where.size() < 2) return result;
    for (const Occurrence& occurrence : kernel.where) {
      if (p_.monomials.degree(occurrence.factor) > 0) continue;
      result += kOperation / 2 * std::max(p_.monomials.degree(occurrence.first) - 1, 0);
      result += kOperation / 2 * std::max(p_.monomials.degree(occurrence.second) - 1, 0);
    }
    return result;
  }

  void push(int kernel) {
    const Plan now = plan(kernels_[at(kernel)]);
    if (now.savings > 0) queue_.push({priority(now, kernels_[at(kernel)]), kernel});
  }

  void extract_next() {
    const Candidate best = queue_.top();
    queue_.pop();
    const Plan now = plan(kernels_[at(best.kernel)]);
    const int now_priority = priority(now, kernels_[at(best.kernel)]);
    if (now_priority < best.priority) {
      if (now_priority > 0) queue_.push({now_priority, best.kernel});
      return;
    }
    extract(best.kernel, now);
  }

  void extract(int index, const Plan& plan) {
    const Kernel kernel = kernels_[at(index)];
    const int source = plan.existing >= 0 ? plan.existing : new_polynomial(kernel, plan.scale);
    const NodeId shared = p_.polynomials[at(source)].node;
    const MonomialId shared_monomial = p_.monomials.id({shared});
    touched_.clear();
    for (const Occurrence& occurrence : kernel.where) {
      if (occurrence.polynomial == source) continue;
      const Rational* c = coefficient(kernel, occurrence);
      if (c == nullptr) continue;  // an earlier occurrence has used its terms
      replace(occurrence, {*c / plan.scale, p_.monomials.product(occurrence.factor, shared_monomial)});
    }
    if (plan.existing < 0) index_polynomial(source);
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const int touched : touched_) push(touched);
  }

  int new_polynomial(const Kernel& kernel, const Rational& scale) {
    const NodeId node = p_.draft.add_sum({}, 0);
    p_.polynomials.push_back({node, {{scale, kernel.a}, {scale * kernel.ratio, kernel.b}}});
    ++p_.uses_of(kernel.a);
    ++p_.uses_of(kernel.b);
    return static_cast<int>(p_.polynomials.size()) - 1;
  }

  void replace(const Occurrence& occurrence, PolynomialTerm merged) {
    auto& terms = p_.polynomials[at(occurrence.polynomial)].terms;
    const MonomialId first = occurrence.first, second = occurrence.second;
    std::erase_if(terms, [&](const PolynomialTerm& term) {
      if (term.monomial == merged.monomial) {  // like terms are added
        merged.coefficient += term.coefficient;
        --p_.uses_of(merged.monomial);
      }
      return term.monomial == first || term.monomial == second || term.monomial == merged.monomial;
    });
    --p_.uses_of(first);
    --p_.uses_of(second);
    if (merged.coefficient.is_zero()) return;
    ++p_.uses_of(merged.monomial);
    terms.push_back(merged);
    const std::vector<PolynomialTerm> now = terms;
    const std::size_t begin = now.size() > kWindow ? now.size() - kWindow : 0;
    for (std::size_t k = begin; k + 1 < now.size(); ++k) index_pair(occurrence.polynomial, now[k], merged);
  }

  Polynomials p_;
  Policy policy_;
  std::vector<Kernel> kernels_;
  std::map<std::tuple<MonomialId, MonomialId, Rational>, int> kernel_ids_;
  std::vector<int> touched_;
  std::priority_queue<Candidate> queue_;
};

Function shared_once(const Function& flat) {
  const Function strict = with_shared_products(SumSharing(flat, Policy{false}).run());
  return cheaper(strict, with_shared_products(SumSharing(flat, Policy{true}).run()));
}

}  // namespace

// A partial sum that was made a node early and ends up with one use is merged again: better factors may then show.
Function with_shared_sums(const Function& function) {
  constexpr int kRounds = 3;
  Function best = shared_once(unfolded(function));
  for (int round = 0; round < kRounds; ++round) {
    const int cost_before = cost(best);
    best = cheaper(best, shared_once(with_merged_sums(best)));
    best = cheaper(best, shared_once(with_merged_sums(best, Merging::where_it_costs_nothing)));
    if (!is_worth_repeating(cost_before, cost(best))) break;
  }
  return best;
}

Function share_sums(const Function& function) { return cheaper(function, with_shared_sums(function)); }

}  // namespace flatdyn
