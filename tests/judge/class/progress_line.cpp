#include "judge/class/progress_line.hpp"

#include <unistd.h>

#include <cmath>
#include <iostream>

namespace tumble::judge {

using Clock = std::chrono::steady_clock;

ProgressLine::ProgressLine(std::size_t of, std::string what)
    : of_(of),
      what_(std::move(what)),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      printed_(start_) {}

ProgressLine::~ProgressLine() { clear(); }

double ProgressLine::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void ProgressLine::tick() {
  ++done_;
  const std::chrono::duration<double> since = Clock::now() - printed_;
  if (since.count() < (terminal_ ? 0.2 : 10) && done_ < of_) return;
  printed_ = Clock::now();
  print();
}

void ProgressLine::print() const {
  const double left = seconds() / static_cast<double>(done_) * static_cast<double>(of_ - done_);
  std::cerr << (terminal_ ? "\r\033[K" : "") << "tumble: " << done_ << " of " << of_ << " "
            << what_;
  if (done_ < of_) std::cerr << ", " << duration_text(left) << " left";
  std::cerr << (terminal_ ? "" : "\n") << std::flush;
}

void ProgressLine::clear() const {
  if (terminal_) std::cerr << "\r\033[K" << std::flush;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 100) return std::to_string(whole) + " s";
  if (whole < 100L * 60) return std::to_string((whole + 30) / 60) + " min";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

}  // namespace tumble::judge
