// SPDX-License-Identifier: GPL-2.0-or-later
// A local search for the choices from which a function costs least after the passes. It descends by one change at a
// time, in a fixed order; then it tries some other orders of factoring; then it restarts again and again from random
// changes of the best choices, the same ones on every machine. The candidates depend only on the mechanism and the
// function, so their number alone reproduces the result.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "functions/planning/limit.hpp"
#include "functions/planning/moves.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// Makes the function from these choices, after the passes.
using MakeFunction = std::function<Function(const Choices&)>;

class ChoiceSearch {
 public:
  // `made`: the function from `start`. Without `moves`, only orders of factoring are tried.
  ChoiceSearch(const Mechanism& mechanism, Choices start, const Function& made, bool moves, MakeFunction make);

  void step();       // tries the next candidate
  void step_back();  // undoes the last step

  const Choices& best() const { return best_; }

 private:
  struct Candidate {
    Choices choices;
    bool is_start = false;  // the start of another descent, accepted whatever it costs
  };

  Candidate next();
  bool is_round_over() const { return next_move_ == moves_.size(); }
  void start_round();
  Choices in_other_order();
  Choices randomly_changed();

  const Mechanism* mechanism_;
  MakeFunction make_;
  Choices best_, previous_, current_;  // current_: the current choices of the descent
  int cost_, current_cost_;
  std::vector<Move> moves_;
  std::size_t next_move_ = 0;
  bool has_moves_, is_improved_ = true;
  unsigned last_order_ = 0;
  std::mt19937_64 random_;
};

// Runs all searches in turn, one candidate each, until the limit is reached; returns the number of candidates that each
// has tried. A time limit is checked after each candidate.
int run_searches(std::vector<ChoiceSearch>& searches, const SearchLimit& limit);

}  // namespace flatdyn
