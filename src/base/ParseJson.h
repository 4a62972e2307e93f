#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/Result.h"

namespace gt {

/// Greatest depth of nesting. JSON that is nested more deeply is refused, because its values are
/// copied, written and destroyed recursively.
constexpr std::size_t deepestJson = 100;
/// Greatest number of members of an object. Objects with more are refused, because each key is
/// compared with all before it.
constexpr std::size_t mostJsonMembers = 1000;

namespace detail {

/// Builds a value of nlohmann's library from the parser's events without recursion, and stops the
/// parser at the first error.
template <typename Json>
class JsonBuilder : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(typename Json::number_integer_t value) override { return add(value); }
  bool number_unsigned(typename Json::number_unsigned_t value) override { return add(value); }
  bool number_float(typename Json::number_float_t value,
                    const typename Json::string_t& /*text*/) override {
    return add(value);
  }
  bool string(typename Json::string_t& text) override { return add(std::move(text)); }
  bool binary(typename Json::binary_t& /*bytes*/) override { return false; }  // not in text

  bool start_object(std::size_t /*members*/) override { return open(Json::object()); }
  bool key(typename Json::string_t& name) override {
    if (open_.back()->size() >= mostJsonMembers)
      return fail({}, "has an object of more than " + std::to_string(mostJsonMembers) + " members");
    name_ = std::move(name);
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t /*elements*/) override { return open(Json::array()); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& fault) override {
    if (dynamic_cast<const typename Json::out_of_range*>(&fault))
      return fail({}, "holds a number that is too large");
    return fail(std::to_string(position), "is no JSON");
  }

  Json take() { return std::move(root_); }
  const Error& error() const { return error_; }

 private:
  template <typename T>
  Json& put(T&& value) {
    if (open_.empty()) return root_ = std::forward<T>(value);
    Json& parent = *open_.back();
    if (parent.is_object()) return parent[name_] = std::forward<T>(value);
    parent.push_back(std::forward<T>(value));
    return parent.back();
  }
  template <typename T>
  bool add(T&& value) {
    put(Json(std::forward<T>(value)));
    return true;
  }
  bool open(Json container) {
    if (open_.size() >= deepestJson)
      return fail({}, "is nested too deeply, at most " + std::to_string(deepestJson) + " levels");
    open_.push_back(&put(std::move(container)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  bool fail(std::string field, std::string what) {
    error_ = {.field = std::move(field), .what = std::move(what)};
    return false;
  }

  Json root_;
  std::vector<Json*> open_;  ///< The open containers from the outermost to the innermost; values
                             ///< are added to the innermost only.
  typename Json::string_t name_;
  Error error_;
};

}  // namespace detail

/// Parses text as JSON. All JSON that a program reads is parsed here. The field of an error is the
/// offset in the text.
template <typename Json>
Result<Json> parseJsonAs(std::string_view text, const std::string& sourceName) {
  detail::JsonBuilder<Json> builder;
  if (Json::sax_parse(text, &builder)) return builder.take();
  Error error = builder.error();
  error.file = sourceName;
  return error;
}

}  // namespace gt
