#pragma once
/// @file
/// What is inlined even where a compiler would rather call.
///
/// In what a step does dozens of times, a call costs as much as the sums do, and so does the way
/// through memory to it and back. And a Pack must not go through a function that was compiled for
/// other instructions.

#if defined(__GNUC__)
#define TUMBLE_INLINE inline __attribute__((always_inline))
#else
#define TUMBLE_INLINE inline
#endif
