// SPDX-License-Identifier: BSD-3-Clause
#include "DicomStatements.h"

namespace perilymph::imaging {

namespace dicomPairs {

namespace {

// Headers write lengths with three digits or more.
constexpr double rounding = 2e-3;

constexpr StatedTwice refused(const char* quantity, const char* first, const char* second,
                              const char* unit, double relative, double absolute = 0.0)
{
  return refusedPair("DICOM", quantity, first, second, unit, relative, absolute,
                     "export the series again as original images");
}

constexpr StatedTwice warned(
    const char* quantity, const char* first, const char* second, const char* unit, double relative,
    double absolute = 0.0,
    const char* remedy = "check which of them is right before the measures are used")
{
  return {"DICOM", quantity, first, second, unit, relative, absolute, Disagreement::warn, remedy};
}

}  // namespace

const StatedTwice framesAndGroups =
    refused("the number of its frames", "NumberOfFrames (0028,0008)",
            "PerFrameFunctionalGroupsSequence (5200,9230)", "", 0.0);
const StatedTwice framesAndFragments =
    refused("the number of its frames", "NumberOfFrames (0028,0008)",
            "the compressed images that PixelData holds", "", 0.0);
const StatedTwice framesAndOffsets =
    refused("the number of its frames", "NumberOfFrames (0028,0008)",
            "the offset table of PixelData", "", 0.0);
const StatedTwice framesAndBytes =
    refused("the length of its voxels", "rows, columns, bits and frames", "PixelData (7FE0,0010)",
            "bytes", 0.0, 1.0);  // an odd length is padded
const StatedTwice highBit =
    refused("the highest bit of its voxels", "BitsStored (0028,0101) less one",
            "HighBit (0028,0102)", "", 0.0);
const StatedTwice bitsStored = refused("the bits of its voxels", "BitsStored (0028,0101)",
                                       "the voxels themselves, which need more", "", 0.0);
const StatedTwice columnsOutsideGroups =
    refused("the distance between its columns", "the functional groups",
            "PixelSpacing (0028,0030) outside of them", "mm", rounding);
const StatedTwice rowsOutsideGroups =
    refused("the distance between its rows", "the functional groups",
            "PixelSpacing (0028,0030) outside of them", "mm", rounding);
const StatedTwice slopeOutsideGroups =
    refused("the slope of its gray values", "the functional groups",
            "RescaleSlope (0028,1053) outside of them", "", 1e-6);
const StatedTwice interceptOutsideGroups =
    refused("the intercept of its gray values", "the functional groups",
            "RescaleIntercept (0028,1052) outside of them", "", 1e-6);
const StatedTwice aspectRatio =
    refused("the ratio of a voxel's height to its width", "PixelSpacing (0028,0030)",
            "PixelAspectRatio (0028,0034)", "", rounding);
const StatedTwice modality =
    refused("the kind of its images", "Modality (0008,0060)", "SOPClassUID (0008,0016)", "", 0.0);
const StatedTwice grayTable = refused("its gray values", "RescaleSlope (0028,1053)",
                                      "the entries of ModalityLUTSequence (0028,3000)", "", 0.0);

const StatedTwice step =
    warned("the step", "their positions", "SpacingBetweenSlices (0018,0088)", "mm", 5e-3, 2e-3);
const StatedTwice location = warned("the extent of its slices", "their positions",
                                    "SliceLocation (0020,1041)", "mm", 5e-3, 0.02);
const StatedTwice locationOfSlice = warned("the place above the first", "its position",
                                           "SliceLocation (0020,1041)", "mm", 0.0, 0.05);
const StatedTwice fieldOfView =
    warned("the width of its images", "columns and PixelSpacing (0028,0030)",
           "ReconstructionDiameter (0018,1100)", "mm", 5e-3, 0.0,
           "check that the images were cropped and not scaled");
const StatedTwice imagerColumns =
    warned("the distance between its columns", "PixelSpacing (0028,0030)",
           "ImagerPixelSpacing (0018,1164)", "mm", rounding);
const StatedTwice imagerRows = warned("the distance between its rows", "PixelSpacing (0028,0030)",
                                      "ImagerPixelSpacing (0018,1164)", "mm", rounding);
const StatedTwice tilt =
    warned("the tilt of the gantry", "the slices' positions", "GantryDetectorTilt (0018,1120)",
           "degrees", 0.0, 0.12);  // a tenth of a degree is written
const StatedTwice imagesInAcquisition = warned(
    "the number of its images", "the files that are there", "ImagesInAcquisition (0020,1002)", "",
    0.0, 0.0, "check that the whole series was exported");
const StatedTwice mediaClass = warned("the class of its images", "SOPClassUID (0008,0016)",
                                      "MediaStorageSOPClassUID (0002,0002)", "", 0.0);
const StatedTwice smallest = warned("the smallest gray value", "its voxels",
                                    "SmallestImagePixelValue (0028,0106)", "", 0.0, 0.5);
const StatedTwice largest = warned("the largest gray value", "its voxels",
                                   "LargestImagePixelValue (0028,0107)", "", 0.0, 0.5);

const StatedTwice directions =
    warned("where its rows and columns point", "ImageOrientationPatient (0020,0037)",
           "PatientOrientation (0020,0020)", "", 0.0);
const StatedTwice imageNumber =
    warned("the place in its order", "its position", "InstanceNumber (0020,0013)", "", 0.0);
const StatedTwice side =
    warned("the side of the ear", "Laterality (0020,0060)", "ImageLaterality (0020,0062)", "", 0.0);
const StatedTwice realWorldSlope =
    warned("the slope of its gray values", "RescaleSlope (0028,1053)",
           "RealWorldValueSlope (0040,9225)", "", 1e-6);
const StatedTwice realWorldIntercept =
    warned("the intercept of its gray values", "RescaleIntercept (0028,1052)",
           "RealWorldValueIntercept (0040,9224)", "", 1e-6);

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
          grayTable,
          step,
          location,
          locationOfSlice,
          fieldOfView,
          imagerColumns,
          imagerRows,
          tilt,
          imagesInAcquisition,
          mediaClass,
          smallest,
          largest,
          directions,
          imageNumber,
          side,
          realWorldSlope,
          realWorldIntercept};
}

std::optional<Sentence> disagreement(const DicomHeader& header, const StatedTwice& pair,
                                     double first, double second)
{
  return disagreement(Sentence{"The file %1", nameOf(header)}, pair, first, second);
}

}  // namespace perilymph::imaging
