/// @file
/// doctest itself, without its main.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
