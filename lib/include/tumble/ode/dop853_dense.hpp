#pragma once
/// @file
/// Where DOP853 is between the ends of a step: a polynomial of order 7, of which three more
/// evaluations of f tell what the twelve stages do not.
///
///     y(t + θ h) = r₀ + θ (r₁ + θ' (r₂ + θ (r₃ + θ' (r₄ + θ (r₅ + θ' (r₆ + θ r₇)))))),  θ' = 1 − θ
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// II.6, "Continuous Formulas of Order 7"; coefficients as in Hairer's program dop853 (contd8).

#include <array>

#include "tumble/ode/dop853.hpp"

namespace tumble::detail {

/// The coefficients. The thirteenth stage is f at the end of the step.
struct Dop853DenseTableau {
  static constexpr std::array<long double, 3> c = {0.1L, 0.2L, 7.L / 9};

  // clang-format off
  struct Stage14 {
    static constexpr runge_kutta::Weights<13> weights = {
        5.61675022830479523392909219681e-2L, 0, 0, 0, 0, 0, 2.53500210216624811088794765333e-1L,
        -2.46239037470802489917441475441e-1L, -1.24191423263816360469010140626e-1L,
        1.5329179827876569731206322685e-1L, 8.20105229563468988491666602057e-3L,
        7.56789766054569976138603589584e-3L, -8.298e-3L};
  };
  struct Stage15 {
    static constexpr runge_kutta::Weights<14> weights = {
        3.18346481635021405060768473261e-2L, 0, 0, 0, 0, 2.83009096723667755288322961402e-2L,
        5.35419883074385676223797384372e-2L, -5.49237485713909884646569340306e-2L, 0, 0,
        -1.08347328697249322858509316994e-4L, 3.82571090835658412954920192323e-4L,
        -3.40465008687404560802977114492e-4L, 1.41312443674632500278074618366e-1L};
  };
  struct Stage16 {
    static constexpr runge_kutta::Weights<15> weights = {
        -4.28896301583791923408573538692e-1L, 0, 0, 0, 0, -4.69762141536116384314449447206L,
        7.68342119606259904184240953878L, 4.06898981839711007970213554331L,
        3.56727187455281109270669543021e-1L, 0, 0, 0, -1.39902416515901462129418009734e-3L,
        2.9475147891527723389556272149L, -9.15095847217987001081870187138L};
  };
  struct R4 {
    static constexpr runge_kutta::Weights<16> weights = {
        -8.4289382761090128651353491142L, 0, 0, 0, 0, 0.56671495351937776962531783590L,
        -3.0689499459498916912797304727L, 2.3846676565120698287728149680L,
        2.1170345824450282767155149946L, -0.87139158377797299206789907490L,
        2.2404374302607882758541771650L, 0.63157877876946881815570249290L,
        -0.88990336451333310820698117400e-1L, 18.148505520854727256656404962L,
        -9.1946323924783554000451984436L, -4.4360363875948939664310572000L};
  };
  struct R5 {
    static constexpr runge_kutta::Weights<16> weights = {
        10.427508642579134603413151009L, 0, 0, 0, 0, 242.28349177525818288430175319L,
        165.20045171727028198505394887L, -374.54675472269020279518312152L,
        -22.113666853125306036270938578L, 7.7334326684722638389603898808L,
        -30.674084731089398182061213626L, -9.3321305264302278729567221706L,
        15.697238121770843886131091075L, -31.139403219565177677282850411L,
        -9.3529243588444783865713862664L, 35.816841486394083752465898540L};
  };
  struct R6 {
    static constexpr runge_kutta::Weights<16> weights = {
        19.985053242002433820987653617L, 0, 0, 0, 0, -387.03730874935176555105901742L,
        -189.17813819516756882830838328L, 527.80815920542364900561016686L,
        -11.573902539959630126141871134L, 6.8812326946963000169666922661L,
        -1.0006050966910838403183860980L, 0.77771377980534432092869265740L,
        -2.7782057523535084065932004339L, -60.196695231264120758267380846L,
        84.320405506677161018159903784L, 11.992291136182789328035130030L};
  };
  struct R7 {
    static constexpr runge_kutta::Weights<16> weights = {
        -25.693933462703749003312586129L, 0, 0, 0, 0, -154.18974869023643374053993627L,
        -231.52937917604549567536039109L, 357.63911791061412378285349910L,
        93.405324183624310003907691704L, -37.458323136451633156875139351L,
        104.09964950896230045147246184L, 29.840293426660503123344363579L,
        -43.533456590011143754432175058L, 96.324553959188282948394950600L,
        -39.177261675615439165231486172L, -149.72683625798562581422125276L};
  };
  // clang-format on
};

/// One step, to be gone into as often as one likes.
template <OdeState State>
class Dop853Dense {
 public:
  using Scalar = ScalarOf<State>;

  /// @param stages of the step from y0 at t to y1 at t + h, the last one f(t + h, y1)
  template <OdeRhs<State> F>
  Dop853Dense(F&& f, Scalar t, const State& y0, const State& y1, Scalar h,
              const std::array<State, 13>& stages) {
    using Tableau = Dop853DenseTableau;
    std::array<State, 16> k;
    std::copy(stages.begin(), stages.end(), k.begin());
    const auto time = [&](int i) {
      return t + static_cast<Scalar>(Tableau::c[std::size_t(i)]) * h;
    };
    k[13] = f(time(0), advance<Tableau::Stage14, 13>(y0, h, k));
    k[14] = f(time(1), advance<Tableau::Stage15, 14>(y0, h, k));
    k[15] = f(time(2), advance<Tableau::Stage16, 15>(y0, h, k));
    r_[0] = y0;
    r_[1] = y1 - y0;
    r_[2] = h * k[0] - r_[1];
    r_[3] = r_[1] - h * k[12] - r_[2];
    r_[4] = weighted_difference<Tableau::R4>(h, k);
    r_[5] = weighted_difference<Tableau::R5>(h, k);
    r_[6] = weighted_difference<Tableau::R6>(h, k);
    r_[7] = weighted_difference<Tableau::R7>(h, k);
  }

  /// y after the part θ of the step, 0 … 1.
  State at(Scalar theta) const {
    const Scalar rest = 1 - theta;
    State y = r_[7];
    for (std::size_t i = 7; i-- > 0;) y = State(r_[i] + (i % 2 == 0 ? theta : rest) * y);
    return y;
  }

  /// dy/dθ there.
  State slope(Scalar theta) const {
    const Scalar rest = 1 - theta;
    State y = r_[7], dy = State::Zero(y.size());
    for (std::size_t i = 7; i-- > 0;) {
      const bool even = i % 2 == 0;
      dy = State((even ? theta : rest) * dy + (even ? 1 : -1) * y);
      y = State(r_[i] + (even ? theta : rest) * y);
    }
    return dy;
  }

 private:
  std::array<State, 8> r_;
};

}  // namespace tumble::detail
