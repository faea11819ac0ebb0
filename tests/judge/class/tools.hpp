#pragma once
/// @file
/// Programs that grading calls. The build writes where they are: the only paths in its code.

namespace tumble::judge {

/// Reads archives, and writes zip files; empty if tumble was built without libarchive.
extern const char *const archive_reader, *const archive_writer;
/// CMake, which makes zip files too.
extern const char* const cmake_program;

}  // namespace tumble::judge
