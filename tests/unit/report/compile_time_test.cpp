// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/compile_time.hpp"

#include <gmock/gmock.h>

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A function that writes entries, of which the first is the sum of two inputs.
Function sum_and_zeros(std::size_t entries) {
  Function function;
  Output output{};
  output.entries.assign(entries, function.graph.constant(Rational(0)));
  const NodeId a = function.graph.input({InputKind::q, 0}), b = function.graph.input({InputKind::q, 1});
  output.entries[0] = function.graph.sum({{1, a}, {1, b}});
  function.outputs.push_back(output);
  return function;
}

std::vector<OptimisedFunction> one_function(std::size_t entries) {
  std::vector<OptimisedFunction> functions(1);
  functions[0].function = sum_and_zeros(entries);
  return functions;
}

TEST(CompileTime, IsThatOfOperationsAndOfWrittenEntries) {
  EXPECT_DOUBLE_EQ(compile_seconds(sum_and_zeros(1)), 1.5e-4 + 4e-4);
  EXPECT_DOUBLE_EQ(compile_seconds(sum_and_zeros(10)), 1.5e-4 + 10 * 4e-4);
}

TEST(CompileTime, OfEntriesThatAreLeftOutIsNone) {
  Function function = sum_and_zeros(10);
  function.outputs[0].left_out.assign(10, true);
  function.outputs[0].left_out[0] = false;
  EXPECT_DOUBLE_EQ(compile_seconds(function), 1.5e-4 + 4e-4);
}

TEST(CompileTime, IsToldFromSomeSecondsOn) {
  EXPECT_THAT(describe_compile_time(one_function(7000), {}, {}), IsEmpty());
  EXPECT_THAT(describe_compile_time(one_function(10'000), {}, {}),
              HasSubstr("takes some 4 s of a processor at -O2, in each file that calls all of it"));
}

TEST(CompileTime, OfAPairIsThatOfItsInstances) {
  EmitOptions options;
  options.form = Form::pair;
  options.more_scalars = {"float"};
  EXPECT_THAT(describe_compile_time(one_function(10'000), {}, options), HasSubstr("takes some 16 s"));
}

TEST(CompileTime, IsNoneWhereNothingIsCompiled) {
  EmitOptions options;
  options.language = "javascript";
  EXPECT_THAT(describe_compile_time(one_function(100'000), {}, options), IsEmpty());
  options.language = "c";
  EXPECT_THAT(describe_compile_time(one_function(100'000), {}, options), HasSubstr("once, in its source"));
}

}  // namespace
}  // namespace flatdyn::testing
