#include "judge/page/page_figure.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "judge/page/page_worker.hpp"
#include "judge/protocol/convert.hpp"
#include "judge/protocol/finding.hpp"

namespace tumble::judge {

namespace {

std::vector<double> numbers_of(const Value& answer) {
  std::vector<double> numbers;
  try {
    numbers = from_value<std::vector<double>>(answer);
  } catch (const Malformed& why) {
    throw NoAnswer(Outcome::malformed, why.what());
  }
  for (const double number : numbers)
    if (!std::isfinite(number)) throw NoAnswer(Outcome::wrong, "a number is not finite");
  return numbers;
}

std::vector<double> asked(const std::vector<double>& numbers) {
  PageWorker worker;
  worker.start_case();
  Call call;
  call.arguments = List{to_value(numbers)};
  const auto no_function = [](FunctionId, const List&) -> Value {
    throw Malformed("it called a function that it was not given");
  };
  return numbers_of(worker.ask(call, no_function));
}

}  // namespace

nlohmann::ordered_json answer_for_figure(const nlohmann::json& question) {
  try {
    return {{"numbers", asked(question.get<std::vector<double>>())}};
  } catch (const NoAnswer& why) {
    return {{"outcome", name_of(why.outcome)}, {"detail", why.what()}};
  }
}

}  // namespace tumble::judge
