// Attack: answers with a list of 900000 entries where 4 are asked for.
// Verdict: wrong | malformed
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    send(answer + token + "\x91" + array_of(900000) + std::string(900000, (char)1));
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
