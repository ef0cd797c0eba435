// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/loop_shifts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "symbolic/elimination.hpp"

namespace flatdyn {
namespace {

using IsZero = std::function<bool(const Number&)>;

Number product(const ParameterForm& a, const ParameterForm& b) {
  Number sum = 0;
  for (const auto& [index, coefficient] : a) {
    if (const auto other = b.find(index); other != b.end()) sum += coefficient * other->second;
  }
  return simplified<Number>(sum);
}

ParameterForm sum(ParameterForm a, const Number& factor, const ParameterForm& b) {
  for (const auto& [index, coefficient] : b) a[index] = simplified<Number>(a[index] + factor * coefficient);
  std::erase_if(a, [](const auto& term) { return vanishes(term.second); });
  return a;
}

// Parameters that the model does not have may be part of δ where nothing depends on them.
bool is_possible(const ParameterForm& shift, const std::vector<ParameterForm>& forms, const std::vector<bool>& present,
                 const IsZero& is_zero) {
  ParameterForm absent = shift;
  std::erase_if(absent, [&](const auto& term) { return present[static_cast<std::size_t>(term.first)]; });
  return std::all_of(forms.begin(), forms.end(),
                     [&](const ParameterForm& form) { return is_zero(product(form, absent)); });
}

// In the order in which parameters are kept.
int rank_of(int index) {
  const auto* place = std::find(std::begin(kPreference), std::end(kPreference), parameter_of(index));
  return kParametersPerJoint * joint_of(index) + static_cast<int>(place - std::begin(kPreference));
}

// The row of K that goes.
std::optional<std::size_t> last_row(const BaseParameters& base, const std::vector<Number>& amounts,
                                    const IsZero& is_zero) {
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < amounts.size(); ++k) {
    if (is_zero(amounts[k])) continue;
    if (!last || rank_of(base.columns[k]) > rank_of(base.columns[*last])) last = k;
  }
  return last;
}

}  // namespace

std::vector<ParameterForm> loop_shifts(const Mechanism& mechanism) {
  std::vector<ParameterForm> shifts;
  for (const LoopClosure& loop : mechanism.loops) {
    ParameterForm shift;
    for (std::size_t e = 0; e < 2; ++e) {
      const auto& [body, p] = loop.ends[e];
      if (body < 0) continue;
      const std::vector<Number> entries = entries_of({1, p, steiner(1, p)});
      for (int k = 0; k < kInertialPerBody; ++k) {
        const Number& entry = entries[static_cast<std::size_t>(k)];
        if (!vanishes(entry)) shift[index_of(body, static_cast<Parameter>(k))] += e == 0 ? entry : Number(-entry);
      }
    }
    shifts.push_back(std::move(shift));
  }
  return shifts;
}

BaseParameters without_shifts(const Mechanism& mechanism, BaseParameters base, const std::vector<ParameterForm>& forms,
                              const std::vector<bool>& present, const IsZero& is_zero) {
  for (ParameterForm shift : loop_shifts(mechanism)) {
    if (!is_possible(shift, forms, present, is_zero)) continue;
    for (const LoopShift& before : base.shifts) shift = sum(shift, -product(before.share, shift), before.shift);
    std::vector<Number> amounts;
    for (const ParameterForm& form : base.combination) amounts.push_back(product(form, shift));
    const std::optional<std::size_t> last = last_row(base, amounts, is_zero);
    if (!last) continue;
    ParameterForm share;
    for (const auto& [index, coefficient] : base.combination[*last]) {
      share[index] = simplified<Number>(coefficient / amounts[*last]);
    }
    for (std::size_t k = 0; k < amounts.size(); ++k) {
      if (k != *last) base.combination[k] = sum(base.combination[k], -amounts[k], share);
    }
    base.columns.erase(base.columns.begin() + static_cast<std::ptrdiff_t>(*last));
    base.combination.erase(base.combination.begin() + static_cast<std::ptrdiff_t>(*last));
    base.shifts.push_back({std::move(shift), std::move(share)});
  }
  return base;
}

}  // namespace flatdyn
