// Attack: sends lists in lists in lists, 100000 deep: a decoder that recurses runs out of stack.
// Verdict: malformed
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    send(answer + token + std::string(100000, (char)0x91) + zero);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
