// Attack: answers by frames of its own, with the right token and four zeros.
// Verdict: wrong
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    send(answer + token + "\x91\x94" + zero + zero + zero + zero);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
