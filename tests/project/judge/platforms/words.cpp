/// @file
/// What packages say and are told: names of images and addresses, limits of time.
#include <doctest/doctest.h>

#include "judge/platforms/image_name.hpp"
#include "judge/platforms/platform.hpp"
#include "judge/platforms/slug.hpp"
#include "judge/platforms/time_limits.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble::judge;

TEST_CASE("image names: as registries take them") {
  for (const char* name :
       {"tumble-judge", "owner/tumble-judge", "ghcr.io/owner/tumble_judge:1.2", "a/b/c.d",
        "Registry.Example:5000/judge", "localhost/judge", "judge:V1", "your-account/tumble-judge"})
    CHECK_NOTHROW(require_image_name(name));
  for (const char* name : {"", "OWNER/", "owner//judge", "-judge", "judge-", "judge:", "a b",
                           "judge@latest", "owner/judge/", "jüdge", "a___b"})
    CHECK_REFUSED(require_image_name(name), "is not the name of an image");
  CHECK_REFUSED(require_image_name("OWNER/Tumble"), "did you mean owner/tumble?");
  CHECK_REFUSED(require_image_name(std::string(300, 'a')), "is not the name of an image");
}

TEST_CASE("limits: the deadline leaves room for what has begun") {
  CHECK(time_limits(600, 2400, {}).deadline == 600 - most_for_what_has_begun);
  CHECK(time_limits(600, 2400, 900).limit == 900);
  CHECK_REFUSED(time_limits(600, 2400, 2401), "the limit is 2401 s", "at most 2400 s");
  CHECK_REFUSED(time_limits(600, 2400, 60), "the limit is 60 s");
}

TEST_CASE("platforms: a name that is nearly one") {
  CHECK_NOTHROW(require_platform("gradescope"));
  CHECK_REFUSED(require_platform("gradscope"), "did you mean gradescope?");
  CHECK_REFUSED(require_platform("moodle"), "there are: gradescope, prairielearn");
}

TEST_CASE("slugs: lower case, digits and single hyphens") {
  CHECK(slug_of("Homework 1: particles") == "homework-1-particles");
  CHECK(slug_of("4.1 from_matrix") == "4-1-from-matrix");
  CHECK(slug_of("!") == "tumble");
  CHECK(slug_of(std::string(38, 'a') + " b").size() == 38);
}
