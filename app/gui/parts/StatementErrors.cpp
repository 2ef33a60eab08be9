// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/StatementErrors.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

namespace perilymph::gui {

namespace {

// lupdate reads them here.
constexpr const char* volumeMessages[] = {
    QT_TRANSLATE_NOOP("Data", "holds %1 volumes, the first %2. Give one of these files."),
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
    QT_TRANSLATE_NOOP("Data",
                      "lies more than 1 km from the origin of the patient's coordinates, where no "
                      "scanner measures. Export it again with its orientation."),
    QT_TRANSLATE_NOOP("Data",
                      "states by its intent_code %1 that its voxels are labels or statistics and "
                      "no gray values. Save the CT itself, with the code 0."),
    QT_TRANSLATE_NOOP("Data", "cannot be inflated: there is no memory. Close programs."),
    // warnings about a series
    QT_TRANSLATE_NOOP("Data",
                      "Slices %1 and %2 of %3 have one number (SOPInstanceUID) at different "
                      "places, so one of both "
                      "may be of another series. Export the series again as original images."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Slices %1 and %2 of %3 hold the same voxels at different places, so one of both may be a "
        "copy of the other. Export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "The image %1 has another size or lies across the others, as a scout does; "
                      "it was left out."),
    QT_TRANSLATE_NOOP("Data",
                      "The file %1 beside its images cannot be read or ends before it names its "
                      "series: a slice may be missing. Copy the series again."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The thickness of slice %1 of %2 (%3) is %4 mm at a distance of %5 mm between the slices: "
        "what lies between them was not measured. Take a series without gaps if there is one."),
    QT_TRANSLATE_NOOP("Data",
                      "The thickness of slice %1 of %2 (%3) is %4 mm at a distance of %5 mm "
                      "between the slices: they overlap so much that one of both may be wrong. "
                      "Check them before the measures are used."),
    QT_TRANSLATE_NOOP(
        "Data", "Its slices differ in %1: %2 and %3. Check that they are of one reconstruction."),
    QT_TRANSLATE_NOOP(
        "Data", "It states no modality; by its class (SOPClassUID) it is of the modality %1."),
    QT_TRANSLATE_NOOP("Data",
                      "Its gray values are not Hounsfield units: %1. Judge them only against "
                      "others of the same series."),
    QT_TRANSLATE_NOOP("Data",
                      "Slope or intercept of the gray values differ between slices: slope %1 and "
                      "intercept %2 in %3, slope %4 and intercept %5 in others; check the gray "
                      "values of the slices in the images.")};

// What the placeholders of a disagreement stand for: quantities, places, values and remedies.
constexpr const char* words[] = {
    QT_TRANSLATE_NOOP("Data", "the voxel size"),
    QT_TRANSLATE_NOOP("Data", "the place of its voxels"),
    QT_TRANSLATE_NOOP("Data", "the handedness of its axes"),
    QT_TRANSLATE_NOOP("Data", "whether it has an SForm"),
    QT_TRANSLATE_NOOP("Data", "the bits of a voxel"), QT_TRANSLATE_NOOP("Data", "its gray values"),
    QT_TRANSLATE_NOOP("Data", "the length of its voxels"),
    QT_TRANSLATE_NOOP("Data", "the unit of length"),
    QT_TRANSLATE_NOOP("Data", "its dimensions in space"),
    QT_TRANSLATE_NOOP("Data", "the number of its voxels"), QT_TRANSLATE_NOOP("Data", "one field"),
    QT_TRANSLATE_NOOP("Data", "where its axes point"),
    QT_TRANSLATE_NOOP("Data", "the length of its packed voxels"),
    QT_TRANSLATE_NOOP("Data", "the SForm"), QT_TRANSLATE_NOOP("Data", "the QForm"),
    QT_TRANSLATE_NOOP("Data", "the QForm of the same code"),
    QT_TRANSLATE_NOOP("Data", "the QForm of another code"),
    QT_TRANSLATE_NOOP("Data", "the QForm of code 1 or 2"),
    QT_TRANSLATE_NOOP("Data", "the SForm of a higher code"),
    QT_TRANSLATE_NOOP("Data", "the matrix"), QT_TRANSLATE_NOOP("Data", "its data"),
    QT_TRANSLATE_NOOP("Data", "its sizes and number type"),
    QT_TRANSLATE_NOOP("Data", "its first line"), QT_TRANSLATE_NOOP("Data", "a later line"),
    QT_TRANSLATE_NOOP("Data", "axis mins and axis maxs"),
    QT_TRANSLATE_NOOP("Data", "old min and old max"),
    QT_TRANSLATE_NOOP("Data", "the thickness of its slices"),
    QT_TRANSLATE_NOOP("Data", "the steps of space directions"),
    QT_TRANSLATE_NOOP("Data", "thicknesses"), QT_TRANSLATE_NOOP("Data", "its geometry"),
    QT_TRANSLATE_NOOP("Data", "a field"), QT_TRANSLATE_NOOP("Data", "a key with a value"),
    QT_TRANSLATE_NOOP("Data",
                      "one of both may be wrong, so check the voxel size in the original series"),
    QT_TRANSLATE_NOOP("Data", "ElementSpacing times TransformMatrix"),
    QT_TRANSLATE_NOOP("Data", "ElementMin and ElementMax"),
    QT_TRANSLATE_NOOP("Data", "export it again from the original series"),
    QT_TRANSLATE_NOOP(
        "Data", "it is cut off or damaged, or its header was changed: copy or export it again"),
    QT_TRANSLATE_NOOP("Data", "the SForm is used, so check the sides"),
    QT_TRANSLATE_NOOP("Data", "the QForm, of the scanner's space, is used, so check the sides"),
    QT_TRANSLATE_NOOP("Data", "the QForm is used"),
    QT_TRANSLATE_NOOP("Data", "they are read as stored, so check that bone is above 1000"),
    QT_TRANSLATE_NOOP("Data", "The file"), QT_TRANSLATE_NOOP("Data", "right-handed"),
    QT_TRANSLATE_NOOP("Data", "left-handed"), QT_TRANSLATE_NOOP("Data", "0 (none)"),
    QT_TRANSLATE_NOOP("Data", "zeros or values that are no numbers"),
    QT_TRANSLATE_NOOP("Data", "as stored"),
    QT_TRANSLATE_NOOP("Data", "not stated and taken as the millimeter"),
    QT_TRANSLATE_NOOP("Data", "the meter (xyzt_units)"),
    QT_TRANSLATE_NOOP("Data", "the millimeter (xyzt_units)"),
    QT_TRANSLATE_NOOP("Data", "the micrometer (xyzt_units)"),
    QT_TRANSLATE_NOOP("Data", "not stated (xyzt_units) and taken as the millimeter"),
    // of DICOM
    QT_TRANSLATE_NOOP("Data", "the number of its frames"),
    QT_TRANSLATE_NOOP("Data", "the highest bit of its voxels"),
    QT_TRANSLATE_NOOP("Data", "the bits of its voxels"),
    QT_TRANSLATE_NOOP("Data", "the distance between its columns"),
    QT_TRANSLATE_NOOP("Data", "the distance between its rows"),
    QT_TRANSLATE_NOOP("Data", "the slope of its gray values"),
    QT_TRANSLATE_NOOP("Data", "the intercept of its gray values"),
    QT_TRANSLATE_NOOP("Data", "the ratio of a voxel's height to its width"),
    QT_TRANSLATE_NOOP("Data", "the kind of its images"), QT_TRANSLATE_NOOP("Data", "the step"),
    QT_TRANSLATE_NOOP("Data", "the extent of its slices"),
    QT_TRANSLATE_NOOP("Data", "the place above the first"),
    QT_TRANSLATE_NOOP("Data", "the width of its images"),
    QT_TRANSLATE_NOOP("Data", "the tilt of the gantry"),
    QT_TRANSLATE_NOOP("Data", "the number of its images"),
    QT_TRANSLATE_NOOP("Data", "the class of its images"),
    QT_TRANSLATE_NOOP("Data", "where its rows and columns point"),
    QT_TRANSLATE_NOOP("Data", "the place in its order"),
    QT_TRANSLATE_NOOP("Data", "the side of the ear"),
    QT_TRANSLATE_NOOP("Data", "the smallest gray value"),
    QT_TRANSLATE_NOOP("Data", "the largest gray value"),
    QT_TRANSLATE_NOOP("Data", "the compressed images that PixelData holds"),
    QT_TRANSLATE_NOOP("Data", "the offset table of PixelData"),
    QT_TRANSLATE_NOOP("Data", "rows, columns, bits and frames"),
    QT_TRANSLATE_NOOP("Data", "the voxels themselves, which need more"),
    QT_TRANSLATE_NOOP("Data", "the functional groups"),
    QT_TRANSLATE_NOOP("Data", "the entries of ModalityLUTSequence (0028,3000)"),
    QT_TRANSLATE_NOOP("Data", "PixelSpacing (0028,0030) outside of them"),
    QT_TRANSLATE_NOOP("Data", "RescaleSlope (0028,1053) outside of them"),
    QT_TRANSLATE_NOOP("Data", "RescaleIntercept (0028,1052) outside of them"),
    QT_TRANSLATE_NOOP("Data", "BitsStored (0028,0101) less one"),
    QT_TRANSLATE_NOOP("Data", "their positions"), QT_TRANSLATE_NOOP("Data", "its position"),
    QT_TRANSLATE_NOOP("Data", "columns and PixelSpacing (0028,0030)"),
    QT_TRANSLATE_NOOP("Data", "the slices' positions"),
    QT_TRANSLATE_NOOP("Data", "the files that are there"), QT_TRANSLATE_NOOP("Data", "its voxels"),
    QT_TRANSLATE_NOOP("Data", "export the series again as original images"),
    QT_TRANSLATE_NOOP("Data", "check which of them is right before the measures are used"),
    QT_TRANSLATE_NOOP("Data", "check that the images were cropped and not scaled"),
    QT_TRANSLATE_NOOP("Data", "check that the whole series was exported"),
    QT_TRANSLATE_NOOP("Data", "The series"), QT_TRANSLATE_NOOP("Data", "degrees"),
    QT_TRANSLATE_NOOP("Data", "it is a secondary capture"),
    QT_TRANSLATE_NOOP("Data", "it is of a flat panel"),
    QT_TRANSLATE_NOOP("Data", "it is of a cone-beam scanner")};

// Behind a quantity.
constexpr const char* suffixes[] = {
    QT_TRANSLATE_NOOP("Data", " along i"), QT_TRANSLATE_NOOP("Data", " along j"),
    QT_TRANSLATE_NOOP("Data", " along k"), QT_TRANSLATE_NOOP("Data", ", the smallest,"),
    QT_TRANSLATE_NOOP("Data", ", the largest,")};

/// The place where "<value> in <place> and <value> in <place>" has its middle: the first " and " that is not within the
/// name of a place.
auto middleOf(const QString& values)
{
  const QLatin1String between(" and ");
  const auto first = values.indexOf(between);
  for (auto at = first; at >= 0; at = values.indexOf(between, at + 1)) {
    const QString place = values.left(at).section(QLatin1String(" in "), 1);
    if (statedWord(place) != place) return at;
  }
  return first;
}

}  // namespace

std::optional<QString> statedTwice(const QString& english)
{
  static const QRegularExpression sentence(
      QStringLiteral("^(|.* )states (.+) twice: (.+ in .+ and .+ in .+); (.+)[.]$"));
  const auto found = sentence.match(english);
  if (!found.hasMatch()) return std::nullopt;
  const QString values = found.captured(3);
  const auto middle = middleOf(values);
  const QString one = values.left(middle), other = values.mid(middle + 5);
  const auto value = [](const QString& stated) {
    return localized(stated.section(QLatin1String(" in "), 0, 0));
  };
  const auto place = [](const QString& stated) {
    return statedWord(stated.section(QLatin1String(" in "), 1));
  };
  return subjectOf(found.captured(1)) +
         QCoreApplication::translate("Data", "states %1 twice: %2 in %3 and %4 in %5; %6.")
             .arg(statedWord(found.captured(2)), value(one), place(one), value(other), place(other),
                  statedWord(found.captured(4)));
}

std::span<const char* const> volumeErrors() { return volumeMessages; }

QString statedWord(const QString& word)
{
  static const QRegularExpression ofSlice(
      QStringLiteral("^(.*) of slice ([0-9]+) of ([0-9]+) [(](.*)[)]$"));
  if (const auto slice = ofSlice.match(word); slice.hasMatch())
    return statedWord(slice.captured(1)) +
           QCoreApplication::translate("Data", " of slice %1 of %2 (%3)")
               .arg(slice.captured(2), slice.captured(3), slice.captured(4));
  for (const char* known : words)
    if (word == QLatin1String(known)) return QCoreApplication::translate("Data", known);
  // a voxel's index or a field's name behind a quantity
  for (const char* known : words)
    for (const char* const rest : {" (", ", '", " in "})
      if (word.startsWith(QLatin1String(known) + QLatin1String(rest)))
        return QCoreApplication::translate("Data", known) + word.mid(QLatin1String(known).size());
  for (const char* suffix : suffixes)
    if (word.endsWith(QLatin1String(suffix)))
      return statedWord(word.chopped(QLatin1String(suffix).size())) +
             QCoreApplication::translate("Data", suffix);
  return word;
}

QString localized(const QString& word)
{
  static const QRegularExpression number(QStringLiteral("^-?[0-9]+\\.[0-9]+( [a-z]+)?$"));
  if (!number.match(word).hasMatch()) return statedWord(word);
  const QStringList parts = word.split(QLatin1Char(' '));
  QString text = QString(parts.first()).replace(QLatin1Char('.'), QLocale().decimalPoint());
  if (parts.size() > 1) text += QLatin1Char(' ') + statedWord(parts.last());
  return text;
}

QString subjectOf(const QString& english)
{
  for (const char* const known : {"The file ", "The series "})
    if (english.startsWith(QLatin1String(known)))
      return statedWord(QString::fromLatin1(known).trimmed()) +
             english.mid(QLatin1String(known).size() - 1);
  return english;
}

}  // namespace perilymph::gui
