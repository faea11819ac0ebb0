#include "judge/class/statistics.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace tumble::judge {

namespace {

Counts sorted(const std::map<std::string, std::size_t>& counts) {
  Counts result(counts.begin(), counts.end());
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return result;
}

/// Counts one unit over a class.
class UnitCounter {
 public:
  explicit UnitCounter(const Unit& unit) { statistics_.unit = unit; }

  void add_unread() { ++statistics_.unread; }
  void add(const UnitRecord* record) {
    if (!record || (!record->passed && not_started(*record)))
      ++statistics_.not_started;
    else if (record->passed)
      add_passed(*record);
    else
      add_failed(*record);
  }

  UnitStatistics total() {
    statistics_.misconceptions = sorted(misconceptions_);
    statistics_.outcomes = sorted(outcomes_);
    statistics_.laws = sorted(laws_);
    if (statistics_.passed > 0)
      statistics_.mean_tries = tries_ / static_cast<double>(statistics_.passed);
    return statistics_;
  }

 private:
  void add_passed(const UnitRecord& record) {
    ++statistics_.passed;
    tries_ += record.tries;
  }
  void add_failed(const UnitRecord& record) {
    ++statistics_.failed;
    ++outcomes_[record.summary];
    std::set<std::string> misconceptions;  // each counts once a student
    for (const CaseRecord& each : record.cases) {
      if (!each.passed()) ++laws_[each.law];
      misconceptions.insert(each.misconceptions.begin(), each.misconceptions.end());
    }
    for (const std::string& misconception : misconceptions) ++misconceptions_[misconception];
  }

  UnitStatistics statistics_;
  std::map<std::string, std::size_t> misconceptions_, outcomes_, laws_;
  double tries_ = 0;
};

}  // namespace

bool not_started(const UnitRecord& record) {
  return record.source == 0 || record.summary == name_of(Outcome::not_implemented);
}

std::vector<UnitStatistics> statistics_of(const CourseSettings& settings,
                                          const std::vector<StudentRecord>& records) {
  std::vector<UnitStatistics> all;
  for (const Unit& unit : settings.units) {
    UnitCounter counter(unit);
    for (const StudentRecord& record : records)
      if (!record.refused.empty() || !record.incomplete.empty())
        counter.add_unread();
      else if (!record.absent)
        counter.add(record.find(unit));
    all.push_back(counter.total());
  }
  return all;
}

}  // namespace tumble::judge
