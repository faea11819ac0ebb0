#pragma once
/// @file
/// Answers as a misconception would, in the judge's own process: for the kill matrix.

#include <cstddef>
#include <exception>
#include <string>

#include "judge/spec/answerer.hpp"
#include "judge/spec/session.hpp"

namespace tumble::judge {

class Impostor : public Answerer {
 public:
  /// Answers like misconception number `misconception` of the unit whose spec runs.
  explicit Impostor(std::size_t misconception) : misconception_(misconception) {}
  void start_case() override {}
  Value ask(const Call& question, const CallBack& call_back) override {
    try {
      return question.misconception(misconception_, call_back);
    } catch (const std::exception& e) {
      throw NoAnswer(Outcome::threw, e.what());
    }
  }
  std::string printed() override { return {}; }

 private:
  std::size_t misconception_;
};

}  // namespace tumble::judge
