// The library's methods, and the two loops that every program has: what theirs are measured by.
#include <memory>

#include "project/bench/mass/case.hpp"
#include "tumble/mass/bounding_box.hpp"
#include "tumble/mass/column_mass_properties.hpp"
#include "tumble/mass/low_discrepancy_points.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/point_sampling.hpp"
#include "tumble/mass/random_points.hpp"
#include "tumble/mesh/mesh_solid.hpp"

namespace tumble::bench {
namespace {

/// Reading every vertex and every index once, corners and where each face has its own: what no
/// method can be faster than.
Answer read_once(const PolygonMesh& mesh) {
  double sum[3] = {};
  for (const Vec3& v : mesh.vertices)
    for (int k = 0; k < 3; ++k) sum[k] += v[k];
  std::int64_t indices = 0;
  for (const int v : mesh.corners) indices += v;
  for (const int first : mesh.first_corner) indices += first;
  Answer answer;  // NaN, but a compiler cannot know
  answer.centre *= sum[0] + sum[1] + sum[2] + static_cast<double>(indices);
  return answer;
}

/// One triangle after the other, ten sums in double.
Answer plain_loop(const PolygonMesh& mesh, const Vec3& p) {
  using Point = simd::Point<double>;
  Moments<double> sum;
  const auto from_p = [&](int v) -> Point {
    const Vec3& x = mesh.vertex(v);
    return {x.x() - p.x(), x.y() - p.y(), x.z() - p.z()};
  };
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    const Point a = from_p(mesh.corners[i]), b = from_p(mesh.corners[i + 1]),
                c = from_p(mesh.corners[i + 2]);
    sum += detail::raw_moments(simd::six_volume(a, b, c), a, b, c);
  }
  Moments<simd::DoubleDouble> all;
  return mass_properties(detail::with_factors(all += sum), p, 1);
}

template <class F>
Method on_mesh(const std::string& name, F compute) {
  return {name, [compute](const Body& body) -> Run {
            return [compute, &mesh = body.mesh] { return Answer(compute(mesh)); };
          }};
}

Method integrals(const std::string& name, Accuracy accuracy, const simd::LoopOptions& loop = {}) {
  return on_mesh(name, [=](const PolygonMesh& mesh) {
    return unchecked_mass_properties(mesh, 1, accuracy, loop);
  });
}

/// With everything that the door looks at.
Method diagnosed(const std::string& name, Accuracy accuracy) {
  return on_mesh(name, [=](const PolygonMesh& mesh) -> BoundedMassProperties {
    return mesh_mass_properties(mesh, 1, {.accuracy = accuracy});
  });
}

Method only_in_table(Method method) {
  method.in_figure = false;
  return method;
}

/// With two threads.
Method on_two_threads(const std::string& name, Accuracy accuracy) {
  Method method = only_in_table(integrals(name, accuracy, {.threads = 2}));
  method.clock = Clock::wall;
  return method;
}

/// The same with less than this processor has: what others will get.
void add_older_processors(std::vector<Method>& methods) {
  using simd::InstructionSet;
  const std::pair<const char*, InstructionSet> sets[] = {{"AVX2", InstructionSet::avx2},
                                                         {"baseline", InstructionSet::baseline}};
  for (const auto& [name, instructions] : sets) {
    if (instructions >= simd::best_instruction_set()) continue;
    for (const auto& [tier, accuracy] :
         {std::pair{"fast, ", Accuracy::fast}, std::pair{"tight, ", Accuracy::tight}})
      methods.push_back(only_in_table(
          integrals(std::string(tier) + name, accuracy, {.instructions = instructions})));
  }
}

/// @tparam Points RandomPoints or R3Points
template <class Points>
void add_sampling(std::vector<Method>& methods, const std::string& curve) {
  for (const int n : {1'000, 10'000, 100'000})
    methods.push_back({curve + ", " + std::to_string(n),
                       [n](const Body& body) -> Run {
                         const auto solid = std::make_shared<MeshSolid>(body.mesh);
                         return [n, solid]() -> Answer {
                           return MassProperties(
                               sampling::sample_mass_properties(*solid, 1, Points(n)));
                         };
                       },
                       true, curve});
}

void add_columns(std::vector<Method>& methods) {
  for (const int n : {1'000, 10'000, 100'000})
    methods.push_back({"columns, " + std::to_string(n),
                       [n](const Body& body) -> Run {
                         return [n, &body]() -> Answer {
                           return MassProperties(sampling::column_mass_properties(body.mesh, 1, n));
                         };
                       },
                       true, "columns"});
}

}  // namespace

std::vector<Method> own_methods() {
  std::vector<Method> methods = {only_in_table(on_mesh("read once", read_once)),
                                 on_mesh("plain loop",
                                         [](const PolygonMesh& mesh) {
                                           return plain_loop(mesh, detail::reference_point(mesh));
                                         }),
                                 only_in_table(on_mesh("plain loop about the origin",
                                                       [](const PolygonMesh& mesh) {
                                                         return plain_loop(mesh, Vec3(0, 0, 0));
                                                       })),
                                 integrals("fast", Accuracy::fast),
                                 on_two_threads("fast, 2 threads", Accuracy::fast),
                                 integrals("tight", Accuracy::tight),
                                 on_two_threads("tight, 2 threads", Accuracy::tight),
                                 integrals("textbook (Mirtich)", Accuracy::textbook),
                                 only_in_table(diagnosed("fast, diagnosed", Accuracy::fast)),
                                 diagnosed("tight, diagnosed", Accuracy::tight),
                                 {"box of the true mass", [](const Body& body) -> Run {
                                    return [&body]() -> Answer {
                                      return boxes::box_mass_properties(
                                          boxes::aligned_box(body.mesh.vertices), body.truth.mass);
                                    };
                                  }}};
  add_older_processors(methods);
  add_sampling<sampling::RandomPoints>(methods, "random points");
  add_sampling<sampling::R3Points>(methods, "R3 points");
  add_columns(methods);
  return methods;
}

}  // namespace tumble::bench
