#pragma once
/// @file
/// Submissions that come packed. An archive is a stranger's file like any other: it is read by a
/// process behind walls that can write nothing, and what leaves that process is text.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tumble::judge {

namespace fs = std::filesystem;

/// What is in a student's archive, or why it is not looked at. An archive in it is read too, its
/// files are under its name: homework.zip/product.cpp.
struct Unpacked {
  std::map<std::string, std::string> files;  ///< the source files, by their paths in it
  std::string refused;                       ///< empty if it was read
  std::vector<std::string> others = {};      ///< paths of files that are not source files
  std::vector<std::string> notes = {};       ///< which archives in it were not read, and why
};

/// Limits of what is unpacked at all.
inline constexpr std::size_t largest_archive = 32u << 20, largest_content = 256u << 20,
                             most_entries = 20'000;
/// The same of a download of a whole class, and how much of it is kept.
inline constexpr std::size_t largest_class = std::size_t{8} << 30, largest_class_kept = 512u << 20,
                             most_class_entries = 500'000;
/// File systems take 255 bytes for a name; beside a file its next version is written.
inline constexpr std::size_t longest_name = 250, longest_path = 2000;

struct Finished;

/// What is wrong with an archive whose reader has ended so; empty if nothing is.
/// @throws std::runtime_error if it is this machine that has failed: then the archive may be right
std::string why_not_read(const Finished& reader, const fs::path& archive);

/// The status with which the reader ends if it could not read from the disk.
inline constexpr int disk_failed = 3;

/// Reads an archive's source files; of several entries of one path the last, with a note. Refused
/// are archives with a path that leads out of them, a link or a device, a file and a folder of one
/// name, a path that is too long, more than 20,000 entries, 256 MB of content or 32 MB packed, or
/// that are damaged or encrypted.
/// @throws std::runtime_error if the judge itself is broken, or this machine: no memory, a disk
/// that
///         fails, too many open files
Unpacked unpack(const fs::path& archive);

/// An entry of a class's download that was not unpacked.
struct EntryLeftOut {
  std::string path, why;  ///< "Ann_1_assignsubmission_file_/product.cpp", "is encrypted"
  bool is_work = false;   ///< by its name a source file or an archive
};

/// Unpacks a platform's download of a class into a folder: source files and archives, and of all
/// else the names. Of what is left out, the folders are made, and a file of its name without a
/// content if it is somebody's work: so a student who has nothing else is known.
/// @throws std::invalid_argument if the archive cannot be read
std::vector<EntryLeftOut> unpack_class(const fs::path& archive, const fs::path& to);

}  // namespace tumble::judge
