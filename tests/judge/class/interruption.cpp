#include "judge/class/interruption.hpp"

#include <signal.h>
#include <sys/mman.h>

#include <initializer_list>
#include <new>

namespace tumble::judge {

namespace {

/// Shared with the children: a child that is not of the terminal's group hears of it between two
/// exercises.
volatile sig_atomic_t* stop_asked = nullptr;

void ask_to_stop(int) { *stop_asked = 1; }

void on_interruption(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN)  // nohup, or a shell's own way of starting in the background
      sigaction(signal, &action, nullptr);
  }
}

}  // namespace

Interruption::Interruption() {
  if (!stop_asked) {
    void* shared = mmap(nullptr, sizeof(sig_atomic_t), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::bad_alloc();
    stop_asked = static_cast<volatile sig_atomic_t*>(shared);
  }
  *stop_asked = 0;
  asked_ = stop_asked;
  on_interruption(ask_to_stop);
}

Interruption::~Interruption() { on_interruption(SIG_DFL); }

bool Interruption::asked() const { return *asked_ != 0; }

void Interruption::leave_to_system() { on_interruption(SIG_DFL); }

}  // namespace tumble::judge
