#include <iostream>

#include "scenes/commands.hpp"
#include "scenes/inertial_blocks.hpp"
#include "scenes/mass_output.hpp"

namespace tumble::scenes {
namespace {

void print_all(const std::vector<MassAnswer>& all, const MassCommand& command) {
  if (command.json) {
    Json list = Json::array();
    for (const MassAnswer& found : all) list.push_back(answer_json(found, command));
    std::cout << (all.size() == 1 ? list[0] : list).dump(2) << '\n';
  } else if (!command.block.empty()) {
    for (const MassAnswer& found : all) {
      if (all.size() > 1) std::cout << "<!-- " << found.file << " -->\n";
      if (found.usable) std::cout << inertial_block(command.block, found.body);
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

}  // namespace

int run(const MassCommand& command) {
  const std::vector<std::string> files = mesh_files(command.files);
  require_one_if_needed(files, command);
  std::vector<MassAnswer> all;
  all.reserve(files.size());
  for (const std::string& file : files) all.push_back(mass_answer(command, file));
  print_all(all, command);
  int status = 0;
  for (const MassAnswer& found : all) {
    if (found.usable) continue;
    status = 1;
    if (!command.block.empty())
      for (const MeshDefect& finding : found.findings)
        std::cerr << name_of(finding.kind) << ": " << finding.message << '\n';
    std::cerr << "tumble: " << found.file
              << ": this is not the boundary of a body. You find the reasons above."
              << (command.accept ? "" : " With --accept we compute what we can.") << '\n';
  }
  return status;
}

}  // namespace tumble::scenes
