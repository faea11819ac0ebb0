#include "book/tool/exercises.hpp"

#include <sstream>

#include "book/tool/contract.hpp"
#include "book/tool/snippet.hpp"

namespace tumble::book {

namespace {

const std::string announcement = "<!-- exercise: ";

ContractPart part_of(const Page& page, const ExerciseBlock& block, const fs::path& contract) {
  for (const ContractPart& part : read_contract(contract).parts)
    if (part.number == block.number) return part;
  fail(page, block.comment, contract.string() + " has no exercise " + block.number);
}

/// The first of an exercise's hints, line by line.
std::vector<std::string> first_hint(const Page& page, const ExerciseBlock& block,
                                    const fs::path& file) {
  const std::vector<Hint> hints = hints_of(file, block.number);
  if (hints.empty()) fail(page, block.comment, file.string() + " has no hint to " + block.number);
  return hints.front();
}

/// The block, not quoted yet.
std::string block_text(const fs::path& root, const Page& page, const ExerciseBlock& block) {
  const fs::path contract = contract_of(root, page);
  const ContractPart part = part_of(page, block, contract);
  const std::string place = contract.lexically_relative(root).string();
  std::ostringstream text;
  text << "**Now write " << block.number << ": `" << part.name << "`.** " << as_sentence(part.title)
       << "\n\n<!-- signature: " << place << "#" << part.name << " -->\n```cpp\n"
       << signature(contract, part.name) << "```\n\n[The contract]("
       << contract.lexically_relative(page.file.parent_path()).string()
       << ") says exactly what it takes and gives. Ask the judge:\n\n```sh\n./tumble check "
       << block.number << "\n```\n\n<details><summary>A hint</summary>\n\n";
  for (const std::string& line : first_hint(page, block, contract.parent_path() / "hints.md"))
    text << line << "\n";
  text << "\n</details>\n";
  return text.str();
}

std::vector<std::string> wanted_lines(const fs::path& root, const Page& page,
                                      const ExerciseBlock& block) {
  std::istringstream text(block_text(root, page, block));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);)
    lines.push_back(line.empty() ? ">" : "> " + line);
  return lines;
}

bool is_fresh(const Page& page, const ExerciseBlock& block,
              const std::vector<std::string>& wanted) {
  const auto begin = page.lines.begin() + static_cast<std::ptrdiff_t>(block.comment) + 1;
  const auto end = page.lines.begin() + static_cast<std::ptrdiff_t>(block.end);
  return std::vector<std::string>(begin, end) == wanted;
}

}  // namespace

fs::path contract_of(const fs::path& root, const Page& page) {
  return root / "exercises" / page.file.parent_path().filename() / "contract.hpp";
}

std::vector<std::string> exercises_in(const fs::path& contract) {
  std::vector<std::string> numbers;
  for (const ContractPart& part : read_contract(contract).parts) numbers.push_back(part.number);
  return numbers;
}

std::string announced_exercise(const std::string& line) {
  if (!line.starts_with(announcement) || !line.ends_with(" -->")) return {};
  return line.substr(announcement.size(), line.size() - announcement.size() - 4);
}

std::vector<ExerciseBlock> exercise_blocks(const Page& page) {
  std::vector<ExerciseBlock> blocks;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    ExerciseBlock block;
    block.number = announced_exercise(page.lines[i]);
    if (block.number.empty()) continue;
    block.comment = i;
    for (block.end = i + 1; block.end < page.lines.size() && is_quoted(page.lines[block.end]);)
      ++block.end;
    blocks.push_back(block);
  }
  return blocks;
}

std::vector<std::string> stale_exercises(const fs::path& root, const Page& page) {
  std::vector<std::string> stale;
  for (const ExerciseBlock& block : exercise_blocks(page)) {
    try {
      if (!is_fresh(page, block, wanted_lines(root, page, block)))
        stale.push_back(
            at(page, block.comment) + "exercise " + block.number +
            " is not what contract and hints say; ./tumble book --write updates the page");
    } catch (const std::exception& error) {
      const std::string what = error.what();
      stale.push_back(what.starts_with(page.file.string()) ? what : at(page, block.comment) + what);
    }
  }
  return stale;
}

Page with_fresh_exercises(const fs::path& root, const Page& page) {
  Page result{page.file, {}};
  std::size_t next = 0;
  for (const ExerciseBlock& block : exercise_blocks(page)) {
    for (; next <= block.comment; ++next) result.lines.push_back(page.lines[next]);
    for (std::string& line : wanted_lines(root, page, block))
      result.lines.push_back(std::move(line));
    next = block.end;
  }
  for (; next < page.lines.size(); ++next) result.lines.push_back(page.lines[next]);
  return result;
}

}  // namespace tumble::book
