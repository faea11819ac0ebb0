#pragma once
/// @file
/// Where a JSON document cannot be read: the library's exceptions know that only of what is not
/// JSON.

#include <nlohmann/json.hpp>
#include <string>

namespace tumble::support {

/// Reads a document for nothing but its first fault: the last byte that was read, and the word that
/// could not be taken.
struct FirstFault final : nlohmann::json_sax<nlohmann::json> {
  using Json = nlohmann::json;
  std::size_t byte = 0;
  std::string token;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(Json::number_integer_t) override { return true; }
  bool number_unsigned(Json::number_unsigned_t) override { return true; }
  bool number_float(Json::number_float_t, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(Json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(std::string&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t at, const std::string& last, const Json::exception&) override {
    byte = at;
    token = last;
    return false;
  }
};

inline FirstFault first_fault(const std::string& text) {
  FirstFault fault;
  nlohmann::json::sax_parse(text, &fault);
  return fault;
}

}  // namespace tumble::support
