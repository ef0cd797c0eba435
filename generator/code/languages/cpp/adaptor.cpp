// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/adaptor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "code/conventions/coverage.hpp"
#include "code/conventions/meanings.hpp"
#include "code/emit/argument_text.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "code/languages/cpp/function.hpp"
#include "code/languages/cpp/steps.hpp"
#include "code/lower/arguments.hpp"

namespace flatdyn {
namespace {

class AdaptorWriter {
 public:
  AdaptorWriter(const AdaptedCode& code, std::size_t function)
      : code_(code),
        convention_(code.convention),
        function_(code.functions[function]),
        text_(code.texts[function]),
        floats_(code.mechanism.floating_base),
        is_plain_(code.convention.is_plain() || !floats_),
        is_rubbed_(flatdyn::is_rubbed(function_, code.mechanism, code.convention)),
        size_(code.mechanism.size()),
        pose_(pose_entries(code.mechanism)) {}

  Adaptor written() {
    write_inputs();
    const std::string call = core_call(text_, arguments_);
    const bool has_results = write_results();
    Adaptor result{comment(), template_parameters(), signature(), "", shape()};
    result.body = without_newline(body(call, has_results));
    return result;
  }

 private:
  // C of velocities in axes that turn needs B.
  bool adds_inertia() const { return floats_ && is_coriolis(function_) && convention_.linear_in_world; }
  const FunctionText& inertia() const {
    const auto found = std::find_if(code_.functions.begin(), code_.functions.end(), is_of_inertia);
    return code_.texts[static_cast<std::size_t>(found - code_.functions.begin())];
  }
  bool uses_trigonometry() const { return text_.uses_trigonometry || (adds_inertia() && inertia().uses_trigonometry); }

  // Arguments of the call, and what converts them.
  void write_inputs() {
    if (!code_.mechanism.symbols.empty()) parameters_.emplace_back("const Parameters<Scalar>& parameters");
    for (const InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, JointCounts(code_.mechanism));
      if (kind == InputKind::g_b) {
        needs_base_ = true;
        locals_.emplace_back("g_b[3]");
        conversions_.emplace_back("base.gravity(g_b);");
        arguments_.emplace_back("g_b");
        continue;
      }
      parameters_.push_back("const Scalar* " + argument.name);
      if (kind == InputKind::q) {
        if (has_other_quaternions(convention_, code_.mechanism)) reorder_joints();
        arguments_.push_back(positions());
      } else if (kind == InputKind::tau && is_rubbed_) {
        const std::string core = argument.name + "_b";
        convert(argument,
                is_plain_ ? fmt::format("for (int k = 0; k < {}; ++k) {}[k] = tau[k];", argument.length, core)
                          : fmt::format("base.to_core(tau, {});", core),
                core);
        oppose_friction(core, "-");
      } else if (is_plain_ && (kind != InputKind::h_e || !floats_)) {
        arguments_.push_back(argument.name);
      } else if (kind == InputKind::h_e) {
        convert(argument, "base.to_base_axes(h_e, h_e_b);", "h_e_b");
      } else {
        const std::string core = argument.name + "_b";
        convert(argument, fmt::format("base.to_core({}, {});", argument.name, core), core);
        if (kind == InputKind::v && sees_from_origin()) {
          conversions_.push_back(fmt::format("base.stop_origin({});", core));
        }
      }
    }
  }

  // The joints' entries of q as the function takes them.
  std::string positions() const {
    return has_other_quaternions(convention_, code_.mechanism) ? "q_joints" : entries_of_joints();
  }
  std::string entries_of_joints() const { return pose_ == 0 ? "q" : fmt::format("q + {}", pose_); }
  void reorder_joints() {
    locals_.push_back(fmt::format("q_joints[{}]", code_.mechanism.position_count()));
    conversions_.push_back(fmt::format("detail::joints_to_core({}, q_joints);", entries_of_joints()));
  }

  void convert(const InputArgument& argument, const std::string& statement, const std::string& core) {
    needs_base_ = true;
    locals_.push_back(fmt::format("{}[{}]", core, argument.length));
    conversions_.push_back(statement);
    arguments_.push_back(core);
  }

  // The statements that add friction of the base's origin to a force in base axes, or with "-" take it away.
  static std::string friction_added_to(const std::string& force, const std::string& sign) {
    return fmt::format("base.friction(v, f_b);\nfor (int k = 0; k < 3; ++k) {0}[k] = {0}[k] {1} f_b[k];", force, sign);
  }
  void oppose_friction(const std::string& force, const std::string& sign) {
    locals_.emplace_back("f_b[3]");
    conversions_.push_back(with_replaced(friction_added_to(force, sign), "\n", "\n  "));
  }

  // Whether the function is called as from a frame that moves with the base's origin at the moment.
  bool sees_from_origin() const {
    return floats_ && convention_.linear_in_world &&
           std::any_of(function_.outputs.begin(), function_.outputs.end(), depends_on_acceleration);
  }

  // Adds the outputs, and what converts them in place. Returns whether there are such statements.
  bool write_results() {
    for (std::size_t k = 0; k < text_.outputs.size(); ++k) {
      const std::string& name = text_.outputs[k].name;
      parameters_.push_back("Scalar* " + name);
      const std::string statement = conversion_of(function_.outputs[k], name);
      if (needs_friction(function_.outputs[k])) locals_.emplace_back("f_b[3]");
      if (!statement.empty()) results_.push_back(statement);
    }
    if (!results_.empty()) needs_base_ = true;
    return !results_.empty();
  }

  // Whether friction is added to this result, as no force is an argument.
  bool needs_friction(const Output& output) const {
    return is_rubbed_ && output.quantity == OutputQuantity::joint_torque && function_.outputs.size() == 1;
  }

  std::string conversion_of(const Output& output, const std::string& name) const {
    const std::string turned = turned_result(output, name);
    if (!needs_friction(output)) return turned;
    return friction_added_to(name, "+") + (turned.empty() ? "" : "\n" + turned);
  }

  std::string turned_result(const Output& output, const std::string& name) const {
    if (!floats_) return "";
    switch (output.quantity) {
      case OutputQuantity::joint_torque:
      case OutputQuantity::joint_rate:
      case OutputQuantity::joint_acceleration:
        return is_plain_ ? "" : fmt::format("base.from_core({});", name);
      case OutputQuantity::joint_inertia:
      case OutputQuantity::torque_per_rate:
        return is_plain_ ? "" : turning(name) + fmt::format("base.both_from_core({});", name);
      case OutputQuantity::number:
        if (output.layout != Layout::matrix) return "";
        if (output.rows == 3) return fmt::format("base.turn_frame({});", name);
        return fmt::format("for (int k = 0; k < {}; k += 9) base.turn_frame({} + k);", 3 * output.rows, name);
      case OutputQuantity::contact_force:
      case OutputQuantity::contact_impulse:
      case OutputQuantity::contact_acceleration:
        return for_each_three(output, fmt::format("base.turn({} + k)", name));
      case OutputQuantity::contact_jacobian:
        return for_each_three(output, fmt::format("base.rows_to_world({} + {} * k, 3)", name, size_));
      case OutputQuantity::position:
        if (output.rows == 3) return fmt::format("base.move_point({});", name);
        return for_each_three(output, fmt::format("base.move_point({} + k)", name));
      case OutputQuantity::tip_jacobian:
      case OutputQuantity::momentum_per_rate:
        return fmt::format("base.rows_to_world({}, {});", name, output.rows);
      case OutputQuantity::tip_acceleration:
      case OutputQuantity::force_and_moment:
        return fmt::format("base.to_world({});", name);
      default:
        return "";
    }
  }

  // Points, or the rows of contacts, of which three are a vector.
  static std::string for_each_three(const Output& output, const std::string& statement) {
    return fmt::format("for (int k = 0; k < {}; k += 3) {};", output.rows, statement);
  }

  std::string turning(const std::string& name) const {
    return adds_inertia() ? fmt::format("base.add_turning(B, v_b, {});\n", name) : "";
  }

  std::string core_call(const FunctionText& text, std::vector<std::string> arguments) const {
    for (const ArrayArgument& output : text.outputs) arguments.push_back(output.name);
    return call_of(text, std::move(arguments));
  }

  std::string call_of(const FunctionText& text, std::vector<std::string> arguments,
                      const char* result = "is_valid") const {
    if (!code_.mechanism.symbols.empty()) arguments.insert(arguments.begin(), "parameters");
    if (text.uses_trigonometry) arguments.emplace_back("sin_cos");
    return without_newline(list_line(
        fmt::format("{}::{}::{}(", result_before_call(text, result), code_.name_space, text.name), arguments, ");", 2));
  }

  // "return " for the last statement that has a value, and "const bool is_valid = " for one that results follow.
  std::string result_before_call(const FunctionText& text, const char* result) const {
    if (text.returns == "void") return "";
    return text.outputs.empty() || !has_conversions() ? "return " : fmt::format("const bool {} = ", result);
  }
  bool has_conversions() const {
    for (std::size_t k = 0; k < text_.outputs.size(); ++k) {
      if (!conversion_of(function_.outputs[k], "x").empty()) return true;
    }
    return false;
  }

  std::string body(const std::string& call, bool has_results) const {
    std::string lines;
    if (needs_base_) lines += "  const detail::Base<Scalar> base(q);\n";
    std::vector<std::string> arrays = locals_;
    if (adds_inertia()) arrays.push_back(fmt::format("B[{}]", size_ * size_));
    if (!arrays.empty()) lines += list_line("Scalar ", arrays, ";", kStatementIndent);
    for (const std::string& statement : conversions_) lines += "  " + statement + "\n";
    if (adds_inertia()) lines += call_of(inertia(), {positions(), "B"}, "has_inertia") + "\n";
    lines += call + "\n";
    for (const std::string& statement : results_) lines += "  " + with_replaced(statement, "\n", "\n  ") + "\n";
    const bool needs_both = adds_inertia() && inertia().returns == "bool";
    if (has_results && text_.returns == "bool") {
      lines += needs_both ? "  return has_inertia && is_valid;\n" : "  return is_valid;\n";
    }
    return lines;
  }

  std::string template_parameters() const {
    return uses_trigonometry() ? "class Scalar, class SinCos = DefaultSinCos" : "class Scalar";
  }

  std::string signature() const {
    std::vector<std::string> parameters = parameters_;
    if (uses_trigonometry()) parameters.emplace_back("const SinCos& sin_cos = {}");
    return without_newline(
        list_line(fmt::format("{}static inline {} {}(", not_to_discard(text_.returns), text_.returns, text_.name),
                  parameters, ") noexcept {", 0));
  }

  // The type of the function, with the length of this convention's q.
  ShapedFunction shape() const {
    FunctionText text = text_;
    std::vector<ArrayArgument> inputs;
    for (std::size_t k = 0; k < text.inputs.size(); ++k) {
      const InputKind kind = function_.inputs[k];
      if (kind == InputKind::g_b) continue;
      inputs.push_back(text.inputs[k]);
      if (kind == InputKind::q) inputs.back().length += static_cast<std::size_t>(pose_);
    }
    text.inputs = inputs;
    HeaderScope scope(dialect_);
    if (!code_.mechanism.symbols.empty()) scope.parameters.emplace_back("parameters");
    return shaped(function_, text, scope);
  }

  std::vector<std::string> comment() const {
    std::vector<std::string> lines = brief_comment(function_);
    std::vector<std::array<std::string, 3>> rows;
    for (const InputKind kind : function_.inputs) {
      if (kind == InputKind::g_b) continue;
      const InputArgument argument = input_argument(kind, JointCounts(code_.mechanism));
      const int length = argument.length + (kind == InputKind::q ? pose_ : 0);
      rows.push_back({fmt::format("{}[{}]", argument.name, length), "in",
                      meaning_of_input(kind, convention_, JointCounts(code_.mechanism), function_)});
    }
    for (std::size_t k = 0; k < text_.outputs.size(); ++k) {
      Output output = function_.outputs[k];
      output.name = text_.outputs[k].name;
      rows.push_back({fmt::format("{}[{}]", text_.outputs[k].name, text_.outputs[k].length), "out",
                      floats_ ? meaning_of_output(output, convention_, JointCounts(code_.mechanism)) : output.meaning});
      const std::string layout = layout_text(output);
      if (!layout.empty()) rows.push_back({"", "", layout});
    }
    for (const std::string& line : argument_lines(rows)) lines.push_back(line);
    const std::string result = text_.result.empty() ? "" : "Returns " + comment_text(text_.result) + ".";
    for (const std::string& line : wrapped_words(result, kCommentWidth)) lines.push_back(line);
    if (function_.at_rest) lines.emplace_back("Holds where v = 0, and does not read it.");
    return lines;
  }

  const AdaptedCode& code_;
  const Convention& convention_;
  const Function& function_;
  const FunctionText& text_;
  const bool floats_;     // whether the base does
  const bool is_plain_;   // whether v, a and tau are as in flatdyn's functions
  const bool is_rubbed_;  // whether friction of the base's origin is added
  const int size_;
  const int pose_;  // entries of q that are the base's
  CppDialect dialect_;
  bool needs_base_ = false;
  std::vector<std::string> parameters_, arguments_, locals_, conversions_, results_;
};

}  // namespace

Adaptor adaptor(const AdaptedCode& code, std::size_t function) { return AdaptorWriter(code, function).written(); }

}  // namespace flatdyn
