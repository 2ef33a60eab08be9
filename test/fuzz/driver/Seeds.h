// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Seeds: shipped files and the stored corpus.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "FuzzTarget.h"
#include "perilymph/test/Places.h"

namespace perilymph::fuzz {

inline Bytes contentOf(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

/// Adds every file with the extension in a folder and its subfolders, in sorted order.
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

/// Adds the corpus of a target in test/fuzz/corpus: small inputs written by
/// test/fuzz/make_corpus.py and inputs that revealed errors.
inline void addCorpus(const std::string& target, std::vector<Bytes>& seeds)
{
  const std::filesystem::path folder = test::projectFolder() / "test" / "fuzz" / "corpus" / target;
  promise(std::filesystem::is_directory(folder), "the kept corpus is there");
  addFiles(folder, "", seeds);
}

/// The corpus of a target as its only seeds.
inline std::vector<Bytes> corpusOf(const std::string& target)
{
  std::vector<Bytes> seeds;
  addCorpus(target, seeds);
  return seeds;
}

}  // namespace perilymph::fuzz
