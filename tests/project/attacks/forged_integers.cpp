// Attack: answers with integers where the contract has floating-point numbers, largest first.
// Verdict: wrong | malformed
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    const std::string largest = "\xcf\xff\xff\xff\xff\xff\xff\xff\xff";
    send(answer + token + "\x91\x94" + largest + largest + largest + largest);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
