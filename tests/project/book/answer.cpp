/// @file
/// What the server of the site says to a request: files of the site, and nothing else.
#include <doctest/doctest.h>

#include "book/serve/answer.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/temporary_folder.hpp"

using namespace tumble::book;
using tumble::test::mentions;
namespace fs = std::filesystem;

namespace {

/// A site, and beside it what is nobody's business.
class Site : public tumble::test::TemporaryFolder {
 public:
  Site() {
    write("secret.txt", "secret");
    write("site/index.html", "front");
    write("site/exercises/judge_04.wasm", "wasm");
    write("site/exercises/a b.mjs", "script");
    write("site/exercises/clang.wasm.zst", "packed");
    fs::create_symlink(path() / "secret.txt", path() / "site/link.txt");
  }

  Answer asked(const std::string& request) const {
    return answer_to(fs::canonical(path() / "site"), request);
  }
};

}  // namespace

TEST_CASE("server: each file has the type that browsers ask for") {
  const Site site;
  CHECK(site.asked("GET / HTTP/1.1").type == "text/html; charset=utf-8");
  CHECK(site.asked("GET /exercises/judge_04.wasm?v=2 HTTP/1.1").type == "application/wasm");
  CHECK(site.asked("GET /exercises/a%20b.mjs HTTP/1.1").type == "text/javascript; charset=utf-8");
  CHECK(site.asked("GET /exercises/clang.wasm.zst HTTP/1.0").type == "application/octet-stream");
}

TEST_CASE("server: a folder is its index.html, and HEAD has no content") {
  const Site site;
  const Answer front = site.asked("HEAD / HTTP/1.1");
  CHECK(front.file.filename() == "index.html");
  CHECK_FALSE(front.with_content);
  CHECK(mentions(front.head(), "HTTP/1.1 200 OK\r\n", "Content-Length: 5\r\n"));
}

TEST_CASE("server: nothing outside the site is there, by whatever path") {
  const Site site;
  for (const char* address : {"/../secret.txt", "/%2e%2e/secret.txt", "/exercises/../../secret.txt",
                              "/link.txt", "//etc/passwd", "/exercises", "/none.html"}) {
    CAPTURE(address);
    const Answer answer = site.asked(std::string("GET ") + address + " HTTP/1.1");
    CHECK(answer.status == 404);
    CHECK(answer.file.empty());
  }
}

TEST_CASE("server: what is no request for a file is refused") {
  const Site site;
  CHECK(site.asked("POST / HTTP/1.1").status == 405);
  for (const char* request : {"GET /", "", "GET index.html HTTP/1.1", "GET /%zz HTTP/1.1",
                              "GET /%00 HTTP/1.1", "GET /% HTTP/1.1"})
    CHECK(site.asked(request).status == 400);
  CHECK(mentions(site.asked("DELETE / HTTP/1.1").head(), "405 Method Not Allowed"));
}
