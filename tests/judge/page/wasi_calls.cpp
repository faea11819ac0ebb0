#include "judge/page/wasi_calls.hpp"

#include <map>

namespace tumble::judge {

std::string purpose_of_wasi_call(const std::string& name) {
  static const std::map<std::string, std::string> purposes{
      {"path_open", "open a file"},
      {"path_create_directory", "make a folder"},
      {"path_unlink_file", "delete a file"},
      {"path_remove_directory", "delete a file"},
      {"path_filestat_get", "look for a file"},
      {"path_readlink", "look for a file"},
      {"path_rename", "rename a file"},
      {"fd_readdir", "look for a file"},
      {"sock_accept", "open a network connection"},
      {"sock_recv", "open a network connection"},
      {"sock_send", "open a network connection"},
      {"sock_shutdown", "open a network connection"},
      {"poll_oneoff", "sleep"},
      {"proc_raise", "send a signal to a process"},
      {"fd_close", "close a file that is not its own"},
      {"fd_renumber", "copy an open file"}};
  const auto known = purposes.find(name);
  return known != purposes.end() ? known->second : "ask the operating system";
}

}  // namespace tumble::judge
