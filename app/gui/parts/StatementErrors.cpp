// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/StatementErrors.h"

#include <QCoreApplication>

namespace perilymph::gui {

namespace {

// lupdate reads them here.
constexpr const char* volumeMessages[] = {
    QT_TRANSLATE_NOOP("Data", "holds %1 volumes, the first %2. Give one of these files."),
    QT_TRANSLATE_NOOP("Data", "states %1 twice: %2 in %3 and %4 in %5; %6."),
    QT_TRANSLATE_NOOP("Data",
                      "has voxels of %1 mm along %2 where 0.01 to 10 mm are read; its unit of "
                      "length is %3. Export it again in millimeters."),
    QT_TRANSLATE_NOOP("Data",
                      "has axes %1 and %2 that meet at %3 degrees, not at 90 within 0.057. "
                      "Resample it to right angles, or open the original series."),
    QT_TRANSLATE_NOOP("Data",
                      "has a matrix with values that are no finite numbers. Export it again with "
                      "its orientation."),
    QT_TRANSLATE_NOOP(
        "Data",
        "states its unit of length by the code %1, which is none. Export it again in millimeters."),
    QT_TRANSLATE_NOOP(
        "Data",
        "states its unit of length as %1; millimeters, centimeters, meters and micrometers are "
        "read, one for each of three axes. Export it again in millimeters."),
    QT_TRANSLATE_NOOP("Data",
                      "has a QForm that is no rotation: its quaternion is longer than 1, its "
                      "pixdim[0] not 1 or -1, or a number not finite. Export it again."),
    QT_TRANSLATE_NOOP("Data",
                      "has a scl_slope or scl_inter that scales no gray value: the slope must be "
                      "above 0 and both finite. Export it again."),
    QT_TRANSLATE_NOOP("Data",
                      "holds no volume of three dimensions: its dim[0] is %1. Save the CT alone."),
    QT_TRANSLATE_NOOP("Data",
                      "is damaged: a line of its header is no field. Copy or export it again."),
    QT_TRANSLATE_NOOP("Data",
                      "has an axis of the kind '%1', which is none in space. Export the CT as NRRD "
                      "with its voxels in the file."),
    QT_TRANSLATE_NOOP("Data",
                      "keeps its voxels in '%1'; they are read from one file in the header's "
                      "folder. Export the CT as NRRD with its voxels in the file."),
    QT_TRANSLATE_NOOP("Data",
                      "has a field '%1' that is not one number for each of its three axes: '%2'. "
                      "Export it again."),
    QT_TRANSLATE_NOOP(
        "Data",
        "is no MetaImage file with a whole header. Export the CT as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP(
        "Data",
        "has no TransformMatrix, Offset and ElementSpacing of three dimensions, so left and right "
        "or its voxel size are not known. Export the CT as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP(
        "Data", "holds no volume of three dimensions. Export the CT as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP(
        "Data", "holds voxels that are no gray values. Export the CT as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP("Data",
                      "is of the modality %1, not CT. Export the CT as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP("Data",
                      "does not hold its voxels as binary numbers in a stated order. Export the CT "
                      "as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP("Data",
                      "scales its gray values by ElementToIntensityFunction, which programs read "
                      "differently. Export the CT as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP("Data",
                      "keeps its voxels in '%1'; they are read from one file in the header's "
                      "folder. Export the CT as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP("Data",
                      "skips a part of its voxels. Export the CT as MetaImage (.mha) or NRRD."),
    QT_TRANSLATE_NOOP("Data", "cannot be inflated: there is no memory. Close programs.")};

// What the placeholders of a disagreement stand for: quantities, places, values and remedies.
constexpr const char* words[] = {
    QT_TRANSLATE_NOOP("Data", "the voxel size"),
    QT_TRANSLATE_NOOP("Data", "the place of its voxels"),
    QT_TRANSLATE_NOOP("Data", "the handedness of its axes"),
    QT_TRANSLATE_NOOP("Data", "whether it has an SForm"),
    QT_TRANSLATE_NOOP("Data", "the bits of a voxel"),
    QT_TRANSLATE_NOOP("Data", "its gray values"),
    QT_TRANSLATE_NOOP("Data", "the length of its voxels"),
    QT_TRANSLATE_NOOP("Data", "the unit of length"),
    QT_TRANSLATE_NOOP("Data", "its dimensions in space"),
    QT_TRANSLATE_NOOP("Data", "the number of its voxels"),
    QT_TRANSLATE_NOOP("Data", "one field"),
    QT_TRANSLATE_NOOP("Data", "where its axes point"),
    QT_TRANSLATE_NOOP("Data", "the length of its packed voxels"),
    QT_TRANSLATE_NOOP("Data", "the SForm"),
    QT_TRANSLATE_NOOP("Data", "the QForm"),
    QT_TRANSLATE_NOOP("Data", "the QForm of the same code"),
    QT_TRANSLATE_NOOP("Data", "the QForm of another code"),
    QT_TRANSLATE_NOOP("Data", "the QForm of code 1 or 2"),
    QT_TRANSLATE_NOOP("Data", "the SForm of a higher code"),
    QT_TRANSLATE_NOOP("Data", "the matrix"),
    QT_TRANSLATE_NOOP("Data", "its data"),
    QT_TRANSLATE_NOOP("Data", "its sizes and number type"),
    QT_TRANSLATE_NOOP("Data", "its first line"),
    QT_TRANSLATE_NOOP("Data", "a later line"),
    QT_TRANSLATE_NOOP("Data", "axis mins and axis maxs"),
    QT_TRANSLATE_NOOP("Data", "old min and old max"),
    QT_TRANSLATE_NOOP("Data", "ElementSpacing times TransformMatrix"),
    QT_TRANSLATE_NOOP("Data", "ElementMin and ElementMax"),
    QT_TRANSLATE_NOOP("Data", "export it again from the original series"),
    QT_TRANSLATE_NOOP(
        "Data", "it is cut off or damaged, or its header was changed: copy or export it again"),
    QT_TRANSLATE_NOOP("Data", "the SForm is used, so check the sides"),
    QT_TRANSLATE_NOOP("Data", "the QForm, of the scanner's space, is used, so check the sides"),
    QT_TRANSLATE_NOOP("Data", "the QForm is used"),
    QT_TRANSLATE_NOOP("Data", "they are read as stored, so check that bone is above 1000"),
    QT_TRANSLATE_NOOP("Data", "The file"),
    QT_TRANSLATE_NOOP("Data", "right-handed"),
    QT_TRANSLATE_NOOP("Data", "left-handed"),
    QT_TRANSLATE_NOOP("Data", "0 (none)"),
    QT_TRANSLATE_NOOP("Data", "zeros or values that are no numbers"),
    QT_TRANSLATE_NOOP("Data", "as stored"),
    QT_TRANSLATE_NOOP("Data", "not stated and taken as the millimeter"),
    QT_TRANSLATE_NOOP("Data", "the meter (xyzt_units)"),
    QT_TRANSLATE_NOOP("Data", "the millimeter (xyzt_units)"),
    QT_TRANSLATE_NOOP("Data", "the micrometer (xyzt_units)"),
    QT_TRANSLATE_NOOP("Data", "not stated (xyzt_units) and taken as the millimeter")};

// Behind a quantity.
constexpr const char* suffixes[] = {
    QT_TRANSLATE_NOOP("Data", " along i"), QT_TRANSLATE_NOOP("Data", " along j"),
    QT_TRANSLATE_NOOP("Data", " along k"), QT_TRANSLATE_NOOP("Data", ", the smallest,"),
    QT_TRANSLATE_NOOP("Data", ", the largest,")};

}  // namespace

std::span<const char* const> volumeErrors() { return volumeMessages; }

QString statedWord(const QString& word)
{
  for (const char* known : words)
    if (word == QLatin1String(known)) return QCoreApplication::translate("Data", known);
  // a voxel's index or a field's name behind a quantity
  for (const char* known : words)
    for (const char* const rest : {" (", ", '"})
      if (word.startsWith(QLatin1String(known) + QLatin1String(rest)))
        return QCoreApplication::translate("Data", known) + word.mid(QLatin1String(known).size());
  for (const char* suffix : suffixes)
    if (word.endsWith(QLatin1String(suffix)))
      return statedWord(word.chopped(QLatin1String(suffix).size())) +
             QCoreApplication::translate("Data", suffix);
  return word;
}

}  // namespace perilymph::gui
