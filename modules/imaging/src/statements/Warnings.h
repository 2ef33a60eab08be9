// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What readers tell of a series that they read all the same, beside what it states twice (Statements.h): every
// sentence in one place, because the window translates each.

#include <array>

#include "perilymph/foundation/Sentence.h"

namespace perilymph::imaging {

namespace warnings {
inline constexpr Phrase scouts{"%1 scout images were left out."};
inline constexpr Phrase loneImage{
    "The image %1 has another size or lies across the others, as a scout does; it was left out."};
inline constexpr Phrase samePlace{
    "%1 slices lie at the position of another; they are dropped if their voxels are the same, and "
    "the series is refused if not."};
inline constexpr Phrase tilted{
    "The gantry is tilted by %1 degrees; the volume is resampled to right angles."};
inline constexpr Phrase lossy{"Its images were compressed with loss; fine edges may be gone."};
inline constexpr Phrase derived{
    "Its images were computed from others, as reformatted planes are; original ones are sharper."};
inline constexpr Phrase stump{
    "The file %1 beside its images cannot be read or ends before it names its series: a slice may "
    "be missing. Copy the series again."};
inline constexpr Phrase patients{
    "The folder holds images of %1 patients; this series is of one of them. Check that it is the "
    "right one."};
inline constexpr Phrase listedApart{
    "%1 of %2 images with its series number are of another %3 and are listed apart. Check which "
    "of them belong together."};
inline constexpr Phrase directoryLost{
    "None of the %1 files that the DICOMDIR names is there; the files in its folder were read "
    "instead."};
inline constexpr Phrase directoryMissing{
    "%1 of %2 files that the DICOMDIR names are not there; slices may be missing. Copy the whole "
    "medium."};
inline constexpr Phrase coarse{"A voxel is %1 mm long; at most 0.65 mm is advised for a cochlea."};
inline constexpr Phrase thin{"Small field of view (%1 mm); 25 mm recommended."};
inline constexpr Phrase gaps{
    "The thickness of slice %1 of %2 (%3) is %4 mm at a distance of %5 mm between the slices: "
    "what lies between them was not measured. Take a series without gaps if there is one."};
inline constexpr Phrase overlap{
    "The thickness of slice %1 of %2 (%3) is %4 mm at a distance of %5 mm between the slices: "
    "they overlap so much that one of both may be wrong. Check them before the measures are used."};
inline constexpr Phrase settings{
    "Its slices differ in %1: %2 and %3. Check that they are of one reconstruction."};
inline constexpr Phrase noModality{
    "It states no modality; by its class (SOPClassUID) it is of the modality %1."};
inline constexpr Phrase grayValues{
    "Its gray values are not Hounsfield units: %1. Judge them only against others of the same "
    "series."};
inline constexpr Phrase scales{
    "Slope or intercept of the gray values differ between slices: slope %1 and intercept %2 in "
    "%3, slope %4 and intercept %5 in others; check the gray values of the slices in the "
    "images."};

inline constexpr Phrase copied{
    "Slices %1 and %2 of %3 hold the same voxels at different places, so one of both may be a "
    "copy of the other. Export the series again as original images."};

inline constexpr Phrase sameInstance{
    "Slices %1 and %2 of %3 have one number (SOPInstanceUID) at different places, so one of "
    "both "
    "may be of another series. Export the series again as original images."};

inline constexpr std::array all{
    copied,  sameInstance, scouts,   loneImage,   samePlace,     tilted,           lossy,
    derived, stump,        patients, listedApart, directoryLost, directoryMissing, coarse,
    thin,    gaps,         overlap,  settings,    noModality,    grayValues,       scales};

// Why gray values are no Hounsfield units, and what images with one series number differ in.
inline constexpr Phrase capture{"it is a secondary capture"};
inline constexpr Phrase flatPanel{"it is of a flat panel"};
inline constexpr Phrase coneBeam{"it is of a cone-beam scanner"};
inline constexpr Phrase patientOrStudy{"patient or study"};
inline constexpr Phrase frameOfReference{"frame of reference"};

inline constexpr std::array reasons{capture, flatPanel, coneBeam, patientOrStudy, frameOfReference};
}  // namespace warnings

}  // namespace perilymph::imaging
