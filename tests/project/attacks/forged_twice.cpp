// Attack: answers each question twice, so that the second answer meets the next question.
// Verdict: malformed | wrong
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    for (int n = 0; n < 2; ++n) send(answer + token + "\x91\x94" + zero + zero + zero + zero);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
