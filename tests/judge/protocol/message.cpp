#include "judge/protocol/message.hpp"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace tumble::judge {

namespace {

using nlohmann::json;

// ── Writing: [kind, token, content], a function as {"function": number} ──

json to_json(const Value& value) {
  return std::visit(
      [](const auto& x) -> json {
        using T = std::decay_t<decltype(x)>;
        if constexpr (std::is_same_v<T, List>) {
          json array = json::array();
          for (const Value& element : x) array.push_back(to_json(element));
          return array;
        } else if constexpr (std::is_same_v<T, FunctionId>) {
          return json{{"function", x.number}};
        } else {
          return x;
        }
      },
      value.data);
}

// ── Reading: event by event, so that depth is limited before anything is nested ──

class ValueBuilder : public json::json_sax_t {
 public:
  bool null() override { return false; }
  bool boolean(bool) override { return false; }
  bool number_integer(number_integer_t n) override { return add(std::int64_t{n}); }
  bool number_unsigned(number_unsigned_t n) override { return add(static_cast<std::int64_t>(n)); }
  bool number_float(number_float_t x, const string_t&) override { return add(x); }
  bool string(string_t& text) override { return add(std::move(text)); }
  bool binary(binary_t&) override { return false; }
  bool start_array(std::size_t) override {
    if (open_.size() >= max_depth) return false;
    open_.emplace_back();
    return true;
  }
  bool end_array() override {
    List list = std::move(open_.back());
    open_.pop_back();
    return add(std::move(list));
  }
  bool start_object(std::size_t) override { return !std::exchange(in_object_, true); }
  bool key(string_t& name) override { return name == "function"; }
  bool end_object() override { return std::exchange(in_object_, false); }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override {
    return false;
  }

  Value root;

 private:
  bool add(Value value) {
    if (in_object_) {
      const std::int64_t* number = value.as<std::int64_t>();
      if (!number) return false;
      value = FunctionId{*number};
    }
    if (open_.empty())
      root = std::move(value);
    else
      open_.back().push_back(std::move(value));
    return true;
  }

  std::vector<List> open_;
  bool in_object_ = false;
};

}  // namespace

std::string encode(const Message& message) {
  const json j = {static_cast<std::int64_t>(message.kind), message.token, to_json(message.content)};
  std::string body;
  json::to_msgpack(j, body);
  return body;
}

Message decode(const std::string& body) {
  ValueBuilder builder;
  if (!json::sax_parse(body, &builder, json::input_format_t::msgpack))
    throw BadMessage("these bytes are not a message");
  const List* parts = builder.root.as<List>();
  if (!parts || parts->size() != 3) throw BadMessage("a message has three parts");
  const std::int64_t* kind = (*parts)[0].as<std::int64_t>();
  const std::int64_t* token = (*parts)[1].as<std::int64_t>();
  const List* content = (*parts)[2].as<List>();
  if (!kind || !token || !content) throw BadMessage("a message has a kind, a token and a list");
  if (*kind < 0 || *kind > static_cast<std::int64_t>(Kind::forbidden))
    throw BadMessage("there is no such kind of message");
  return {static_cast<Kind>(*kind), *token, *content};
}

std::string frame_head(std::size_t size) {
  if (size > max_frame) throw BadMessage("this message is too long");
  std::string head(4, '\0');
  for (std::size_t i = 0; i < 4; ++i) head[i] = static_cast<char>(size >> (8 * i) & 0xff);
  return head;
}

std::size_t frame_size(const unsigned char head[4]) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) size |= std::size_t{head[i]} << (8 * i);
  if (size > max_frame) throw BadMessage("a message of " + std::to_string(size) + " bytes");
  return size;
}

}  // namespace tumble::judge
