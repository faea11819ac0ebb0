// Every submission in tests/project/attacks/ gets the verdict that it deserves, and harms nobody.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <thread>

#include "expectations.hpp"

using namespace tumble::test;

namespace {

/// The judgements on many submissions, several at once.
std::vector<Judgement> judge_all(const std::vector<Submission>& submissions) {
  std::vector<Judgement> judgements(submissions.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < submissions.size();) judgements[i] = judge(submissions[i]);
  };
  std::vector<std::thread> threads;
  // More than there are cores: some wait for the judge's limits of time, which costs nothing.
  for (unsigned i = 0; i < std::thread::hardware_concurrency() + 2; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  return judgements;
}

/// A table for those who look at what the judge says: TUMBLE_ATTACKS_VERBOSE=1.
void show(const Submission& submission, const Judgement& judgement) {
  if (!std::getenv("TUMBLE_ATTACKS_VERBOSE")) return;
  const std::string summary =
      judgement.product.is_object() ? judgement.product.at("summary").get<std::string>() : "?";
  std::printf("%-40s %-26s %5.1f s\n", submission.name.c_str(), summary.c_str(), judgement.seconds);
}

void check(const Submission& submission, const Judgement& judgement) {
  CAPTURE(submission.name);
  CAPTURE(judgement.output.substr(0, 3000));
  show(submission, judgement);
  check_verdict(judgement, submission.verdicts, submission.laws);
  check_the_judge_stood(judgement, submission.text, passed(judgement.product), submission.laws);
}

/// Those that TUMBLE_ATTACKS names ("exit" for all with "exit" in their names), or all.
std::vector<Submission> chosen(std::vector<Submission> all) {
  const char* part = std::getenv("TUMBLE_ATTACKS");
  if (part)
    std::erase_if(all, [&](const Submission& s) { return s.name.find(part) == std::string::npos; });
  return all;
}

void check_folder(const fs::path& folder) {
  const std::vector<Submission> submissions = chosen(submissions_in(folder));
  const std::vector<Judgement> judgements = judge_all(submissions);
  for (std::size_t i = 0; i < submissions.size(); ++i) check(submissions[i], judgements[i]);
}

}  // namespace

TEST_CASE("attacks: each earns what it deserves, and nobody else suffers") {
  check_folder(root() / "tests/project/attacks");
}

TEST_CASE("attacks: what is odd but honest passes") {
  check_folder(root() / "tests/project/attacks/honest");
}
