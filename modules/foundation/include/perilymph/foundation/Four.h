// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Four numbers at a time. A kernel is written once, for T = double or T = Four: the same operations in
// the same order, so that the bits do not depend on how many numbers are computed together, nor on the
// instructions that the machine has, none with fused multiply-add: on x86-64 SSE2, AVX2 or AVX-512, which
// has twice the registers; elsewhere those of the rest of the program. Kernels use no lanes wider than four.

#include <cstddef>
#include <cstring>

/// After the parameters of a kernel: what is not inlined would not be compiled for AVX2 and AVX-512.
#define PERILYMPH_KERNEL __attribute__((always_inline))
/// Before what kernels call.
#define PERILYMPH_IN_LANES [[gnu::always_inline]] inline

// Functions that take or return lanes are inlined: none passes them by a convention that depends on
// the instructions.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace perilymph {

using Four [[gnu::vector_size(32)]] = double;
/// Four of an array of numbers, wherever it begins.
using FourOfArray [[gnu::vector_size(32), gnu::aligned(8)]] = double;

/// Instructions for which kernels are compiled; each has all of those before it. The first are those of the
/// rest of the program, of x86-64 SSE2.
enum class Instructions { everywhere, avx2, avx512 };

/// The last that this machine has.
inline Instructions machineInstructions() noexcept
{
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512vl") != 0) return Instructions::avx512;
  if (__builtin_cpu_supports("avx2") != 0) return Instructions::avx2;
#endif
  return Instructions::everywhere;
}

/// Those that kernels use. Tests set it, to compare the bits.
inline Instructions kernelInstructions = machineInstructions();

#ifdef __x86_64__
template <class Function>
[[gnu::target("avx2")]] void callWithAvx2(const Function& function) noexcept
{
  function();
}

template <class Function>
[[gnu::target("avx2,avx512f,avx512vl")]] void callWithAvx512(const Function& function) noexcept
{
  function();
}
#endif

/// Calls a function that computes with lanes itself, compiled for the instructions of kernels.
template <class Function>
PERILYMPH_IN_LANES void withLanes(const Function& function) noexcept
{
#ifdef __x86_64__
  if (kernelInstructions == Instructions::avx512) return callWithAvx512(function);
  if (kernelInstructions == Instructions::avx2) return callWithAvx2(function);
#endif
  function();
}

template <class T>
PERILYMPH_IN_LANES T load(const double* from, std::size_t i) noexcept
{
  T value;
  std::memcpy(&value, from + i, sizeof value);
  return value;
}

/// As numbers, not as bytes: what is stored changes no pointer, so that a kernel reads its pointers once.
template <class T>
PERILYMPH_IN_LANES void store(const T& value, double* to, std::size_t i) noexcept
{
  if constexpr (sizeof(T) == sizeof(double))
    to[i] = value;
  else
    *reinterpret_cast<FourOfArray*>(to + i) = value;
}

/// The larger of two numbers, like std::max: the first if one is not a number.
PERILYMPH_IN_LANES double larger(double a, double b) noexcept { return a < b ? b : a; }
PERILYMPH_IN_LANES Four larger(const Four& a, double b) noexcept
{
  const Four wide = Four{} + b;
  return a < wide ? wide : a;
}

PERILYMPH_IN_LANES Four larger(const Four& a, const Four& b) noexcept { return a < b ? b : a; }

/// The smaller of two numbers, like std::min.
PERILYMPH_IN_LANES double smaller(double a, double b) noexcept { return b < a ? b : a; }
PERILYMPH_IN_LANES Four smaller(const Four& a, double b) noexcept
{
  const Four wide = Four{} + b;
  return wide < a ? wide : a;
}
PERILYMPH_IN_LANES Four smaller(const Four& a, const Four& b) noexcept { return b < a ? b : a; }

/// One of two numbers in each lane; the condition is the result of a comparison of lanes.
template <class T, class Condition>
PERILYMPH_IN_LANES T oneOf(const Condition& condition, const T& yes, const T& no) noexcept
{
  return condition ? yes : no;
}

}  // namespace perilymph
