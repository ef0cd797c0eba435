// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/passes.hpp"

#include <chrono>
#include <utility>

#include "graph/passes/draft.hpp"
#include "graph/passes/expand_tanh.hpp"
#include "graph/passes/like_terms.hpp"
#include "graph/passes/quotients.hpp"
#include "graph/passes/rescale.hpp"
#include "graph/passes/share_products.hpp"
#include "graph/passes/share_sums.hpp"
#include "graph/passes/trigonometric.hpp"

namespace flatdyn {

const std::vector<Pass>& pass_table() {
  static const std::vector<Pass> table = {
      {"dead_code", "drop what no output needs", without_dead_code},
      {"like_terms", "merge sums into sums, and collect", like_terms},
      {"trigonometric", "c^2 + s^2 = 1", trigonometric},
      {"share_sums", "factor sums, and share partial sums", share_sums},
      {"rescale", "compute sums as the multiple that is cheapest", rescale},
      {"share_products", "share partial products", share_products},
      {"quotients", "divide at once where a reciprocal is used once", quotients},
  };
  return table;
}

const Pass& last_pass() {
  static const Pass pass = {"expand_tanh", "tanh by sums, products, quotients and signs", expand_tanh};
  return pass;
}

Function run_passes(Function function, std::vector<PassRecord>* record, const PassObserver& observer) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRounds = 4;
  int round = 1;
  const auto run = [&](const Pass& pass) {
    PassRecord done{pass.name, count_operations(function), {}, round, 0};
    const Clock::time_point start = Clock::now();
    function = pass.run(function);
    done.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    done.after = count_operations(function);
    if (observer) observer(done, function);
    if (record != nullptr) record->push_back(std::move(done));
  };
  for (;; ++round) {
    const int cost_before = cost(function);
    for (const Pass& pass : pass_table()) run(pass);
    if (round == kRounds || !is_worth_repeating(cost_before, cost(function))) break;
  }
  if (has_tanh(function)) run(last_pass());
  return function;
}

}  // namespace flatdyn
