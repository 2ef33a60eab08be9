// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where inputs to start from lie: among the files that are shipped, and in the kept corpus.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "FuzzTarget.h"

namespace perilymph::fuzz {

inline Bytes contentOf(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

/// Adds every file of a folder and of the folders below that has the ending, in their order.
inline void addFiles(const std::filesystem::path& folder, const std::string& ending,
                     std::vector<Bytes>& seeds)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && (ending.empty() || entry.path().extension() == ending))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) seeds.push_back(contentOf(file));
}

/// Adds what is kept for a target in test/fuzz/corpus: small inputs that test/fuzz/make-corpus
/// wrote, and inputs that once broke something.
inline void addCorpus(const std::string& target, std::vector<Bytes>& seeds)
{
  const std::filesystem::path folder = std::filesystem::path(PERILYMPH_FUZZ_CORPUS) / target;
  promise(std::filesystem::is_directory(folder), "the kept corpus is there");
  addFiles(folder, "", seeds);
}

}  // namespace perilymph::fuzz
