/// @file
/// A die that falls onto a table by a student's functions. It runs in the student's process, so
/// nothing that it says is believed but the numbers, and those are measured elsewhere.
#include "judge/mine/student/die_run.hpp"
#include "judge/worker/serve.hpp"

using namespace tumble::judge;

int main() {
  return serve_questions([](const List& question) {
    return to_value(mine::DieOnTable(from_value<mine::DieQuestion>(question.at(0))).run());
  });
}
