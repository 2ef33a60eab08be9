// SPDX-License-Identifier: BSD-3-Clause

// With libFuzzer: writes the target's seeds into the corpus folder of the command line, so that the
// search starts from valid inputs.

#include <filesystem>
#include <fstream>
#include <string>

#include "FuzzTarget.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerInitialize(int* count, char*** text);

int LLVMFuzzerInitialize(int* count, char*** text)
{
  for (int i = 1; i < *count; ++i) {
    const std::string word = (*text)[i];
    if (word.empty() || word.front() == '-') continue;
    const std::filesystem::path folder(word);
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const perilymph::fuzz::Bytes& seed : perilymph::fuzz::seeds()) {
      std::ofstream file(folder / ("seed-" + std::to_string(number++)), std::ios::binary);
      file.write(reinterpret_cast<const char*>(seed.data()),
                 static_cast<std::streamsize>(seed.size()));
    }
    break;
  }
  return 0;
}
