#include "book/tool/contract.hpp"

#include <algorithm>
#include <cctype>

namespace tumble::book {

namespace {

const std::string comment = "///", heading = "// == ";

/// "/// text" → "text", with its indentation beyond the first blank.
std::string uncommented(const std::string& line) { return line.size() > 4 ? line.substr(4) : ""; }

/// "t0, t1 the first and the last time" → "`t0`, `t1`: the first and the last time".
std::string parameter(const std::string& text) {
  std::string names = "`";
  std::size_t at = 0;
  for (; at < text.size() && text[at] != ' '; ++at) {
    names += text[at];
    if (text.compare(at, 2, ", ") == 0) {
      names.back() = '`';
      names += ", `";
      ++at;
    }
  }
  const auto rest = text.find_first_not_of(' ', at);
  return names + "`: " + (rest == std::string::npos ? "" : text.substr(rest));
}

/// A line of the comment that begins an item: "- `x`: …"; empty for any other line.
std::string item_of(const std::string& line) {
  if (line.starts_with("@param ")) return "- " + parameter(line.substr(7));
  if (line.starts_with("@return ")) return "- returns " + line.substr(8);
  if (line.starts_with("@throws ")) return "- throws " + line.substr(8);
  return {};
}

std::string without_indentation(const std::string& line) {
  const auto first = line.find_first_not_of(' ');
  return first == std::string::npos ? "" : line.substr(first);
}

bool is_heading(const std::string& line) {
  const auto space = line.find(' ', heading.size()), colon = line.find(": ", heading.size());
  return line.starts_with(heading) && colon != std::string::npos && space < colon;
}

/// "9.1 pack: a state becomes thirteen numbers"
ContractPart part_of(const std::string& line) {
  const std::string text = line.substr(heading.size());
  const auto space = text.find(' '), colon = text.find(": ");
  return {text.substr(0, space), text.substr(space + 1, colon - space - 1), text.substr(colon + 2),
          "", ""};
}

/// The contract's lines, sorted into what they say.
class Reader {
 public:
  Contract read(const Page& page) {
    for (const std::string& line : page.lines) add(line);
    end_part();
    const auto title_ends = std::find(about_file_.begin(), about_file_.end(), "");
    about_file_.erase(about_file_.begin(), title_ends);
    contract_.introduction = markdown_of_comment(about_file_);
    return contract_;
  }

 private:
  void add(const std::string& line) {
    if (is_heading(line)) {
      end_part();
      contract_.parts.push_back(part_of(line));
    } else if (in_file_comment_) {
      in_file_comment_ = line.starts_with(comment);
      if (in_file_comment_) about_file_.push_back(uncommented(line));
    } else if (line == "/// @file") {
      in_file_comment_ = true;
    } else if (!contract_.parts.empty() && line.starts_with(comment) && code_.empty()) {
      task_.push_back(uncommented(line));
    } else if (!line.starts_with("#") && !line.starts_with("namespace ") &&
               !line.starts_with("}  // namespace")) {
      if (!line.empty() || !code_.empty()) code_ += line + "\n";
    }
  }

  void end_part() {
    while (code_.ends_with("\n\n")) code_.pop_back();
    if (contract_.parts.empty()) {
      contract_.types = code_;
    } else {
      contract_.parts.back().task = markdown_of_comment(task_);
      contract_.parts.back().code = code_;
    }
    task_.clear();
    code_.clear();
  }

  Contract contract_;
  std::vector<std::string> about_file_, task_;
  std::string code_;
  bool in_file_comment_ = false;
};

}  // namespace

std::string markdown_of_comment(const std::vector<std::string>& lines) {
  std::string text;
  bool in_items = false, in_code = false, in_list = false;
  for (const std::string& line : lines) {
    const bool code = line.starts_with("    ") && !in_items;
    if (code != in_code && !line.empty()) {
      text += code ? "\n```cpp\n" : "```\n\n";
      in_code = code;
    }
    const std::string item = item_of(line);
    if (!item.empty() && !in_items && !text.ends_with("\n\n")) text += "\n";
    if (!item.empty() && !in_items && in_list) text += "What it takes and gives:\n\n";
    in_list = line.starts_with("- ") || (in_list && (line.empty() || line.starts_with("  ")));
    in_items = in_items || !item.empty();
    const std::string plain = code ? line.substr(4) : without_indentation(line);
    if (in_code && line.empty()) continue;
    if (!item.empty())
      text += item + "\n";
    else
      text += (in_items && !plain.empty() ? "  " : "") + plain + "\n";
  }
  return text + (in_code ? "```\n" : "");
}

std::vector<Hint> hints_of(const fs::path& file, const std::string& number) {
  constexpr std::size_t mark = 3;  // "1. ", and the indentation of what follows
  std::vector<Hint> hints;
  bool inside = false;
  for (const std::string& line : read_page(file).lines) {
    if (line.starts_with("## ")) inside = line.starts_with("## " + number + " ");
    if (!inside || line.size() < mark) continue;
    if (line.starts_with(std::to_string(hints.size() + 1) + ". ")) hints.emplace_back();
    if (!hints.empty()) hints.back().push_back(line.substr(mark));
  }
  return hints;
}

std::string as_sentence(std::string title) {
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title + (title.ends_with("?") ? "" : ".");
}

Contract read_contract(const fs::path& file) { return Reader().read(read_page(file)); }

}  // namespace tumble::book
