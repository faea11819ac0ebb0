#pragma once
/// @file
/// Asks a student's module that runs beside the judge's, in the same page. Each question is one
/// call of its main(): it reads the question's frame, may call back, and writes an answer's frame.

#include <cstddef>
#include <exception>
#include <optional>
#include <string>

#include "judge/conversation/exchange.hpp"
#include "judge/spec/session.hpp"

namespace tumble::judge {

/// How a call of the student's main() has ended.
struct PageEnding {
  std::string how;     ///< "returned", "stopped", "signal", "exited", "refused", "hung", "failed"
  std::string detail;  ///< the signal's name, the refused call's, why the page failed
  int status = 0;      ///< of "exited"
};

class PageWorker : public Answerer {
 public:
  PageWorker();
  ~PageWorker() override;

  void start_case() override;
  Value ask(const Call& question, const CallBack& call_back) override;
  std::string printed() override { return printed_; }

  // ── For the student's module, while it runs: nothing here throws ──
  /// It has written to a descriptor of its own.
  /// @return whether it may go on
  bool take(int descriptor, const std::string& bytes) noexcept;
  /// It reads what is next of the question and of results: at most `most` bytes, none at the end.
  std::size_t give(char* to, std::size_t most) noexcept;

 private:
  void take_text(const std::string& bytes);
  /// Answers calls back, until the message comes that ends the question.
  void take_messages();
  [[noreturn]] void no_answer_came(const PageEnding& ending) const;

  Exchange exchange_;
  const CallBack* call_back_ = nullptr;
  std::string sent_, received_, printed_;
  std::size_t bytes_printed_ = 0;
  std::optional<Message> last_message_;
  std::optional<PageEnding> gone_;  ///< it has ended after its last answer
  std::exception_ptr stopped_;
  int case_ = 0, question_ = 0;
};

}  // namespace tumble::judge
