#pragma once
/// @file
/// Header-only or compiled once: a header X.hpp has the declarations, X.inl beside it the bodies.
/// Plain `-I` includes both. With TUMBLE_COMPILED you include the declarations alone and link a
/// library of all bodies, CMake's `tumble::compiled`. Your programs compile in half the time.

/// Stands before each definition in an .inl file.
#ifdef TUMBLE_COMPILED
#define TUMBLE_BODY
#else
#define TUMBLE_BODY inline
#endif
