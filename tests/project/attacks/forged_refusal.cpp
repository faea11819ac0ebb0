// Attack: reports a refused system call that it never made, with a number that does not exist.
// Verdict: forbidden | malformed | crashed
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    send(std::string("\x93\x07\x00\x91\xd2\x80\x00\x00\x00", 9));
    static_cast<void>(token);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
