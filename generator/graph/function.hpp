// SPDX-License-Identifier: GPL-2.0-or-later
// One thing that the generated code computes: a graph with named, shaped outputs. What passes and emitters work on.
#pragma once

#include <string>
#include <vector>

#include "graph/graph.hpp"
#include "graph/task.hpp"

namespace flatdyn {

// How the entries of an output are laid out.
enum class Layout {
  scalar,       // one entry
  vector,       // rows entries
  matrix,       // rows × cols, row by row, in full
  fields,       // rows members of a struct, each with its own name
  christoffel,  // c_ijk for j <= k: rows = n, cols = n(n+1)/2, entry (i, k(k+1)/2 + j) with j <= k, 0-based
};

struct Output {
  std::string name;  // "B", "tau", …
  Layout layout = Layout::vector;
  int rows = 1, cols = 1;
  std::vector<NodeId> entries;   // rows · cols of them; a structural zero is the constant 0
  std::string meaning;           // one line: what, unit, frame
  std::vector<bool> left_out{};  // by entry: nobody needs it, it is the constant 0 here and is not written; empty: none

  bool leaves_out(std::size_t entry) const { return !left_out.empty() && left_out[entry]; }
  bool is_written() const;  // any entry of it
};

// What an output of joint torques means.
inline constexpr const char* kTorqueMeaning = "joint torques, N m (forces, N, for prismatic joints)";

struct Function {
  std::string name;               // "inverse_dynamics"
  std::string summary;            // one line for people
  std::string equation;           // "(7.42)"
  std::vector<InputKind> inputs;  // the arguments in order, whether or not every entry is read
  int base_parameters = 0;        // length of pi_b, where it is one of them
  bool at_rest = false;           // holds where qd = 0, and does not read it
  Task task{};                    // of the operational space
  Graph graph;
  std::vector<Output> outputs;
  // Values that must all be positive for the result to mean anything (pivots of B, loops); then the function returns
  // bool.
  std::vector<NodeId> validity_conditions;
  // Of the first ones of these: what a pivot is the rest of (b_kk), where rounding may leave nothing of the rest. It
  // counts as positive only if kLeastShare of it is not lost beside that in the scalar's arithmetic.
  std::vector<NodeId> pivot_diagonals{};
  int loop_conditions = 0;  // the last ones of these: closed loops that must not be singular
};

// A pivot below 1/(2 kLeastShare) units of the last place of what it is the rest of is rounding error for the most.
inline const Rational kLeastShare{1, 64};

// Output entries, conditions and scales, in order: what keeps a node alive.
std::vector<NodeId> roots(const Function& function);

// The same outputs and conditions in another graph, where node k of the function's is image[k].
Function with_graph(const Function& function, Graph graph, const std::vector<NodeId>& image);

// Whether condition k is known to hold without being computed: a positive constant, in float, too.
bool always_holds(const Function& function, std::size_t k);

// Whether every entry of every output is computed.
bool is_whole(const Function& function);

// The inputs that the function really reads, in order of kind and index.
std::vector<Input> inputs_read(const Function& function);

}  // namespace flatdyn
