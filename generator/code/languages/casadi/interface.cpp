// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/casadi/interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/diagnostics/diagnostics.hpp"
#include "code/lower/arguments.hpp"
#include "graph/function_name.hpp"
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

  int directions() const { return directions_before + length; }
};

// A function f with everything that its derivatives need to know of it.
struct Differentiated {
  const Function& function;
  std::vector<Variable> variables;
  std::vector<Sparsity> outputs;
};

std::vector<Variable> variables_of(const Mechanism& mechanism, const Function& function) {
  std::vector<Variable> variables;
  for (const InputKind kind : function.inputs) {
    const InputArgument argument = input_argument(kind, JointCounts(mechanism), function);
    variables.push_back({kind, argument.name, argument.length, kind == InputKind::q ? mechanism.base_bodies() : 0});
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

// The matrix whose row k is row k of `rows` when these count the entries of an output column by column.
NodeMatrix with_rows_column_by_column(const NodeMatrix& rows, const Sparsity& output) {
  NodeMatrix result(rows.rows, rows.cols);
  for (int i = 0; i < output.rows; ++i) {
    for (int j = 0; j < output.cols; ++j) {
      for (int k = 0; k < rows.cols; ++k) result.at(j * output.rows + i, k) = rows.at(i * output.cols + j, k);
    }
  }
  return result;
}

// dY/dX by the entries of X.
NodeMatrix jacobian(const Differentiated& of, const Function& derivatives, std::size_t output, const Variable& by) {
  const std::string& name = of.function.outputs[output].name;
  const Output& found = output_of(derivatives, fmt::format("d{}_d{}", name, by.name));
  NodeMatrix matrix(static_cast<int>(found.entries.size()) / by.directions(), by.directions());
  for (int i = 0; i < matrix.rows; ++i) {
    for (int k = 0; k < matrix.cols; ++k) {
      matrix.at(i, k) = found.entries[static_cast<std::size_t>(i * matrix.cols + k)];
    }
  }
  return with_rows_column_by_column(columns_from(matrix, by.directions_before), of.outputs[output]);
}

// The second derivatives by the entries of X and Z; of two that are the other way round, their transpose.
std::optional<NodeMatrix> second_derivatives(const Function& derivatives, const Variable& x, const Variable& z) {
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
  void add_zeros(const std::string& name, int rows, int cols) {
    result_.outputs.push_back({name, without_entries(rows, cols)});
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
    AssembledArray array;
    const int variables = static_cast<int>(of.variables.size()), outputs = static_cast<int>(of.outputs.size());
    if (kind == InputKind::weights || kind == InputKind::direction) {
      const bool has_weights = kind == InputKind::weights;
      for (int k = 0; k < (has_weights ? outputs : variables); ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (!has_weights) array.length += of.variables[at].directions_before;
        const int length = has_weights ? of.outputs[at].count() : of.variables[at].length;
        if (length > 0) array.pieces.push_back({variables + outputs + k, array.length, length});
        array.length += length;
      }
      return array;
    }
    for (int k = 0; k < variables; ++k) {
      const Variable& each = of.variables[static_cast<std::size_t>(k)];
      if (each.kind == kind) return {each.length, {{k, 0, each.length}}};
    }
    throw Failure(FailureKind::bug, code_.name + " has an argument that its function has not");
  }

  Function code_;
  CasadiFunction result_;
};

// The weights that CasADi gives are those of the entries that are not always zero, column by column; those of the
// function are of all entries, row by row.
Function with_weights_of_nonzeros(const Function& function, const Differentiated& of) {
  std::vector<int> places(static_cast<std::size_t>(function.own.length), -1);
  int before = 0, place = 0;
  for (const Sparsity& sparsity : of.outputs) {
    for (int j = 0; j < sparsity.cols; ++j) {
      for (int k = sparsity.column_begin[static_cast<std::size_t>(j)];
           k < sparsity.column_begin[static_cast<std::size_t>(j + 1)]; ++k) {
        const int i = sparsity.row[static_cast<std::size_t>(k)];
        places[static_cast<std::size_t>(before + i * sparsity.cols + j)] = place++;
      }
    }
    before += sparsity.rows * sparsity.cols;
  }
  const auto image_of = [&places](const Input& input, Graph& to) -> std::optional<NodeId> {
    if (input.kind != InputKind::weights) return std::nullopt;
    const int own = places[static_cast<std::size_t>(input.index)];
    return own < 0 ? to.constant(0) : to.input({InputKind::weights, own});
  };
  Graph graph;
  const std::vector<NodeId> image = substituted(function.graph, image_of, graph);
  Function result = with_graph(function, std::move(graph), image);
  result.own.length = place;
  return result;
}

CasadiFunction itself(const Differentiated& of) {
  Written written(of.function, casadi_name(of.function.name));
  written.add_inputs(of.variables);
  for (const Output& output : of.function.outputs) written.add(output.name, matrix_of(output), output.meaning);
  return written.finished(of);
}

CasadiFunction jacobian_function(const Differentiated& of, const Function& derivatives) {
  Written written(derivatives, kJacobian + casadi_name(of.function.name));
  written.add_inputs(of.variables);
  written.add_unused_results(of);
  for (std::size_t k = 0; k < of.outputs.size(); ++k) {
    const std::string& name = of.function.outputs[k].name;
    for (const Variable& by : of.variables) {
      written.add(fmt::format("{}{}_{}", kJacobian, name, by.name), jacobian(of, derivatives, k, by),
                  fmt::format("derivatives of {} by {}", name, by.name));
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
    written.add(kAdjoint + by.name, columns_from(all.transposed(), by.directions_before).transposed(),
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
    written.add(kForward + name, matrix_of(output_of(product, "d" + name)), of.outputs[k], "rate of " + name);
  }
  return written.finished(of);
}

// `both`: outputs of hessian:f and of jac:f.
CasadiFunction adjoint_jacobian_function(const Differentiated& of, const Function& both) {
  const Function code = with_weights_of_nonzeros(both, of);
  Written written(code, "jac_adj1_" + casadi_name(of.function.name));
  written.add_inputs(of.variables);
  add_weights(of, written);
  for (const Variable& x : of.variables)
    written.add_input(fmt::format("out_adj_{}", x.name), without_entries(x.length, 1));
  for (const Variable& x : of.variables) {
    const std::string name = fmt::format("jac_adj_{}_", x.name);
    for (const Variable& z : of.variables) {
      const std::optional<NodeMatrix> second = second_derivatives(code, x, z);
      if (second) {
        written.add(name + z.name, *second,
                    fmt::format("second derivatives of the weighted sum by {}, {}", x.name, z.name));
      } else {
        written.add_zeros(name + z.name, x.length, z.length);
      }
    }
    for (std::size_t k = 0; k < of.outputs.size(); ++k) {
      const Sparsity& output = of.outputs[k];
      written.add_zeros(name + kOutput + of.function.outputs[k].name, x.length, output.rows * output.cols);
    }
    for (std::size_t k = 0; k < of.outputs.size(); ++k) {
      const std::string& output = of.function.outputs[k].name;
      written.add(name + kAdjoint + output, jacobian(of, code, k, x).transposed(),
                  fmt::format("derivatives of {} by {}, transposed", output, x.name));
    }
  }
  return written.finished(of);
}

}  // namespace

std::string casadi_name(const std::string& function) { return cpp_identifier(function); }

std::vector<CasadiFunction> casadi_functions(const Mechanism& mechanism, const std::vector<Function>& functions) {
  std::vector<CasadiFunction> result;
  for (const Function& each : functions) {
    if (parts_of_name(each.name).derivative != Derivative::none) continue;
    const Differentiated of = differentiated(mechanism, each);
    result.push_back(itself(of));
    const auto add = [&](const std::string& name, const auto& written) {
      const auto found = std::find_if(functions.begin(), functions.end(),
                                      [&name](const Function& function) { return function.name == name; });
      if (found != functions.end()) result.push_back(written(of, *found));
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
