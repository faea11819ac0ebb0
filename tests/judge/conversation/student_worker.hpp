#pragma once
/// @file
/// Asks a student's worker: one fresh process a test case, behind all walls.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "judge/protocol/message.hpp"
#include "judge/sandbox/confined_process.hpp"
#include "judge/sandbox/pipe.hpp"
#include "judge/sandbox/worker_program.hpp"
#include "judge/spec/answerer.hpp"
#include "judge/spec/session.hpp"

namespace tumble::judge {

class StudentWorker : public Answerer {
 public:
  explicit StudentWorker(WorkerProgram program);
  ~StudentWorker() override;

  void start_case() override;
  Value ask(const Call& question, const CallBack& call_back) override;
  std::string printed() override;

 private:
  struct Running;

  void send(Kind kind, const List& content);
  Message receive();
  /// The message for which the judge has the bytes already, if it has all of them.
  std::optional<Message> take_message();
  Value answer_of(const Message& message);
  /// What it printed before it ended may say why.
  void read_last_words();
  /// The pipe for answers is at its end: says how the worker has ended.
  [[noreturn]] void no_answer_came();
  /// The deadline has passed: gives another one to a program that this machine keeps from
  /// computing.
  void wait_longer_or_stop();
  [[noreturn]] void stop(Outcome outcome, const std::string& detail);

  WorkerProgram program_;
  std::unique_ptr<Running> running_;
  std::string printed_;
  std::mt19937_64 tokens_{std::random_device{}()};
  std::int64_t token_ = 0;
  Clock::time_point deadline_;
  int delays_ = 0, hung_cases_ = 0;
};

}  // namespace tumble::judge
