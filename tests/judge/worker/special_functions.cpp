// What a student's file only declares: see special_functions.hpp.
#include "judge/build/special_functions.hpp"

TUMBLE_SPECIAL_FUNCTIONS(template, float)
TUMBLE_SPECIAL_FUNCTIONS(template, long double)
