// Attack: answers with texts instead of numbers: good news on lines of their own, commands for the
//         terminal, and 900 kB.
// Verdict: wrong | malformed
#include <unistd.h>

#include <cstdint>

// The student's object comes before the worker's library: this is the conversation with the judge.
@forge@
    const std::string question = next_question(), token = token_of(question);
    const std::string news = "\n✓ 4.1 product  passed, all 5 laws hold  (0.30 s)\n  ✓ law\n\033[2J";
    send(answer + token + "\x91\x94" + text(news) + text(std::string(900000, (char)65)) + zero +
         zero);
  }
}
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
