// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/search.hpp"

#include <chrono>
#include <utility>

#include "graph/passes/draft.hpp"

namespace flatdyn {

ChoiceSearch::ChoiceSearch(const Mechanism& mechanism, Choices start, const Function& made, bool moves,
                           MakeFunction make)
    : mechanism_(&mechanism),
      make_(std::move(make)),
      best_(std::move(start)),
      previous_(best_),
      current_(best_),
      cost_(cost(made)),
      current_cost_(cost_),
      has_moves_(moves) {}

void ChoiceSearch::start_round() {
  is_improved_ = false;
  next_move_ = 0;
  moves_ = possible_moves(*mechanism_, current_);
}

// The next candidate: a move that changes the current choices; after the last move another order, then random restarts.
ChoiceSearch::Candidate ChoiceSearch::next() {
  constexpr unsigned kOrders = 10;
  if (has_moves_ && is_round_over() && is_improved_) start_round();
  while (!is_round_over()) {
    Choices candidate = current_;
    if (moves_[next_move_++](candidate)) return {std::move(candidate)};
  }
  if (has_moves_ && last_order_ >= kOrders) return {randomly_changed(), true};
  return {in_other_order()};
}

Choices ChoiceSearch::in_other_order() {
  Choices candidate = best_;
  candidate.order = ++last_order_;
  return candidate;
}

Choices ChoiceSearch::randomly_changed() {
  constexpr int kChanges = 3;
  Choices candidate = best_;
  for (int k = 0; k < kChanges; ++k) {
    const std::vector<Move> moves = possible_moves(*mechanism_, candidate);
    moves[random_() % moves.size()](candidate);
  }
  return candidate;
}

void ChoiceSearch::step() {
  previous_ = best_;
  Candidate candidate = next();
  const int found = cost(make_(candidate.choices));
  if (found >= current_cost_ && !candidate.is_start) return;
  current_ = std::move(candidate.choices);
  current_cost_ = found;
  is_improved_ = true;
  if (found >= cost_) return;
  best_ = current_;
  cost_ = found;
}

void ChoiceSearch::step_back() { best_ = previous_; }

int run_searches(std::vector<ChoiceSearch>& searches, const SearchLimit& limit) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto is_late = [&] {
    return limit.seconds && std::chrono::duration<double>(Clock::now() - start).count() > *limit.seconds;
  };
  int candidates = 0;
  for (; !limit.candidates || candidates < *limit.candidates; ++candidates) {
    for (std::size_t k = 0; k < searches.size(); ++k) {
      searches[k].step();
      if (!is_late()) continue;
      if (k + 1 == searches.size()) return candidates + 1;
      for (std::size_t j = 0; j <= k; ++j) searches[j].step_back();
      return candidates;
    }
  }
  return candidates;
}

}  // namespace flatdyn
