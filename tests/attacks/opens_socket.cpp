// Attack: sends the questions to a server, or asks it for answers.
// Verdict: forbidden
#include <arpa/inet.h>
#include <sys/socket.h>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const int line = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in server = {};
  server.sin_family = AF_INET;
  server.sin_port = htons(80);
  server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  connect(line, reinterpret_cast<sockaddr*>(&server), sizeof server);
  return a;
}
}  // namespace quaternions
