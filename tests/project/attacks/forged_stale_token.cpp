// Attack: answers each question with the token of the one before.
// Verdict: malformed
#include <unistd.h>

#include <cstdint>
#include <utility>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    static std::string before = std::string("\xcf\0\0\0\0\0\0\0\x07", 9);
    send(answer + std::exchange(before, token) + "\x91\x94" + zero + zero + zero + zero);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
