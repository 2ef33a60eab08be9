// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a scenario chooses by name, and the names: one table for each choice.

#include <array>
#include <cstdint>

#include "perilymph/foundation/Choice.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::session {

/// How the stylet is handled.
enum class Technique : std::uint8_t {
  standard,         ///< The stylet stays in until full depth.
  advanceOffStylet  ///< It is held still from the array's hold depth on, the array pushed off it.
};

/// The opening into the scala tympani.
enum class OpeningKind : std::uint8_t {
  none,  ///< Nothing but the wall.
  roundWindow,
  cochleostomy
};

/// The roof of the scala tympani.
enum class MembraneKind : std::uint8_t {
  rigid,  ///< As hard as the bone around it.
  soft    ///< Yields as a basilar membrane does.
};

inline constexpr std::array techniques{
    Choice<Technique>{Technique::standard, "standard"},
    Choice<Technique>{Technique::advanceOffStylet, "aos", "advance off stylet"}};
inline constexpr std::array openings{
    Choice<OpeningKind>{OpeningKind::none, "none"},
    Choice<OpeningKind>{OpeningKind::roundWindow, "round-window"},
    Choice<OpeningKind>{OpeningKind::cochleostomy, "cochleostomy"}};
inline constexpr std::array membranes{Choice<MembraneKind>{MembraneKind::rigid, "rigid"},
                                      Choice<MembraneKind>{MembraneKind::soft, "soft"}};
inline constexpr std::array modelKinds{
    Choice<mechanics::ModelKind>{mechanics::ModelKind::rod, "rod"},
    Choice<mechanics::ModelKind>{mechanics::ModelKind::points, "points"}};
inline constexpr std::array couplings{
    Choice<mechanics::Coupling>{mechanics::Coupling::rigid, "rigid"},
    Choice<mechanics::Coupling>{mechanics::Coupling::spring, "spring"}};
constexpr const char* nameOf(Technique technique) { return nameIn(techniques, technique); }
constexpr const char* nameOf(OpeningKind opening) { return nameIn(openings, opening); }
constexpr const char* nameOf(MembraneKind membrane) { return nameIn(membranes, membrane); }
constexpr const char* nameOf(mechanics::ModelKind model) { return nameIn(modelKinds, model); }

}  // namespace perilymph::session
