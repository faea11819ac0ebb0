// Attack: promises a text of four thousand million bytes.
// Verdict: malformed
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    send(answer + token +
         "\x91\xdb\xff\xff\xff\xff"
         "abc");
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
