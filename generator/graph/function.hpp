// SPDX-License-Identifier: GPL-2.0-or-later
// A function of the generated code: a graph with named, shaped outputs. Passes and emitters work on it.
#pragma once

#include <string>
#include <vector>

#include "graph/graph.hpp"
#include "graph/output_quantity.hpp"
#include "graph/task.hpp"

namespace flatdyn {

// The layout of an output's entries.
enum class Layout {
  scalar,       // one entry
  vector,       // a vector of `rows` entries
  matrix,       // a rows × cols matrix, row by row, in full
  fields,       // a struct of `rows` members, each with its own name
  christoffel,  // c_ijk for j <= k: rows = n, cols = n(n+1)/2, entry (i, k(k+1)/2 + j) with j <= k, 0-based
};

struct Output {
  std::string name;  // "B", "tau", …
  Layout layout = Layout::vector;
  int rows = 1, cols = 1;
  std::vector<NodeId> entries;  // rows · cols nodes; a structural zero is the constant 0
  std::string meaning;          // one line for people: what it is, unit, frame
  // By entry: true if it is not needed; it is then the constant 0 and is not written. Empty: all entries are needed.
  std::vector<bool> left_out{};
  OutputQuantity quantity = OutputQuantity::none;

  bool leaves_out(std::size_t entry) const { return !left_out.empty() && left_out[entry]; }
  bool is_written() const;  // whether any entry is written
};

// The output that says how near a problem is to having no solution. Functions that have it have it last, and it is not
// differentiated.
inline constexpr const char* kCondition = "condition";

// The formulation of most functions.
inline constexpr const char* kRecursion = "recursion";

// The argument weights or direction of a product with derivatives, whose length depends on the function.
struct OwnArgument {
  int length = 0;
  std::string meaning;  // "weights of the entries of tau"
};

struct Function {
  std::string name;               // "inverse_dynamics"
  std::string summary;            // one line for people
  std::string equation;           // "(7.42)"
  std::string formulation{};      // the one of several by which it is computed: "articulated bodies"
  std::vector<InputKind> inputs;  // the arguments in order, whether or not every entry is read
  int base_parameters = 0;        // length of pi_b, if that is an input
  OwnArgument own{};              // weights or direction, if that is an input
  bool at_rest = false;           // the function holds for qd = 0 only and does not read qd
  Task task{};                    // the task of the operational space
  Graph graph;
  std::vector<Output> outputs;
  // Values that must all be positive for the result to be valid (pivots of B and what they must stay below, conditions
  // of loops). If there are any, the generated function returns bool.
  std::vector<NodeId> validity_conditions;
  // The scales of the first of `validity_conditions`: pivot k is a diagonal entry less what elimination subtracts from
  // it, so that rounding may cancel all digits of it, and the same holds for the determinant of a loop. A last place of
  // its scale is the rounding error that the terms bring in. It counts as positive only if kPivotSignificance of it
  // still changes its scale in the scalar's arithmetic.
  std::vector<NodeId> pivot_scales{};
  // Without scales: every pivot of B is at least this share of its scale, which is proven at every position within the
  // limits of prismatic joints. 0: unknown, or there are no pivots of B.
  double proven_pivot_share = 0;
  int loop_conditions = 0;  // the number of conditions, at the end, that require a closed loop not to be singular
  // The matrices whose pivots are conditions, in words, if they are others than B and the task's: "B or J B^-1 J^T".
  std::string inverted{};
};

// A pivot below 1/(2 kPivotSignificance) units in the last place of its scale is mostly rounding error.
inline const Rational kPivotSignificance{1, 64};

// The length of an argument that depends on the function.
int own_length(const Function& function, ArgumentLength length);

// The nodes that must be kept: output entries, validity conditions and pivot scales, in this order.
std::vector<NodeId> roots(const Function& function);

// The same function over another graph, in which node k of the function's graph is image[k].
Function with_graph(const Function& function, Graph graph, const std::vector<NodeId>& image);

// Whether condition k is a pivot that rounding may cancel, so that it is compared with a scale.
bool has_scale(const Function& function, std::size_t k);

// Whether pivots of B or of another matrix are compared with scales.
bool compares_pivots(const Function& function);

// Whether condition k holds without being computed: it is a positive constant, in float, too.
bool always_holds(const Function& function, std::size_t k);

// Whether it takes sines or cosines of angles that it computes, such as those after a part of a step.
bool computes_angles(const Function& function);

// The number of entries of all outputs.
std::size_t entry_count(const Function& function);

// Whether every entry of every output is computed.
bool is_whole(const Function& function);

// The inputs that the function reads, ordered by kind and index.
std::vector<Input> inputs_read(const Function& function);

}  // namespace flatdyn
