/// @file
/// The first whole program of the book. It needs nothing else of the project, so that you can type
/// it in and run it: that is why it says once more what satellite.hpp says.

#include <cmath>
#include <cstdio>

void dydt(double, const double y[], double ydot[]) {
  const double GM = 3.986004418e14;  // of the Earth [m³/s²]
  const double distance = std::sqrt(y[0] * y[0] + y[1] * y[1]);
  const double pull = GM / (distance * distance * distance);
  ydot[0] = y[2];  // the rate of a position is a velocity …
  ydot[1] = y[3];
  ydot[2] = -pull * y[0];  // … and the rate of a velocity is F/m
  ydot[3] = -pull * y[1];
}

int main() {
  double y[4] = {7.0e6, 0, 0, 9242}, ydot[4];  // position [m], velocity [m/s]
  const int steps = 960;
  const double h = 16486. / steps;  // [s]
  for (int i = 0; i <= steps; ++i) {
    if (i % (steps / 8) == 0)
      std::printf("%6.0f s %8.0f km %8.0f km\n", i * h, y[0] / 1000, y[1] / 1000);
    dydt(i * h, y, ydot);
    for (int j = 0; j < 4; ++j) y[j] += h * ydot[j];
  }
}
