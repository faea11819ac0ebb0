#pragma once
/// @file
/// Functions that a compiler has to look through.

/// Inlined even where nothing else is: a Pack must not go through a function that was compiled for
/// other instructions, and a stage of a Runge–Kutta method not through a call.
#define TUMBLE_INLINE inline __attribute__((always_inline))
