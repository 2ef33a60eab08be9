// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What readers tell of a series that they read all the same, beside what it states twice (Statements.h): every
// sentence in one place, because the window translates each.

#include <array>
#include <initializer_list>
#include <string>

namespace perilymph::imaging {

namespace warnings {
// {0}, {1} and so on stand for what differs.
inline constexpr const char* scouts = "{0} scout images were left out.";
inline constexpr const char* loneImage =
    "The image {0} has another size or lies across the others, as a scout does; it was left out.";
inline constexpr const char* samePlace =
    "{0} slices lie at the position of another; they are dropped if their voxels are the same, and "
    "the series is refused if not.";
inline constexpr const char* tilted =
    "The gantry is tilted by {0} degrees; the volume is resampled to right angles.";
inline constexpr const char* lossy =
    "Its images were compressed with loss; fine edges may be gone.";
inline constexpr const char* derived =
    "Its images were computed from others, as reformatted planes are; original ones are sharper.";
inline constexpr const char* stump =
    "The file {0} beside its images cannot be read or ends before it names its series: a slice may "
    "be missing. Copy the series again.";
inline constexpr const char* patients =
    "The folder holds images of {0} patients; this series is of one of them. Check that it is the "
    "right one.";
inline constexpr const char* listedApart =
    "{0} of {1} images with its series number are of another {2} and are listed apart. Check which "
    "of them belong together.";
inline constexpr const char* directoryLost =
    "None of the {0} files that the DICOMDIR names is there; the files in its folder were read "
    "instead.";
inline constexpr const char* directoryMissing =
    "{0} of {1} files that the DICOMDIR names are not there; slices may be missing. Copy the whole "
    "medium.";
inline constexpr const char* coarse =
    "A voxel is {0} mm long; at most 0.65 mm is advised for a cochlea.";
inline constexpr const char* thin =
    "The volume is only {0} mm thick; a cochlea with its surroundings needs about 25 mm.";
inline constexpr const char* gaps =
    "The thickness of slice {0} of {1} ({2}) is {3} mm at a distance of {4} mm between the slices: "
    "what lies between them was not measured. Take a series without gaps if there is one.";
inline constexpr const char* overlap =
    "The thickness of slice {0} of {1} ({2}) is {3} mm at a distance of {4} mm between the slices: "
    "they overlap so much that one of both may be wrong. Check them before the measures are used.";
inline constexpr const char* settings =
    "Its slices differ in {0}: {1} and {2}. Check that they are of one reconstruction.";
inline constexpr const char* noModality =
    "It states no modality; by its class (SOPClassUID) it is of the modality {0}.";
inline constexpr const char* grayValues =
    "Its gray values are not Hounsfield units: {0}. Judge them only against others of the same "
    "series.";
inline constexpr const char* scales =
    "Slope or intercept of the gray values differ between slices: slope {0} and intercept {1} in "
    "{2}, slope {3} and intercept {4} in others; check the gray values of the slices in the "
    "images.";

inline constexpr const char* copied =
    "Slices {0} and {1} of {2} hold the same voxels at different places, so one of both may be a "
    "copy of the other. Export the series again as original images.";

inline constexpr const char* sameInstance =
    "Slices {0} and {1} of {2} have one number (SOPInstanceUID) at different places, so one of "
    "both "
    "may be of another series. Export the series again as original images.";

inline constexpr std::array all{
    copied,  sameInstance, scouts,   loneImage,   samePlace,     tilted,           lossy,
    derived, stump,        patients, listedApart, directoryLost, directoryMissing, coarse,
    thin,    gaps,         overlap,  settings,    noModality,    grayValues,       scales};

// Why gray values are no Hounsfield units, and what images with one series number differ in.
inline constexpr const char* capture = "it is a secondary capture";
inline constexpr const char* flatPanel = "it is of a flat panel";
inline constexpr const char* coneBeam = "it is of a cone-beam scanner";
inline constexpr const char* patientOrStudy = "patient or study";
inline constexpr const char* frameOfReference = "frame of reference";

inline constexpr std::array reasons{capture, flatPanel, coneBeam, patientOrStudy, frameOfReference};
}  // namespace warnings

/// A sentence with its values.
inline std::string worded(const char* sentence, std::initializer_list<std::string> values = {})
{
  std::string text = sentence;
  std::size_t place = 0;
  for (const std::string& value : values) {
    const std::string mark = "{" + std::to_string(place++) + "}";
    if (const std::size_t at = text.find(mark); at != std::string::npos)
      text.replace(at, mark.size(), value);
  }
  return text;
}

}  // namespace perilymph::imaging
