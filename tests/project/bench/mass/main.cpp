// Speed against error of mass properties: every method, ours and others', on the same meshes in
// one run. The methods take turns (random interleaving), so that ratios hold on a busy machine.
#include <iostream>
#include <map>

#include "project/bench/least_times.hpp"
#include "project/bench/mass/case.hpp"
#include "project/bench/mass/reading.hpp"
#include "support/command_line.hpp"
#include "support/plot.hpp"
#include "support/table.hpp"
#include "support/text_file.hpp"
#include "tumble/simd/instruction_set.hpp"

namespace tumble::bench {
namespace {

using support::Table;

struct Options {
  int triangles = 1'000'000;
  int repetitions = 7;
  double seconds = 0.05;  ///< of each repetition, at least
  bool with_peers = true;
  std::string svg;
};

/// A method on a body, and what came out.
struct Result {
  const Method* method;
  const Body* body;
  Answer answer;
  Run run = {};  ///< none if the method refuses the body
  double seconds = std::numeric_limits<double>::infinity();  ///< the least of all repetitions
};

double relative(const Mat3& I, const Mat3& truth) { return (I - truth).norm() / truth.norm(); }

double mass_error(const Result& r) { return std::abs(r.answer.mass / r.body->truth.mass - 1); }

/// In diagonals of the box.
double centre_error(const Result& r) {
  using T = simd::DoubleDouble;
  const Vector3<T> found = r.answer.centre.cast<T>() + r.answer.centre_rest.cast<T>();
  return detail::to_double(found - r.body->centre).norm() / r.body->diagonal;
}

double inertia_error(const Result& r) { return relative(r.answer.inertia, r.body->truth.inertia); }

std::string error_text(double error) {
  return std::isnan(error) ? "-" : support::error_number(error);
}

/// Everything that is to be measured, each computed once. What a method refuses has no numbers.
std::vector<Result> prepare(const std::vector<Method>& methods, const std::vector<Body>& bodies) {
  std::vector<Result> results;
  for (const Body& body : bodies)
    for (const Method& method : methods) {
      if (method.slow && body.mesh.face_count() > 100'000) continue;
      std::cerr << "tumble: " << body.name << ": " << method.name << '\n';
      Result result{&method, &body, {}};
      try {
        const Run run = method.prepare(body);
        result.answer = run();
        result.run = run;
      } catch (const std::invalid_argument& refusal) {
        std::cerr << "tumble: refused: " << refusal.what() << '\n';
      }
      results.push_back(result);
    }
  return results;
}

/// Notes the least time of each.
void measure(std::vector<Result>& results, const Options& options) {
  std::vector<Timed> all;
  for (const Result& result : results) {
    const auto mass = [&result] { return result.run().mass; };
    all.push_back({result.run ? mass : std::function<double()>(), options.repetitions,
                   options.seconds, result.method->clock});
  }
  const std::vector<double> seconds = least_times(all);
  for (std::size_t i = 0; i < results.size(); ++i) results[i].seconds = seconds[i];
}

/// A table for one body: time and ratio to the plain loop, and errors.
Table table_for(const Body& body, const std::vector<Result>& results) {
  double plain = 1;
  for (const Result& r : results)
    if (r.body == &body && r.method->name == "plain loop") plain = r.seconds;
  Table table({"method", "ns per triangle", "× plain loop", "mass error", "centre error",
               "inertia error", "its bound"});
  for (const Result& r : results) {
    if (r.body != &body) continue;
    const double triangles = static_cast<double>(body.mesh.corners.size()) / 3;
    const bool refused = std::isinf(r.seconds);
    table.add({r.method->name,
               refused ? "refused" : support::number(r.seconds * 1e9 / triangles, 3),
               refused ? "-" : support::number(r.seconds / plain, 2), error_text(mass_error(r)),
               error_text(centre_error(r)), error_text(inertia_error(r)),
               error_text(r.answer.inertia_error_bound)});
  }
  return table;
}

/// Error of the inertia against time, on one body; what is exact is drawn at one rounding.
support::Plot figure(const Body& body, const std::vector<Result>& results) {
  support::Plot plot{body.name,
                     {"time [s]", support::Scale::log},
                     {"relative error of the inertia tensor", support::Scale::log},
                     {}};
  std::map<std::string, std::size_t> curves;
  for (const Result& r : results) {
    if (r.body != &body || !r.method->in_figure || std::isnan(inertia_error(r))) continue;
    const std::string& name = r.method->curve.empty() ? r.method->name : r.method->curve;
    if (!curves.count(name)) {
      curves[name] = plot.series.size();
      plot.series.push_back({name, {}, {}});
    }
    support::Series& series = plot.series[curves[name]];
    series.x.push_back(r.seconds);
    series.y.push_back(std::max(inertia_error(r), 0x1p-53));
  }
  return plot;
}

/// What the methods promise: where a bound is given, the error is below it.
void check_bounds(const std::vector<Result>& results) {
  for (const Result& r : results)
    for (const auto& [error, bound] : {std::pair{mass_error(r), r.answer.mass_error_bound},
                                       std::pair{inertia_error(r), r.answer.inertia_error_bound}})
      require(!(error > bound + 0x1p-53), r.method->name, " on ", r.body->name, " has an error of ",
              error, ", above its bound of ", bound);
}

const char* name_of(simd::InstructionSet set) {
  if (set == simd::InstructionSet::avx512) return "AVX-512";
  return set == simd::InstructionSet::avx2 ? "AVX2" : "what any processor has";
}

void run(const Options& options) {
  std::vector<Method> methods = own_methods();
  if (options.with_peers)
    for (const Method& peer : peers()) methods.push_back(peer);
  const std::vector<Body> all = bodies(options.triangles);
  std::vector<Result> results = prepare(methods, all);
  check_bounds(results);
  std::cerr << "tumble: measuring\n";
  measure(results, options);
  std::cout << "Processor time of the thread, of two threads that on the wall; least of "
            << options.repetitions << ". Methods of ours without a name of instructions use "
            << name_of(simd::best_instruction_set())
            << "; all else is compiled for any processor.\n\n";
  for (const Body& body : all)
    std::cout << body.name << " (" << body.mesh.corners.size() / 3 << " triangles)\n"
              << table_for(body, results).text() << '\n';
  std::cerr << "tumble: reading files\n";
  const Table reading =
      reading_table(options.triangles, options.repetitions, options.seconds, options.with_peers);
  std::cout << "reading mesh files\n" << reading.text() << '\n';
  if (!options.svg.empty())
    support::write_text(options.svg, support::to_svg(figure(all.front(), results)));
}

}  // namespace
}  // namespace tumble::bench

int main(int argc, char** argv) {
  using tumble::bench::Options;
  Options options;
  CLI::App app(
      "Mass properties: time per triangle and error of every method on the same meshes; and how "
      "long mesh files take to read.",
      "./tumble bench mass");
  app.add_option("--triangles", options.triangles, "of the torus, also of that in the files")
      ->check(CLI::Range(100, 100'000'000));
  app.add_option("--svg", options.svg, "draw error against time on the first body into this file");
  app.add_option("--repetitions", options.repetitions, "of each method; the least time counts")
      ->check(CLI::Range(1, 1000));
  bool quick = false, no_peers = false;
  app.add_flag("--quick", quick, "a small torus, each once: to see that everything works");
  app.add_flag("--no-peers", no_peers, "our own methods only");
  return tumble::support::run_command_line(app, argc, argv, [&] {
    if (quick) options = {20'000, 1, 0.001, true, options.svg};
    options.with_peers = !no_peers;
    tumble::bench::run(options);
    return tumble::support::exit_status::achieved;
  });
}
