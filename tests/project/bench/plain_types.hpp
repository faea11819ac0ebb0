#pragma once
/// @file
/// The library's vectors and quaternions under its names, without its headers: Simbody's are no
/// C++20, and the library's are nothing else.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tumble {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

}  // namespace tumble
