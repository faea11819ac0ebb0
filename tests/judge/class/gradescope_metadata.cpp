#include "judge/class/gradescope_metadata.hpp"

#include <sstream>

#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// A value of YAML on one line: plain, 'quoted' or "quoted".
std::string yaml_value(std::string text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  text = text.substr(begin, text.find_last_not_of(" \r") - begin + 1);
  if (text == "null" || text == "~") return "";
  const char quote = text.front();
  if (text.size() < 2 || (quote != '\'' && quote != '"') || text.back() != quote) return text;
  std::string value;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const bool escape = (quote == '\'' && text[i] == '\'') || (quote == '"' && text[i] == '\\');
    if (escape && i + 2 < text.size()) ++i;
    value += text[i];
  }
  return value;
}

/// A line: how far it is indented, whether it begins an element of a list, its key and its value.
struct YamlLine {
  std::size_t indent = 0;
  bool element = false;
  std::string key, value;
};

YamlLine yaml_line(const std::string& text) {
  YamlLine line;
  std::size_t at = text.find_first_not_of(' ');
  line.indent = at;
  if (text.compare(at, 2, "- ") == 0) {
    line.element = true;
    at = text.find_first_not_of(' ', at + 1);
    if (at == std::string::npos) return line;
  }
  const std::size_t end = text.find(':', at + 1);  // a key of Ruby's begins with a colon
  if (end == std::string::npos) return line;
  line.key = text.substr(at, end - at);
  line.value = yaml_value(text.substr(end + 1));
  return line;
}

class MetadataReader {
 public:
  std::map<std::string, GradescopeSubmission> read(const std::string& text) {
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
      line.erase(line.find_last_not_of(" \r") + 1);
      if (!line.empty() && line != "---") take(yaml_line(line));
    }
    require(!all_.empty(), "it names no submission");
    return std::move(all_);
  }

 private:
  void take(const YamlLine& line) {
    if (line.indent == 0 && !line.element) {
      require(!line.key.empty(), "it is not a list of submissions");
      now_ = &all_[yaml_value(line.key)];
      among_submitters_ = false;
      return;
    }
    require(now_ != nullptr, "it is not a list of submissions");
    if (line.indent <= 2 && !line.element) {
      among_submitters_ = line.key == ":submitters";
      if (line.key == ":created_at") now_->created_at = line.value;
    } else if (among_submitters_) {
      take_submitter(line);
    }
  }

  void take_submitter(const YamlLine& line) {
    if (line.element) now_->submitters.emplace_back();
    require(!now_->submitters.empty(), ":submitters is not a list");
    Identity& submitter = now_->submitters.back();
    if (line.key == ":name") submitter.name = line.value;
    if (line.key == ":sid") submitter.id = line.value;
    if (line.key == ":email") submitter.email = line.value;
  }

  std::map<std::string, GradescopeSubmission> all_;
  GradescopeSubmission* now_ = nullptr;
  bool among_submitters_ = false;
};

}  // namespace

std::map<std::string, GradescopeSubmission> read_gradescope_metadata(const std::string& text) {
  return MetadataReader().read(text);
}

}  // namespace tumble::judge
