#include "judge/page/page_engine.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "judge/mine/questions.hpp"
#include "judge/page/page_worker.hpp"
#include "judge/protocol/convert.hpp"
#include "judge/protocol/finding.hpp"

namespace tumble::judge {

namespace {

mine::RunQuestion question_of(const std::vector<double>& numbers) {
  constexpr std::size_t count = 26;
  if (numbers.size() != count) throw std::invalid_argument("a motion is asked for by 26 numbers");
  mine::RunQuestion question;
  question.setting.mass = numbers[0];
  question.setting.inertia = Eigen::Map<const Eigen::Matrix3d>(&numbers[1]);
  question.start = Eigen::Map<const mine::Numbers>(&numbers[10]);
  question.duration = numbers[23];
  question.method = mine::Method::simulate;
  question.steps = static_cast<int>(numbers[24]);
  question.samples = static_cast<int>(numbers[25]);
  return question;
}

mine::RunAnswer asked(const mine::RunQuestion& question) {
  PageWorker worker;
  worker.start_case();
  Call call;
  call.arguments = List{to_value(mine::Topic::run), to_value(question)};
  const auto no_function = [](FunctionId, const List&) -> Value {
    throw Malformed("it called a function that it was not given");
  };
  const Value answer = worker.ask(call, no_function);
  try {
    return from_value<mine::RunAnswer>(answer);
  } catch (const Malformed& why) {
    throw NoAnswer(Outcome::malformed, why.what());
  }
}

}  // namespace

nlohmann::ordered_json motion_by_student(const nlohmann::json& question) {
  try {
    const mine::RunAnswer answer = asked(question_of(question));
    std::vector<double> states;
    for (const mine::Numbers& y : answer.states) {
      if (!y.allFinite()) throw NoAnswer(Outcome::wrong, "the state becomes no number");
      states.insert(states.end(), y.begin(), y.end());
    }
    return {{"states", states}};
  } catch (const NoAnswer& why) {
    return {{"outcome", name_of(why.outcome)}, {"detail", why.what()}};
  }
}

}  // namespace tumble::judge
