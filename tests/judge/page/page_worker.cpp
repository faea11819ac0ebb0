#include "judge/page/page_worker.hpp"

#include <emscripten.h>
#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/conversation/endings.hpp"
#include "judge/page/wasi_calls.hpp"
#include "judge/worker/descriptors.hpp"

// site/student.mjs
EM_JS(void, student_forget, (), { Module.student.forget(); });
EM_JS(char*, student_answer, (int case_number, int question),
      { return allocateUTF8(JSON.stringify(Module.student.answer(case_number, question))); });

namespace tumble::judge {

namespace {

constexpr std::uint64_t memory_bytes = 512ull << 20;  // as the linker says: see build/
constexpr int seconds_of_computing = 2;               // as the page's clock says: see client.mjs

PageWorker* current = nullptr;

PageEnding run_student(int case_number, int question) {
  const std::unique_ptr<char, decltype(&std::free)> text(student_answer(case_number, question),
                                                         std::free);
  const auto j = nlohmann::json::parse(text.get());
  return {j.at("how"), j.value("detail", ""), j.value("status", 0)};
}

int signal_of(const std::string& name) {
  if (name == "SIGFPE") return SIGFPE;
  if (name == "SIGABRT") return SIGABRT;
  return name == "SIGILL" ? SIGILL : SIGSEGV;
}

}  // namespace

PageWorker::PageWorker() : exchange_(memory_bytes) { current = this; }

PageWorker::~PageWorker() { current = nullptr; }

void PageWorker::start_case() {
  student_forget();
  gone_.reset();
  received_.clear();
  printed_.clear();
  bytes_printed_ = 0;
  ++case_;
  question_ = 0;
}

Value PageWorker::ask(const Call& question, const CallBack& call_back) {
  try {
    sent_ = exchange_.question(question.arguments);
    call_back_ = &call_back;
    last_message_.reset();
    take_messages();  // of a worker that has said more than was asked
    const PageEnding ending = gone_ ? *gone_ : run_student(case_, ++question_);
    if (stopped_) std::rethrow_exception(std::exchange(stopped_, nullptr));
    if (!last_message_) no_answer_came(ending);
    if (ending.how != "returned") gone_ = ending;
    return exchange_.answer_of(*last_message_);
  } catch (...) {
    student_forget();
    gone_.reset();
    received_.clear();
    exchange_.rethrow();
  }
}

bool PageWorker::take(int descriptor, const std::string& bytes) noexcept {
  try {
    if (descriptor == answers_descriptor) {
      received_ += bytes;
      take_messages();
    } else {
      take_text(bytes);
    }
    return true;
  } catch (...) {
    stopped_ = std::current_exception();
    return false;
  }
}

void PageWorker::take_text(const std::string& bytes) {
  bytes_printed_ += bytes.size();
  if (printed_.size() < most_printed) printed_ += bytes;
  if (bytes_printed_ > flood) throw flooded();
}

void PageWorker::take_messages() {
  while (!last_message_) {
    std::optional<Message> message = take_message(received_);
    if (!message) return;
    if (std::optional<std::string> result = exchange_.result_for(*message, *call_back_))
      sent_ += *result;
    else
      last_message_ = std::move(message);
  }
}

std::size_t PageWorker::give(char* to, std::size_t most) noexcept {
  const std::size_t size = sent_.copy(to, std::min(most, sent_.size()));
  sent_.erase(0, size);
  return size;
}

void PageWorker::no_answer_came(const PageEnding& ending) const {
  if (ending.how == "hung") throw computed_too_long(seconds_of_computing);
  if (ending.how == "signal") throw crashed(signal_of(ending.detail), printed_);
  if (ending.how == "refused") throw refused(purpose_of_wasi_call(ending.detail), ending.detail);
  if (ending.how == "failed")
    throw std::runtime_error("the page could not run the student's module: " + ending.detail);
  throw exited(ending.status);
}

}  // namespace tumble::judge

extern "C" {
EMSCRIPTEN_KEEPALIVE int student_wrote(int descriptor, const char* bytes, std::size_t size) {
  return tumble::judge::current->take(descriptor, std::string(bytes, size)) ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE std::size_t student_reads(char* to, std::size_t most) {
  return tumble::judge::current->give(to, most);
}
}
