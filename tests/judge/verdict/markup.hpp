#pragma once
/// @file
/// Text that stands in XML and HTML as it is.

#include <string>

namespace tumble::judge {

/// Escaped; what XML 1.0 cannot say at all becomes a question mark.
std::string markup(const std::string& text);

}  // namespace tumble::judge
