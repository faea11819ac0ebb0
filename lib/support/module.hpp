#pragma once
/// @file
/// Code that is loaded while a program runs: specs of the judge, peers of the benchmarks.

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace tumble::support {

/// A shared object, loaded once and never unloaded: what it has registered stays valid.
class Module {
 public:
  /// @throws std::runtime_error saying what the loader says
  explicit Module(const std::filesystem::path& file)
      : file_(file), handle_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) throw std::runtime_error(std::string("cannot load ") + dlerror());
  }

  /// The function or object of this name.
  /// @tparam T its type
  /// @throws std::runtime_error if the module has none
  template <class T>
  T& symbol(const char* name) const {
    void* address = dlsym(handle_, name);
    if (address == nullptr)
      throw std::runtime_error(file_.string() + " has no " + name + ": it is another module");
    return *reinterpret_cast<T*>(address);
  }

 private:
  std::filesystem::path file_;
  void* handle_;
};

}  // namespace tumble::support
