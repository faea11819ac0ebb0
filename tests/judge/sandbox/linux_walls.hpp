#pragma once
/// @file
/// TUMBLE_LINUX_WALLS: whether this is Linux, with its walls around a worker.

#if defined(__linux__) && !defined(TUMBLE_PORTABLE_WORKER)
#define TUMBLE_LINUX_WALLS 1
#else
#define TUMBLE_LINUX_WALLS 0
#endif
