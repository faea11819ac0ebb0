#pragma once
/// @file
/// What all programs behind ./tumble have in common: how they read their command line, how they
/// report what went wrong, and their exit statuses.

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "support/nearest.hpp"
#include "support/printable.hpp"

namespace tumble::support {

/// What ./tumble --help promises. Ctrl-C gives 130.
namespace exit_status {
inline constexpr int achieved = 0;      ///< what the command is for
inline constexpr int not_achieved = 1;  ///< something did not pass
inline constexpr int broken = 2;        ///< wrong usage, a missing file, a full disk
}  // namespace exit_status

/// Says what went wrong.
inline int failed(const std::string& what) {
  std::cout.flush();
  std::cerr << "tumble: " << printable(what) << "\n";
  return exit_status::broken;
}

/// Looks whether everything that was printed has arrived: a full disk is found out here at last.
/// @return the status, or `broken`
inline int finished(int status) {
  if (std::cout.flush()) return status;
  std::cerr << "tumble: the output could not be written: is the disk full?\n";
  return exit_status::broken;
}

/// The command that was given, or the program itself.
inline const CLI::App& given_command(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  return given.empty() ? app : *given.front();
}

/// "./tumble check"
inline std::string usage_name(const CLI::App& app) {
  const CLI::App& command = given_command(app);
  return app.get_name() + (&command == &app ? "" : " " + command.get_name());
}

/// "--seed", "--json", …
inline std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

inline std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// About an argument that nothing takes.
inline std::string unexpected(const CLI::App& app, const std::string& argument) {
  const CLI::App& command = given_command(app);
  const std::string name = argument.substr(0, argument.find('='));
  if (argument.starts_with("-"))
    return "there is no option '" + name + "'" + did_you_mean(name, option_names(command));
  if (&command == &app && !command_names(app).empty())
    return "there is no command '" + name + "'" + did_you_mean(name, command_names(app));
  return "'" + argument + "' is one argument too many";
}

/// What CLI11 says of values, in plain words: "--about: at least 3 values are expected, not 1".
inline std::string in_plain_words(std::string said) {
  const auto replace = [&](const std::string& words, const std::string& by) {
    const std::size_t at = said.find(words);
    if (at != std::string::npos) said.replace(at, words.size(), by);
    return at != std::string::npos;
  };
  if (replace("Could not convert: ", "") && replace(" = ", ": '"))
    return said + "' is not a number";
  if (replace(": At least ", ": at least ") || replace(": At Most ", ": at most "))
    replace(" required but received ", " values are expected, not ");
  const std::size_t none = said.find(": 1 required ");
  return none == std::string::npos ? said : said.substr(0, none) + ": a value is missing";
}

inline std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining(true);
  const bool no_command = &given_command(app) == &app && !command_names(app).empty();
  const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  return !rest.empty() && (extra || no_command) ? unexpected(app, rest.front())
                                                : in_plain_words(error.what());
}

/// A file larger than `ulimit -f` allows is then a write that fails, as on a full disk, and not the
/// end of the program. By a handler: programs that we start would inherit that it is ignored.
inline void let_long_files_fail() {
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, [](int) {});
#endif
}

/// Reads the command line, runs, and reports what went wrong.
/// @param app is named as users call it, "./tumble tour": nobody sees another program's path
/// @return the exit status for main
inline int run_command_line(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  let_long_files_fail();
  try {
    app.parse(argc, argv);
    return finished(run());
  } catch (const CLI::Success& help) {
    return finished(app.exit(help));
  } catch (const CLI::ParseError& error) {
    return failed(complaint(app, error) + "\ntumble: see " + usage_name(app) + " --help");
  } catch (const std::filesystem::filesystem_error& error) {
    return failed(error.path1().string() + ": " + error.code().message());
  } catch (const std::exception& error) {
    return failed(error.what());
  }
}

}  // namespace tumble::support
