// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which bright place is which contact: the chain of an array's known spacings that explains the metal best.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

#include "EarFrame.h"
#include "MetalGrid.h"
#include "perilymph/electrode/ArrayDesign.h"

namespace perilymph::outcome {

/// A bright place with its place in the ear.
struct Candidate {
  Eigen::Vector3d position_P = Eigen::Vector3d::Zero();
  double strength = 0.0;  ///< Relative to that of the array's contacts: about 1 for a contact.
  EarPlace place;
};

/// A chain of contacts: for each, from the tip, its candidate; -1: it was not seen.
struct Chain {
  std::vector<int> candidate;
  double score = -1e9;
};

/// Blobs near the duct or before the opening, with strengths relative to the median of the strongest as many as
/// the array has contacts.
std::vector<Candidate> candidatesOf(const std::vector<Blob>& blobs, const EarFrame& frame,
                                    std::size_t contacts);

/// The best chain, by dynamic programming over pairs of candidates. A contact that was not seen, a step
/// whose length differs from the spacing, metal missing between two contacts, a sharp bend and a turn back
/// cost; a bright candidate in the chain counts.
///
/// @param byHand       Candidate of contacts that a person placed, by index from 0.
/// @param fwhm_mm      Full width at half maximum of the blur: metal ends no more sharply.
Chain bestChain(const std::vector<Candidate>& candidates, const MetalGrid& grid,
                const electrode::ArrayDesign& array, const std::map<int, int>& byHand,
                double fwhm_mm);

}  // namespace perilymph::outcome
