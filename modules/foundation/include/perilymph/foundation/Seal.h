// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The seal of a file with results: a hash of its content, written into it by the program. It detects
// a change by hand or by a damaged disk; it does not prove who wrote the file.

#include <map>
#include <string>
#include <string_view>

#include "perilymph/foundation/Sha256.h"

namespace perilymph {

/// What the seal says of a file's content.
enum class Seal {
  intact,   ///< It is as the program wrote it.
  absent,   ///< The file is of a version that wrote no seal.
  changed,  ///< It was changed after the program wrote it: it has no number of its own.
};

/// "intact", "absent" or "changed", in JSON and Python.
const char* nameOf(Seal seal) noexcept;

/// A sentence about a file whose seal is absent or broken; empty for an intact one.
std::string noteOn(Seal seal);

/// Key of the seal in every kind of file.
inline constexpr const char* sealKey = "content_sha256";

/// Facts about a file, by their keys.
using SealedFacts = std::map<std::string, std::string>;

/// Seal of a table: its facts except the seal itself, and the hash of its rows in order.
std::string sealOver(const SealedFacts& facts, const Sha256& rows);

/// The state of a table whose facts have, or lack, a seal.
///
/// @param hasToHave  Whether the file's format has a seal.
Seal sealIn(const SealedFacts& facts, const Sha256& rows, bool hasToHave);

/// The value of `sealKey` in a JSON text that is not sealed yet.
std::string sealToBe();

/// A JSON text with its seal: the hash of the text that has sealToBe() in the seal's place.
std::string sealed(std::string json);

/// The state of a JSON text, byte by byte.
///
/// @param hasToHave  Whether its format has a seal.
Seal sealIn(std::string_view json, bool hasToHave);

}  // namespace perilymph
