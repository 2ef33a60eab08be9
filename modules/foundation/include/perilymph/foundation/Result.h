// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The result of an operation that can fail: a value, or an error with a message for the user.

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "perilymph/foundation/Sentence.h"

namespace perilymph {

/// Why an operation on a file, device or scan failed: one or two sentences that name the object,
/// the value with its unit, the allowed range and the remedy.
struct Error {
  template <std::size_t size>
  explicit Error(const char (&phrase)[size]) : message(phrase)
  {
  }
  template <class First, class... Others>
  Error(PhraseOf<std::type_identity_t<First>, std::type_identity_t<Others>...> phrase,
        const First& first, const Others&... others)
      : message(phrase, first, others...)
  {
  }
  explicit Error(Sentence sentence) : message(std::move(sentence)) {}
  template <std::same_as<std::string> Text>
  explicit Error(Text text) : message(std::move(text))
  {
  }

  Sentence message;
};

/// A value or an Error.
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

/// The result of an operation without a value: success, `{}`, or an Error.
template <>
class [[nodiscard]] Result<void> {
public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  explicit operator bool() const noexcept { return !error_; }

  const Error& error() const { return *error_; }

private:
  std::optional<Error> error_;
};

}  // namespace perilymph
