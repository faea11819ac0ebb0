/// @file
/// Topic "die": see figure_die.hpp.
#include "judge/page/student/figure_die.hpp"

int main() { return tumble::judge::figure::serve_figure(tumble::judge::figure::die); }
