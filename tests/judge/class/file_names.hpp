#pragma once
/// @file
/// Names that students give to files: which exercise is meant, and which of two comes later.

#include <filesystem>
#include <string>

namespace tumble::judge {

/// The exercise that a file's name means: "product" for product.cpp, Product.CPP, product (1).cpp,
/// product-1.cpp, product.cpp.txt, "product - Copy.cpp". Empty if it is not a source file.
std::string exercise_named(const std::string& file);

/// The order that people expect: v2 before v10, "a" before "a-1", without regard to case. Texts
/// that differ are never equal.
bool natural_less(const std::string& a, const std::string& b);

/// The same of paths: part by part, source files and archives without their endings.
bool natural_less(const std::filesystem::path& a, const std::filesystem::path& b);

/// A name for the file that is kept about a student: the student's, or where that is too long or
/// has what no file name should have, what is left of it and a number that follows from it.
std::string file_name_for(const std::string& student);

/// A name as a terminal may show it, on one line: "a\x1B[2J", "two\nlines".
std::string escaped(const std::string& name);

}  // namespace tumble::judge
