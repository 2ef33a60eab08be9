// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the script that the device guard receives from the program.

#include <algorithm>

#include "FuzzTarget.h"
#include "guard/GuardScript.h"

namespace perilymph::fuzz {

std::vector<Bytes> seeds()
{
  const std::uint8_t output[] = {0, 1, 2, 3}, feature[] = {5, 6};
  device::guard::Script script(50);
  promise(script.addNoForce({false, output}) && script.addSwitchOff({true, feature}),
          "a short script has room");
  const device::guard::Script empty;
  const auto bytes = script.bytes(), none = empty.bytes();
  return {Bytes(bytes.begin(), bytes.end()), Bytes(none.begin(), none.end())};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  using device::guard::Script;
  const std::span<const std::uint8_t> input(data, size);
  const std::size_t behind = Script::sizeBehind(input.first(std::min(size, Script::head)));
  fuzz::promise(behind <= Script::capacity, "the rest has a bounded size");
  Script script;
  if (!script.take(input)) return 0;
  fuzz::promise(script.lines() <= Script::maxLines, "a bounded number of reports");
  fuzz::promise(script.noForceLines() <= script.lines(), "reports of no force are reports");
  std::size_t total = Script::head;
  for (std::size_t i = 0; i < script.lines(); ++i) {
    const auto bytes = script.line(i).bytes;
    fuzz::promise(!bytes.empty(), "a report has bytes");
    fuzz::promise(bytes.data() >= script.bytes().data() &&
                      bytes.data() + bytes.size() <= script.bytes().data() + script.bytes().size(),
                  "a report lies in the script");
    total += 3 + bytes.size();
  }
  fuzz::promise(total <= size, "a script has its reports and nothing more");
  return 0;
}
