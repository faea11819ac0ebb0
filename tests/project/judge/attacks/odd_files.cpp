// What stands where the source file is looked for need not be one: what no attack in
// tests/project/attacks/ can be, because it cannot be kept as a source file, is made here.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <functional>

#include "expectations.hpp"

using namespace tumble::test;

namespace {

const std::vector<std::string> refused = {"refused"};

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// Judges what `make` puts at the path of the source file, beside a right 4.2.
void check_file(const std::function<void(const fs::path&)>& make,
                const std::vector<std::string>& verdicts, std::size_t laws = 0) {
  const Place place;
  make(place.files() / "product.cpp");
  hand_in_a_right_inverse(place);
  const Judgement judgement = judge(place);
  CAPTURE(judgement.output.substr(0, 3000));
  check_verdict(judgement, verdicts, laws);
  check_the_judge_stood(judgement, "", passed(judgement.product), laws);
}

void check_text(const std::string& text, const std::vector<std::string>& verdicts,
                std::size_t laws = 0) {
  check_file([&](const fs::path& file) { write(file, text); }, verdicts, laws);
}

fs::path solution() { return root() / "solutions/04_quaternions/product.cpp"; }

std::string right_product() { return text_of(solution()); }

}  // namespace

TEST_CASE("odd files: a link is refused, wherever it leads") {
  const std::string targets[] = {solution().string(), "/etc/passwd", "/dev/zero",
                                 "/dev/stdin",        "/nowhere",    "product.cpp"};
  for (const std::string& target : targets) {
    CAPTURE(target);
    check_file([&](const fs::path& file) { fs::create_symlink(target, file); }, refused);
  }
}

TEST_CASE("odd files: a link to the folder of the solutions gives no solution away") {
  const Place place;
  fs::create_directory_symlink(solution().parent_path(), place.files() / "04_quaternions");
  const Judgement judgement = judge(place);
  CAPTURE(judgement.output.substr(0, 3000));
  check_verdict(judgement, refused, 0);
}

TEST_CASE("odd files: a folder, a pipe, a socket: refused, and nobody waits") {
  check_file([](const fs::path& file) { fs::create_directory(file); }, refused);
  check_file([](const fs::path& file) { CHECK(mkfifo(file.c_str(), 0644) == 0); }, refused);
  check_file(
      [](const fs::path& file) {
        sockaddr_un address = {};
        address.sun_family = AF_UNIX;
        REQUIRE(file.string().size() < sizeof address.sun_path);
        std::strcpy(address.sun_path, file.c_str());
        const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
        CHECK(bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
        close(listener);
      },
      refused);
}

TEST_CASE("odd files: a device is refused") {
  if (geteuid() != 0) return;  // only root can make one
  constexpr int major_of_memory = 1, minor_of_zero = 5;
  const Place place;
  const fs::path file = place.files() / "product.cpp";
  if (mknod(file.c_str(), S_IFCHR | 0644, makedev(major_of_memory, minor_of_zero)) != 0) return;
  const Judgement judgement = judge(place);
  CAPTURE(judgement.output.substr(0, 3000));
  check_verdict(judgement, refused, 0);
}

TEST_CASE("odd files: nothing, and next to nothing, is refused") {
  check_file([](const fs::path&) {}, refused);
  check_text("", refused);
  check_text(" \n\t\r\n \n", refused);
}

TEST_CASE("odd files: a file that may not be read is no verdict, and the next one is judged") {
  if (geteuid() == 0) return;  // root may
  check_file(
      [](const fs::path& file) {
        write(file, right_product());
        fs::permissions(file, fs::perms::none);
      },
      {"judge failed"});
}

TEST_CASE("odd files: what is too large is refused before it is read") {
  check_file(
      [](const fs::path& file) {
        write(file, right_product());
        fs::resize_file(file, std::uintmax_t{1} << 30);  // a hole: no disk is used
      },
      refused);
  std::string lines;
  for (int n = 0; n < 1000000; ++n) lines += "int line_" + std::to_string(n) + ";\n";
  check_text(right_product() + lines, refused);
}

TEST_CASE(
    "odd files: bytes that are no UTF-8 are read as Windows-1252, in a comment they do no harm") {
  check_text(right_product() +
                 "// Gr\xfc\xdf"
                 "e\n",
             {"passed"}, 5);
  check_text(right_product() + "// \xed\xa0\x80 half of a pair\n", {"passed"}, 5);  // a surrogate
  check_text(right_product() + "// \xc0\xaf \xe0\x80\xaf overlong\n", {"passed"}, 5);
  check_text(right_product() + "// cut off \xe2\x82", {"passed"}, 5);
}

TEST_CASE("odd files: a NUL is refused, and bytes without a meaning do not compile") {
  check_text(right_product() + std::string("// \0\n", 5), refused);  // NUL
  check_text("\xff\xfe" + replaced(right_product(), "\n", std::string("\n\0", 2)),
             {"does not compile"});
  check_text(std::string(1000, '\xff'), {"does not compile"});
}

TEST_CASE("odd files: in UTF-16 too, the file shows why the answer is wrong") {
  std::string wide = "\xff\xfe";
  for (const char c : replaced(right_product(), "{a[0]", "{1/2 * a[0]")) wide += {c, '\0'};
  const Place place;
  write(place.files() / "product.cpp", wide);
  const Judgement judgement = judge(place);
  CAPTURE(judgement.output.substr(0, 3000));
  CHECK(judgement.output.find("There is 1/2 in line") != std::string::npos);
}

TEST_CASE("odd files: what other systems' editors make of a right answer passes") {
  check_text(replaced(right_product(), "\n", "\r\n"), {"passed"}, 5);
  check_text("\xef\xbb\xbf" + right_product(), {"passed"}, 5);  // a byte order mark
  check_text(right_product() + "// no newline at the end", {"passed"}, 5);
}

TEST_CASE("odd files: names with commands for the shell in them stay names") {
  const Place place;
  const fs::path strange = place.files() / "a b;touch pwned;$(touch pwned)`touch pwned`'\"";
  fs::create_directory(strange);
  write(strange / "product.cpp", right_product());
  const std::string quoted = "'" + replaced(strange.string(), "'", "'\\''") + "'";
  const auto result =
      std::system(("cd " + place.path().string() + " && '" + variable("TUMBLE_JUDGE").string() +
                   "' check 4.1 --from " + quoted + " --seed 1 > output 2>&1")
                      .c_str());
  CAPTURE(text_of(place.path() / "output"));
  CHECK(result == 0);
  for (const fs::path& folder : {place.path(), place.files(), strange})
    CHECK_FALSE(fs::exists(folder / "pwned"));
}
