#include "project/harness/chromium.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "project/harness/temporary_folder.hpp"

namespace tumble::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int patience = 60'000;  // [ms]: a loaded machine takes its time

std::string decoded(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : base64) {
    const auto value = digits.find(c);
    if (value == std::string::npos) break;
    bits = bits << 6 | static_cast<unsigned>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

/// Becomes the browser, which reads commands from descriptor 3 and answers on 4.
[[noreturn]] void become(const std::string& program, const fs::path& profile, int commands,
                         int answers) {
  setpgid(0, 0);  // with its helpers it can be ended as one
  // Both away from 3 and 4, and then there.
  const int from = fcntl(commands, F_DUPFD, 10), to = fcntl(answers, F_DUPFD, 10);
  dup2(from, 3);
  dup2(to, 4);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  dup2(nowhere, 2);
  const std::string folder = "--user-data-dir=" + profile.string();
  std::vector<const char*> words{program.c_str(),
                                 "--headless",
                                 "--disable-gpu",
                                 "--disable-dev-shm-usage",
                                 "--remote-debugging-pipe",
                                 "--no-first-run",
                                 "--disable-background-networking",
                                 "--disable-component-update",
                                 "--hide-scrollbars",
                                 folder.c_str()};
  if (geteuid() == 0) words.push_back("--no-sandbox");
  words.push_back("about:blank");
  words.push_back(nullptr);
  execv(program.c_str(), const_cast<char* const*>(words.data()));
  _exit(127);
}

}  // namespace

std::string chromium_program() {
  const char* path = std::getenv("PATH");
  std::string folders = path ? path : "";
  for (std::size_t begin = 0; begin < folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      const fs::path program = fs::path(folders.substr(begin, end - begin)) / name;
      if (access(program.c_str(), X_OK) == 0) return program.string();
    }
    begin = end + 1;
  }
  return {};
}

class BrowserProcess {
 public:
  BrowserProcess() {
    std::array<int, 2> commands{}, answers{};
    if (pipe2(commands.data(), O_CLOEXEC) != 0 || pipe2(answers.data(), O_CLOEXEC) != 0)
      throw std::runtime_error("no pipe to the browser");
    const std::string program = chromium_program();
    process_ = fork();
    if (process_ == 0) become(program, profile_.path(), commands[0], answers[1]);
    close(commands[0]);
    close(answers[1]);
    to_ = commands[1];
    from_ = answers[0];
  }
  BrowserProcess(const BrowserProcess&) = delete;
  BrowserProcess& operator=(const BrowserProcess&) = delete;
  ~BrowserProcess() {
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    close(to_);
    close(from_);
    // Its helpers may still write into the profile.
    std::error_code busy;
    for (int i = 0; i < 100 && fs::exists(profile_.path()); ++i) {
      fs::remove_all(profile_.path(), busy);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  /// The one that this program has; it ends with the program.
  static BrowserProcess& shared() {
    static BrowserProcess browser;
    return browser;
  }

  /// Sends a command, with a number of its own, to a page or, without a session, to the browser.
  /// @return the number
  int send(const std::string& session, const std::string& method, Json parameters) {
    Json message = {{"id", ++last_}, {"method", method}, {"params", std::move(parameters)}};
    if (!session.empty()) message["sessionId"] = session;
    const std::string text = message.dump();
    for (std::size_t sent = 0; sent <= text.size();) {
      const ssize_t count = write(to_, text.c_str() + sent, text.size() + 1 - sent);
      if (count <= 0) throw std::runtime_error("the browser takes no commands");
      sent += static_cast<std::size_t>(count);
    }
    return last_;
  }

  /// The next message: an answer, or an event.
  Json receive() {
    while (true) {
      if (const auto end = unread_.find('\0'); end != std::string::npos) {
        const Json message = Json::parse(unread_.substr(0, end));
        unread_.erase(0, end + 1);
        return message;
      }
      pollfd ready{from_, POLLIN, 0};
      if (poll(&ready, 1, patience) <= 0) throw std::runtime_error("the browser does not answer");
      std::array<char, 65536> bytes{};
      const ssize_t count = read(from_, bytes.data(), bytes.size());
      if (count <= 0) throw std::runtime_error("the browser has gone");
      unread_.append(bytes.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  TemporaryFolder profile_;
  pid_t process_ = -1;
  int to_ = -1, from_ = -1, last_ = 0;
  std::string unread_;
};

Chromium::Chromium() : browser_(BrowserProcess::shared()) {
  context_ = call("Target.createBrowserContext").at("browserContextId");
  const Json target =
      call("Target.createTarget", {{"url", "about:blank"}, {"browserContextId", context_}});
  session_ = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}})
                 .at("sessionId");
  for (const char* domain : {"Page", "Runtime", "Log", "Network"})
    call(std::string(domain) + ".enable");
}

Chromium::~Chromium() {
  session_.clear();
  try {
    call("Target.disposeBrowserContext", {{"browserContextId", context_}});
  } catch (const std::exception&) {  // it has gone: what it kept is gone as well
  }
}

void Chromium::take(const Json& event) {
  if (event.value("sessionId", "") != session_) return;  // of a page that is gone
  const std::string method = event.value("method", "");
  const Json& what = event.contains("params") ? event["params"] : Json::object();
  seen_.push_back(method);
  if (method == "Runtime.exceptionThrown")
    complaints_.push_back("exception: " + what["exceptionDetails"].dump());
  if (method == "Log.entryAdded" && what["entry"]["level"] == "error")
    complaints_.push_back("log: " + what["entry"]["text"].get<std::string>() + " " +
                          what["entry"].value("url", ""));
  if (method == "Runtime.consoleAPICalled" && what["type"] == "error")
    complaints_.push_back("console: " + what["args"].dump());
  if (method == "Network.requestWillBeSent") {
    const std::string address = what["request"]["url"];
    const auto begins = [&](const std::string& place) { return address.starts_with(place); };
    if (!begins("file:") && !begins("data:") && !begins("blob:") && !begins(home_))
      complaints_.push_back("request: " + address);
  }
}

Json Chromium::call(const std::string& method, Json parameters) {
  const int number = browser_.send(session_, method, std::move(parameters));
  while (true) {
    const Json answer = browser_.receive();
    if (answer.value("id", 0) != number) {
      take(answer);
      continue;
    }
    if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
    return answer["result"];
  }
}

void Chromium::wait_for(const std::string& event) {
  const auto there = [&] { return std::find(seen_.begin(), seen_.end(), event) != seen_.end(); };
  while (!there()) take(browser_.receive());
}

void Chromium::resize(int width, int height, bool phone) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", phone}});
  call("Emulation.setTouchEmulationEnabled", {{"enabled", phone}});
}

void Chromium::prefer_dark(bool dark) {
  const Json feature = {{"name", "prefers-color-scheme"}, {"value", dark ? "dark" : "light"}};
  call("Emulation.setEmulatedMedia", {{"features", Json::array({feature})}});
}

void Chromium::open(const std::string& address) {
  const std::size_t path = address.find('/', address.find("://") + 3);
  home_ = address.substr(0, path == std::string::npos ? path : path + 1);
  // By way of an empty page: to another place in the same one nothing would be loaded.
  for (const std::string& next : {std::string("about:blank"), address}) {
    seen_.clear();
    complaints_.clear();
    call("Page.navigate", {{"url", next}});
    wait_for("Page.loadEventFired");
  }
}

Json Chromium::evaluate(const std::string& expression) {
  const Json answer =
      call("Runtime.evaluate",
           {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (answer.contains("exceptionDetails"))
    throw std::runtime_error("in the page: " + answer["exceptionDetails"].dump());
  return answer["result"].value("value", Json());
}

void Chromium::drag(double x, double y, double to_x, double to_y) {
  const auto mouse = [&](const char* type, double at_x, double at_y, int buttons) {
    call("Input.dispatchMouseEvent", {{"type", type},
                                      {"x", at_x},
                                      {"y", at_y},
                                      {"button", "left"},
                                      {"buttons", buttons},
                                      {"clickCount", 1}});
  };
  mouse("mousePressed", x, y, 1);
  mouse("mouseMoved", to_x, to_y, 1);
  mouse("mouseReleased", to_x, to_y, 0);
}

void Chromium::press(const std::string& key, int number) {
  for (const char* type : {"rawKeyDown", "keyUp"})
    call("Input.dispatchKeyEvent",
         {{"type", type}, {"key", key}, {"code", key}, {"windowsVirtualKeyCode", number}});
}

void Chromium::type(const std::string& text) {
  for (const char c : text) {
    const std::string key(1, c);
    call("Input.dispatchKeyEvent", {{"type", "keyDown"}, {"key", key}, {"text", key}});
    call("Input.dispatchKeyEvent", {{"type", "keyUp"}, {"key", key}});
  }
}

void Chromium::screenshot(const fs::path& file) {
  const Json answer = call("Page.captureScreenshot", {{"format", "png"}});
  std::ofstream(file, std::ios::binary) << decoded(answer["data"]);
}

}  // namespace tumble::test
