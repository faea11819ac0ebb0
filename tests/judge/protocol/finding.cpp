#include "judge/protocol/finding.hpp"

namespace tumble::judge {

std::string name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::passed:
      return "passed";
    case Outcome::wrong:
      return "wrong";
    case Outcome::not_implemented:
      return "not implemented";
    case Outcome::threw:
      return "threw";
    case Outcome::crashed:
      return "crashed";
    case Outcome::hung:
      return "hung";
    case Outcome::out_of_memory:
      return "out of memory";
    case Outcome::flooded:
      return "flooded";
    case Outcome::exited:
      return "exited";
    case Outcome::forbidden:
      return "forbidden";
    case Outcome::wrong_call:
      return "wrong call";
    case Outcome::malformed:
      return "malformed";
    case Outcome::not_run:
      return "not run";
  }
  return "unknown";
}

}  // namespace tumble::judge
