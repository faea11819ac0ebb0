#include "book/serve/answer.hpp"

#include <map>
#include <optional>
#include <sstream>

namespace tumble::book {

namespace {

namespace fs = std::filesystem;

std::string type_of(const fs::path& file) {
  static const std::map<std::string, std::string> types{{".html", "text/html; charset=utf-8"},
                                                        {".css", "text/css; charset=utf-8"},
                                                        {".js", "text/javascript; charset=utf-8"},
                                                        {".mjs", "text/javascript; charset=utf-8"},
                                                        {".json", "application/json"},
                                                        {".wasm", "application/wasm"},
                                                        {".svg", "image/svg+xml"},
                                                        {".png", "image/png"},
                                                        {".woff2", "font/woff2"},
                                                        {".cpp", "text/plain; charset=utf-8"},
                                                        {".hpp", "text/plain; charset=utf-8"},
                                                        {".txt", "text/plain; charset=utf-8"}};
  const auto found = types.find(file.extension().string());
  return found == types.end() ? "application/octet-stream" : found->second;
}

std::string words_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 405:
      return "Method Not Allowed";
    default:
      return "Not Found";
  }
}

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int letter = (c | 32) - 'a';
  return letter >= 0 && letter < 6 ? letter + 10 : -1;
}

/// "a b" of "a%20b"; nothing if that means no path.
std::optional<std::string> decoded(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain += text[i];
      continue;
    }
    if (i + 2 >= text.size() || digit(text[i + 1]) < 0 || digit(text[i + 2]) < 0) return {};
    plain += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
    i += 2;
  }
  if (plain.find('\0') != std::string::npos || !plain.starts_with("/")) return {};
  return plain;
}

/// Whether a file is below a folder, whatever links are on the way.
bool is_within(const fs::path& folder, const fs::path& file) {
  const std::string relative = file.lexically_relative(folder).string();
  return !relative.empty() && !relative.starts_with("..");
}

}  // namespace

std::string Answer::head() const {
  const auto size = file.empty() ? 0 : fs::file_size(file);
  std::ostringstream text;
  text << "HTTP/1.1 " << status << " " << words_of(status) << "\r\nContent-Length: " << size
       << "\r\nCache-Control: no-cache\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n";
  if (!type.empty()) text << "Content-Type: " << type << "\r\n";
  text << "\r\n";
  return text.str();
}

Answer answer_to(const fs::path& site, const std::string& request) {
  std::istringstream words(request);
  std::string method, address, version;
  words >> method >> address >> version;
  if (!version.starts_with("HTTP/1.")) return {400, "", "", false};
  if (method != "GET" && method != "HEAD") return {405, "", "", false};
  const auto path = decoded(address.substr(0, address.find_first_of("?#")));
  if (!path) return {400, "", "", false};
  std::error_code unreadable;
  fs::path file = fs::weakly_canonical(site / path->substr(1), unreadable);
  if (fs::is_directory(file, unreadable)) file = fs::weakly_canonical(file / "index.html");
  if (!is_within(site, file) || !fs::is_regular_file(file, unreadable)) return {404, "", "", false};
  return {200, type_of(file), file, method == "GET"};
}

}  // namespace tumble::book
