#pragma once
/// @file
/// What figures ask an engine that is made of a reader's functions: numbers, for numbers. Each file
/// figure_TOPIC.cpp beside this one answers one topic. It runs in the student's module, and nothing
/// that it says is judged.

#include <vector>

#include "judge/mine/questions.hpp"
#include "judge/worker/serve.hpp"

namespace tumble::judge::figure {

using AllNumbers = std::vector<double>;

/// The numbers of a question, one after the other.
class Numbers {
 public:
  explicit Numbers(const AllNumbers& all) : all_(all) {}

  bool end() const { return next_ == all_.size(); }
  double number() { return all_.at(next_++); }
  int count() { return static_cast<int>(number()); }
  /// A vector, or a symmetric matrix.
  template <class Matrix>
  Matrix matrix() {
    Matrix read;
    for (Eigen::Index i = 0; i < read.size(); ++i) read(i) = number();
    return read;
  }
  /// Mass [kg], inertia by rows [kg m²], a constant force [N] and the point of the body where it
  /// acts [m], the state at the start (x, q as w x y z, P, L), the duration [s]: 30 numbers.
  mine::RunQuestion scene() {
    mine::RunQuestion question;
    question.setting.mass = number();
    question.setting.inertia = matrix<Eigen::Matrix3d>();
    question.setting.pull = matrix<Eigen::Vector3d>();
    question.setting.p_body = matrix<Eigen::Vector3d>();
    question.start = matrix<mine::Numbers>();
    question.duration = number();
    question.method = mine::Method::simulate;
    return question;
  }

 private:
  const AllNumbers& all_;
  std::size_t next_ = 0;
};

/// Answers questions by this function until the page hangs up.
/// @return the status for main
inline int serve_figure(AllNumbers (*answer)(Numbers)) {
  return serve_questions([answer](const List& question) {
    const auto numbers = from_value<AllNumbers>(question.at(0));
    return to_value(answer(Numbers(numbers)));
  });
}

}  // namespace tumble::judge::figure
