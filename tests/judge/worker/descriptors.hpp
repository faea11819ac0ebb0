#pragma once
/// @file
/// The open files of a worker. Text that the student prints goes to 1 and 2, one pipe; messages
/// have their own, so that std::cout << x for debugging harms nothing.

namespace tumble::judge {

inline constexpr int answers_descriptor = 3;    ///< worker → judge
inline constexpr int questions_descriptor = 4;  ///< judge → worker

}  // namespace tumble::judge
