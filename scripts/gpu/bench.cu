// SPDX-License-Identifier: GPL-2.0-or-later
// Times one function on a graphics processor and compares it with 50 digits. Compiled with -D HEADER="panda.cuh"
// -D SPACE=panda -D FUNCTION=gravity -D LAYOUT=Tiles -D SCALAR=double -D ROBOT=panda. Prints a line of a table:
// robot, function, layout, scalar; nanoseconds a state; numbers of registers, bytes of local memory that a thread has
// (spilled registers), GB/s of inputs and outputs; error in units of the scalar's last place, beside the largest entry
// of the output in the state; kernels.
#include HEADER

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "flatdyn/cuda_batch.cuh"
#include "states.hpp"

namespace {

using namespace flatdyn::cuda;
using Function = SPACE::functions::FUNCTION;
using T = SCALAR;
using Layout = LAYOUT;

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)

void require(cudaError_t error, const char* what) {
  if (error == cudaSuccess) return;
  std::fprintf(stderr, "%s: %s\n", what, cudaGetErrorString(error));
  std::exit(1);
}

__global__ void fill(T* array, size_t states, int input, int entries) {
  const size_t at = blockIdx.x * size_t(256) + threadIdx.x;
  if (at >= states * static_cast<size_t>(entries)) return;
  const size_t state = at / static_cast<size_t>(entries);
  const int entry = static_cast<int>(at % static_cast<size_t>(entries));
  array[Layout::first(state, states, entries) + Layout::stride(states) * entry] = T(number_at(state, input, entry));
}

cudaStream_t stream = nullptr;

// The largest use of registers and local memory among the kernels.
struct Resources {
  int registers = 0, local = 0;
};

template <class Of, class Shape>
struct Measured;
template <class Of, class R, class... A>
struct Measured<Of, R(A...)> {
  static constexpr bool outputs[] = {detail::Argument<A>::is_output...};
  static constexpr int full[] = {detail::Argument<A>::entries...};

  template <int... part>
  static Resources resources(std::integer_sequence<int, part...>) {
    Resources most;
    const auto add = [&most](auto* kernel) {
      cudaFuncAttributes found;
      require(cudaFuncGetAttributes(&found, kernel), "attributes");
      most.registers = std::max(most.registers, found.numRegs);
      most.local = std::max(most.local, static_cast<int>(found.localSizeBytes));
    };
    (add(detail::kernel_of<Of, T, part, typename detail::Argument<A>::Passed...>()), ...);
    return most;
  }

  // Calls `call` with the arrays and, behind them, the result's.
  template <size_t... k>
  static cudaError_t launch(size_t states, T* const* arrays, T* numbers, bool* valid, std::index_sequence<k...>) {
    if constexpr (std::is_same_v<R, bool>) return for_each_state<Function, T, Layout>(stream, states, arrays[k]..., valid);
    else if constexpr (std::is_same_v<R, T>) return for_each_state<Function, T, Layout>(stream, states, arrays[k]..., numbers);
    else return for_each_state<Function, T, Layout>(stream, states, arrays[k]...);
  }

  template <size_t... k>
  static constexpr int places(size_t which, std::index_sequence<k...>) {
    constexpr int counts[] = {Of::template entries<k, A>()...};
    return counts[which];
  }
  template <size_t k>
  static constexpr int place(int entry) {
    if constexpr (!outputs[k]) return entry;
    else return detail::Places<Function, Of::output_number(k), Layout>::at(entry);
  }
};

using Of = detail::Batch<Function, T, Layout>;
using Shape = Function::Shape<T>;
using Run = Measured<Of, Shape>;

constexpr size_t arguments = sizeof(Run::outputs);

// The largest error of the outputs, in last places of T beside the largest entry of the output.
template <size_t... k>
double error_of(size_t states, T* const* arrays, const std::vector<double>& reference, std::index_sequence<k...> all) {
  size_t at = 0;
  double largest = 0;
  std::vector<T> host[arguments];
  for (size_t a = 0; a < arguments; ++a) {
    if (!Run::outputs[a]) continue;
    host[a].resize(Layout::length(states, Run::places(a, all)));
    require(cudaMemcpy(host[a].data(), arrays[a], host[a].size() * sizeof(T), cudaMemcpyDeviceToHost), "copying");
  }
  for (size_t state = 0; state < reference_states; ++state) {
    const auto compare = [&](auto argument) {
      constexpr size_t a = decltype(argument)::value;
      if constexpr (Run::outputs[a]) {
        double scale = 0, worst = 0;
        for (int e = 0; e < Run::full[a]; ++e, at += 2) {
          const int place = Run::template place<a>(e);
          const size_t where = Layout::first(state, states, Run::places(a, all)) + Layout::stride(states) * std::max(0, place);
          const double found = place < 0 ? 0.0 : static_cast<double>(host[a][where]);
          const double error = std::fabs((found - reference[at]) - reference[at + 1]);
          if (!(error <= worst)) worst = error;
          scale = std::max(scale, std::fabs(reference[at]));
        }
        if (scale > 0) largest = std::max(largest, worst / scale / std::numeric_limits<T>::epsilon());
        if (!(worst >= 0)) largest = std::numeric_limits<double>::infinity();
      }
    };
    (compare(std::integral_constant<size_t, k>()), ...);
  }
  return largest;
}

double median_of(std::vector<double> list) {
  std::sort(list.begin(), list.end());
  return list[list.size() / 2];
}

}  // namespace

int main(int count, char** values) {
  constexpr auto all = std::make_index_sequence<arguments>();
  size_t numbers_a_state = 0;
  for (size_t a = 0; a < arguments; ++a) numbers_a_state += static_cast<size_t>(Run::places(a, all));
  // 4 million states, or as many as 8 GB hold; a million at least.
  size_t states = size_t(1) << 22;
  while (states > (size_t(1) << 20) && states * numbers_a_state * sizeof(T) > (size_t(8) << 30)) states /= 2;
  T* arrays[arguments];
  T* numbers = nullptr;
  bool* valid = nullptr;
  for (size_t a = 0; a < arguments; ++a) {
    require(cudaMalloc(&arrays[a], Layout::length(states, Run::places(a, all)) * sizeof(T)), "allocating");
  }
  require(cudaMalloc(&numbers, states * sizeof(T)), "allocating");
  require(cudaMalloc(&valid, states), "allocating");
  require(cudaStreamCreate(&stream), "a stream");
  // Inputs of so many states, and outputs that are no numbers.
  const auto prepare = [&](size_t some) {
    int input = 0;
    for (size_t a = 0; a < arguments; ++a) {
      const int entries = Run::places(a, all);
      if (Run::outputs[a]) {
        require(cudaMemset(arrays[a], 0xff, Layout::length(some, entries) * sizeof(T)), "poisoning");
      } else {
        const size_t of_all = some * static_cast<size_t>(entries);
        fill<<<static_cast<unsigned>((of_all + 255) / 256), 256>>>(arrays[a], some, input++, entries);
      }
    }
    require(cudaDeviceSynchronize(), "filling");
  };
  const auto launch = [&](size_t some) { return Run::launch(some, arrays, numbers, valid, all); };
  const auto run = [&](size_t some) {
    require(launch(some), "launching");
    require(cudaStreamSynchronize(stream), "running");
  };
  double error = -1;
  if (count > 1) {
    std::vector<double> reference;
    if (FILE* file = std::fopen(values[1], "rb")) {
      double one;
      while (std::fread(&one, sizeof(one), 1, file) == 1) reference.push_back(one);
      std::fclose(file);
    }
    size_t expected = 0;
    for (size_t a = 0; a < arguments; ++a) expected += Run::outputs[a] ? size_t(2 * Run::full[a]) : 0;
    if (reference.size() == expected * reference_states) {
      prepare(reference_states);
      run(reference_states);
      error = error_of(reference_states, arrays, reference, all);
    }
  }
  prepare(states);
  run(states);
  cudaEvent_t begin, end;
  require(cudaEventCreate(&begin), "an event");
  require(cudaEventCreate(&end), "an event");
  std::vector<double> times;
  for (int k = 0; k < 11; ++k) {
    require(cudaEventRecord(begin, stream), "timing");
    require(launch(states), "launching");
    require(cudaEventRecord(end, stream), "timing");
    require(cudaEventSynchronize(end), "running");
    float milliseconds = 0;
    require(cudaEventElapsedTime(&milliseconds, begin, end), "timing");
    times.push_back(milliseconds * 1e6 / static_cast<double>(states));
  }
  // A graph of one launch for a single state.
  cudaGraph_t graph;
  cudaGraphExec_t executable;
  require(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), "capturing");
  require(launch(1), "launching");
  require(cudaStreamEndCapture(stream, &graph), "capturing");
  require(cudaGraphInstantiate(&executable, graph, 0), "a graph");
  std::vector<double> singles;
  for (int k = 0; k < 21; ++k) {
    constexpr int rounds = 20;
    require(cudaEventRecord(begin, stream), "timing");
    for (int r = 0; r < rounds; ++r) require(cudaGraphLaunch(executable, stream), "launching");
    require(cudaEventRecord(end, stream), "timing");
    require(cudaEventSynchronize(end), "running");
    float milliseconds = 0;
    require(cudaEventElapsedTime(&milliseconds, begin, end), "timing");
    singles.push_back(milliseconds * 1e3 / rounds);
  }
  const double time = median_of(times);
  const Resources used = Run::resources(std::make_integer_sequence<int, Function::parts>());
  std::printf("| %s | %s | %s | %s | %.4f | %d | %d | %.0f | %.1f | %d | %.1f |\n", TEXT(ROBOT), TEXT(FUNCTION), TEXT(LAYOUT),
              TEXT(SCALAR), time, used.registers, used.local, static_cast<double>(numbers_a_state * sizeof(T)) / time,
              error, Function::parts, median_of(singles));
}
