#pragma once
/// @file
/// Pipes and reads with a deadline.

#include <chrono>
#include <cstddef>
#include <string>

namespace tumble::judge {

using Clock = std::chrono::steady_clock;

/// The moment `seconds` from now.
Clock::time_point after(double seconds);

/// One open file, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { reset(); }
  int number() const { return number_; }
  int release();
  void reset();

 private:
  int number_;
};

struct Pipe {
  Descriptor read, write;
};

/// @throws std::runtime_error if the process has too many open files
Pipe make_pipe();

/// Waits until one of two files can be read (a negative number is none), or for the deadline.
struct Ready {
  bool first = false, second = false;
};
Ready wait_readable(int first, int second, Clock::time_point deadline);

/// Appends what can be read now, at most `most` bytes.
/// @return false at the end of the file
bool read_some(int descriptor, std::string& to, std::size_t most = 1 << 16);

/// Writes to a pipe that nobody may be reading.
/// @return whether everything was written before the deadline
bool write_all(int descriptor, const std::string& bytes, Clock::time_point deadline);

}  // namespace tumble::judge
