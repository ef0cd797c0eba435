// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/casadi/interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/diagnostics/diagnostics.hpp"
#include "code/lower/arguments.hpp"
#include "graph/passes/substitution.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

constexpr const char* kOutput = "out_";
constexpr const char* kAdjoint = "adj_";
constexpr const char* kForward = "fwd_";
constexpr const char* kJacobian = "jac_";

// An argument of f. The directions in which it varies begin, for q of a robot with a floating base, with those of the
// base, which are not of entries of q.
struct Variable {
  InputKind kind;
  std::string name;
  int length = 0, directions_before = 0;
  bool is_read = true;  // false for velocities where a scene holds at rest: derivatives by them are zero then

  int directions() const { return directions_before + length; }
};

// A function f with everything that its derivatives need to know of it.
struct Differentiated {
  const Function& function;
  std::vector<Variable> variables;
  std::vector<Sparsity> outputs;

  bool is_differentiated(std::size_t output) const { return function.outputs[output].name != kCondition; }
  int entries_of(std::size_t output) const { return outputs[output].rows * outputs[output].cols; }
};

std::vector<Variable> variables_of(const Mechanism& mechanism, const Function& function) {
  std::vector<Variable> variables;
  for (const InputKind kind : function.inputs) {
    const InputArgument argument = input_argument(kind, JointCounts(mechanism), function);
    variables.push_back({kind, argument.name, argument.length, kind == InputKind::q ? mechanism.base_bodies() : 0,
                         !(function.at_rest && is_velocity(kind))});
  }
  if (!mechanism.symbols.empty()) {
    variables.push_back({InputKind::parameter, "parameters", static_cast<int>(mechanism.symbols.size())});
  }
  return variables;
}

Differentiated differentiated(const Mechanism& mechanism, const Function& function) {
  Differentiated result{function, variables_of(mechanism, function), {}};
  for (const Output& output : function.outputs) {
    result.outputs.push_back(sparsity_of(function.graph, matrix_of(output)));
  }
  return result;
}

const Output* find_output(const Function& function, const std::string& name) {
  const auto found = std::find_if(function.outputs.begin(), function.outputs.end(),
                                  [&name](const Output& output) { return output.name == name; });
  return found == function.outputs.end() ? nullptr : &*found;
}

const Output& output_of(const Function& function, const std::string& name) {
  if (const Output* output = find_output(function, name)) return *output;
  throw Failure(FailureKind::bug, function.name + " has no output " + name);
}

// The columns of a matrix from `first` on.
NodeMatrix columns_from(const NodeMatrix& matrix, int first) {
  NodeMatrix result(matrix.rows, matrix.cols - first);
  for (int i = 0; i < result.rows; ++i) {
    for (int j = 0; j < result.cols; ++j) result.at(i, j) = matrix.at(i, first + j);
  }
  return result;
}

// The second derivatives by the entries of X and Z; of two that are the other way round, their transpose.
std::optional<NodeMatrix> second_derivatives(const Function& derivatives, const Variable& x, const Variable& z) {
  if (!x.is_read || !z.is_read) return std::nullopt;
  const auto matrix = [&](const Variable& a, const Variable& b) -> std::optional<NodeMatrix> {
    const Output* found = find_output(derivatives, fmt::format("H_{}_{}", a.name, b.name));
    if (found == nullptr) return std::nullopt;
    return columns_from(columns_from(matrix_of(*found), b.directions_before).transposed(), a.directions_before)
        .transposed();
  };
  if (std::optional<NodeMatrix> found = matrix(x, z)) return found;
  if (std::optional<NodeMatrix> found = matrix(z, x)) return found->transposed();
  return std::nullopt;
}

// The function with other outputs, which are given one after the other.
class Written {
 public:
  Written(const Function& from, std::string name) : code_(from) {
    code_.outputs.clear();
    code_.name = name;
    result_.name = std::move(name);
  }

  void add(const std::string& name, const NodeMatrix& matrix, const std::string& meaning) {
    add(name, matrix, sparsity_of(code_.graph, matrix), meaning);
  }
  // With zeros where `sparsity` has an entry that is always zero.
  void add(const std::string& name, const NodeMatrix& matrix, const Sparsity& sparsity, const std::string& meaning) {
    result_.outputs.push_back({name, sparsity});
    if (sparsity.count() == 0) return;
    const bool is_vector = matrix.cols == 1 && sparsity.count() == matrix.rows;
    code_.outputs.push_back(
        {.name = name,
         .layout = Layout::vector,
         .rows = sparsity.count(),
         .cols = 1,
         .entries = stored_entries(matrix, sparsity),
         .meaning = is_vector ? meaning
                              : fmt::format("{}, {} x {}: the entries that are not always zero, column by column",
                                            meaning, matrix.rows, matrix.cols)});
  }
  void summarise(std::string summary) { code_.summary = std::move(summary); }
  NodeMatrix zeros(int rows, int cols) {
    NodeMatrix matrix(rows, cols);
    std::fill(matrix.entries.begin(), matrix.entries.end(), code_.graph.constant(0));
    return matrix;
  }
  void add_zeros(const std::string& name, int rows, int cols) {
    result_.outputs.push_back({name, without_entries(rows, cols)});
  }
  // `matrix`: none if it is zero.
  void add(const std::string& name, const std::optional<NodeMatrix>& matrix, int rows, int cols,
           const std::string& meaning) {
    if (matrix) {
      add(name, *matrix, meaning);
    } else {
      add_zeros(name, rows, cols);
    }
  }
  void add_input(const std::string& name, const Sparsity& sparsity) { result_.inputs.push_back({name, sparsity}); }
  void add_inputs(const std::vector<Variable>& variables, const std::string& before = "") {
    for (const Variable& each : variables) add_input(before + each.name, dense(each.length, 1));
  }
  // The results of f, which CasADi passes to its derivatives, and which these do not need.
  void add_unused_results(const Differentiated& of) {
    for (std::size_t k = 0; k < of.outputs.size(); ++k) {
      const Sparsity& sparsity = of.outputs[k];
      add_input(kOutput + of.function.outputs[k].name, without_entries(sparsity.rows, sparsity.cols));
    }
  }

  // `of`: the function whose arguments come first.
  CasadiFunction finished(const Differentiated& of) {
    for (const InputKind kind : code_.inputs) result_.arguments.push_back(array_for(kind, of));
    const std::vector<Variable>& variables = of.variables;
    if (!variables.empty() && variables.back().kind == InputKind::parameter) {
      result_.parameters = static_cast<int>(variables.size()) - 1;
    }
    const std::string name = casadi_name(of.function.name);
    if (name != result_.name) result_.derivative_of = name;
    if (!code_.outputs.empty()) result_.code = std::move(code_);
    return std::move(result_);
  }

 private:
  AssembledArray array_for(InputKind kind, const Differentiated& of) const {
    const int variables = static_cast<int>(of.variables.size()), outputs = static_cast<int>(of.outputs.size());
    AssembledArray array;
    if (kind == InputKind::weights) {
      for (int k = 0; k < outputs; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (of.is_differentiated(at)) append({variables + outputs + k, array.length, of.outputs[at].count()}, array);
      }
      return array;
    }
    if (kind == InputKind::direction) {
      for (int k = 0; k < variables; ++k) {
        const Variable& each = of.variables[static_cast<std::size_t>(k)];
        array.length += each.directions_before;
        if (each.is_read) {
          append({variables + outputs + k, array.length, each.length}, array);
        } else {
          array.length += each.length;
        }
      }
      return array;
    }
    for (int k = 0; k < variables; ++k) {
      const Variable& each = of.variables[static_cast<std::size_t>(k)];
      if (each.kind == kind) return {each.length, {{k, 0, each.length}}};
    }
    throw Failure(FailureKind::bug, code_.name + " has an argument that its function has not");
  }

  static void append(const AssembledArray::Piece& piece, AssembledArray& array) {
    if (piece.length > 0) array.pieces.push_back(piece);
    array.length += piece.length;
  }

  Function code_;
  CasadiFunction result_;
};

// dY/dX by the entries of X, with a row for each entry of Y, column by column; nullopt if it is zero. Entries of Y that
// are not stored, be they always zero or left out by a scene, have rows of zeros.
std::optional<NodeMatrix> jacobian(const Differentiated& of, const Function& derivatives, std::size_t output,
                                   const Variable& by, Written& written) {
  if (!of.is_differentiated(output) || !by.is_read) return std::nullopt;
  const Output& found = output_of(derivatives, fmt::format("d{}_d{}", of.function.outputs[output].name, by.name));
  const Sparsity& stored = of.outputs[output];
  NodeMatrix matrix = written.zeros(of.entries_of(output), by.length);
  for (int j = 0; j < stored.cols; ++j) {
    const auto column = static_cast<std::size_t>(j);
    for (int n = stored.column_begin[column]; n < stored.column_begin[column + 1]; ++n) {
      const int i = stored.row[static_cast<std::size_t>(n)], row = i * stored.cols + j;
      for (int k = 0; k < by.length; ++k) {
        const int place = row * by.directions() + by.directions_before + k;
        matrix.at(j * stored.rows + i, k) = found.entries[static_cast<std::size_t>(place)];
      }
    }
  }
  return matrix;
}

// Copies a graph with the weights at other places, and without those whose place is -1. If there are none such, every
// operation stays as the passes left it.
std::vector<NodeId> with_weights_at(const std::vector<int>& places, const Graph& from, Graph& to) {
  const auto place_of = [&places](const Input& input) { return places[static_cast<std::size_t>(input.index)]; };
  const auto is_weight = [&from](NodeId id) {
    return from[id].op == Op::input && from[id].input.kind == InputKind::weights;
  };
  bool leaves_out = false;
  for (NodeId id = 0; id < from.size(); ++id) leaves_out |= is_weight(id) && place_of(from[id].input) < 0;
  const auto image_of = [&place_of](const Input& input, Graph& graph) -> std::optional<NodeId> {
    if (input.kind != InputKind::weights) return std::nullopt;
    return place_of(input) < 0 ? graph.constant(0) : graph.input({InputKind::weights, place_of(input)});
  };
  if (leaves_out) return substituted(from, image_of, to);
  std::vector<NodeId> image;
  for (NodeId id = 0; id < from.size(); ++id) {
    image.push_back(is_weight(id) ? *image_of(from[id].input, to) : to.copy(from[id], image));
    copy_name(from, id, to, image.back());
  }
  return image;
}

// "weights of the entries of tau", "weights of the stored entries of R, column by column, then of p".
std::string meaning_of_weights(const Differentiated& of) {
  std::string text, stored;
  for (std::size_t k = 0; k < of.outputs.size() && of.is_differentiated(k); ++k) {
    const Sparsity& sparsity = of.outputs[k];
    text += (k > 0 ? ", then of " : "") + of.function.outputs[k].name + (sparsity.cols > 1 ? ", column by column" : "");
    if (sparsity.count() < sparsity.rows * sparsity.cols) stored = "stored ";
  }
  return "weights of the " + stored + "entries of " + text;
}

// The weights that CasADi gives are those of the entries that are not always zero, column by column; those of the
// function are of all entries, row by row.
Function with_weights_of_nonzeros(const Function& function, const Differentiated& of) {
  std::vector<int> places(static_cast<std::size_t>(function.own.length), -1);
  int before = 0, place = 0;
  for (std::size_t output = 0; output < of.outputs.size() && of.is_differentiated(output); ++output) {
    const Sparsity& sparsity = of.outputs[output];
    for (int j = 0; j < sparsity.cols; ++j) {
      for (int k = sparsity.column_begin[static_cast<std::size_t>(j)];
           k < sparsity.column_begin[static_cast<std::size_t>(j + 1)]; ++k) {
        const int i = sparsity.row[static_cast<std::size_t>(k)];
        places[static_cast<std::size_t>(before + i * sparsity.cols + j)] = place++;
      }
    }
    before += sparsity.rows * sparsity.cols;
  }
  Graph graph;
  const std::vector<NodeId> image = with_weights_at(places, function.graph, graph);
  Function result = with_graph(function, std::move(graph), image);
  result.own = {place, meaning_of_weights(of)};
  return result;
}

CasadiFunction itself(const Differentiated& of) {
  Written written(of.function, casadi_name(of.function.name));
  written.add_inputs(of.variables);
  for (const Output& output : of.function.outputs) written.add(output.name, matrix_of(output), output.meaning);
  CasadiFunction function = written.finished(of);
  for (std::size_t k = 0; k < of.outputs.size(); ++k) {
    if (!of.is_differentiated(k)) function.undifferentiated = k;
  }
  return function;
}

CasadiFunction jacobian_function(const Differentiated& of, const Function& derivatives) {
  Written written(derivatives, kJacobian + casadi_name(of.function.name));
  written.add_inputs(of.variables);
  written.add_unused_results(of);
  for (std::size_t k = 0; k < of.outputs.size(); ++k) {
    const std::string& name = of.function.outputs[k].name;
    for (const Variable& by : of.variables) {
      written.add(fmt::format("{}{}_{}", kJacobian, name, by.name), jacobian(of, derivatives, k, by, written),
                  of.entries_of(k), by.length, fmt::format("derivatives of {} by {}", name, by.name));
    }
  }
  return written.finished(of);
}

void add_weights(const Differentiated& of, Written& written) {
  written.add_unused_results(of);
  for (std::size_t k = 0; k < of.outputs.size(); ++k) {
    written.add_input(kAdjoint + of.function.outputs[k].name, of.outputs[k]);
  }
}

CasadiFunction adjoint_function(const Differentiated& of, const Function& product) {
  const Function code = with_weights_of_nonzeros(product, of);
  Written written(code, "adj1_" + casadi_name(of.function.name));
  written.add_inputs(of.variables);
  add_weights(of, written);
  for (const Variable& by : of.variables) {
    const NodeMatrix all = matrix_of(output_of(code, by.name + "_bar"));
    written.add(
        kAdjoint + by.name,
        by.is_read ? columns_from(all.transposed(), by.directions_before).transposed() : written.zeros(by.length, 1),
        dense(by.length, 1), fmt::format("derivatives of the weighted sum by {}", by.name));
  }
  return written.finished(of);
}

CasadiFunction forward_function(const Differentiated& of, const Function& product) {
  Written written(product, "fwd1_" + casadi_name(of.function.name));
  written.add_inputs(of.variables);
  written.add_unused_results(of);
  written.add_inputs(of.variables, kForward);
  for (std::size_t k = 0; k < of.outputs.size(); ++k) {
    const std::string& name = of.function.outputs[k].name;
    const NodeMatrix rates = of.is_differentiated(k) ? matrix_of(output_of(product, "d" + name))
                                                     : written.zeros(of.outputs[k].rows, of.outputs[k].cols);
    written.add(kForward + name, rates, of.outputs[k], "rate of " + name);
  }
  return written.finished(of);
}

// `both`: outputs of hessian:f and of jac:f.
CasadiFunction adjoint_jacobian_function(const Differentiated& of, const Function& both) {
  const Function code = with_weights_of_nonzeros(both, of);
  Written written(code, "jac_adj1_" + casadi_name(of.function.name));
  written.summarise(fmt::format(
      "The derivatives of adj1_{0}: second derivatives of the weighted sum of the entries of {0}, and J^T; signs count "
      "as constant",
      casadi_name(of.function.name)));
  written.add_inputs(of.variables);
  add_weights(of, written);
  for (const Variable& x : of.variables)
    written.add_input(fmt::format("out_adj_{}", x.name), without_entries(x.length, 1));
  for (const Variable& x : of.variables) {
    const std::string name = fmt::format("jac_adj_{}_", x.name);
    for (const Variable& z : of.variables) {
      written.add(name + z.name, second_derivatives(code, x, z), x.length, z.length,
                  fmt::format("second derivatives of the weighted sum by {}, {}", x.name, z.name));
    }
    for (std::size_t k = 0; k < of.outputs.size(); ++k) {
      written.add_zeros(name + kOutput + of.function.outputs[k].name, x.length, of.entries_of(k));
    }
    for (std::size_t k = 0; k < of.outputs.size(); ++k) {
      const std::string& output = of.function.outputs[k].name;
      std::optional<NodeMatrix> matrix = jacobian(of, code, k, x, written);
      if (matrix) matrix = matrix->transposed();
      written.add(name + kAdjoint + output, matrix, x.length, of.entries_of(k),
                  fmt::format("derivatives of {} by {}, transposed", output, x.name));
    }
  }
  return written.finished(of);
}

}  // namespace

std::string casadi_name(const std::string& function) { return cpp_identifier(function); }

std::vector<CasadiFunction> casadi_functions(const Mechanism& mechanism, const std::vector<Function>& functions) {
  std::vector<CasadiFunction> result;
  std::set<std::string> written_with_their_function;
  for (const Function& each : functions) {
    if (written_with_their_function.contains(each.name)) continue;
    const Differentiated of = differentiated(mechanism, each);
    result.push_back(itself(of));
    const auto add = [&](const std::string& name, const auto& written) {
      const auto found = std::find_if(functions.begin(), functions.end(),
                                      [&name](const Function& function) { return function.name == name; });
      if (found == functions.end()) return;
      result.push_back(written(of, *found));
      written_with_their_function.insert(name);
    };
    add("jac:" + each.name, jacobian_function);
    add("vjp:" + each.name, adjoint_function);
    add("jvp:" + each.name, forward_function);
    add(fmt::format("hessian:{0}_jac:{0}", each.name), adjoint_jacobian_function);
  }
  return result;
}

std::vector<Function> code_of_casadi_functions(const Mechanism& mechanism, const std::vector<Function>& functions) {
  std::vector<Function> code;
  for (CasadiFunction& each : casadi_functions(mechanism, functions)) {
    if (each.code) code.push_back(std::move(*each.code));
  }
  return code;
}

}  // namespace flatdyn
