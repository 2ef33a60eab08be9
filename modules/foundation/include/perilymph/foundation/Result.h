#pragma once

// What a call to the outside world gives: a value, or one sentence that says what to do.

#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace perilymph {

/// Why the world (a file, a device, a scan) did not give what was asked: one or two sentences
/// that name the thing, the value with its unit, what is allowed and what to do.
struct Error {
  std::string message;
};

/// The value of a call that has nothing to give but success.
struct Done {};

/// A value, or the Error that stands in its place.
template <class Value>
class [[nodiscard]] Result {
public:
  Result(Value value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const noexcept { return content_.index() == 0; }

  Value& operator*() & { return std::get<0>(content_); }
  const Value& operator*() const& { return std::get<0>(content_); }
  Value&& operator*() && { return std::get<0>(std::move(content_)); }
  Value* operator->() { return &std::get<0>(content_); }
  const Value* operator->() const { return &std::get<0>(content_); }

  const Error& error() const { return std::get<1>(content_); }

private:
  std::variant<Value, Error> content_;
};

}  // namespace perilymph
