// Attack: answers with a matrix of one very wide and many narrow cells: shown as a table, 110 kB
//         become 100 MB.
// Verdict: wrong | malformed
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    std::string rows = "\x92" + zero + text(std::string(100000, (char)65));
    for (int n = 1; n < 1000; ++n) rows += "\x91" + zero;
    send(answer + token + "\x91" + array_of(1000) + rows);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
