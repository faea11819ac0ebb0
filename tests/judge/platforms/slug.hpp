#pragma once
/// @file
/// Names for folders and addresses.

#include <string>

namespace tumble::judge {

/// Lower case, digits and hyphens, 2 to 39 of them: "homework-1".
std::string slug_of(const std::string& title);

}  // namespace tumble::judge
