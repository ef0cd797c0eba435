// SPDX-License-Identifier: BSD-3-Clause
// Launches functions of a generated CUDA header (flatdyn generate --language cuda) for many states, each in a thread of
// its own. Arrays are on the device, nothing is allocated, and errors are returned. For nvcc 12 or later, or clang.
//
//   using Dynamics = panda::functions::inverse_dynamics;
//   using flatdyn::cuda::Tiles;
//   // q, qd, qdd, tau: on the device, flatdyn::cuda::length_of<Dynamics, 0, Tiles>(states) floats for q, and so on.
//   cudaError_t error = flatdyn::cuda::for_each_state<Dynamics, float, Tiles>(stream, states, q, qd, qdd, tau);
//
// Arguments are in the order of the function's: its free parameters (by value) if it has any, inputs, outputs. After
// them comes, for a function that returns a number, an array with one for each state; for a function that returns
// bool, `bool* valid` with one for each state, or nullptr: the outputs of a state that is not valid mean nothing.
// Outputs must overlap neither inputs nor each other. Launches are asynchronous, and streams that capture a graph take
// them. The q of a body without joints is nullptr.
//
// Layouts of arrays:
//   Tiles    entry i of state k is at [k / 32][i][k % 32]: fastest, as the threads of a warp read and write side by side
//   Columns  entry i of state k is at [i][k]
//   Rows     entry i of state k is at [k][i], as arrays of structures are; through shared memory as far as it holds them
//   Packed<Tiles>, Packed<Columns>, Packed<Rows>: the same, without zeros of outputs and with equal entries, such as the
//            halves of a symmetric matrix, once: entry i of output o is at i = Function::place<o>(entry) (-1: zero)
#pragma once

#include <stddef.h>

#include <type_traits>
#include <utility>

#ifdef __CUDACC__
#include <cuda_runtime.h>
#define FLATDYN_ANYWHERE __host__ __device__ __forceinline__
#else
#define FLATDYN_ANYWHERE inline
#endif

namespace flatdyn {
namespace cuda {

// States side by side in a tile, and threads of a block.
inline constexpr int tile = 32, threads = 128;

struct Tiles {
  static constexpr bool is_packed = false, is_by_rows = false;
  struct Stride {
    FLATDYN_ANYWHERE constexpr size_t operator*(int place) const { return static_cast<size_t>(place) * tile; }
  };
  FLATDYN_ANYWHERE static constexpr size_t first(size_t state, size_t, int entries) {
    return state / tile * tile * static_cast<size_t>(entries) + state % tile;
  }
  FLATDYN_ANYWHERE static constexpr Stride stride(size_t) { return {}; }
  FLATDYN_ANYWHERE static constexpr size_t length(size_t states, int entries) {
    return (states + tile - 1) / tile * tile * static_cast<size_t>(entries);
  }
};

struct Columns {
  static constexpr bool is_packed = false, is_by_rows = false;
  struct Stride {
    size_t states;
    FLATDYN_ANYWHERE constexpr size_t operator*(int place) const { return static_cast<size_t>(place) * states; }
  };
  FLATDYN_ANYWHERE static constexpr size_t first(size_t state, size_t, int) { return state; }
  FLATDYN_ANYWHERE static constexpr Stride stride(size_t states) { return {states}; }
  FLATDYN_ANYWHERE static constexpr size_t length(size_t states, int entries) {
    return states * static_cast<size_t>(entries);
  }
};

struct Rows {
  static constexpr bool is_packed = false, is_by_rows = true;
  struct Stride {
    FLATDYN_ANYWHERE constexpr size_t operator*(int place) const { return static_cast<size_t>(place); }
  };
  FLATDYN_ANYWHERE static constexpr size_t first(size_t state, size_t, int entries) {
    return state * static_cast<size_t>(entries);
  }
  FLATDYN_ANYWHERE static constexpr Stride stride(size_t) { return {}; }
  FLATDYN_ANYWHERE static constexpr size_t length(size_t states, int entries) {
    return states * static_cast<size_t>(entries);
  }
};

template <class Layout>
struct Packed : Layout {
  static constexpr bool is_packed = true;
};

namespace detail {

// An argument of a function: const T (&)[7], T (&)[7], T (&)[7][7], or what is passed as it is.
template <class A>
struct Argument {
  static constexpr bool is_input = false, is_output = false;
  static constexpr int entries = 0;
  using Passed = std::remove_cv_t<std::remove_reference_t<A>>;
};
template <class T, size_t count>
struct Argument<const T (&)[count]> {
  static constexpr bool is_input = true, is_output = false;
  static constexpr int entries = static_cast<int>(count);
  using Passed = const T*;
};
template <class T, size_t count>
struct Argument<T (&)[count]> {
  static constexpr bool is_input = false, is_output = true;
  static constexpr int entries = static_cast<int>(count);
  using Passed = T*;
};
template <class T, size_t rows, size_t columns>
struct Argument<T (&)[rows][columns]> : Argument<T (&)[rows * columns]> {};

// The places of an output's entries.
template <class Function, int output>
struct PackedPlaces {
  FLATDYN_ANYWHERE static constexpr int at(int entry) { return Function::template place<output>(entry); }
  FLATDYN_ANYWHERE static constexpr int count(int entries) {
    int count = 0;
    for (int entry = 0; entry < entries; ++entry) count = at(entry) >= count ? at(entry) + 1 : count;
    return count;
  }
};
struct AllPlaces {
  FLATDYN_ANYWHERE static constexpr int at(int entry) { return entry; }
  FLATDYN_ANYWHERE static constexpr int count(int entries) { return entries; }
};
template <class Function, int output, class Layout>
using Places = std::conditional_t<Layout::is_packed, PackedPlaces<Function, output>, AllPlaces>;

// The entries of an input at one state. Nothing writes inputs while a kernel runs.
template <class T, class Stride, bool is_global>
struct Input {
  const T* first;
  Stride stride;
  FLATDYN_ANYWHERE T operator[](int entry) const {
#ifdef __CUDA_ARCH__
    if constexpr (is_global) return __ldg(first + stride * entry);
#endif
    return first[stride * entry];
  }
};

// The entries of an output at one state. What is read by [] is zero if everything written was a finite number, else not
// a number: functions check their results so, and need not fetch them from memory. stored() reads what an earlier part
// has written.
template <class T, class Stride, class Places, bool is_watched>
struct Output {
  T* first;
  Stride stride;
  T* watch;

  struct Entry {
    const Output& output;
    int entry;
    FLATDYN_ANYWHERE T operator=(T value) const {
      const int place = Places::at(entry);
      if (place >= 0) output.first[output.stride * place] = value;
      if constexpr (is_watched) *output.watch += T(0.0) * value;
      return value;
    }
    FLATDYN_ANYWHERE operator T() const { return *output.watch; }
  };
  FLATDYN_ANYWHERE Entry operator[](int entry) const { return {*this, entry}; }
  FLATDYN_ANYWHERE T stored(int entry) const { return first[stride * Places::at(entry)]; }
};

// The result of a function that returns void.
struct None {};

template <class Function, class T, class Layout, class Shape = typename Function::template Shape<T>>
struct Batch;

template <class Function, class T, class Layout, class R, class... A>
struct Batch<Function, T, Layout, R(A...)> {
  using Returns = R;
  static constexpr bool is_checked = std::is_same_v<R, bool>, returns_number = std::is_same_v<R, T>;
  using Result = std::conditional_t<is_checked, bool*, std::conditional_t<returns_number, T*, None>>;
  using All = std::index_sequence_for<A...>;
  static constexpr size_t arguments = sizeof...(A);

  // The number of the output that argument k is.
  FLATDYN_ANYWHERE static constexpr int output_number(size_t k) {
    constexpr bool outputs[] = {Argument<A>::is_output...};
    int number = 0;
    for (size_t before = 0; before < k; ++before) number += outputs[before] ? 1 : 0;
    return number;
  }
  // The entries that argument k has in its array.
  template <size_t k, class Of>
  FLATDYN_ANYWHERE static constexpr int entries() {
    constexpr int all = Argument<Of>::entries;
    if constexpr (Argument<Of>::is_output) return Places<Function, output_number(k), Layout>::count(all);
    return all;
  }
  template <size_t... k>
  static constexpr int entries_of(size_t which, std::index_sequence<k...>) {
    constexpr int counts[] = {entries<k, A>()...};
    return counts[which];
  }

  // What the function gets for argument k at a state.
  template <size_t k, class Of, bool is_global, class Stride, class Passed>
  FLATDYN_ANYWHERE static auto access(Passed passed, size_t first, Stride stride, T* watch) {
    if constexpr (Argument<Of>::is_input) {
      return Input<T, Stride, is_global>{passed + first, stride};
    } else if constexpr (Argument<Of>::is_output) {
      return Output<T, Stride, Places<Function, output_number(k), Layout>, is_checked>{passed + first, stride, watch};
    } else {
      return passed;
    }
  }

  // The place of argument k's numbers among those of a row in shared memory, and the length of a row.
  template <size_t... k>
  FLATDYN_ANYWHERE static constexpr int staged(size_t which, std::index_sequence<k...>) {
    constexpr int counts[] = {entries<k, A>()...};
    int sum = 0;
    for (size_t before = 0; before < which; ++before) sum += counts[before];
    return sum;
  }
  // Odd: no two threads of a warp use the same bank.
  FLATDYN_ANYWHERE static constexpr int row() { return staged(sizeof...(A), All()) | 1; }
  // Long rows go through shared memory if they fit; a function in parts writes only some entries of them.
  FLATDYN_ANYWHERE static constexpr bool is_staged() {
    constexpr int few = 40, most = 48 * 1024 / (tile * static_cast<int>(sizeof(T)));
    return Layout::is_by_rows && Function::parts == 1 && row() > few && row() <= most;
  }

  template <int part, class Value>
  FLATDYN_ANYWHERE static void finish(size_t state, Result result, Value value) {
    if constexpr (is_checked) {
      if (result != nullptr && (part == 0 || !value)) result[state] = value;
    } else {
      result[state] = value;
    }
  }

  // Computes a part of the function at one state.
  template <int part, size_t... k>
  FLATDYN_ANYWHERE static void at_state(size_t state, size_t states, std::index_sequence<k...>,
                                        typename Argument<A>::Passed... passed, [[maybe_unused]] Result result) {
    T watch = T(0.0);
    const auto stride = Layout::stride(states);
    const auto call = [&] {
      return Function::template call<T, part>(
          access<k, A, true>(passed, Layout::first(state, states, entries<k, A>()), stride, &watch)...);
    };
    if constexpr (std::is_void_v<R>) {
      call();
    } else {
      finish<part>(state, result, call());
    }
  }

#ifdef __CUDACC__
  // Copies argument k of some states between its rows and those in shared memory, with all threads of a warp.
  template <size_t k, class Of, bool is_load, class Passed>
  __device__ static void stage([[maybe_unused]] Passed passed, size_t first, int count, T* shared) {
    constexpr int length = entries<k, Of>(), place = staged(k, All());
    if constexpr (is_load ? Argument<Of>::is_input : Argument<Of>::is_output) {
      for (int at = static_cast<int>(threadIdx.x); at < count * length; at += tile) {
        T& of_row = shared[at / length * row() + place + at % length];
        auto& of_array = passed[first * length + static_cast<size_t>(at)];
        if constexpr (is_load) {
          of_row = of_array;
        } else {
          of_array = of_row;
        }
      }
    }
  }
  template <size_t k, class Of, class Passed>
  __device__ static auto access_staged(Passed passed, T* of_row, T* watch) {
    if constexpr (Argument<Of>::is_input || Argument<Of>::is_output) {
      return access<k, Of, false>(of_row, static_cast<size_t>(staged(k, All())), Rows::Stride(), watch);
    } else {
      return passed;
    }
  }

  // Computes the function at the states of a warp, one for each thread, with rows in shared memory.
  template <size_t... k>
  __device__ static void at_rows(size_t first, size_t states, T* shared, std::index_sequence<k...>,
                                 typename Argument<A>::Passed... passed, [[maybe_unused]] Result result) {
    const int count = states - first < tile ? static_cast<int>(states - first) : tile;
    (stage<k, A, true>(passed, first, count, shared), ...);
    __syncwarp();
    if (static_cast<int>(threadIdx.x) < count) {
      T watch = T(0.0);
      T* const of_row = shared + threadIdx.x * row();
      const auto call = [&] { return Function::template call<T, 0>(access_staged<k, A>(passed, of_row, &watch)...); };
      if constexpr (std::is_void_v<R>) {
        call();
      } else {
        finish<0>(first + threadIdx.x, result, call());
      }
    }
    __syncwarp();
    (stage<k, A, false>(passed, first, count, shared), ...);
  }
#endif
};

#ifdef __CUDACC__

template <class Of, int part, class... Passed>
__global__ void __launch_bounds__(threads) batch_kernel(size_t states, typename Of::Result result, Passed... passed) {
  const size_t state = static_cast<size_t>(blockIdx.x) * threads + threadIdx.x;
  if (state < states) Of::template at_state<part>(state, states, typename Of::All(), passed..., result);
}

template <class Of, class T, class... Passed>
__global__ void __launch_bounds__(tile) rows_kernel(size_t states, typename Of::Result result, Passed... passed) {
  __shared__ T shared[Of::row() * tile];
  Of::at_rows(static_cast<size_t>(blockIdx.x) * tile, states, shared, typename Of::All(), passed..., result);
}

// The kernel of a part, and its threads in a block.
template <class Of, class T, int part, class... Passed>
constexpr auto kernel_of() {
  if constexpr (Of::is_staged()) {
    return &rows_kernel<Of, T, Passed...>;
  } else {
    return &batch_kernel<Of, part, Passed...>;
  }
}

template <class Of, class T, int part, class... Passed>
cudaError_t launch(cudaStream_t stream, size_t states, typename Of::Result result, Passed... passed) {
  constexpr unsigned in_block = Of::is_staged() ? tile : threads;
  const size_t blocks = (states + in_block - 1) / in_block;
  if (blocks > 0x7fffffff) return cudaErrorInvalidValue;
  void* arguments[] = {&states, &result, &passed...};
  const auto* kernel = reinterpret_cast<const void*>(kernel_of<Of, T, part, Passed...>());
  return cudaLaunchKernel(kernel, dim3(static_cast<unsigned>(blocks)), dim3(in_block), arguments, 0, stream);
}

#endif

// Separates the arguments from the result behind them.
template <class Of, class T, class Shape>
struct Caller;
template <class Of, class T, class R, class... A>
struct Caller<Of, T, R(A...)> {
#ifdef __CUDACC__
  template <int... part>
  static cudaError_t on_device(std::integer_sequence<int, part...>, cudaStream_t stream, size_t states,
                               typename Argument<A>::Passed... passed, typename Of::Result result) {
    cudaError_t error = cudaSuccess;
    if (states == 0) return error;
    ((error = error == cudaSuccess ? launch<Of, T, part, typename Argument<A>::Passed...>(stream, states, result, passed...)
                                   : error),
     ...);
    return error;
  }
#endif
  template <int... part>
  static void on_host(std::integer_sequence<int, part...>, size_t states, typename Argument<A>::Passed... passed,
                      typename Of::Result result) {
    for (size_t state = 0; state < states; ++state) {
      (Of::template at_state<part>(state, states, typename Of::All(), passed..., result), ...);
    }
  }
};

}  // namespace detail

// The length of the array of argument `argument` (from 0) of a function for so many states, in scalars.
template <class Function, int argument, class Layout = Tiles, class T = float>
constexpr size_t length_of(size_t states) {
  using Of = detail::Batch<Function, T, Layout>;
  static_assert(argument >= 0 && argument < static_cast<int>(Of::arguments), "the function has no such argument");
  return Layout::length(states, Of::entries_of(argument, typename Of::All()));
}

#ifdef __CUDACC__
// Launches the kernels of a function for states 0 to states - 1, in their order; T is float or double.
template <class Function, class T, class Layout = Tiles, class... Arguments>
cudaError_t for_each_state(cudaStream_t stream, size_t states, Arguments... arguments) {
  using Of = detail::Batch<Function, T, Layout>;
  using Caller = detail::Caller<Of, T, typename Function::template Shape<T>>;
  constexpr std::make_integer_sequence<int, Function::parts> parts;
  if constexpr (std::is_void_v<typename Of::Returns>) {
    return Caller::on_device(parts, stream, states, arguments..., detail::None());
  } else {
    return Caller::on_device(parts, stream, states, arguments...);
  }
}
#endif

// The same on the host, with arrays of the host: one state after the other.
template <class Function, class T, class Layout = Tiles, class... Arguments>
void for_each_state_on_host(size_t states, Arguments... arguments) {
  using Of = detail::Batch<Function, T, Layout>;
  using Caller = detail::Caller<Of, T, typename Function::template Shape<T>>;
  constexpr std::make_integer_sequence<int, Function::parts> parts;
  if constexpr (std::is_void_v<typename Of::Returns>) {
    Caller::on_host(parts, states, arguments..., detail::None());
  } else {
    Caller::on_host(parts, states, arguments...);
  }
}

}  // namespace cuda
}  // namespace flatdyn
