// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Interface of a fuzz target. The entry point has libFuzzer's name, so that libFuzzer and
// FuzzLoop.cpp can drive it.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

/// Runs one input. Ends the program where an assertion fails.
// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace perilymph::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// Valid inputs to start from.
std::vector<Bytes> seeds();

/// Ends the program with a message unless the condition holds.
inline void promise(bool isKept, const char* what)
{
  if (isKept) return;
  std::fprintf(stderr, "Broken promise: %s\n", what);
  std::abort();
}

/// Reads values from the front of an input; zeros at its end.
class InputReader {
public:
  explicit InputReader(std::span<const std::uint8_t> input) : rest_(input) {}

  std::uint8_t byte()
  {
    if (rest_.empty()) return 0;
    const std::uint8_t first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }
  std::span<const std::uint8_t> bytes(std::size_t count)
  {
    const auto taken = rest_.first(count < rest_.size() ? count : rest_.size());
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  bool isEmpty() const { return rest_.empty(); }

private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace perilymph::fuzz
