// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of emitted C++ as types, and the instances that a source is compiled for.
#include <fmt/format.h>

#include <algorithm>

#include "code/languages/cpp/read_file.hpp"

namespace flatdyn {
namespace {

bool is_whole_result(const Function& function) {
  return std::all_of(function.outputs.begin(), function.outputs.end(), [](const Output& output) {
    return std::find(output.left_out.begin(), output.left_out.end(), true) == output.left_out.end();
  });
}

}  // namespace

// Takes const Scalar (&q)[7] or Scalar (&B)[7][7].
void CppFile::shape_of_array(const EmittedParameter& parameter, const std::string& name) {
  const char* const type = parameter.kind == EmittedParameter::Kind::input ? "const Scalar" : "Scalar";
  if (parameter.columns == 0) {
    expect(fmt::format("{} (&{})[{}]", type, name, parameter.length));
  } else {
    const int rows = parameter.length / parameter.columns;
    expect(fmt::format("{} (&{})[{}][{}]", type, name, rows, parameter.columns));
  }
}

// Takes the functions by themselves, which may be members of stages, too, and then those that are only members.
void CppFile::shapes() {
  const auto is_empty = [this](const Known& known) {
    const std::vector<EmittedParameter> list = parameters_of(*known.function, contents_);
    return std::any_of(list.begin(), list.end(), [](const EmittedParameter& each) {
      return each.kind != EmittedParameter::Kind::parameters && each.length == 0;
    });
  };
  const auto is_among_others = [this](const Known& known) {
    return std::any_of(contents_.functions.begin(), contents_.functions.end(),
                       [&](const FileFunction& each) { return each.name == known.function->name; });
  };
  std::vector<const Known*> wanted;
  for (const Known& known : known_) {
    const bool is_member = !known.stage.empty();
    if (!is_empty(known) && !(is_member && is_among_others(known))) wanted.push_back(&known);
  }
  if (wanted.empty()) return;
  const auto by_stage = [this](const Known* a, const Known* b) { return place_of_stage(*a) < place_of_stage(*b); };
  std::stable_sort(wanted.begin(), wanted.end(), by_stage);
  expect("namespace functions {");
  for (const Known* known : wanted) shape(*known, known->stage.empty());
  expect("}");
}

// The functions by themselves are before those of the first stage.
int CppFile::place_of_stage(const Known& known) const {
  for (std::size_t k = 0; k < contents_.stages.size(); ++k) {
    if (contents_.stages[k].name == known.stage) return static_cast<int>(k) + 1;
  }
  return 0;
}

void CppFile::shape(const Known& known, bool is_by_itself) {
  const std::string& name = known.function->name;
  std::string stage = known.stage;
  for (const Known& other : known_) {
    if (other.function->name == name && !other.stage.empty()) stage = other.stage;
  }
  expect(fmt::format("struct {} {{ template <class Scalar> using Shape = {}(", name,
                     returns_of(*known.function, "Scalar")));
  std::size_t output = 0;
  bool is_first = true;
  for (const EmittedParameter& parameter : parameters_of(*known.function, contents_)) {
    if (!is_first) expect(",");
    is_first = false;
    if (parameter.kind == EmittedParameter::Kind::parameters) {
      expect("const Parameters<Scalar>&");
    } else {
      const bool is_output = parameter.kind == EmittedParameter::Kind::output;
      shape_of_array(parameter, is_output ? known.outputs[output++] : parameter.name);
    }
  }
  expect(");");
  if (!is_whole_result(*known.function->function)) expect("static constexpr bool leaves_out = true;");
  if (is_by_itself) {
    expect("template <class... Of> [[gnu::always_inline]] auto operator()(Of&&... of) const noexcept {");
    expect(fmt::format("return ::$namespace$::{}(of...); }}", name));
  }
  if (!stage.empty()) {
    expect(
        fmt::format("template <class Scalar, class... Of> [[gnu::always_inline]] auto operator()(const {}<Scalar>& "
                    "stage, Of&&... of) "
                    "const noexcept {{ return stage.{}(of...); }}",
                    stage, name));
  }
  expect("};");
}

// Takes the list of instances in the header, or the same list in the source.
void CppFile::instances(const std::string& begin) {
  const auto of_scalars = [&](const Known& known) {
    for (const std::string& scalar : contents_.scalars) {
      instance(begin, known, scalar, "DefaultSinCos");
      if (known.has_sin_cos) instance(begin, known, scalar, fmt::format("GivenSinCos<{}>", scalar));
    }
  };
  for (const Known& known : known_) {
    if (known.stage.empty()) of_scalars(known);
  }
  for (const Known& known : makers_) of_scalars(known);
  for (const std::string& scalar : contents_.scalars) {
    for (const FileStage& stage : contents_.stages) expect(fmt::format("{} struct {}<{}>;", begin, stage.name, scalar));
  }
  for (const std::string& scalar : contents_.scalars) {
    expect(fmt::format("{} bool rounding_is_as_written<{}>();", begin, scalar));
  }
}

void CppFile::instance(const std::string& begin, const Known& known, const std::string& scalar,
                       const std::string& source) {
  using Kind = EmittedParameter::Kind;
  std::string list;
  std::size_t output = 0;
  for (const EmittedParameter& parameter : parameters_of(*known.function, contents_)) {
    const std::string& name = parameter.kind == Kind::output ? known.outputs[output++] : parameter.name;
    const std::string type = parameter.kind == Kind::parameters ? fmt::format("const Parameters<{}>& ", scalar)
                             : parameter.kind == Kind::input    ? fmt::format("const {}* ", scalar)
                                                                : scalar + "* ";
    list += (list.empty() ? "" : ", ") + type + name;
  }
  if (known.has_sin_cos) list += (list.empty() ? "" : ", ") + fmt::format("const {}& sin_cos", source);
  expect(fmt::format("{} {} {}({});", begin, returns_of(*known.function, scalar), known.function->name, list));
}

}  // namespace flatdyn
