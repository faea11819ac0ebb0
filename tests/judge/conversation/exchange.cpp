#include "judge/conversation/exchange.hpp"

#include "judge/conversation/endings.hpp"
#include "judge/protocol/convert.hpp"

namespace tumble::judge {

namespace {

constexpr int most_hung_cases = 2;  // each costs seconds

NoAnswer malformed(const std::string& why) { return {Outcome::malformed, why}; }

std::string first_text(const List& content) {
  const std::string* text = content.empty() ? nullptr : content[0].as<std::string>();
  return text ? *text : std::string();
}

}  // namespace

std::string frame_of(const Message& message) {
  const std::string body = encode(message);
  return frame_head(body.size()) + body;
}

std::optional<Message> take_message(std::string& received) {
  if (received.size() < 4) return std::nullopt;
  const std::size_t size = frame_size(reinterpret_cast<const unsigned char*>(received.data()));
  if (received.size() < 4 + size) return std::nullopt;
  Message message = decode(received.substr(4, size));
  received.erase(0, 4 + size);
  return message;
}

std::string Exchange::question(const List& arguments) {
  if (hung_cases_ >= most_hung_cases)
    throw NoAnswer(Outcome::not_run, "two cases before this one had no answer in time");
  token_ = static_cast<std::int64_t>(tokens_() >> 1);
  return frame_of({Kind::question, token_, arguments});
}

std::optional<std::string> Exchange::result_for(const Message& message, const CallBack& call_back) {
  if (message.token != token_) throw malformed("a message that belongs to no question");
  if (message.kind != Kind::call_back) return std::nullopt;
  const FunctionId* function =
      message.content.size() == 2 ? message.content[0].as<FunctionId>() : nullptr;
  if (!function) throw malformed("a call of no function");
  return frame_of({Kind::result, token_, {call_back(*function, list_of(message.content[1]))}});
}

Value Exchange::answer_of(const Message& message) const {
  switch (message.kind) {
    case Kind::answer:
      if (message.content.size() == 1) return message.content[0];
      throw malformed("an answer is one value");
    case Kind::not_implemented:
      throw NoAnswer(Outcome::not_implemented, "");
    case Kind::threw:
      throw threw(first_text(message.content));
    case Kind::out_of_memory:
      throw too_much_memory(memory_bytes_);
    default:
      throw malformed("a message that no worker sends");
  }
}

void Exchange::rethrow() {
  try {
    throw;
  } catch (const BadMessage& why) {
    throw malformed(why.what());
  } catch (const Malformed& why) {
    throw malformed(why.what());
  } catch (const NoAnswer& why) {
    if (why.outcome == Outcome::hung) ++hung_cases_;
    throw;
  }
}

}  // namespace tumble::judge
