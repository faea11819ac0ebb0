#pragma once
/// @file
/// DOP853, the 8(5,3) triple of Hairer, Nørsett and Wanner on twelve stages of Dormand and Prince.
///
/// Two embedded results, of order 5 and 3, give one error estimate that falls as h⁸:
///
///     ‖e‖ = ‖e₅‖² / √(‖e₅‖² + 0.01 ‖e₃‖²)
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// II.5 and II.10, eqs. 10.17 to 10.19; coefficients as in Hairer's program dop853.

#include "tumble/ode/embedded_runge_kutta.hpp"

namespace tumble {

/// @addtogroup ode
/// @{

namespace detail {

/// The coefficients.
struct Dop853Tableau {
  static constexpr std::size_t stages = 12;
  static constexpr int order = 8;
  static constexpr int error_order = 7;
  static constexpr bool error_needs_end = false;

  // clang-format off
  static constexpr runge_kutta::Weights<12> c = {
      0, 0.0526001519587677318785587544488L, 0.0789002279381515978178381316732L,
      0.11835034190722739672675719751L, 0.28164965809277260327324280249L, 1.L / 3, 0.25L,
      4.L / 13, 0.651282051282051282051282051282L, 0.6L, 6.L / 7, 1};
  static constexpr std::array<runge_kutta::Weights<12>, 12> a = {{
      {},
      {0.0526001519587677318785587544488L},
      {0.0197250569845378994544595329183L, 0.0591751709536136983633785987549L},
      {0.0295875854768068491816892993775L, 0, 0.0887627564304205475450678981324L},
      {0.241365134159266685502369798665L, 0, -0.884549479328286085344864962717L,
       0.924834003261792003115737966543L},
      {0.037037037037037037037037037037L, 0, 0, 0.170828608729473871279604482173L,
       0.125467687566822425016691814123L},
      {0.037109375L, 0, 0, 0.170252211019544039314978060272L, 0.0602165389804559606850219397283L,
       -0.017578125L},
      {0.0370920001185047927108779319836L, 0, 0, 0.170383925712239993810214054705L,
       0.107262030446373284651809199168L, -0.0153194377486244017527936158236L,
       0.00827378916381402288758473766002L},
      {0.624110958716075717114429577812L, 0, 0, -3.36089262944694129406857109825L,
       -0.868219346841726006818189891453L, 27.5920996994467083049415600797L,
       20.1540675504778934086186788979L, -43.4898841810699588477366255144L},
      {0.477662536438264365890433908527L, 0, 0, -2.48811461997166764192642586468L,
       -0.590290826836842996371446475743L, 21.2300514481811942347288949897L,
       15.2792336328824235832596922938L, -33.2882109689848629194453265587L,
       -0.0203312017085086261358222928593L},
      {-0.93714243008598732571704021658L, 0, 0, 5.18637242884406370830023853209L,
       1.09143734899672957818500254654L, -8.14978701074692612513997267357L,
       -18.5200656599969598641566180701L, 22.7394870993505042818970056734L,
       2.49360555267965238987089396762L, -3.0467644718982195003823669022L},
      {2.27331014751653820792359768449L, 0, 0, -10.5344954667372501984066689879L,
       -2.00087205822486249909675718444L, -17.9589318631187989172765950534L,
       27.9488845294199600508499808837L, -2.85899827713502369474065508674L,
       -8.87285693353062954433549289258L, 12.3605671757943030647266201528L,
       0.643392746015763530355970484046L}}};
  static constexpr runge_kutta::Weights<12> b = {
      0.0542937341165687622380535766363L, 0, 0, 0, 0, 4.45031289275240888144113950566L,
      1.89151789931450038304281599044L, -5.8012039600105847814672114227L,
      0.31116436695781989440891606237L, -0.152160949662516078556178806805L,
      0.201365400804030348374776537501L, 0.0447106157277725905176885569043L};

  /// b less the weights of the embedded result of order 5.
  struct ErrorWeights5 {
    static constexpr runge_kutta::Weights<12> weights = {
        0.01312004499419488073250102996L, 0, 0, 0, 0, -1.225156446376204440720569753L,
        -0.4957589496572501915214079952L, 1.664377182454986536961530415L,
        -0.350328848749973681688648729L, 0.3341791187130174790297318841L,
        0.08192320648511571246570742613L, -0.02235530786388629525884427845L};
  };
  // clang-format on

  /// b less the weights of the embedded result of order 3, which needs three stages.
  struct ErrorWeights3 {
    static constexpr runge_kutta::Weights<12> weights = [] {
      runge_kutta::Weights<12> e = b;
      e[0] -= 0.244094488188976377952755905512L;
      e[8] -= 0.733846688281611857341361741547L;
      e[11] -= 0.0220588235294117647058823529412L;
      return e;
    }();
  };

  /// Both estimates in one, so weighted that it falls as h⁸.
  template <OdeState State, class Tolerance>
  static ScalarOf<State> error(ScalarOf<State> h, const std::array<State, 13>& k, const State& y0,
                               const State& y1, const Tolerance& tolerances) {
    using runge_kutta::error_norm;
    using std::sqrt;
    using Scalar = ScalarOf<State>;
    const Scalar e5 = error_norm(weighted_difference<ErrorWeights5>(h, k), y0, y1, tolerances);
    const Scalar e3 = error_norm(weighted_difference<ErrorWeights3>(h, k), y0, y1, tolerances);
    if (e5 == 0) return Scalar(0);
    return e5 * (e5 / sqrt(e5 * e5 + Scalar(0.01) * e3 * e3));
  }
};

}  // namespace detail

/// The method for tight tolerances, 1e-7 to 1e-13, of problems that are not stiff.
using Dop853 = runge_kutta::EmbeddedRungeKutta<detail::Dop853Tableau>;

/// @}

}  // namespace tumble
