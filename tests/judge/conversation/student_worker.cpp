#include "judge/conversation/student_worker.hpp"

#include <signal.h>
#include <string.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <utility>

#include "judge/protocol/convert.hpp"
#include "judge/sandbox/system_calls.hpp"

namespace tumble::judge {

namespace {

constexpr std::size_t most_printed = 1 << 16;     // kept to be shown
constexpr std::size_t most_detail = 500;          // of an exception's text
constexpr std::size_t flood = 1 << 20;            // printed in one case: enough
constexpr std::size_t most_evaluations = 100000;  // of functions, for one answer
constexpr int most_hung_cases = 2;                // each costs seconds
constexpr int most_delays = 5;  // of a machine that does not let it compute, a deadline each

std::string signal_text(int number) {
  switch (number) {
    case SIGSEGV:
      return "SIGSEGV: it used memory that is not its own (an index out of range, endless "
             "recursion, or tables too large to start with)";
    case SIGFPE:
      return "SIGFPE: an integer was divided by zero";
    case SIGABRT:
      return "SIGABRT: an assertion failed, or an exception was caught by nobody";
    case SIGBUS:
      return "SIGBUS: it used memory that is not there";
    case SIGILL:
      return "SIGILL: it ran into no instruction (a function without return?)";
    case SIGTRAP:
      return "SIGTRAP: it ran into a trap (a function without return?)";
    default:
      return std::string("signal ") + std::to_string(number) + ": " + strsignal(number);
  }
}

/// What assert(), Eigen and the standard library print before they end a program:
/// "… Assertion `index < size()' failed.", with one quote or the other.
std::string failed_assertion(const std::string& printed) {
  const std::string before = "Assertion ";
  const auto start = printed.rfind(before);
  const auto end = printed.find("' failed", start);
  if (start == std::string::npos || end == std::string::npos) return {};
  const auto text = start + before.size() + 1;
  return text < end ? printed.substr(text, end - text) : std::string();
}

bool is_about_index(const std::string& assertion) {
  return assertion.find("index") != std::string::npos ||
         assertion.find("__n < this->size()") != std::string::npos;
}

std::string abort_text(const std::string& printed) {
  const std::string assertion = failed_assertion(printed);
  if (assertion.empty()) return signal_text(SIGABRT);
  return "an assertion failed, " + assertion.substr(0, most_detail) +
         (is_about_index(assertion) ? " (an index out of range)" : "");
}

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

StudentWorker::StudentWorker(WorkerProgram program) : program_(std::move(program)) {
  signal(SIGPIPE, SIG_IGN);  // a worker that is gone is noticed when it does not answer
}

StudentWorker::~StudentWorker() = default;

void StudentWorker::start_case() {
  running_.reset();
  printed_.clear();
}

std::string StudentWorker::printed() { return printed_; }

void StudentWorker::stop(Outcome outcome, const std::string& detail) {
  if (outcome == Outcome::hung) ++hung_cases_;
  running_.reset();
  throw NoAnswer(outcome, detail);
}

void StudentWorker::send(Kind kind, const List& content) {
  const std::string body = encode({kind, token_, content});
  // If the worker does not read, or is gone, receive() will say why.
  write_all(running_->questions.write.number(), frame_head(body.size()) + body, deadline_);
}

std::optional<Message> StudentWorker::take_message() {
  std::string& bytes = running_->received;
  if (bytes.size() < 4) return std::nullopt;
  const std::size_t size = frame_size(reinterpret_cast<const unsigned char*>(bytes.data()));
  if (bytes.size() < 4 + size) return std::nullopt;
  Message message = decode(bytes.substr(4, size));
  bytes.erase(0, 4 + size);
  return message;
}

Message StudentWorker::receive() {
  Running& run = *running_;
  while (true) {
    if (std::optional<Message> message = take_message()) return *std::move(message);
    const Ready ready = wait_readable(run.answers.read.number(), run.text.read.number(), deadline_);
    if (ready.second) {
      std::string text;
      if (!read_some(run.text.read.number(), text)) run.text.read.reset();
      run.printed += text.size();
      if (printed_.size() < most_printed) printed_ += text;
      if (run.printed > flood) stop(Outcome::flooded, "more than a megabyte of text");
    }
    if (ready.first && !read_some(run.answers.read.number(), run.received)) no_answer_came();
    if (Clock::now() >= deadline_) wait_longer_or_stop();
  }
}

void StudentWorker::wait_longer_or_stop() {
  const double seconds = program_.walls.limits.wall_seconds;
  if (!running_->process.waits_for_processor())
    stop(Outcome::hung, "no answer after " + std::to_string(static_cast<int>(seconds)) + " s");
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
  if (!ending) stop(Outcome::malformed, "it closed the pipe for answers");
  if (running_->process.killed_from_outside())
    throw std::runtime_error(
        "the student's program was killed from outside: the memory of this "
        "machine is used up?");
  if (!ending->by_signal) stop(Outcome::exited, "with status " + std::to_string(ending->number));
  if (ending->number == SIGXCPU || ending->number == SIGKILL)
    stop(Outcome::hung, "no answer after " + std::to_string(program_.walls.limits.cpu_seconds) +
                            " s of computing");
  if (ending->number == SIGABRT) stop(Outcome::crashed, abort_text(printed_));
  if (ending->number == SIGSYS)
    stop(Outcome::forbidden, "asked the operating system for something");
  stop(Outcome::crashed, signal_text(ending->number));
}

Value StudentWorker::answer_of(const Message& message) {
  const List& content = message.content;
  const auto first_text = [&] {
    const std::string* text = content.empty() ? nullptr : content[0].as<std::string>();
    return text ? text->substr(0, most_detail) : std::string();
  };
  switch (message.kind) {
    case Kind::answer:
      if (content.size() == 1) return content[0];
      stop(Outcome::malformed, "an answer is one value");
    case Kind::not_implemented:
      stop(Outcome::not_implemented, "");
    case Kind::threw:
      stop(Outcome::threw, first_text());
    case Kind::out_of_memory:
      stop(Outcome::out_of_memory,
           "more than " + std::to_string(program_.walls.limits.memory_bytes >> 20) + " MB");
    case Kind::forbidden: {
      const std::int64_t* call = content.empty() ? nullptr : content[0].as<std::int64_t>();
      const int number = call ? static_cast<int>(*call) : -1;
      read_last_words();
      if (is_abort(number)) stop(Outcome::crashed, abort_text(printed_));
      stop(Outcome::forbidden,
           "tried to " + purpose_of_call(number) + " (" + name_of_call(number) + ")");
    }
    default:
      stop(Outcome::malformed, "a message that no worker sends");
  }
}

Value StudentWorker::ask(const Call& question, const CallBack& call_back) {
  if (hung_cases_ >= most_hung_cases)
    throw NoAnswer(Outcome::not_run, "two cases before this one had no answer in time");
  if (!running_) running_ = std::make_unique<Running>(program_);
  token_ = static_cast<std::int64_t>(tokens_() >> 1);
  deadline_ = after(program_.walls.limits.wall_seconds);
  delays_ = 0;
  try {
    send(Kind::question, question.arguments);
    for (std::size_t evaluations = 0;; ++evaluations) {
      const Message message = receive();
      if (message.kind != Kind::forbidden && message.token != token_)
        stop(Outcome::malformed, "a message that belongs to no question");
      if (message.kind != Kind::call_back) return answer_of(message);
      if (evaluations == most_evaluations)
        stop(Outcome::hung, "it called a function that it was given 100000 times");
      const FunctionId* function =
          message.content.size() == 2 ? message.content[0].as<FunctionId>() : nullptr;
      if (!function) stop(Outcome::malformed, "a call of no function");
      send(Kind::result, {call_back(*function, list_of(message.content[1]))});
    }
  } catch (const BadMessage& why) {
    stop(Outcome::malformed, why.what());
  } catch (const Malformed& why) {
    stop(Outcome::malformed, why.what());
  }
}

}  // namespace tumble::judge
