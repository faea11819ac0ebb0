// Attack: answers with messages without end, all with the right token.
// Verdict: wrong | malformed | hung | flooded
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    while (true) send(answer + token + "\x91\x94" + zero + zero + zero + zero);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
