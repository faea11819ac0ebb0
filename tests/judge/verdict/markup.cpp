#include "judge/verdict/markup.hpp"

namespace tumble::judge {

std::string markup(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (code >= 0x20 || c == '\n' || c == '\t')
      result += c;
    else
      result += '?';
  }
  return result;
}

}  // namespace tumble::judge
