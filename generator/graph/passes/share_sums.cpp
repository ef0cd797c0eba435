// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/share_sums.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>

#include "graph/passes/coefficients.hpp"
#include "graph/passes/like_terms.hpp"
#include "graph/passes/polynomials.hpp"
#include "graph/passes/share_products.hpp"
#include "graph/passes/sharing_memo.hpp"

namespace flatdyn {
namespace {

// The cost of one operation in the unit of savings: when one of u terms that use a product goes, 1/u of the product is
// saved.
constexpr int kOperation = 60;

// How savings are estimated. Neither policy is always the best, so both are tried.
struct Policy {
  bool count_shared_products;  // whether a use of a shared product counts as a part of its cost, or as nothing
};

// A term of a sum: a coefficient times a product.
struct SumTerm {
  CoefficientId coefficient;
  MonomialId monomial;
};

// An occurrence of a partial sum: polynomial = … + c · factor · (a + ratio · b).
struct Occurrence {
  int polynomial;
  MonomialId factor;
  MonomialId first, second;  // the products factor · a and factor · b
  auto operator<=>(const Occurrence&) const = default;
};

// The coefficients of an occurrence's two terms.
struct TermPair {
  CoefficientId first, second;
};

// The partial sum a + ratio · b, a < b, without a common factor.
struct Kernel {
  MonomialId a, b;
  RatioId ratio;
  std::uint32_t begin, count, capacity;  // the place of its occurrences, as they were when they were examined
};

// All partial sums of two terms, with their occurrences one after another in a single array.
class KernelTable {
 public:
  // The number of a partial sum; it is new if it is the size before.
  int id(MonomialId a, MonomialId b, RatioId ratio) {
    const int next = size();
    const int found = index_.find_or_add(mixed_bits(pair_key(a, b) ^ mixed_bits(static_cast<std::uint64_t>(ratio))),
                                         next, [&](int k) {
                                           const Kernel& kernel = (*this)[k];
                                           return kernel.a == a && kernel.b == b && kernel.ratio == ratio;
                                         });
    if (found == next) kernels_.push_back({a, b, ratio, 0, 0, 0});
    return found;
  }

  const Kernel& operator[](int kernel) const { return kernels_[static_cast<std::size_t>(kernel)]; }
  int size() const { return static_cast<int>(kernels_.size()); }

  std::span<Occurrence> where(int kernel) {
    return {occurrences_.data() + (*this)[kernel].begin, (*this)[kernel].count};
  }

  void add(int kernel, const Occurrence& occurrence) {
    Kernel& known = kernels_[static_cast<std::size_t>(kernel)];
    if (known.count == known.capacity) move_to_end(known);
    occurrences_[known.begin + known.count++] = occurrence;
  }

  // Keeps the first occurrences only.
  void keep(int kernel, std::size_t count) {
    kernels_[static_cast<std::size_t>(kernel)].count = static_cast<std::uint32_t>(count);
  }

 private:
  void move_to_end(Kernel& kernel) {
    const std::size_t begin = occurrences_.size();
    kernel.capacity = std::max<std::uint32_t>(1, 2 * kernel.capacity);
    occurrences_.resize(begin + kernel.capacity);
    std::copy_n(occurrences_.begin() + kernel.begin, kernel.count,
                occurrences_.begin() + static_cast<std::ptrdiff_t>(begin));
    kernel.begin = static_cast<std::uint32_t>(begin);
  }

  std::vector<Kernel> kernels_;
  std::vector<Occurrence> occurrences_;
  HashIndex index_;
};

class SumSharing {
 public:
  explicit SumSharing(const Function& flat) : p_(flat) {
    for (const Polynomial& polynomial : p_.polynomials) {
      std::vector<SumTerm>& terms = sums_.emplace_back();
      for (const PolynomialTerm& term : polynomial.terms) {
        terms.push_back({coefficients_.id(term.coefficient), term.monomial});
      }
    }
    for (int k = 0; k < static_cast<int>(sums_.size()); ++k) index_sum(k);
    touched_.clear();
  }

  Function run(Policy policy) {
    policy_ = policy;
    for (int k = 0; k < kernels_.size(); ++k) {
      if (!is_hopeless_from_the_start(k)) push(k);
    }
    while (!queue_.empty()) extract_next();
    return finish();
  }

  // Whether the policy has had any effect.
  bool depends_on_policy() const { return depends_on_policy_; }

 private:
  // In a very long sum only terms this close to each other are paired, so that the work stays linear.
  static constexpr std::size_t kWindow = 48;

  struct Candidate {
    int priority, kernel;
    bool operator<(const Candidate& other) const {
      return std::tie(priority, other.kernel) < std::tie(other.priority, kernel);
    }
  };
  // The multiple of a kernel that is made the new node: scale · (a + ratio · b). The scale is 1, or 1 / ratio, or the
  // first coefficient of an occurrence.
  enum class Scale { one, inverse_ratio, of_occurrence };
  // The savings of extracting a kernel, and the multiple of it that is best made the new node.
  struct Plan {
    int savings = 0;
    Scale scale = Scale::one;
    TermPair terms{};   // with Scale::of_occurrence: the coefficients of a and b
    int existing = -1;  // the polynomial that is the kernel already
  };

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  int degree(MonomialId monomial) const { return p_.monomials.degree(monomial); }

  const SumTerm* find(int sum, MonomialId monomial) const {
    for (const SumTerm& term : sums_[at(sum)]) {
      if (term.monomial == monomial) return &term;
    }
    return nullptr;
  }

  void index_pair(int sum, SumTerm first, SumTerm second) {
    auto [factor, a, b] = p_.monomials.split(first.monomial, second.monomial);
    if (a > b) {
      std::swap(a, b);
      std::swap(first, second);
    }
    const int kernel = kernels_.id(a, b, coefficients_.ratio(second.coefficient, first.coefficient));
    kernels_.add(kernel, {sum, factor, first.monomial, second.monomial});
    touched_.push_back(kernel);
  }

  void index_sum(int k) {
    const std::vector<SumTerm>& terms = sums_[at(k)];
    for (std::size_t j = 1; j < terms.size(); ++j) {
      for (std::size_t i = j > kWindow ? j - kWindow : 0; i < j; ++i) index_pair(k, terms[i], terms[j]);
    }
  }

  // The coefficients of an occurrence; nullopt if the occurrence is gone.
  std::optional<TermPair> coefficients(int kernel, const Occurrence& occurrence) {
    const SumTerm* first = find(occurrence.polynomial, occurrence.first);
    if (first == nullptr) return std::nullopt;
    const SumTerm* second = find(occurrence.polynomial, occurrence.second);
    if (second == nullptr) return std::nullopt;
    const TermPair pair = {first->coefficient, second->coefficient};
    if (coefficients_.ratio(pair.second, pair.first) != kernels_[kernel].ratio) return std::nullopt;
    return pair;
  }

  int cost_of_multiplication(CoefficientId coefficient) const {
    return coefficients_.is_unit(coefficient) ? 0 : kOperation;
  }
  // The cost of multiplying by the ratio of two coefficients.
  int cost_of_ratio(CoefficientId a, CoefficientId b) const {
    return coefficients_.have_equal_sizes(a, b) ? 0 : kOperation;
  }

  int coefficient_cost(CoefficientId coefficient, MonomialId monomial) const {
    return degree(monomial) == 0 ? 0 : cost_of_multiplication(coefficient);
  }

  // The share of a product's cost that one term bears.
  int product_cost(MonomialId monomial) {
    const int factors = degree(monomial), uses = p_.uses_of(monomial);
    if (factors < 2) return 0;
    if (uses <= 1) return (factors - 1) * kOperation;
    depends_on_policy_ = true;
    return policy_.count_shared_products ? (factors - 1) * kOperation / uses : 0;
  }

  // The cost of the new node's own two products, if no sum has them as they are.
  int new_products_cost(int kernel) {
    for (const Occurrence& occurrence : kernels_.where(kernel)) {
      if (degree(occurrence.factor) == 0) return 0;
    }
    int total = 0;
    for (const MonomialId monomial : {kernels_[kernel].a, kernels_[kernel].b}) {
      if (p_.uses_of(monomial) == 0) total += std::max(degree(monomial) - 1, 0) * kOperation;
    }
    return total;
  }

  // The savings at one occurrence without the coefficient of the new term, which depends on the kernel's scale.
  int savings_at(const Occurrence& occurrence, TermPair c) {
    const int before =
        kOperation + coefficient_cost(c.first, occurrence.first) + coefficient_cost(c.second, occurrence.second);
    const int factors = degree(occurrence.factor);
    if (factors == 0) return before;
    return before + product_cost(occurrence.first) + product_cost(occurrence.second) - factors * kOperation;
  }

  // Whether a partial sum with one use saves nothing because neither a coefficient nor a factor is taken out.
  bool is_hopeless(const Occurrence& only, TermPair c) const {
    return degree(only.factor) == 0 && !coefficients_.have_equal_sizes(c.first, c.second);
  }

  bool is_hopeless_from_the_start(int kernel) {
    if (kernels_[kernel].count > 1) return false;
    const Occurrence& only = kernels_.where(kernel)[0];
    return degree(only.factor) == 0 && is_hopeless(only, *coefficients(kernel, only));
  }

  // Sorts the occurrences, and removes those that are there twice or gone. found_ holds the coefficients of the rest.
  void examine(int kernel) {
    const std::span<Occurrence> where = kernels_.where(kernel);
    std::sort(where.begin(), where.end());
    const auto end = std::unique(where.begin(), where.end());
    found_.clear();
    for (auto it = where.begin(); it != end; ++it) {
      const std::optional<TermPair> pair = coefficients(kernel, *it);
      if (!pair) continue;
      where[found_.size()] = *it;
      found_.push_back(*pair);
    }
    kernels_.keep(kernel, found_.size());
  }

  Plan plan(int kernel) {
    examine(kernel);
    const std::span<const Occurrence> where = kernels_.where(kernel);
    Plan best;
    if (where.empty() || (where.size() == 1 && is_hopeless(where[0], found_[0]))) return best;
    int savings = 0;
    std::size_t kept = 0;  // found_ keeps the coefficients of occurrences that are not the kernel itself
    for (std::size_t k = 0; k < where.size(); ++k) {
      const bool is_kernel = degree(where[k].factor) == 0 && sums_[at(where[k].polynomial)].size() == 2;
      if (is_kernel && best.existing < 0) {
        best.existing = where[k].polynomial;
        best.scale = Scale::of_occurrence;
        best.terms = found_[k];
        continue;
      }
      savings += savings_at(where[k], found_[k]);
      found_[kept++] = found_[k];
    }
    found_.resize(kept);
    if (best.existing >= 0) {
      const bool is_useless = kept == 0 || is_extreme(Scale::of_occurrence, best.terms);
      best.savings = is_useless ? 0 : savings - scaling_cost(Scale::of_occurrence, best.terms);
      return best;
    }
    savings -= kOperation + new_products_cost(kernel);
    choose_scale(kernel, best);
    best.savings += savings;
    return best;
  }

  // The cost of the coefficients c / scale of the new terms.
  int scaling_cost(Scale scale, TermPair terms) const {
    int total = 0;
    for (const TermPair& c : found_) {
      total += scale == Scale::of_occurrence ? cost_of_ratio(c.first, terms.first)
                                             : cost_of_multiplication(scale == Scale::one ? c.first : c.second);
    }
    return total;
  }

  // The cost of the two coefficients of scale · (a + ratio · b).
  int cost_of_terms(const Kernel& kernel, Scale scale, TermPair terms) const {
    if (scale == Scale::of_occurrence) {
      return coefficient_cost(terms.first, kernel.a) + coefficient_cost(terms.second, kernel.b);
    }
    const MonomialId monomial = scale == Scale::one ? kernel.b : kernel.a;
    return degree(monomial) == 0 ? 0 : cost_of_ratio(found_[0].first, found_[0].second);
  }

  // Whether an extraction with this scale makes a coefficient that is far larger than those that are there.
  bool is_extreme(Scale scale, TermPair terms) const {
    const auto exponent = [this](CoefficientId id) { return coefficients_.exponent(id); };
    const int ratio = exponent(found_[0].second) - exponent(found_[0].first);
    if (scale != Scale::of_occurrence) return (scale == Scale::one ? ratio : -ratio) > kLargestExponent;
    return std::any_of(found_.begin(), found_.end(),
                       [&](const TermPair& c) { return exponent(c.first) - exponent(terms.first) > kLargestExponent; });
  }

  // Chooses the scale: the kernel may be made as scale · (a + ratio · b) for any scale. Without one, it saves nothing.
  void choose_scale(int kernel, Plan& best) const {
    constexpr std::size_t kTried = 4;
    constexpr int kNoSavings = -1'000'000;
    best.savings = kNoSavings;
    const auto consider = [&](Scale scale, TermPair terms) {
      const int savings = -scaling_cost(scale, terms) - cost_of_terms(kernels_[kernel], scale, terms);
      if (savings <= best.savings || is_extreme(scale, terms)) return;
      best.savings = savings;
      best.scale = scale;
      best.terms = terms;
    };
    consider(Scale::one, found_[0]);
    consider(Scale::inverse_ratio, found_[0]);
    for (std::size_t k = 0; k < std::min(found_.size(), kTried); ++k) consider(Scale::of_occurrence, found_[k]);
  }

  // Among equal savings, partial sums of products that several sums have go first: taking a factor out of one of these
  // sums would hide them.
  int priority(const Plan& plan, int kernel) {
    int result = plan.savings;
    if (result <= 0 || kernels_[kernel].count < 2) return result;
    for (const Occurrence& occurrence : kernels_.where(kernel)) {
      if (degree(occurrence.factor) > 0) continue;
      result += kOperation / 2 * std::max(degree(occurrence.first) - 1, 0);
      result += kOperation / 2 * std::max(degree(occurrence.second) - 1, 0);
    }
    return result;
  }

  void push(int kernel) {
    const Plan now = plan(kernel);
    if (now.savings > 0) queue_.push({priority(now, kernel), kernel});
  }

  void extract_next() {
    const Candidate best = queue_.top();
    queue_.pop();
    const Plan now = plan(best.kernel);
    const int now_priority = priority(now, best.kernel);
    if (now_priority < best.priority) {
      if (now_priority > 0) queue_.push({now_priority, best.kernel});
      return;
    }
    extract(best.kernel, now);
  }

  CoefficientId quotient(CoefficientId above, CoefficientId below) {
    return coefficients_.id(coefficients_[above] / coefficients_[below]);
  }

  // The coefficients of a and b in scale · (a + ratio · b).
  TermPair scaled_terms(const Plan& plan) {
    switch (plan.scale) {
      case Scale::one:
        return {CoefficientTable::kOne, quotient(plan.terms.second, plan.terms.first)};
      case Scale::inverse_ratio:
        return {quotient(plan.terms.first, plan.terms.second), CoefficientTable::kOne};
      case Scale::of_occurrence:
        break;
    }
    return plan.terms;
  }

  void extract(int kernel, const Plan& plan) {
    const TermPair made = scaled_terms(plan);
    const int source = plan.existing >= 0 ? plan.existing : new_sum(kernel, made);
    const MonomialId shared = p_.monomials.id({p_.polynomials[at(source)].node});
    touched_.clear();
    const std::span<const Occurrence> where = kernels_.where(kernel);
    const std::vector<Occurrence> occurrences(where.begin(), where.end());
    for (const Occurrence& occurrence : occurrences) {
      if (occurrence.polynomial == source) continue;
      const std::optional<TermPair> c = coefficients(kernel, occurrence);
      if (!c) continue;  // an earlier occurrence has used its terms
      replace(occurrence, {quotient(c->first, made.first), p_.monomials.product(occurrence.factor, shared)});
    }
    if (plan.existing < 0) index_sum(source);
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const int touched : touched_) push(touched);
  }

  int new_sum(int kernel, TermPair coefficients) {
    const MonomialId a = kernels_[kernel].a, b = kernels_[kernel].b;
    p_.polynomials.push_back({p_.draft.add_sum({}, 0), {}});
    sums_.push_back({{coefficients.first, a}, {coefficients.second, b}});
    ++p_.uses_of(a);
    ++p_.uses_of(b);
    return static_cast<int>(sums_.size()) - 1;
  }

  void replace(const Occurrence& occurrence, SumTerm merged) {
    std::vector<SumTerm>& terms = sums_[at(occurrence.polynomial)];
    const MonomialId first = occurrence.first, second = occurrence.second;
    Rational coefficient = coefficients_[merged.coefficient];
    std::erase_if(terms, [&](const SumTerm& term) {
      if (term.monomial == merged.monomial) {  // like terms are added
        coefficient += coefficients_[term.coefficient];
        --p_.uses_of(merged.monomial);
      }
      return term.monomial == first || term.monomial == second || term.monomial == merged.monomial;
    });
    --p_.uses_of(first);
    --p_.uses_of(second);
    if (coefficient.is_zero()) return;
    merged.coefficient = coefficients_.id(coefficient);
    ++p_.uses_of(merged.monomial);
    terms.push_back(merged);
    const std::size_t begin = terms.size() > kWindow ? terms.size() - kWindow : 0;
    for (std::size_t k = begin; k + 1 < terms.size(); ++k) index_pair(occurrence.polynomial, terms[k], merged);
  }

  Function finish() {
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      std::vector<PolynomialTerm>& terms = p_.polynomials[k].terms;
      terms.clear();
      for (const SumTerm& term : sums_[k]) terms.push_back({coefficients_[term.coefficient], term.monomial});
    }
    return p_.finish();
  }

  Polynomials p_;
  std::vector<std::vector<SumTerm>> sums_;  // by polynomial
  CoefficientTable coefficients_;
  KernelTable kernels_;
  Policy policy_{};
  bool depends_on_policy_ = false;
  std::vector<TermPair> found_;
  std::vector<int> touched_;
  std::priority_queue<Candidate> queue_;
};

// The cheaper of the results of both policies.
Function newly_shared(const Function& flat) {
  const SumSharing indexed(flat);
  SumSharing strict(indexed);
  const Function first = strict.run(Policy{false});
  if (!strict.depends_on_policy()) return with_shared_products(first);
  const Function second = SumSharing(indexed).run(Policy{true});
  if (has_same_nodes(first, second)) return with_shared_products(first);
  return cheaper(with_shared_products(first), with_shared_products(second));
}

Function shared_once(const Function& flat) {
  thread_local SharingMemo memo;
  if (std::optional<Function> known = memo.find(flat)) return std::move(*known);
  Function result = newly_shared(flat);
  memo.add(flat, result);
  return result;
}

}  // namespace

// A partial sum that was made a node early and ends up with one use is merged again: better factors may then show.
Function with_shared_sums(const Function& function) {
  constexpr int kRounds = 3;
  Function best = shared_once(unfolded(function));
  for (int round = 0; round < kRounds; ++round) {
    const int cost_before = cost(best);
    for (const Merging merging : {Merging::where_it_saves, Merging::where_it_costs_nothing}) {
      const Function merged = with_merged_sums(best, merging);
      best = cheaper(std::move(best), shared_once(merged));
    }
    if (!is_worth_repeating(cost_before, cost(best))) break;
  }
  return best;
}

Function share_sums(const Function& function) { return cheaper(function, with_shared_sums(function)); }

}  // namespace flatdyn
