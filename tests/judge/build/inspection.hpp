#pragma once
/// @file
/// What a source file must not contain, looked for in what the compiler made of it: macros, raw
/// strings and spellings cannot hide anything there.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace tumble::judge {

/// The files of a Makefile rule, as compilers write them with -MD.
std::vector<std::filesystem::path> dependencies_of(const std::filesystem::path& rule);

/// The headers that an exercise may see: those of the precompiled header (Eigen/Core and parts of
/// the standard library), the contracts, and every other header of the standard library.
class AllowedHeaders {
 public:
  /// @param precompiled_rule the dependencies of the precompiled header
  /// @param contracts        contract.hpp of every chapter, and what they include
  /// @throws std::runtime_error if the rule names nothing: then everything would be forbidden
  AllowedHeaders(const std::filesystem::path& precompiled_rule,
                 const std::vector<std::filesystem::path>& contracts);
  bool contains(const std::filesystem::path& header) const;

 private:
  std::set<std::filesystem::path> files_, folders_;
  std::vector<std::filesystem::path> trees_;
};

/// The line number (of the assembly) of the first piece that the source wrote in assembler, or that
/// would make the assembler read another file; 0 if there is none.
std::size_t line_with_assembler(const std::filesystem::path& assembly);

}  // namespace tumble::judge
