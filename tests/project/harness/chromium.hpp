#pragma once
/// @file
/// A headless Chromium that a test drives, by the DevTools protocol over two pipes.

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tumble::test {

/// The program of Chromium, or empty if there is none.
std::string chromium_program();

/// The browser itself: a process that all pages of a program share, as it takes long to start.
class BrowserProcess;

/// A page in a browser that has seen no other: nothing that an earlier page has kept is there.
class Chromium {
 public:
  /// @throws std::runtime_error if the browser does not start
  Chromium();
  Chromium(const Chromium&) = delete;
  Chromium& operator=(const Chromium&) = delete;
  ~Chromium();

  /// The size of the page from now on [px]; `phone` means touch, and no mouse.
  void resize(int width, int height, bool phone = false);
  /// Whether pages are told that the reader wants dark colours.
  void prefer_dark(bool dark);
  /// Opens a page, and waits until it is loaded and its scripts have run.
  void open(const std::string& address);
  /// What an expression of JavaScript gives; of a promise, what it resolves to.
  /// @throws std::runtime_error with the page's own message if it throws
  nlohmann::json evaluate(const std::string& expression);
  /// Presses the mouse at a point of the window, moves it, and lets go [px].
  void drag(double x, double y, double to_x, double to_y);
  /// Presses a key, by its name and the number that browsers have for it: ("Tab", 9).
  void press(const std::string& key, int number);
  /// Presses the keys of a text of ASCII characters.
  void type(const std::string& text);
  /// A picture of the window, as PNG.
  void screenshot(const std::filesystem::path& file);

  /// Errors in the console, exceptions, and requests to others than the page's own server, since
  /// the page was opened.
  const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  nlohmann::json call(const std::string& method,
                      nlohmann::json parameters = nlohmann::json::object());
  void take(const nlohmann::json& event);
  void wait_for(const std::string& event);

  BrowserProcess& browser_;
  std::string context_, session_, home_ = "file:";
  std::vector<std::string> complaints_, seen_;
};

}  // namespace tumble::test
