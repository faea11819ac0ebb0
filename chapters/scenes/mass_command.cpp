#include <algorithm>
#include <iostream>

#include "scenes/commands.hpp"
#include "scenes/inertial_blocks.hpp"
#include "scenes/mass_output.hpp"
#include "scenes/mesh_files.hpp"
#include "support/command_line.hpp"
#include "support/printable.hpp"

namespace tumble::scenes {
namespace {

/// What was found goes with the numbers: the file is read by people who have not seen our messages.
void print_block(const MassAnswer& found, const MassCommand& command) {
  if (!found.findings.empty())
    for (const std::string& sentence : sentences(found)) std::cout << comment(sentence);
  std::cout << inertial_block(command.block, found.body);
}

void print_all(const std::vector<MassAnswer>& all, const MassCommand& command) {
  if (command.json) {
    Json list = Json::array();
    for (const MassAnswer& found : all) list.push_back(answer_json(found, command));
    std::cout << json_text(all.size() == 1 ? list[0] : list) << '\n';
  } else if (!command.block.empty()) {
    for (const MassAnswer& found : all) {
      for (const std::string& sentence : sentences(found)) std::cerr << sentence << '\n';
      if (all.size() > 1) std::cout << comment(support::escaped(found.file));
      if (found.usable) print_block(found, command);
    }
  } else if (all.size() > 1) {
    print_table(all);
  } else {
    print(all[0], command);
  }
}

/// @throws std::invalid_argument if something is asked that has a meaning for one file only
void require_one_if_needed(const std::vector<std::string>& files, const MassCommand& command) {
  if (files.size() == 1) return;
  require(!command.mass, "--mass is what one body weighs, and there are ", files.size(),
          " files: ask about one after the other");
  require(command.about.empty() || command.json, "--about: the table of ", files.size(),
          " files has no room for it: ask for --json, or about one file");
}

/// Notes which files' numbers no block can have.
void require_blocks(std::vector<MassAnswer>& all) {
  for (MassAnswer& found : all)
    if (found.usable && !(found.no_block = block_defect(found.body)).empty()) found.usable = false;
}

/// Says why a file has no numbers.
/// @return the exit status for it
int complain(const MassAnswer& found, const MassCommand& command) {
  if (!found.refusal.empty()) return support::failed(found.refusal);
  std::cerr << "tumble: " << support::escaped(found.file);
  if (!found.no_block.empty()) {
    std::cerr << ": " << found.no_block << ". We print no --" << command.block << " block\n";
    return support::exit_status::not_achieved;
  }
  std::cerr << (command.is_shell() ? ": faces of this shell count twice."
                                   : ": this is not the boundary of a body.")
            << " You find the reasons above."
            << (command.accept ? "" : " With --accept we compute what we can.") << '\n';
  return support::exit_status::not_achieved;
}

}  // namespace

int run(const MassCommand& command) {
  require_meaning(command);
  const std::vector<std::string> files = mesh_files(command.files);
  require_one_if_needed(files, command);
  std::vector<MassAnswer> all;
  all.reserve(files.size());
  for (const std::string& file : files)
    all.push_back(files.size() == 1 ? mass_answer(command, file)
                                    : answer_or_refusal(command, file));
  if (!command.block.empty()) require_blocks(all);
  print_all(all, command);
  int status = support::exit_status::achieved;
  for (const MassAnswer& found : all)
    if (!found.usable) status = std::max(status, complain(found, command));
  return status;
}

}  // namespace tumble::scenes
