// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What can be said of a surface's file before VTK reads it: its header, and text where it is text.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// An STL in text without the names of its solids, which may be in any script; empty for one that is
/// no text beside them, or without facets. VTK takes a file with such a name for a binary one.
std::optional<std::string> namelessStl(const std::string& content);

/// A number with a decimal comma behind a place of a text; empty if there is none.
std::optional<std::string> commaNumber(const std::string& content, std::size_t from = 0);

/// A list of an element of a PLY file.
struct PlyList {
  std::string name;
  std::size_t countBytes = 0, itemBytes = 0;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<std::string> names;  ///< Names of its numbers.
  std::size_t numberBytes = 0;     ///< All its numbers together.
  bool isInteger = true;           ///< All of its numbers and lists are.
  std::vector<PlyList> lists;
};

struct PlyHeader {
  bool isText = false;
  std::vector<PlyElement> elements;
  std::size_t end = 0;  ///< First byte behind the header.

  const PlyElement* find(const std::string& name) const;
};

/// The header of a PLY file; empty if it is incomplete or no PLY header.
std::optional<PlyHeader> plyHeader(const std::string& content);

/// Points and faces that a surface may have, a hundred times what a cochlea needs.
inline constexpr std::size_t maxPlyElements = 5'000'000;

/// Refuses headers without points (x, y, z) or faces of corners, with more than maxPlyElements of an
/// element, and text that is not one line of numbers per element. Without a subject.
Result<void> checkPly(const PlyHeader& header, const std::string& content);

/// Bytes behind the header of a binary file by its counts, if it has so many corners of faces in all;
/// empty where lists other than the faces' corners vary.
std::optional<std::size_t> plyDataBytes(const PlyHeader& header, std::size_t corners);

}  // namespace perilymph::imaging
