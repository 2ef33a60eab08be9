// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The seal of a file with results: a hash of its content, written into it by the program. It detects
// a change by hand or by a damaged disk; it does not prove who wrote the file.

#include <array>
#include <compare>
#include <map>
#include <string>
#include <string_view>

#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Sentence.h"
#include "perilymph/foundation/Sha256.h"

namespace perilymph {

/// State of a file's content by its seal.
enum class Seal {
  intact,   ///< It is as the program wrote it.
  absent,   ///< The file is of a version that wrote no seal.
  changed,  ///< It was changed after the program wrote it: it has no number of its own.
};

inline constexpr std::array seals{Choice<Seal>{Seal::intact, "intact"},
                                  Choice<Seal>{Seal::absent, "absent"},
                                  Choice<Seal>{Seal::changed, "changed"}};
/// "intact", "absent" or "changed", in JSON and Python.
constexpr const char* nameOf(Seal seal) { return nameIn(seals, seal); }

/// A sentence about a file whose seal is absent or broken; empty for an intact one.
Sentence noteOn(Seal seal);

/// Release of the program.
struct Release {
  int major = 0, minor = 0;
  friend auto operator<=>(const Release&, const Release&) = default;
};

/// From which release on, its development included, the program seals recordings, and every other
/// file with results.
inline constexpr Release sealsRecordings{0, 2}, sealsResults{0, 3};

/// Whether a file that names its program ("0.3.0-dev+1a2b", "Perilymph 0.2.0") must have a seal,
/// whatever its format line states. False for programs of others.
bool hasToBeSealed(std::string_view program, Release since = sealsResults);

/// Key of the seal in every kind of file.
inline constexpr const char* sealKey = "content_sha256";

/// Facts about a file, by their keys.
using SealedFacts = std::map<std::string, std::string>;

/// Seal of a table: its facts except the seal itself, and the hash of its rows in order.
std::string sealOver(const SealedFacts& facts, const Sha256& rows);

/// The state of a table whose facts have, or lack, a seal.
///
/// @param isInFormat  Whether the file's format has a seal.
/// @param program     The program that the file names: without a seal, one that has to seal it makes
///                    it a changed file (hasToBeSealed()).
Seal sealIn(const SealedFacts& facts, const Sha256& rows, bool isInFormat,
            std::string_view program = {});

/// The value of `sealKey` in a JSON text that is not sealed yet.
std::string sealToBe();

/// A JSON text with its seal: the hash of the text that has sealToBe() in the seal's place.
std::string sealed(std::string json);

/// The state of a JSON text, byte by byte.
///
/// @param isInFormat, program  As of a table.
Seal sealIn(std::string_view json, bool isInFormat, std::string_view program = {});

}  // namespace perilymph
