// Attack: calls a function of the judge, where the question has none.
// Verdict: wrong call
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    send("\x93\x02" + token +
         "\x92\x81\xa8"
         "function" +
         std::string(1, char(0)) + "\x90");
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
