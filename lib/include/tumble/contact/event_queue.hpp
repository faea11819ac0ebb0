#pragma once
/// @file
/// What may happen next, in the order of time: events that are known, and searches for meetings
/// that have been left at the time up to which nothing happens. So a search goes no farther than
/// the next event, however long the run is, and finds what it would have found in one go.

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "tumble/collide/first_meeting.hpp"

namespace tumble::contact::detail {

/// Two bodies, or a body and a wall, that will meet; or a body that will have slid to its end.
struct ContactEvent {
  int body, other, wall;     ///< other is -1 for a wall, wall is -1 for a body; for an end both are
  int flight, other_flight;  ///< how many flights they had begun when this was predicted
  collide::Meeting meeting;

  double t() const { return meeting.t; }
  bool is_end_of_slide() const { return other < 0 && wall < 0; }
};

/// An event, or a search for one that is not over.
struct Awaited {
  ContactEvent event;
  collide::detail::SearchState search;

  /// Later ones have lower priority. At one time searches come first, as they may find an event
  /// then; of events, that of the smallest numbers.
  friend bool operator<(const Awaited& a, const Awaited& b) { return a.order() > b.order(); }

 private:
  std::tuple<double, bool, int, int, int> order() const {
    return {event.t(), search.is_over, event.body, event.other, event.wall};
  }
};

/// A heap. Now and then we throw out what is out of date.
class EventQueue {
 public:
  bool empty() const { return heap_.empty(); }
  /// The time of the first one [s].
  double t() const { return heap_.front().event.t(); }
  void clear() { heap_.clear(); }

  void push(Awaited awaited) {
    heap_.push_back(std::move(awaited));
    std::push_heap(heap_.begin(), heap_.end());
  }
  Awaited pop() {
    std::pop_heap(heap_.begin(), heap_.end());
    Awaited first = std::move(heap_.back());
    heap_.pop_back();
    return first;
  }

  /// Throws out what is out of date, if that may be more than the rest.
  template <class IsOld>
  void tidy(const IsOld& is_old) {
    if (heap_.size() <= most_) return;
    std::erase_if(heap_, [&](const Awaited& awaited) { return is_old(awaited.event); });
    std::make_heap(heap_.begin(), heap_.end());
    most_ = std::max<std::size_t>(64, 2 * heap_.size());
  }

 private:
  std::vector<Awaited> heap_;
  std::size_t most_ = 64;
};

}  // namespace tumble::contact::detail
