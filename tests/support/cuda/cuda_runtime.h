// SPDX-License-Identifier: GPL-2.0-or-later
// So much of CUDA's declarations that clang++ -x cuda -nocudainc -nocudalib checks the syntax of emitted headers and of
// flatdyn/cuda_batch.cuh where CUDA is not installed. Nothing here is defined.
#pragma once

#include <stddef.h>

#define __CUDACC__ 1
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
#define __launch_bounds__(...) __attribute__((launch_bounds(__VA_ARGS__)))
#define __forceinline__ inline __attribute__((always_inline))
#define __noinline__ __attribute__((noinline))

struct uint3 {
  unsigned x, y, z;
};
struct dim3 {
  unsigned x, y, z;
  __host__ __device__ constexpr dim3(unsigned of_x = 1, unsigned of_y = 1, unsigned of_z = 1)
      : x(of_x), y(of_y), z(of_z) {}
};
extern const __device__ uint3 threadIdx, blockIdx;

enum cudaError_t { cudaSuccess = 0, cudaErrorInvalidValue = 1 };
using cudaStream_t = struct CUstream_st*;
extern "C" cudaError_t cudaLaunchKernel(const void*, dim3, dim3, void**, size_t, cudaStream_t);
extern "C" unsigned __cudaPushCallConfiguration(dim3, dim3, size_t = 0, void* = nullptr);
extern "C" cudaError_t cudaConfigureCall(dim3, dim3, size_t = 0, cudaStream_t = nullptr);

#define __shared__ __attribute__((shared))
__device__ void __syncwarp(unsigned = 0xffffffff);
template <class T>
__device__ T __ldg(const T*);
__device__ float sin(float);
__device__ float cos(float);
__device__ float fma(float, float, float);
__device__ double fma(double, double, double);
__device__ float sqrt(float);
__device__ double sin(double);
__device__ double cos(double);
__device__ double sqrt(double);
namespace std {
using ::cos;
using ::fma;
using ::sin;
using ::sqrt;
}  // namespace std
extern "C" __device__ void* memcpy(void*, const void*, size_t);
