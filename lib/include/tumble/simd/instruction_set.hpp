#pragma once
/// @file
/// Which vector instructions the processor has, found out when the program runs: nobody has to
/// compile for a machine, and a program built once is fast on each.
///
/// A kernel is a function template over a Pack (pack.hpp). dispatch() calls it inside a function
/// that the compiler was told to make for those instructions; everything inside has to be inlined
/// there, and so is marked TUMBLE_INLINE.

#include "tumble/simd/pack.hpp"

namespace tumble::simd {

/// @addtogroup simd
/// @{

/// Sets of instructions that kernels are compiled for, each containing those before it.
enum class InstructionSet {
  baseline,  ///< what the whole program is compiled for
  avx2,      ///< 4 doubles at once and fused multiply-add (x86, since 2013)
  avx512,    ///< 8 doubles at once and 32 registers
};

/// Runs a kernel compiled for what the whole program is compiled for.
template <class Kernel>
TUMBLE_ONE_COPY void run_baseline(const Kernel& kernel) {
  kernel.template run<FourDoubles, baseline_fma>();
}

#if defined(__x86_64__)
#define TUMBLE_TARGET_AVX2 __attribute__((target("avx2,fma")))
#define TUMBLE_TARGET_AVX512 __attribute__((target("avx2,fma,avx512f,avx512dq,avx512vl")))

/// The best of the sets that this processor has.
inline InstructionSet best_instruction_set() {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
    return InstructionSet::baseline;
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  return avx512 ? InstructionSet::avx512 : InstructionSet::avx2;
}

/// Runs a kernel compiled for AVX2.
template <class Kernel>
TUMBLE_ONE_COPY TUMBLE_TARGET_AVX2 void run_avx2(const Kernel& kernel) {
  kernel.template run<FourDoubles, Fma::fused>();
}

/// Runs a kernel compiled for AVX-512.
template <class Kernel>
TUMBLE_ONE_COPY TUMBLE_TARGET_AVX512 void run_avx512(const Kernel& kernel) {
  kernel.template run<EightDoubles, Fma::fused>();
}

/// Runs a kernel with the Pack and the instructions of the set; the same code for every call.
/// @param kernel has a member `template <class P, Fma fma> TUMBLE_INLINE void run() const`
/// @param set    at most best_instruction_set(): others stop the program
template <class Kernel>
void dispatch(InstructionSet set, const Kernel& kernel) {
  if (set == InstructionSet::avx512) return run_avx512(kernel);
  if (set == InstructionSet::avx2) return run_avx2(kernel);
  run_baseline(kernel);
}
#else
inline InstructionSet best_instruction_set() { return InstructionSet::baseline; }
template <class Kernel>
void dispatch(InstructionSet, const Kernel& kernel) {
  run_baseline(kernel);
}
#endif

/// @}

}  // namespace tumble::simd
