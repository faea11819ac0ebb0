// Attack: sends the questions to a server, or asks it for answers.
// Verdict: forbidden
#include <sys/socket.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const int line = socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr server = {AF_INET, {0, 80, 127, 0, 0, 1}};
  connect(line, &server, sizeof server);
  return a;
}
}  // namespace quaternions
