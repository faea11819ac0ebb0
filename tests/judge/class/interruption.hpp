#pragma once
/// @file
/// Ctrl-C in the middle of a long command: what was begun stops, and what is there is written.

#include <csignal>

namespace tumble::judge {

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end this process, but are known to it and to
/// all that it forks. A signal that was ignored before (nohup) stays so.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// Has anybody asked to stop?
  bool asked() const;
  /// In a child: it ends with the signal, as it would have.
  static void leave_to_system();

 private:
  const volatile std::sig_atomic_t* asked_;
};

}  // namespace tumble::judge
