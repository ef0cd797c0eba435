// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cuda/dialect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <string_view>

#include "base/diagnostics/diagnostics.hpp"
#include "code/emit/name_space.hpp"
#include "code/emit/packed_places.hpp"
#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/cpp/function.hpp"
#include "code/languages/cpp/shapes.hpp"
#include "templates.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

constexpr std::size_t kTableIndent = 10;

// Variables of CUDA that are there without a header.
constexpr auto kVariables =
    std::to_array<std::string_view>({"threadIdx", "blockIdx", "blockDim", "gridDim", "warpSize"});

// Names that nvcc's header cuda_runtime.h declares in the global namespace, some by <time.h> and <ctype.h>; functions
// for float, with an f at the end, are added.
constexpr auto kOfRuntime = std::to_array<std::string_view>(
    {"all",        "any",        "asctime",   "ballot",  "clock",     "clock64",  "cospi",      "ctime",   "dadd",
     "daylight",   "difftime",   "dim3",      "dmul",    "dsub",      "dysize",   "erfcinv",    "erfcx",   "erfinv",
     "fdivide",    "fpclassify", "getdate",   "gmtime",  "isfinite",  "isnormal", "itimerspec", "llmax",   "llmin",
     "localtime",  "max",        "min",       "mktime",  "nanosleep", "norm",     "norm3d",     "norm4d",  "normcdf",
     "normcdfinv", "nullptr_t",  "ptrdiff_t", "rcbrt",   "rhypot",    "rnorm",    "rnorm3d",    "rnorm4d", "rsqrt",
     "sigevent",   "signbit",    "sincospi",  "sinpi",   "strftime",  "strptime", "time",       "timegm",  "timelocal",
     "timex",      "timezone",   "tm",        "toascii", "tolower",   "toupper",  "tzname",     "tzset",   "ullmax",
     "ullmin",     "umax",       "umin"});

bool is_listed(std::string_view name) {
  const auto is_in = [name](const auto& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return is_in(kVariables) || is_in(kOfRuntime);
}

// "float4", "uchar2".
bool is_vector_type(std::string_view name) {
  if (name.empty() || name.back() < '1' || name.back() > '4') return false;
  std::string_view scalar = name.substr(0, name.size() - 1);
  if (scalar.starts_with('u')) scalar.remove_prefix(1);
  for (const char* each : {"char", "short", "int", "long", "longlong", "float", "double"}) {
    if (scalar == each) return true;
  }
  return false;
}

// Whether CUDA's runtime declares the name, in the global namespace: "cudaSuccess", "threadIdx", "max", "float4".
bool is_in_runtime(std::string_view name) {
  const auto begins = [name](std::string_view prefix, char first, char last) {
    return name.size() > prefix.size() && name.starts_with(prefix) && name[prefix.size()] >= first &&
           name[prefix.size()] <= last;
  };
  constexpr std::string_view kMake = "make_";
  return begins("cuda", 'A', 'Z') || begins("atomic", 'A', 'Z') || begins("tex", '1', '3') ||
         begins("surf", '1', '3') || is_vector_type(name) ||
         (name.starts_with(kMake) && is_vector_type(name.substr(kMake.size()))) || is_listed(name) ||
         (name.ends_with('f') && is_listed(name.substr(0, name.size() - 1)));
}

// Throws Failure(usage) for a namespace whose name means something else in CUDA or in the header's own macros.
void check_name_space(const std::string& name_space) {
  const std::vector<std::string> parts = parts_of_namespace(name_space);
  const bool is_macro =
      std::any_of(parts.begin(), parts.end(), [](const std::string& part) { return part.starts_with("FLATDYN_"); });
  if (!is_macro && !is_in_runtime(parts.front())) return;
  throw Failure(
      FailureKind::usage,
      fmt::format("\"{}\" is no namespace for CUDA: {}", name_space,
                  is_macro ? "macros of the header begin with FLATDYN_" : "its runtime has something of that name"),
      fmt::format("another --namespace, such as \"{}_\"", is_macro ? "arm" : name_space));
}

// The types of a function's arrays, in order: "In1", "In2", "Out1".
std::vector<std::string> array_types(const std::vector<Argument>& arguments) {
  std::vector<std::string> types;
  int inputs = 0, outputs = 0;
  for (const Argument& argument : arguments) {
    if (argument.kind == Argument::Kind::input) types.push_back(fmt::format("In{}", ++inputs));
    if (argument.kind == Argument::Kind::output) types.push_back(fmt::format("Out{}", ++outputs));
  }
  return types;
}

// A parameter. One that is not used has no name, so that compilers do not warn.
std::string array_parameter(const std::string& type, const Argument& argument) {
  return type + " " + (argument.is_used ? argument.name : "/* " + argument.name + " */");
}

std::string template_head(const FunctionText& text) {
  std::string head = "class Scalar";
  for (std::size_t k = 0; k < text.inputs.size(); ++k) head += fmt::format(", class In{}", k + 1);
  for (std::size_t k = 0; k < text.outputs.size(); ++k) head += fmt::format(", class Out{}", k + 1);
  return head + (text.uses_trigonometry ? ", class SinCos = DefaultSinCos" : "");
}

// A head may be longer than a line.
std::string broken(const std::string& head) {
  std::string text = without_newline(list_line("template <", {head}, ">", 0));
  return text.substr(std::string("template <").size(), text.size() - std::string("template <>").size());
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string table_of(const std::vector<int>& places) {
  std::string line, text;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::string item = std::to_string(places[k]) + (k + 1 < places.size() ? "," : "};");
    if (!line.empty() && kTableIndent + line.size() + 1 + item.size() > kLineWidth) {
      text += std::string(kTableIndent, ' ') + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + item;
  }
  return text + std::string(kTableIndent, ' ') + line;
}

data places_of(const Function& function) {
  data list(data::type::list);
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const std::vector<int> places = packed_places(function.outputs[k], function.graph);
    if (is_identity(places)) continue;
    data item;
    item["output"] = std::to_string(k);
    item["table"] = table_of(places);
    list << item;
  }
  return list;
}

bool has_places(const Function& function) {
  for (const Output& output : function.outputs) {
    if (!is_identity(packed_places(output, function.graph))) return true;
  }
  return false;
}

// Whether a part reads what an earlier one has written.
bool reads_parts(const Function& function) {
  const std::vector<Input> inputs = inputs_read(function);
  return std::any_of(inputs.begin(), inputs.end(), [](const Input& input) { return input.kind == InputKind::stored; });
}

// An argument's shape. An input without entries, the q of a body without joints, is nullptr.
std::string shape_in_kernel(const ShapedArray& array) {
  return array.length == 0 && !array.is_output ? "decltype(nullptr)" : shape_of(array);
}

// The struct of function k, whose parts begin at `first` among the functions.
data kernel_of(const CodeContent& content, std::size_t k, std::size_t first, int parts) {
  const Function& function = content.functions[k];
  const FunctionText& text = content.texts[k];
  const ShapedFunction shape = shaped(function, text, content.scope);
  data item;
  data calls(data::type::list);
  item["name"] = text.name;
  item["shape"] = shape_line(shape, shape_in_kernel);
  item["parts"] = std::to_string(std::max(1, parts));
  item["places?"] = has_places(function);
  item["places"] = places_of(function);
  for (int part = 0; part < std::max(1, parts); ++part) {
    data call;
    call["part"] = std::to_string(part);
    const std::size_t callee = parts == 0 ? k : first + static_cast<std::size_t>(part);
    call["callee"] = content.name_space + "::" + content.texts[callee].name;
    calls << call;
  }
  item["calls"] = data(calls);
  return item;
}

data kernels_of(const CodeContent& content) {
  data list(data::type::list);
  const std::vector<int>& parts = content.options.kernel_parts;
  const std::size_t whole = parts.empty() ? content.functions.size() : parts.size();
  std::size_t first = whole;
  for (std::size_t k = 0; k < whole; ++k) {
    const int count = parts.empty() ? 0 : parts[k];
    if (can_be_launched(content.texts[k])) list << kernel_of(content, k, first, count);
    first += static_cast<std::size_t>(count);
  }
  return list;
}

std::vector<std::string> example_of(const CodeContent& content) {
  const FunctionText& text = content.texts.front();
  const std::string& scalar = content.options.scalar;
  const std::string result = text.returns == "Scalar" ? scalar : text.returns;
  const std::string parameters = content.scope.parameters.empty() ? "" : content.name_space + "::Parameters<>";
  return call_example(text, {fmt::format("{}::{}<{}>", content.name_space, text.name, scalar), result, scalar, "{}",
                             parameters, "parameters"});
}

// A launch of the first function that has one.
std::vector<std::string> batch_example_of(const CodeContent& content) {
  const auto found = std::find_if(content.texts.begin(), content.texts.end(), can_be_launched);
  if (found == content.texts.end()) return {};
  const FunctionText& text = *found;
  std::vector<std::string> arguments = {"stream", "states"};
  if (!content.scope.parameters.empty()) arguments.emplace_back("parameters");
  for (const ArrayArgument& input : text.inputs) arguments.push_back(input.length > 0 ? input.name : "nullptr");
  for (const ArrayArgument& output : text.outputs) arguments.push_back(output.name);
  if (text.returns == "Scalar") arguments.emplace_back("results");
  if (text.returns == "bool") arguments.emplace_back("valid");
  const std::string call = fmt::format("flatdyn::cuda::for_each_state<Function, {}>(", content.options.scalar);
  constexpr std::size_t kCommentIndent = 5;  // "//   "
  std::vector<std::string> lines = lines_of(list_line("cudaError_t error = " + call, arguments, ");", kCommentIndent));
  for (std::string& line : lines) line.erase(0, kCommentIndent);
  lines.insert(lines.begin(), fmt::format("using Function = {}::functions::{};", content.name_space, text.name));
  return lines;
}

}  // namespace

std::vector<std::string> CudaDialect::reserved() const {
  std::vector<std::string> words = CppDialect::reserved();
  constexpr int kMostArrays = 16;
  for (int k = 1; k <= kMostArrays; ++k) {
    words.push_back(fmt::format("In{}", k));
    words.push_back(fmt::format("Out{}", k));
  }
  for (const char* word : {"In", "Out"}) words.emplace_back(word);
  words.insert(words.end(), kVariables.begin(), kVariables.end());
  return words;
}

LanguageTraits CudaDialect::traits() const {
  LanguageTraits traits = CppDialect::traits();
  traits.lives = Lives::fewest;
  traits.reads_parts = true;
  traits.stores_zeros_together = false;
  traits.longest_function = std::numeric_limits<int>::max() / 8;
  return traits;
}

std::string CudaDialect::written_entry(const std::string& output, int entry) const {
  return fmt::format("detail::stored({}, {})", output, entry);
}

void CudaDialect::declare(FunctionText& text, const UndeclaredFunction& function) const {
  const std::vector<std::string> types = array_types(function.arguments);
  std::size_t next = 0;
  for (const Argument& argument : function.arguments) {
    const bool is_array = argument.kind != Argument::Kind::parameters;
    text.parameters.push_back(array_parameter(is_array ? types[next++] : "const Parameters<Scalar>&", argument));
  }
  if (function.body.uses_trigonometry()) text.parameters.emplace_back("const SinCos& sin_cos = {}");
}

std::vector<FileTemplate> CudaDialect::files() const { return {{".cuh", templates::header_cuh}}; }

void CudaDialect::write_function(data& item, const Function&, const FunctionText& text) const {
  item["header_parameters"] = broken(template_head(text));
  item["signature"] = without_newline(
      list_line(fmt::format("{}FLATDYN_FUNCTION {} {}(", not_to_discard(text.returns), text.returns, text.name),
                text.parameters, ") noexcept {", 0));
}

void CudaDialect::write_page(data& page, const CodeContent& content) const {
  check_name_space(content.name_space);
  if (!content.texts.empty()) {
    page["example"] = list_of(example_of(content));
    page["batch_example"] = list_of(batch_example_of(content));
  }
  page["reads_parts?"] = std::any_of(content.functions.begin(), content.functions.end(), reads_parts);
  page["kernels"] = kernels_of(content);
  page["header_angles?"] = content.uses_trigonometry && !content.scope.angles.empty();
  page["cuda_sines"] = without_newline(rendered(templates::cuda_sines_cuh, page));
}

}  // namespace flatdyn
