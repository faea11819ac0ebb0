#pragma once
/// @file
/// Numbers for other programs, as the library writes them.

#include "tumble/core/shortest.hpp"

namespace tumble::support {

using detail::shortest;

}  // namespace tumble::support
