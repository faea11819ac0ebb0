/// @file
/// Editors in a site: what is copied, what is named, what is missing.
#include <doctest/doctest.h>

#include <string>

#include "book/tool/editors.hpp"
#include "book/tool/html.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/temporary_folder.hpp"

using namespace tumble::book;
using tumble::test::mentions;
using tumble::test::TemporaryFolder;

namespace {

const std::string box =
    "<div class=\"now-write\" id=\"now-write-4.1\"> <p><b>Now write 4.1: "
    "<code>product</code>.</b></p></div>"
    "<div class=\"now-write\" id=\"now-write-10.2\"> <p><b>Now write 10.2: "
    "<code>free</code>.</b></p></div>";

/// A site with a page that has boxes, and what is to be put into it.
class Site : public TemporaryFolder {
 public:
  Site() {
    write("site/index.html", "<body>Front</body>");
    write("site/chapters-04.html", "<body>" + box + "</body>");
    write("site/print.html", "<body>" + box + "</body>");
    write("site/terms.html", "<body>Terms</body>");
    for (const char* name :
         {"manifest.json", "units.json", "exercise.mjs", "exercise.css", "client.mjs",
          "service_worker.js", "codemirror/codemirror.js", "codemirror/codemirror.css",
          "codemirror/clike.js", "codemirror/matchbrackets.js", "codemirror/closebrackets.js"})
      write(std::string("made/") + name, name);
  }

  std::string text(const std::string& name) const { return text_of(path() / "site" / name); }
  void add() const { add_editors(path() / "site", path() / "made"); }
};

}  // namespace

TEST_CASE("editors: pages with a box and the front page have the script, others do not") {
  const Site site;
  site.add();
  const std::string script =
      "<script class=\"editors\">if (location.protocol !== \"file:\") "
      "import(\"./exercises/exercise.mjs\");</script>";
  for (const char* page : {"index.html", "chapters-04.html"})
    CHECK(mentions(site.text(page), script + "\n</body>"));
  for (const char* page : {"print.html", "terms.html"})
    CHECK(site.text(page).find("script") == std::string::npos);
}

TEST_CASE("editors: a list says which page each exercise is on") {
  const Site site;
  site.add();
  CHECK(site.text("exercises/pages.json") ==
        "{\n  \"10.2\": \"chapters-04.html\",\n  \"4.1\": \"chapters-04.html\"\n}\n");
}

TEST_CASE("editors: the service worker is at the root of the site, all else in its folder") {
  const Site site;
  site.add();
  CHECK(site.text("service_worker.js") == "service_worker.js");
  CHECK(site.text("exercises/codemirror/clike.js") == "codemirror/clike.js");
  CHECK_FALSE(fs::exists(site.path() / "site/exercises/service_worker.js"));
}

TEST_CASE("editors: twice is as once, and what was there before is gone") {
  const Site site;
  site.add();
  const std::string page = site.text("chapters-04.html"), list = site.text("exercises/pages.json");
  site.write("site/exercises/old.mjs", "old");
  site.add();
  CHECK(site.text("chapters-04.html") == page);
  CHECK(site.text("exercises/pages.json") == list);
  CHECK_FALSE(fs::exists(site.path() / "site/exercises/old.mjs"));
}

TEST_CASE("editors: what is missing is said, and nothing is changed") {
  const Site site;
  const std::string page = site.text("chapters-04.html");
  fs::remove(site.path() / "made/units.json");
  fs::remove(site.path() / "made/codemirror/clike.js");
  const std::string said = tumble::test::message_of([&] { site.add(); });
  CHECK(mentions(said, "made is not complete: it has no units.json, codemirror/clike.js"));
  CHECK(site.text("chapters-04.html") == page);
  CHECK_FALSE(fs::exists(site.path() / "site/exercises"));
}
