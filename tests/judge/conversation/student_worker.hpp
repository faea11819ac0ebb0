#pragma once
/// @file
/// Asks a student's worker: one fresh process a test case, behind all walls.

#include <memory>
#include <string>

#include "judge/conversation/exchange.hpp"
#include "judge/sandbox/confined_process.hpp"
#include "judge/sandbox/pipe.hpp"
#include "judge/sandbox/worker_program.hpp"
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

  void send(const std::string& frame);
  Message receive();
  /// What it printed before it ended may say why.
  void read_last_words();
  /// The pipe for answers is at its end: says how the worker has ended.
  [[noreturn]] void no_answer_came();
  /// The deadline has passed: gives another one to a program that this machine keeps from
  /// computing.
  void wait_longer_or_stop();
  /// It says that the system has refused it something.
  [[noreturn]] void refused_call(const Message& message);

  WorkerProgram program_;
  Exchange exchange_;
  std::unique_ptr<Running> running_;
  std::string printed_;
  Clock::time_point deadline_;
  int delays_ = 0;
};

}  // namespace tumble::judge
