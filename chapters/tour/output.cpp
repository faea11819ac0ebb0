#include <fstream>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "support/terminal.hpp"
#include "support/text_file.hpp"
#include "tour/tour.hpp"

namespace tumble::tour {

Output::Output(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw std::runtime_error(folder_.string() + ": we can't make this folder: " + error.message());
}

void Output::write(const std::string& file, const std::string& content) {
  support::write_text(folder_ / file, content);
  files_.push_back(file);
}

void Output::show(const std::string& heading, const support::Table& table,
                  const std::string& file) {
  std::cout << '\n' << heading << "\n\n" << support::fitted(table) << std::flush;
  write(file + ".csv", table.csv());
}

void progress(const std::string& what) { std::cerr << "… " << what << '\n'; }

}  // namespace tumble::tour
