#pragma once
/// @file
/// A machine on which no file can be opened any more, for as long as this lives.

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace tumble::test {

class WithoutFiles {
 public:
  WithoutFiles() {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    const int next = ::open("/dev/null", O_RDONLY | O_CLOEXEC);  // the lowest that is free
    ::close(next);
    const rlimit none = {static_cast<rlim_t>(next), before_.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &none);
  }
  WithoutFiles(const WithoutFiles&) = delete;
  WithoutFiles& operator=(const WithoutFiles&) = delete;
  ~WithoutFiles() { end(); }
  void end() const { ::setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_ = {};
};

}  // namespace tumble::test
