#pragma once
/// @file
/// What is inlined even where a compiler would rather call.
///
/// In what a step does dozens of times, a call costs as much as the sums do, and so does the way
/// through memory to it and back. And a Pack must not go through a function that was compiled for
/// other instructions.

///
/// TUMBLE_FLATTEN is for the outermost of such functions: all that it calls, Eigen's too, is
/// inlined into it. Compilers inline less in a large source than in a small one: without it, a
/// right-hand side beside a dozen others was seen to take four times as long as alone.
///
/// TUMBLE_COLD is for what ends in a refusal: it is compiled elsewhere, and what calls it stays
/// small.

#if defined(__GNUC__)
#define TUMBLE_INLINE inline __attribute__((always_inline))
#define TUMBLE_FLATTEN __attribute__((flatten))
#define TUMBLE_COLD __attribute__((noinline, cold))
#else
#define TUMBLE_INLINE inline
#define TUMBLE_FLATTEN
#define TUMBLE_COLD
#endif
