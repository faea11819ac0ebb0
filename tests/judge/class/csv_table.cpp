#include "judge/class/csv_table.hpp"

#include <algorithm>

#include "judge/build/utf16.hpp"
#include "judge/class/file_kinds.hpp"
#include "judge/class/file_names.hpp"
#include "support/csv.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What separates the fields of the first line, where it is not quoted.
char separator_of(const std::string& text) {
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == ',' || c == ';' || c == '\t')) return c;
    if (!quoted && c == '\n') break;
  }
  return ',';
}

class CsvReader {
 public:
  CsvReader(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name)) {}

  std::vector<std::vector<std::string>> read() {
    const char separator = separator_of(text_);
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '\n') ++line_;
      if (quoted_)
        take_quoted(i);
      else if (c == '"' && field_.empty())
        open_quote();
      else if (c == separator)
        end_field();
      else if (c == '\n')
        end_row();
      else if (c != '\r')
        field_ += c;
    }
    require(!quoted_, name_, ", line ", opened_, ": a quote is not closed");
    end_row();
    return std::move(rows_);
  }

 private:
  void open_quote() {
    quoted_ = true;
    opened_ = line_;
  }
  void take_quoted(std::size_t& i) {
    if (text_[i] != '"')
      field_ += text_[i];
    else if (i + 1 < text_.size() && text_[i + 1] == '"')
      field_ += text_[i++];
    else
      quoted_ = false;
  }
  void end_field() {
    row_.push_back(std::move(field_));
    field_.clear();
  }
  void end_row() {
    end_field();
    if (row_.size() > 1 || !row_.front().empty()) rows_.push_back(std::move(row_));
    row_.clear();
  }

  std::string text_, name_, field_;
  std::vector<std::string> row_;
  std::vector<std::vector<std::string>> rows_;
  std::size_t line_ = 1, opened_ = 1;
  bool quoted_ = false;
};

}  // namespace

std::optional<std::size_t> CsvTable::column(const std::vector<std::string>& names) const {
  for (const std::string& name : names)
    for (std::size_t i = 0; i < header.size(); ++i)
      if (lower_case(header[i]) == name) return i;
  return std::nullopt;
}

std::string CsvTable::text() const {
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i == 0 ? "" : ",") + support::csv_field(row[i]);
    text += '\n';
  };
  add(header);
  for (const auto& row : rows) add(row);
  return text;
}

CsvTable read_csv(const std::string& bytes, const std::string& name) {
  std::string text = utf8_of_utf16(bytes).value_or(bytes);
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  std::vector<std::vector<std::string>> rows = CsvReader(std::move(text), name).read();
  require(!rows.empty(), name, " is empty");
  CsvTable table;
  table.header = std::move(rows.front());
  rows.erase(rows.begin());
  for (auto& row : rows) {
    require(row.size() <= table.header.size(), name, ": the row of ", escaped(row.front()), " has ",
            row.size(), " fields, the header has ", table.header.size());
    row.resize(table.header.size());
  }
  table.rows = std::move(rows);
  return table;
}

std::string without_formula(const std::string& text) {
  const bool is_formula =
      text.size() > 1 && std::string("=+-@\t\r").find(text[0]) != std::string::npos;
  return is_formula ? "'" + text : text;
}

std::string foreign_field(const std::string& text) {
  return support::csv_field(without_formula(text));
}

}  // namespace tumble::judge
