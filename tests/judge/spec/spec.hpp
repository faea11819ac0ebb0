#pragma once
/// @file
/// All that a spec needs. TUMBLE_UNIT is the unit's path, as "04_quaternions/product": the build
/// defines it for each spec from its file name.

#include <doctest/doctest.h>

#include "judge/spec/demand.hpp"
#include "judge/spec/inputs.hpp"
#include "judge/spec/misconception.hpp"
#include "judge/spec/session.hpp"
#include "judge/spec/student.hpp"
