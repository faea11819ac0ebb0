#pragma once
/// @file
/// The ways from L to ω.

#include "common.hpp"

namespace momentum_chapter {

/// Everything that the ways from L to ω start from.
template <class T>
struct Task {
  RigidBody<T> body;
  Quaternion<T> q;
  Matrix3<T> R;
  Vector3<T> L;
  Vector3<T> moments;  ///< along the body's axes, if these are principal
};

// Flattened: whether the compiler happens to inline what they call is not what is measured.

/// The three products of the library.
template <class T>
[[gnu::flatten]] Vector3<T> by_three_products(const Task<T>& task) {
  return angular_velocity(task.body, task.R, task.L);
}

/// The same in principal axes, where the tensor is three numbers.
template <class T>
[[gnu::flatten]] Vector3<T> in_principal_axes(const Task<T>& task) {
  Vector3<T> v = task.R.transpose() * task.L;
  for (int i = 0; i < 3; ++i) v[i] = v[i] / task.moments[i];
  return task.R * v;
}

/// The world's inverse tensor first, then its product with L.
template <class T>
[[gnu::flatten]] Vector3<T> by_inverse_in_world(const Task<T>& task) {
  const Matrix3<T> half = task.R * task.body.I_body_inv();
  const Matrix3<T> I_inv = half * task.R.transpose();
  return I_inv * task.L;
}

/// The world's tensor, inverted anew, by cofactors.
template <class T>
[[gnu::flatten]] Vector3<T> by_inverting_in_world(const Task<T>& task) {
  const Matrix3<T> half = task.R * task.body.I_body();
  const Matrix3<T> I = half * task.R.transpose();
  Matrix3<T> cofactors;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    cofactors.col(i) = I.col(j).cross(I.col(k));
  }
  const T scale = T(1) / I.col(0).dot(cofactors.col(0));
  return scale * (cofactors * task.L);
}

}  // namespace momentum_chapter
