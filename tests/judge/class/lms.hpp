#pragma once
/// @file
/// How learning platforms name what they let an instructor download.
///
/// Source: Moodle, mod/assign/locallib.php and feedback/file/importziplib.php; Canvas,
/// lib/content_zipper.rb; Gradescope, "Download Submissions".

#include <optional>
#include <string>

namespace tumble::judge {

enum class Lms { none, moodle, canvas, gradescope };

/// The names, for messages.
inline constexpr const char* lms_names = "moodle, canvas, gradescope, folders";

/// "moodle" and so on; "folders" is none of them.
/// @throws std::invalid_argument if there is no such platform
Lms lms_named(const std::string& name);
std::string name_of(Lms lms);

/// What an entry of a download says about itself.
struct LmsEntry {
  std::string name;        ///< the student's
  std::string id;          ///< the platform's number for the student
  std::string file;        ///< the name that the student gave it; empty for a folder
  std::string attachment;  ///< Canvas's number for the file
  bool late = false;       ///< marked as late
  bool is_text = false;    ///< what was typed into the platform itself
  std::string kind = {};   ///< Moodle's name for it, if it is not the work: "comments"

  /// "Ann Meyer_4711": two students of one name have two numbers.
  std::string key() const { return name + "_" + id; }
};

/// "Ann Meyer_4711_assignsubmission_file_": a folder, or with more behind it a file. Instead of
/// "file" any of Moodle's plugins may be there: "onlinetext", "comments".
std::optional<LmsEntry> moodle_entry(const std::string& name);

/// "doejane_12345_67890_product-1.cpp", "doejane_LATE_12345_67890_product.cpp",
/// "anon_aB3xY_67890_product.cpp", "doejane_12345_text.html".
std::optional<LmsEntry> canvas_entry(const std::string& name);

}  // namespace tumble::judge
