// SPDX-License-Identifier: GPL-2.0-or-later
// Search for the choices from which a function costs least after the passes: up the hill, one change at a time, in a
// fixed order; then some other orders of factoring; then up the hill again and again from some changes at random of the
// best, the same ones on every machine. Which candidates are tried depends on nothing but the mechanism and the
// function, so that their number alone makes the same result again.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "graph/function.hpp"
#include "planning/limit.hpp"
#include "planning/moves.hpp"

namespace flatdyn {

// The function from these choices, after the passes.
using MakeFunction = std::function<Function(const Choices&)>;

class ChoiceSearch {
 public:
  // `made`: the function from `start`. Without `moves`, only orders of factoring are tried.
  ChoiceSearch(const Mechanism& mechanism, Choices start, const Function& made, bool moves, MakeFunction make);

  void step();       // tries one candidate more
  void step_back();  // forgets the last one

  const Choices& best() const { return best_; }

 private:
  struct Candidate {
    Choices choices;
    bool is_start = false;  // of another climb, whatever it costs
  };

  Candidate next();
  bool is_round_over() const { return next_move_ == moves_.size(); }
  void start_round();
  Choices in_other_order();
  Choices shaken();

  const Mechanism* mechanism_;
  MakeFunction make_;
  Choices best_, before_, here_;  // here: where it climbs
  int cost_, cost_here_;
  std::vector<Move> moves_;
  std::size_t next_move_ = 0;
  bool has_moves_, is_improved_ = true;
  unsigned last_order_ = 0;
  std::mt19937_64 random_;
};

// All searches go on side by side until the limit is reached; then each has tried the number of candidates that is
// returned. A time is looked at after each candidate.
int run_searches(std::vector<ChoiceSearch>& searches, const SearchLimit& limit);

}  // namespace flatdyn
