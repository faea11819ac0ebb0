#pragma once
/// @file
/// Which tumble this is: for the preprocessor, and for a program that prints it.
///
/// CMake's project version, CHANGELOG.md and CITATION.cff say the same; a test compares them.

#include <string_view>

#define TUMBLE_VERSION_MAJOR 0
#define TUMBLE_VERSION_MINOR 2
#define TUMBLE_VERSION_PATCH 0

namespace tumble {

/// @addtogroup core
/// @{

/// "major.minor.patch"
inline constexpr std::string_view version = "0.2.0";

/// @}

}  // namespace tumble
