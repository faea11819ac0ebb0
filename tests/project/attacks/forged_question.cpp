// Attack: asks the judge a question.
// Verdict: malformed
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    send(std::string("\x93\x00", 2) + token + "\x92\x94" + zero + zero + zero + zero + zero);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
