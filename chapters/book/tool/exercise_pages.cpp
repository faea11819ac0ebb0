#include "book/tool/exercise_pages.hpp"

#include <algorithm>
#include <sstream>

#include "book/tool/addresses.hpp"
#include "book/tool/boxes.hpp"
#include "book/tool/contract.hpp"
#include "book/tool/exercises.hpp"
#include "book/tool/fences.hpp"
#include "book/tool/html.hpp"
#include "book/tool/links.hpp"

namespace tumble::book {

namespace {

/// The heading of the chapter's page under which an exercise is announced; empty if none is.
std::string section_of(const Page& chapter, const std::string& number) {
  std::string section;
  const std::vector<Fence> fences = fences_of(chapter);
  for (std::size_t i = 0; i < chapter.lines.size(); ++i) {
    if (const Heading heading = heading_in(chapter.lines[i]);
        heading.level > 1 && !is_inside(fences, i))
      section = heading.text;
    if (announced_exercise(chapter.lines[i]) == number) return section;
  }
  return {};
}

/// Hints within hints: if you unfold one, you see that there is another, and not what it says.
std::string hints_text(const std::vector<Hint>& hints) {
  static const std::vector<std::string> names{"Hint 1: a nudge", "Hint 2: an idea",
                                              "Hint 3: almost the code"};
  std::string text, ends;
  for (std::size_t i = 0; i < hints.size(); ++i) {
    text += "<details><summary>" + names.at(std::min(i, names.size() - 1)) + "</summary>\n\n";
    for (const std::string& line : hints[i]) text += line + "\n";
    text += "\n";
    ends += "</details>\n\n";
  }
  return text + ends;
}

/// Links to what belongs to the exercise, as far as it is there.
std::string places_text(const fs::path& root, const fs::path& folder, const Page* chapter,
                        const ContractPart& part) {
  const std::string name = folder.filename().string();
  std::string text = "Your file is `exercises/" + name + "/" + part.name + ".cpp`.";
  if (const std::string section = chapter ? section_of(*chapter, part.number) : "";
      !section.empty())
    text += " In the chapter, " +
            link_html(address_of(root, chapter->file) + "#" + box_id(part.number),
                      "Now write " + part.number) +
            " is in the section [" + section + "](../../chapters/" + name + "/README.md#" +
            anchor_of(section) + (section.ends_with('?') ? ")" : ").");
  const auto add = [&](const std::string& tree, const std::string& before) {
    if (fs::exists(root / tree / name / (part.name + ".cpp")))
      text += before + "](../../" + tree + "/" + name + "#" + part.name + "cpp).";
  };
  add("tests", " What is checked is in [its specification");
  add("solutions", " Once yours passes, compare it with [a solution");
  return text + "\n\n";
}

}  // namespace

Page exercise_page(const fs::path& root, const fs::path& folder) {
  const Contract contract = read_contract(folder / "contract.hpp");
  const fs::path chapter_file = root / "chapters" / folder.filename() / "README.md";
  Page chapter;
  if (fs::exists(chapter_file)) chapter = read_page(chapter_file);
  std::ostringstream text;
  text << "# Exercises: "
       << (chapter.lines.empty() ? folder.filename().string() : heading_in(chapter.lines[0]).text)
       << "\n\n";
  if (!chapter.lines.empty())
    text << "You write these functions in [chapter " << heading_in(chapter.lines[0]).text
         << "](../../chapters/" << folder.filename().string() << "/README.md).\n";
  text << contract.introduction << "\n";
  if (!contract.types.empty())
    text << "## What is given\n\n```cpp\n" << contract.types << "```\n\n";
  for (const ContractPart& part : contract.parts) {
    text << html_block("<a id=\"" + exercise_anchor(root, folder, part.number) + "\"></a>") << "\n"
         << "## " << part.number << " " << part.name << "\n\n"
         << "**" << as_sentence(part.title) << "**" << (part.task.starts_with("- ") ? "\n\n" : " ")
         << part.task << "\n```cpp\n"
         << part.code << "```\n\n```sh\n./tumble check " << part.number << "\n```\n\n"
         << hints_text(hints_of(folder / "hints.md", part.number))
         << places_text(root, folder, chapter.lines.empty() ? nullptr : &chapter, part);
  }
  return page_of(folder / "README.md", text.str());
}

}  // namespace tumble::book
