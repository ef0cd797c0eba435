// SPDX-License-Identifier: GPL-2.0-or-later
// The CUDA form on the host: the bits of the C++ form in every layout of flatdyn/cuda_batch.cuh, and in the parts of
// kernels the same up to rounding, as parts name other values; and its syntax as device code by clang, for which no
// CUDA need be installed.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;

// Compares at all states what is computed in tiles, columns or rows with single calls of the C++ form. Prints the
// number of entries that differ. `valid` of a function in parts is that of all of them.
constexpr const char* kProgram = R"text(
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "cpp/ROBOT.hpp"
#include "flatdyn/cuda_batch.cuh"
#include "cuda/ROBOT.cuh"

using namespace flatdyn::cuda;
constexpr std::size_t states = 70;  // two tiles and a part of one

template <class T>
T number(unsigned& seed) {
  seed = seed * 1664525u + 1013904223u;
  return (T(seed >> 8) - T(8388608)) / T(2796202);
}
// Whether two numbers are the same; of functions in parts, up to some last places of the output's largest entry.
template <class T>
bool same(T a, T b, T tolerance) {
  return std::memcmp(&a, &b, sizeof(T)) == 0 || a == b || std::abs(a - b) <= tolerance;
}

template <class Function, class Layout, class T, class Cpp, class Shape>
struct Comparison;
template <class Function, class Layout, class T, class Cpp, class R, class... A>
struct Comparison<Function, Layout, T, Cpp, R(A...)> {
  using Of = detail::Batch<Function, T, Layout>;
  static constexpr bool outputs[] = {detail::Argument<A>::is_output...};
  static constexpr int full[] = {detail::Argument<A>::entries...};

  template <std::size_t... k>
  static int differences(std::index_sequence<k...>) {
    std::vector<T> arrays[] = {std::vector<T>(Layout::length(states, Of::template entries<k, A>()))...};
    unsigned seed = 7;
    for (std::size_t a = 0; a < sizeof...(A); ++a) {
      if (!outputs[a])
        for (T& x : arrays[a]) x = number<T>(seed);
    }
    arrays[0][0] = T(3e5);  // an angle for the library
    const std::unique_ptr<bool[]> valid(new bool[states]());
    if constexpr (std::is_same_v<R, bool>)
      for_each_state_on_host<Function, T, Layout>(states, arrays[k].data()..., valid.get());
    else
      for_each_state_on_host<Function, T, Layout>(states, arrays[k].data()...);
    int count = 0;
    for (std::size_t state = 0; state < states; ++state) {
      std::vector<T> single[] = {std::vector<T>(static_cast<std::size_t>(full[k]))...};
      (read<k, A>(arrays[k], state, single[k]), ...);
      if constexpr (std::is_same_v<R, bool>) {
        const bool holds = Cpp()(single[k].data()...);
        if (holds != valid[state]) ++count;
      } else {
        Cpp()(single[k].data()...);
      }
      ((count += compare<k, A>(arrays[k], state, single[k])), ...);
    }
    return count;
  }

  template <std::size_t k, class Of1>
  static T at(const std::vector<T>& array, std::size_t state, int place) {
    return array[Layout::first(state, states, Of::template entries<k, Of1>()) + Layout::stride(states) * place];
  }
  template <std::size_t k, class Of1>
  static void read(const std::vector<T>& array, std::size_t state, std::vector<T>& single) {
    for (int e = 0; !outputs[k] && e < full[k]; ++e) single[static_cast<std::size_t>(e)] = at<k, Of1>(array, state, e);
  }
  template <std::size_t k, class Of1>
  static int compare(const std::vector<T>& array, std::size_t state, const std::vector<T>& single) {
    int count = 0;
    T largest = T(0);
    for (const T x : single) largest = std::max(largest, std::abs(x));
    // B's condition multiplies roundings of accelerations.
    const T tolerance = Function::parts > 1 ? 256 * std::numeric_limits<T>::epsilon() * largest : T(0);
    for (int e = 0; outputs[k] && e < full[k]; ++e) {
      const int place = detail::Places<Function, Of::output_number(k), Layout>::at(e);
      const T found = place < 0 ? T(0) : at<k, Of1>(array, state, place);
      if (!same(found, single[static_cast<std::size_t>(e)], tolerance)) ++count;
    }
    return count;
  }
};

template <class Function, class Cpp, class T>
int in_all_layouts() {
  int count = 0;
  const auto add = [&count](auto layout) {
    using Shape = typename Function::template Shape<T>;
    using Each = Comparison<Function, decltype(layout), T, Cpp, Shape>;
    count += Each::differences(typename detail::Batch<Function, T, decltype(layout)>::All());
  };
#ifndef FEW_LAYOUTS
  add(Tiles());
  add(Columns());
  add(Packed<Rows>());
#endif
  add(Rows());
  add(Packed<Tiles>());
  return count;
}

int main() {
  int count = 0;
#define COMPARE(name)                                                                     \
  count += in_all_layouts<ROBOT_cuda::functions::name, ROBOT::functions::name, double>(); \
  count += in_all_layouts<ROBOT_cuda::functions::name, ROBOT::functions::name, float>();
  FUNCTIONS
  std::printf("%d", count);
}
)text";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

class CudaForm : public ::testing::Test {
 protected:
  void make(const std::string& file, const std::string& robot, const std::vector<std::string>& functions) {
    for (const char* of : {"cpp", "cuda"}) fs::create_directories(folder_.path() / of);
    std::string list, calls;
    for (const std::string& name : functions) {
      list += (list.empty() ? "" : ",") + name;
      calls += "COMPARE(" + name + ")\n";
    }
    const std::string both = " --functions " + list;
    ASSERT_EQ(generate(FLATDYN_PROGRAM, FLATDYN_SOURCE_DIR, {file, both}, folder_.path() / "cpp"), "");
    const std::string cuda = both + " --language cuda --namespace " + robot + "_cuda --name " + robot;
    ASSERT_EQ(generate(FLATDYN_PROGRAM, FLATDYN_SOURCE_DIR, {file, cuda}, folder_.path() / "cuda"), "");
    write(folder_.path() / "program.cpp", replaced(replaced(kProgram, "ROBOT", robot), "FUNCTIONS", calls));
    write(folder_.path() / "kernels.cu", kernels(robot, functions));
  }

  // A launch of every function.
  static std::string kernels(const std::string& robot, const std::vector<std::string>& functions) {
    std::string text = fmt::format("#include \"cuda/{}.cuh\"\n#include \"flatdyn/cuda_batch.cuh\"\n", robot);
    for (const std::string& name : functions) {
      text += fmt::format(
          "template <class... A>\ncudaError_t launch_{0}(A... a) {{\n  using flatdyn::cuda::Packed;\n"
          "  return flatdyn::cuda::for_each_state<{1}_cuda::functions::{0}, float, "
          "Packed<flatdyn::cuda::Tiles>>(a...);\n}}\n",
          name, robot);
    }
    const std::string arrays = "cudaStream_t stream, const float* in, float* out, bool* valid";
    text += fmt::format("cudaError_t all({}) {{\n", arrays);
    for (const std::string& name : functions) {
      const bool is_checked = name.starts_with("forward_dynamics"), is_matrix = name == "inertia_matrix";
      const int outputs = name == "forward_dynamics_derivatives" ? 3 : name == "inverse_dynamics_derivatives" ? 2 : 1;
      text += fmt::format("  if (launch_{}(stream, size_t(9)", name);
      for (int k = 0; k < (is_matrix ? 1 : 3); ++k) text += ", in";
      for (int k = 0; k < outputs; ++k) text += ", out";
      text += std::string(is_checked ? ", valid" : "") + ") != cudaSuccess) return cudaSuccess;\n";
    }
    return text + "  return cudaSuccess;\n}\n";
  }

  std::string run(const std::string& command) { return output_of(folder_.path(), command); }

  TemporaryFolder folder_;
};

constexpr const char* kCompile =
    "c++ -std=c++17 -O0 -ffp-contract=off -fno-tree-slp-vectorize -Wall -Wextra -Wpedantic -Wshadow -Wconversion "
    "-Werror "
    "-I. -I " FLATDYN_SOURCE_DIR "/runtime/include program.cpp -o program && ./program";

constexpr const char* kClang =
    "clang++ -x cuda -std=c++17 -fsyntax-only -nocudainc -nocudalib -Wno-unknown-cuda-version --cuda-gpu-arch=sm_70 "
    "-Wall -Wextra -Werror -include " FLATDYN_SOURCE_DIR "/tests/support/cuda/cuda_runtime.h -I " FLATDYN_SOURCE_DIR
    "/tests/support/cuda -I. -I " FLATDYN_SOURCE_DIR "/runtime/include kernels.cu";

TEST_F(CudaForm, HasTheBitsOfCppAndIsDeviceCode) {
  make("robots/panda.urdf", "panda",
       {"inverse_dynamics", "inertia_matrix", "forward_dynamics", "inverse_dynamics_derivatives"});
  EXPECT_EQ(run(kCompile), "0");
  EXPECT_THAT(run(kClang), IsEmpty());
}

// Two parts read what the first one has written, B^-1, where equal entries may be there once.
TEST_F(CudaForm, OfPartsThatReadEarlierOnesIsTheSame) {
  make("robots/panda.urdf", "panda", {"forward_dynamics_derivatives"});
  EXPECT_NE(content_of(folder_.path() / "cuda/panda.cuh").find("detail::stored(dqdd_dtau, "), std::string::npos);
  EXPECT_EQ(run(replaced(kCompile, "-I. ", "-DFEW_LAYOUTS -I. ")), "0");
  EXPECT_THAT(run(kClang), IsEmpty());
}

TEST_F(CudaForm, OfAQuadrupedIsInPartsByItsLegs) {
  make("robots/quadruped12.urdf", "quadruped12", {"inertia_matrix", "forward_dynamics_derivatives"});
  EXPECT_NE(content_of(folder_.path() / "cuda/quadruped12.cuh").find("parts = 2"), std::string::npos);
  EXPECT_EQ(run(kCompile), "0");
}

}  // namespace
}  // namespace flatdyn::testing
