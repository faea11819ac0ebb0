#include "judge/worker/serve.hpp"

#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <cerrno>
#include <exception>
#include <new>
#include <string>

#include "judge/protocol/message.hpp"
#include "judge/sandbox/linux_walls.hpp"
#include "judge/worker/descriptors.hpp"
#include "not_implemented.hpp"

#if TUMBLE_LINUX_WALLS
#include <csignal>

// Theirs is the name, where there are sanitizers; else it is null.
extern "C" void __sanitizer_print_stack_trace()  // NOLINT(bugprone-reserved-identifier)
    __attribute__((weak));
#endif

namespace tumble::judge {

namespace {

constexpr unsigned char mark_of_never_set = 0xfe;  // as gcc's -ftrivial-auto-var-init=pattern

/// The judge has hung up: nobody is left who waits for an answer.
struct HungUp {};

std::int64_t current_token = 0;

void write_all(const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(answers_descriptor, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw HungUp{};
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

void send(Kind kind, List content) {
  const std::string body = encode({kind, current_token, std::move(content)});
  const std::string frame = frame_head(body.size()) + body;
  write_all(frame.data(), frame.size());
}

void read_all(char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t got = ::read(questions_descriptor, data, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw HungUp{};
    data += got;
    size -= static_cast<std::size_t>(got);
  }
}

Message receive() {
  unsigned char head[4];
  read_all(reinterpret_cast<char*>(head), sizeof head);
  std::string body(frame_size(head), '\0');
  read_all(body.data(), body.size());
  return decode(body);
}

void answer_one(const Message& question, const std::function<Value(const List&)>& answer) {
  current_token = question.token;
  try {
    send(Kind::answer, {answer(question.content)});
  } catch (const HungUp&) {
    throw;
  } catch (const NotImplemented&) {
    send(Kind::not_implemented, {});
  } catch (const std::bad_alloc&) {
    send(Kind::out_of_memory, {});
  } catch (const std::exception& e) {
    constexpr std::size_t most = 1000;  // a frame has an end
    send(Kind::threw, {std::string(e.what()).substr(0, most)});
  } catch (...) {
    send(Kind::threw, {std::string("something that is not a std::exception")});
  }
}

#if TUMBLE_LINUX_WALLS
/// The sandbox turns a refused system call into this signal: say which call it was, and end. The
/// student's code may have been inside malloc, so the message is put together without it.
void report_refused_call(int, siginfo_t* info, void*) {
  const auto call = static_cast<unsigned>(info->si_syscall);
  const auto byte = [](unsigned x) { return static_cast<unsigned char>(x & 0xff); };
  // MessagePack: an array of 3; the kind; the token 0; an array of 1 with a 16-bit number.
  const unsigned char frame[] = {7,         0,
                                 0,         0,
                                 0x93,      static_cast<unsigned char>(Kind::forbidden),
                                 0,         0x91,
                                 0xcd,      byte(call >> 8),
                                 byte(call)};
  [[maybe_unused]] const ssize_t written = ::write(answers_descriptor, frame, sizeof frame);
  ::_exit(1);
}

/// With sanitizers, where the time was used up: the judge looks for the line.
void report_endless_loop(int) {
  __sanitizer_print_stack_trace();
  ::_exit(1);
}

/// Before any constructor of the student's file runs, and before main.
void install_report() {
  struct sigaction action = {};
  action.sa_sigaction = report_refused_call;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, nullptr);
}
#endif

}  // namespace

void mark_stack() {
  volatile unsigned char stack[1 << 14];
  for (volatile unsigned char& byte : stack) byte = mark_of_never_set;
}

Value call_back(FunctionId id, const List& arguments) {
  send(Kind::call_back, {id, arguments});
  Message result = receive();
  if (result.kind != Kind::result || result.content.size() != 1)
    throw Malformed("the judge did not send a result");
  return result.content[0];
}

int serve_questions(const std::function<Value(const List&)>& answer) {
#ifdef __GLIBC__
  mallopt(M_PERTURB, 0xff & ~mark_of_never_set);  // new memory gets the complement
#endif
#if TUMBLE_LINUX_WALLS
  if (__sanitizer_print_stack_trace) std::signal(SIGXCPU, report_endless_loop);
#endif
  try {
    while (true) answer_one(receive(), answer);
  } catch (const HungUp&) {
    return 0;
  }
}

}  // namespace tumble::judge

#if TUMBLE_LINUX_WALLS
extern "C" {
using Initialiser = void (*)();
__attribute__((section(".preinit_array"), used)) Initialiser tumble_install_report =
    tumble::judge::install_report;
}
#endif
