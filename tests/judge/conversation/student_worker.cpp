#include "judge/conversation/student_worker.hpp"

#include <signal.h>
#include <stdexcept>
#include <utility>

#include "judge/conversation/endings.hpp"
#include "judge/sandbox/system_calls.hpp"

namespace tumble::judge {

namespace {

constexpr int most_delays = 5;  // of a machine that does not let it compute, a deadline each

}  // namespace

struct StudentWorker::Running {
  Pipe questions = make_pipe(), answers = make_pipe(), text = make_pipe();
  ConfinedProcess process;
  std::string received;
  std::size_t printed = 0;

  explicit Running(const WorkerProgram& program)
      : process({program.file.string()}, program.environment, program.walls,
                // 0, 1, 2, and as in worker/descriptors.hpp
                {-1, text.write.number(), text.write.number(), answers.write.number(),
                 questions.read.number()}) {
    questions.read.reset();
    answers.write.reset();
    text.write.reset();
  }
};

StudentWorker::StudentWorker(WorkerProgram program)
    : program_(std::move(program)), exchange_(program_.walls.limits.memory_bytes) {
  signal(SIGPIPE, SIG_IGN);  // a worker that is gone is noticed when it does not answer
}

StudentWorker::~StudentWorker() = default;

void StudentWorker::start_case() {
  running_.reset();
  printed_.clear();
}

std::string StudentWorker::printed() { return printed_; }

void StudentWorker::send(const std::string& frame) {
  // If the worker does not read, or is gone, receive() will say why.
  write_all(running_->questions.write.number(), frame, deadline_);
}

Message StudentWorker::receive() {
  Running& run = *running_;
  while (true) {
    if (std::optional<Message> message = take_message(run.received)) return *std::move(message);
    const Ready ready = wait_readable(run.answers.read.number(), run.text.read.number(), deadline_);
    if (ready.second) {
      std::string text;
      if (!read_some(run.text.read.number(), text)) run.text.read.reset();
      run.printed += text.size();
      if (printed_.size() < most_printed) printed_ += text;
      if (run.printed > flood) throw flooded();
    }
    if (ready.first && !read_some(run.answers.read.number(), run.received)) no_answer_came();
    if (Clock::now() >= deadline_) wait_longer_or_stop();
  }
}

void StudentWorker::wait_longer_or_stop() {
  const double seconds = program_.walls.limits.wall_seconds;
  if (!running_->process.waits_for_processor())
    throw NoAnswer(Outcome::hung,
                   "no answer after " + std::to_string(static_cast<int>(seconds)) + " s");
  if (++delays_ > most_delays)
    throw std::runtime_error("the student's program did not get the processor: too much runs here");
  deadline_ = after(seconds);
}

void StudentWorker::read_last_words() {
  const int text = running_->text.read.number();
  while (printed_.size() < most_printed && wait_readable(text, -1, after(0.01)).first &&
         read_some(text, printed_)) {
  }
}

void StudentWorker::no_answer_came() {
  read_last_words();
  const std::optional<Ending> ending = running_->process.wait(2);
  if (!ending) throw NoAnswer(Outcome::malformed, "it closed the pipe for answers");
  if (running_->process.killed_from_outside())
    throw std::runtime_error(
        "the student's program was killed from outside: the memory of this "
        "machine is used up?");
  if (!ending->by_signal) throw exited(ending->number);
  if (ending->number == SIGXCPU || ending->number == SIGKILL)
    throw computed_too_long(program_.walls.limits.cpu_seconds);
  if (ending->number == SIGSYS)
    throw NoAnswer(Outcome::forbidden, "asked the operating system for something");
  throw crashed(ending->number, printed_);
}

void StudentWorker::refused_call(const Message& message) {
  const List& content = message.content;
  const std::int64_t* call = content.empty() ? nullptr : content[0].as<std::int64_t>();
  const int number = call ? static_cast<int>(*call) : -1;
  read_last_words();
  if (is_abort(number)) throw crashed(SIGABRT, printed_);
  throw refused(purpose_of_call(number), name_of_call(number));
}

Value StudentWorker::ask(const Call& question, const CallBack& call_back) {
  try {
    const std::string frame = exchange_.question(question.arguments);
    if (!running_) running_ = std::make_unique<Running>(program_);
    deadline_ = after(program_.walls.limits.wall_seconds);
    delays_ = 0;
    send(frame);
    while (true) {
      const Message message = receive();
      if (message.kind == Kind::forbidden) refused_call(message);
      const std::optional<std::string> result = exchange_.result_for(message, call_back);
      if (!result) return exchange_.answer_of(message);
      send(*result);
    }
  } catch (...) {
    running_.reset();
    exchange_.rethrow();
  }
}

}  // namespace tumble::judge
