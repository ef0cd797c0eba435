// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/emitted_text.hpp"
#include "base/diagnostics/diagnostics.hpp"
#include "code/languages/c/read.hpp"
#include "code/languages/cpp/read.hpp"
#include "code/languages/javascript/read.hpp"
#include "fuzz/readers.hpp"

namespace flatdyn::testing {
namespace {

constexpr std::size_t kEntries = 64;  // entries of every output

// A function with as many outputs as that of the text.
Function function_like(const ScannedFunction& written) {
  Function like;
  like.name = written.name;
  for (const ScannedFunction::Parameter& parameter : written.parameters) {
    if (!parameter.is_output) continue;
    Output output;
    output.rows = kEntries;
    output.entries.assign(kEntries, like.graph.constant(0));
    like.outputs.push_back(std::move(output));
  }
  if (!like.outputs.empty() || written.returns == "void" || written.returns == "bool") return like;
  Output returned;
  returned.entries.assign(kEntries, like.graph.constant(0));
  like.outputs.push_back(std::move(returned));
  return like;
}

}  // namespace

// Anything else than emitted text is refused.
void read_text_bytes(std::string_view bytes) {
  const auto read = [](const auto& text_of) {
    try {
      const EmittedText text = text_of();
      for (std::size_t k = 0; k < text.functions().size(); ++k) text.read(k, function_like(text.functions()[k]));
    } catch (const Failure&) {
    }
  };
  const std::string text(bytes);
  read([&] { return EmittedText(text, cpp_reader()); });
  read([&] { return EmittedText(text, c_reader("double")); });
  read([&] { return EmittedText(text, javascript_reader()); });
}

}  // namespace flatdyn::testing
