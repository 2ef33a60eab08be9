// SPDX-License-Identifier: BSD-3-Clause
#include "DicomStatements.h"

namespace perilymph::imaging {

namespace dicomPairs {

namespace {

constexpr const char* exportAgain = "export the series again as original images";
constexpr const char* check = "check which of them is right before the measures are used";
// Headers write lengths with three digits or more.
constexpr double rounding = 2e-3;

}  // namespace

const StatedTwice framesAndGroups{"DICOM",
                                  "the number of its frames",
                                  "NumberOfFrames (0028,0008)",
                                  "PerFrameFunctionalGroupsSequence (5200,9230)",
                                  "",
                                  0.0,
                                  0.0,
                                  Disagreement::refuse,
                                  exportAgain};
const StatedTwice framesAndFragments{"DICOM",
                                     "the number of its frames",
                                     "NumberOfFrames (0028,0008)",
                                     "the compressed images that PixelData holds",
                                     "",
                                     0.0,
                                     0.0,
                                     Disagreement::refuse,
                                     exportAgain};
const StatedTwice framesAndOffsets{"DICOM",
                                   "the number of its frames",
                                   "NumberOfFrames (0028,0008)",
                                   "the offset table of PixelData",
                                   "",
                                   0.0,
                                   0.0,
                                   Disagreement::refuse,
                                   exportAgain};
const StatedTwice framesAndBytes{"DICOM",
                                 "the length of its voxels",
                                 "rows, columns, bits and frames",
                                 "PixelData (7FE0,0010)",
                                 "bytes",
                                 0.0,
                                 1.0,  // an odd length is padded
                                 Disagreement::refuse,
                                 exportAgain};
const StatedTwice highBit{"DICOM",
                          "the highest bit of its voxels",
                          "BitsStored (0028,0101) less one",
                          "HighBit (0028,0102)",
                          "",
                          0.0,
                          0.0,
                          Disagreement::refuse,
                          exportAgain};
const StatedTwice bitsStored{"DICOM",
                             "the bits of its voxels",
                             "BitsStored (0028,0101)",
                             "the voxels themselves, which need more",
                             "",
                             0.0,
                             0.0,
                             Disagreement::refuse,
                             exportAgain};
const StatedTwice columnsOutsideGroups{"DICOM",
                                       "the distance between its columns",
                                       "the functional groups",
                                       "PixelSpacing (0028,0030) outside of them",
                                       "mm",
                                       rounding,
                                       0.0,
                                       Disagreement::refuse,
                                       exportAgain};
const StatedTwice rowsOutsideGroups{"DICOM",
                                    "the distance between its rows",
                                    "the functional groups",
                                    "PixelSpacing (0028,0030) outside of them",
                                    "mm",
                                    rounding,
                                    0.0,
                                    Disagreement::refuse,
                                    exportAgain};
const StatedTwice slopeOutsideGroups{"DICOM",
                                     "the slope of its gray values",
                                     "the functional groups",
                                     "RescaleSlope (0028,1053) outside of them",
                                     "",
                                     1e-6,
                                     0.0,
                                     Disagreement::refuse,
                                     exportAgain};
const StatedTwice interceptOutsideGroups{"DICOM",
                                         "the intercept of its gray values",
                                         "the functional groups",
                                         "RescaleIntercept (0028,1052) outside of them",
                                         "",
                                         1e-6,
                                         0.0,
                                         Disagreement::refuse,
                                         exportAgain};
const StatedTwice aspectRatio{"DICOM",
                              "the ratio of a voxel's height to its width",
                              "PixelSpacing (0028,0030)",
                              "PixelAspectRatio (0028,0034)",
                              "",
                              rounding,
                              0.0,
                              Disagreement::refuse,
                              exportAgain};
const StatedTwice modality{"DICOM",
                           "the kind of its images",
                           "Modality (0008,0060)",
                           "SOPClassUID (0008,0016)",
                           "",
                           0.0,
                           0.0,
                           Disagreement::refuse,
                           exportAgain};

const StatedTwice step{"DICOM",
                       "the step",
                       "their positions",
                       "SpacingBetweenSlices (0018,0088)",
                       "mm",
                       5e-3,
                       2e-3,
                       Disagreement::warn,
                       check};
const StatedTwice location{"DICOM",
                           "the extent of its slices",
                           "their positions",
                           "SliceLocation (0020,1041)",
                           "mm",
                           5e-3,
                           0.02,
                           Disagreement::warn,
                           check};
const StatedTwice locationOfSlice{
    "DICOM", "the place above the first", "its position", "SliceLocation (0020,1041)", "mm", 0.0,
    0.05,    Disagreement::warn,          check};
const StatedTwice fieldOfView{"DICOM",
                              "the width of its images",
                              "columns and PixelSpacing (0028,0030)",
                              "ReconstructionDiameter (0018,1100)",
                              "mm",
                              5e-3,
                              0.0,
                              Disagreement::warn,
                              "check that the images were cropped and not scaled"};
const StatedTwice imagerColumns{"DICOM",
                                "the distance between its columns",
                                "PixelSpacing (0028,0030)",
                                "ImagerPixelSpacing (0018,1164)",
                                "mm",
                                rounding,
                                0.0,
                                Disagreement::warn,
                                check};
const StatedTwice imagerRows{"DICOM",
                             "the distance between its rows",
                             "PixelSpacing (0028,0030)",
                             "ImagerPixelSpacing (0018,1164)",
                             "mm",
                             rounding,
                             0.0,
                             Disagreement::warn,
                             check};
const StatedTwice tilt{"DICOM",
                       "the tilt of the gantry",
                       "the slices' positions",
                       "GantryDetectorTilt (0018,1120)",
                       "degrees",
                       0.0,
                       0.12,  // a tenth of a degree is written
                       Disagreement::warn,
                       check};
const StatedTwice imagesInAcquisition{"DICOM",
                                      "the number of its images",
                                      "the files that are there",
                                      "ImagesInAcquisition (0020,1002)",
                                      "",
                                      0.0,
                                      0.0,
                                      Disagreement::warn,
                                      "check that the whole series was exported"};

}  // namespace dicomPairs

std::vector<StatedTwice> allDicomPairs()
{
  using namespace dicomPairs;
  return {framesAndGroups,
          framesAndFragments,
          framesAndOffsets,
          framesAndBytes,
          highBit,
          bitsStored,
          columnsOutsideGroups,
          rowsOutsideGroups,
          slopeOutsideGroups,
          interceptOutsideGroups,
          aspectRatio,
          modality,
          step,
          location,
          locationOfSlice,
          fieldOfView,
          imagerColumns,
          imagerRows,
          tilt,
          imagesInAcquisition};
}

std::optional<std::string> disagreement(const DicomHeader& header, const StatedTwice& pair,
                                        double first, double second)
{
  return disagreement("The file " + nameOf(header), pair, first, second);
}

}  // namespace perilymph::imaging
