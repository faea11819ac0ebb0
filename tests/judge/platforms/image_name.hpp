#pragma once
/// @file
/// Names of container images.

#include <string>

namespace tumble::judge {

/// Refuses what no registry takes: "owner/tumble-judge", "ghcr.io/owner/tumble-judge:1" are names.
/// @throws std::invalid_argument with the nearest name that is one, where that is clear
/// Source: distribution/reference, reference.go: the grammar of a reference.
void require_image_name(const std::string& name);

}  // namespace tumble::judge
