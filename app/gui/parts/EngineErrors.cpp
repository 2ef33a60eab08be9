// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/EngineErrors.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <iterator>
#include <vector>

#include "gui/parts/DataText.h"
#include "gui/parts/ResultErrors.h"
#include "gui/parts/StatementErrors.h"

namespace perilymph::gui {

namespace {

// With what differs replaced by %1, %2 and so on. lupdate reads them here.
constexpr const char* messages[] = {
    // of a patient's export and import
    QT_TRANSLATE_NOOP("Data", "The copy was canceled; nothing of it was kept."),
    // of a series
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 files are compressed as a whole (transfer syntax "
                      "1.2.840.10008.1.2.1.99, deflated), which this program does not read. Export "
                      "the series uncompressed, or convert it with gdcmconv --raw."),
    QT_TRANSLATE_NOOP("Data",
                      "It is a secondary capture, a picture of a screen, without a place in the "
                      "patient (%1 is missing). Choose a series of original images."),
    QT_TRANSLATE_NOOP("Data",
                      "It is of the modality %1, a projection without a place in the patient (%2 "
                      "is missing). Choose the volume that was reconstructed of it."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Its images are of several modalities, %1 and %2. Export each as a series of its own."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 files were not read: sequences are nested deeper than %3, which no "
                      "image needs. Export the series again."),
    QT_TRANSLATE_NOOP("Data",
                      "The file %1 states %2 as %3, where one number belongs; export the series "
                      "again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "The file %1 states %2 as %3, where %4 numbers belong; export the series "
                      "again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "The file %1 states %2 as %3, where a whole number from %4 to %5 belongs; "
                      "export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "Its images differ in %1, so they may be of two patients. Export the images "
                      "of each patient apart."),
    QT_TRANSLATE_NOOP("Data",
                      "The slope of its gray values, RescaleSlope (0028,1053), is %1 in %2; it "
                      "must be above 0. Export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "PixelRepresentation (0028,0103) differs between its images: signed in %1 "
                      "and unsigned in %2. Export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "Its slices alternate in %1, as those of two reconstructions in one series "
                      "do. Export each reconstruction as a series of its own."),
    QT_TRANSLATE_NOOP("Data",
                      "The gray values of slice %1 of %2 (%3) do not join those of the next one: "
                      "its file states slope %4 and intercept %5, the next one slope %6 and "
                      "intercept %7. Export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "The file %1 stores %2 bits (0028,0101) of a voxel in the %3 that are "
                      "allocated (0028,0100); export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "The file %1 holds compressed voxels and states that they are not (transfer "
                      "syntax %2); export the series again as original images."),
    QT_TRANSLATE_NOOP("Data", "It is of the modality %1, not CT. Choose a CT series."),
    QT_TRANSLATE_NOOP(
        "Data",
        "It is a scout (localizer), a projection and no slices. Choose a series of slices."),
    QT_TRANSLATE_NOOP("Data",
                      "Its images are in color, as of a picture or a fusion, and hold no "
                      "Hounsfield units. Choose a series of original images."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 files are encrypted. Export the series again without encryption."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 of %2 files are cut off: they end before their voxels do. Copy the series again."),
    QT_TRANSLATE_NOOP("Data", "%1 of %2 files hold no image. Export the series again."),
    QT_TRANSLATE_NOOP("Data",
                      "Its voxels are stored in a way this program cannot decode (transfer syntax "
                      "%1). Export the series uncompressed, or convert it with gdcmconv --raw."),
    QT_TRANSLATE_NOOP("Data",
                      "Its slices are of several sizes, %1 x %2 and %3 x %4 voxels. Export each "
                      "size as a series of its own."),
    QT_TRANSLATE_NOOP("Data",
                      "Its slices are of several reconstruction kernels, %1 and %2. Export each "
                      "reconstruction as a series of its own."),
    QT_TRANSLATE_NOOP("Data",
                      "Its slices have no pixel spacing, so no length can be measured in them. "
                      "Export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "Its slices have several pixel spacings, %1 mm and %2 mm. Export each as a "
                      "series of its own."),
    QT_TRANSLATE_NOOP("Data",
                      "It has %1 million voxels; at most %2 million are read. Export the region of "
                      "the temporal bone."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 of %2 slices have no position or orientation in the patient, so no length along the "
        "stack can be trusted. Export the series again as original images."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 of %2 slices have a position more than %3 km from the origin of the patient's "
        "coordinates, where no scanner measures. Export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 slices have an orientation that is not two unit vectors at right "
                      "angles. Export the series again as original images."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 slices have another orientation than the first. Export each "
                      "orientation as a series of its own."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 slice is missing behind slice %2 of %3 (at %4 mm along the normal), where the gap is "
        "%5 mm and the step elsewhere %6 mm. Export the whole series again."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 slices are missing, the first behind slice %2 of %3 (at %4 mm along the normal), where "
        "the gap is %5 mm and the step elsewhere %6 mm. Export the whole series again."),
    QT_TRANSLATE_NOOP("Data",
                      "The slices are not equally spaced: slice %1 of %2 (at %3 mm along the "
                      "normal) lies %4 mm from where equal steps of %5 mm put it, and at most %6 "
                      "mm is allowed. Export the series again as original images."),
    QT_TRANSLATE_NOOP("Data", "There is no slice. Choose another series."),
    QT_TRANSLATE_NOOP("Data",
                      "There is a single slice; at least %1 are needed. Choose another series."),
    QT_TRANSLATE_NOOP("Data",
                      "All %1 slices lie at one position; a volume needs them one above the other. "
                      "Choose another series."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 images that differ lie at the position of slice %2 of %3: the series holds several "
        "phases or reconstructions. Export each as a series of its own."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 voxels lie beyond -32768 to 32767, which 16 bits hold. Export the series "
                      "as Hounsfield units."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The voxels of a file could not be decoded: it is damaged, or stored in a way this program "
        "does not know. Copy or export the series again, uncompressed if it can be."),
    QT_TRANSLATE_NOOP("Data",
                      "The tilted gantry's volume could not be resampled to right angles. Export "
                      "it reformatted without tilt."),
    // of a file, whose name is before it
    QT_TRANSLATE_NOOP("Data",
                      "is neither a file nor a folder. Give a folder of DICOM files, a DICOMDIR, a "
                      "DICOM, NIfTI or NRRD file."),
    QT_TRANSLATE_NOOP("Data", "does not exist. Check the path."),
    QT_TRANSLATE_NOOP("Data",
                      "holds no DICOM image. Give a folder of DICOM files, a DICOMDIR, a DICOM, "
                      "NIfTI or NRRD file."),
    QT_TRANSLATE_NOOP("Data",
                      "holds %1 series of the number %2, of several patients or studies. Choose "
                      "one of them: %3 and so on."),
    QT_TRANSLATE_NOOP("Data",
                      "takes more than 5 minutes to list, because its files are damaged or on a "
                      "slow drive. Copy the series to a folder of this computer."),
    QT_TRANSLATE_NOOP("Data", "is encrypted. Unpack it with its password, and give the folder."),
    QT_TRANSLATE_NOOP("Data",
                      "unpacks to more than 4 GB, or to more than a hundred times its size. Unpack "
                      "it, and give the folder of one series."),
    QT_TRANSLATE_NOOP("Data",
                      "cannot be unpacked: the folder for temporary files (TMPDIR) is missing, "
                      "full or not writable. Make space, or unpack it and give the folder."),
    QT_TRANSLATE_NOOP("Data",
                      "is a damaged .zip, or took more than a minute to unpack. Copy it again, or "
                      "unpack it and give the folder."),
    QT_TRANSLATE_NOOP("Data",
                      "gives its points in another unit (coordinateUnits) than mm, um, cm or m. "
                      "Save the points in millimeters."),
    QT_TRANSLATE_NOOP("Data", "holds more than %1 files. Give the folder of one examination."),
    QT_TRANSLATE_NOOP("Data",
                      "is a DICOMDIR, but none of the files it names is there. Copy the whole "
                      "medium, or give a folder of images."),
    QT_TRANSLATE_NOOP("Data", "cannot be read. Check its name and permissions."),
    QT_TRANSLATE_NOOP("Data", "is cut off or damaged. Copy or export it again."),
    QT_TRANSLATE_NOOP(
        "Data", "is no NIfTI-1 file with its voxels in it. Save the volume as .nii or .nii.gz."),
    QT_TRANSLATE_NOOP("Data",
                      "is a NIfTI-2 file; NIfTI-1 is read. Save the volume as NIfTI-1 (.nii or "
                      ".nii.gz) or as NRRD."),
    QT_TRANSLATE_NOOP("Data",
                      "is of the modality %1, not CT. Export the CT as NRRD with its voxels in the "
                      "file."),
    QT_TRANSLATE_NOOP("Data", "holds more than one volume. Save the CT alone."),
    QT_TRANSLATE_NOOP(
        "Data",
        "holds voxels of the type %1, which are no gray values. Save the CT as 16-bit numbers."),
    QT_TRANSLATE_NOOP("Data",
                      "has neither an SForm nor a QForm in a unit of length, so left and right are "
                      "not known. Export it with its orientation."),
    QT_TRANSLATE_NOOP("Data", "is damaged: its voxels begin nowhere. Export it again."),
    QT_TRANSLATE_NOOP("Data",
                      "holds no volume: each of its sizes must be %1 to %2. Export it again."),
    QT_TRANSLATE_NOOP("Data",
                      "has %1 million voxels; at most %2 million are read. Export the region of "
                      "the temporal bone."),
    QT_TRANSLATE_NOOP(
        "Data",
        "is no NRRD file with a whole header. Export the CT as NRRD with its voxels in the file."),
    QT_TRANSLATE_NOOP(
        "Data",
        "holds no volume of three dimensions. Export the CT as NRRD with its voxels in the file."),
    QT_TRANSLATE_NOOP(
        "Data",
        "holds voxels that are no gray values. Export the CT as NRRD with its voxels in the file."),
    QT_TRANSLATE_NOOP(
        "Data",
        "does not say the order of its bytes. Export the CT as NRRD with its voxels in the file."),
    QT_TRANSLATE_NOOP("Data",
                      "has no space, directions and origin in the patient, so left and right are "
                      "not known. Export the CT as NRRD with its voxels in the file."),
    QT_TRANSLATE_NOOP("Data",
                      "is encoded as '%1'; raw and gzip are read. Export the CT as NRRD with its "
                      "voxels in the file."),
    QT_TRANSLATE_NOOP(
        "Data", "skips a part of its voxels. Export the CT as NRRD with its voxels in the file."),
    QT_TRANSLATE_NOOP(
        "Data", "asks for more memory than there is. Export the region of the temporal bone."),
    // of a volume and its measurement
    QT_TRANSLATE_NOOP("Data",
                      "The volume has %1 x %2 x %3 voxels; at least 2 are needed along every axis. "
                      "Choose another series."),
    QT_TRANSLATE_NOOP("Data",
                      "The volume holds %1 voxels where its size says %2. The file is damaged; "
                      "export the series again."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The volume's orientation matrix is singular or not finite, so no length can be measured "
        "in it. Export the series again with its positions and orientation."),
    QT_TRANSLATE_NOOP("Data",
                      "No cochlea of usual shape was found: the best fit leaves %1 % of the voxels "
                      "near its wall unexplained, at most %2 % is allowed. Click into the cochlea; "
                      "of a malformed or ossified one A, B and H do not apply."),
    QT_TRANSLATE_NOOP(
        "Data",
        "No cochlea of usual shape was found: the best fit falls from the base to the "
        "middle turn, where a cochlea climbs. Click into the cochlea; of a malformed "
        "or ossified one A, B and H do not apply."),
    QT_TRANSLATE_NOOP(
        "Data",
        "There is metal in or beside the cochlea (an implant?): %1 cubic millimeters are "
        "brighter than %2 HU and hide its wall. Take a CT from before the "
        "implantation."),
    QT_TRANSLATE_NOOP("Data",
                      "The scala tympani is built with %1 turns, which were not seen in this "
                      "cochlea, so no patient file is written. Use its measures without the "
                      "model."),
    QT_TRANSLATE_NOOP("Data",
                      "The point given lies outside the volume. Click into the cochlea, or give "
                      "none and let the volume be searched."),
    QT_TRANSLATE_NOOP("Data",
                      "No bone with a hollow was found there: the volume is empty or shows no "
                      "temporal bone. Choose another series, or click into the cochlea."),
    QT_TRANSLATE_NOOP("Data",
                      "Too few voxels lie near the place given to measure a cochlea. Click into "
                      "the cochlea, and take a series that shows all of it."),
    QT_TRANSLATE_NOOP("Data",
                      "The best fit has A %1 mm and B %2 mm; of %3 cochleae A was %4 mm to %5 mm "
                      "and B %6 mm to %7 mm at four standard deviations. Click into the cochlea; "
                      "of a malformed or ossified one A, B and H do not apply."),
    QT_TRANSLATE_NOOP("Data",
                      "A voxel is %1 mm long; at most %2 mm is allowed, and %3 mm or less is "
                      "advised. Take a series with thinner slices."),
    // of a plan
    QT_TRANSLATE_NOOP("Data",
                      "A plan of %1 simulations is too short: the lowest and the highest of fewer "
                      "than %2 hold less than %3 % of the insertions to come. Choose %4 to %5."),
    QT_TRANSLATE_NOOP("Data", "A plan of %1 simulations is too long. Choose %2 to %3."),
    // of a port
    QT_TRANSLATE_NOOP(
        "Data",
        "The port %1 at %2 is taken by another program. End that program, or choose another port."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The address %1 is none of this machine. 127.0.0.1 always is; 'ip address' lists all.")};

/// The sentence as an expression: an optional name before it, then what its placeholders stand for.
QRegularExpression expressionOf(const QString& sentence)
{
  QString text = QRegularExpression::escape(sentence);
  static const QRegularExpression placeholder(QStringLiteral("\\\\%[0-9]"));
  text.replace(placeholder, QStringLiteral("(.+?)"));
  return QRegularExpression(QStringLiteral("^(|.* )") + text + QLatin1Char('$'),
                            QRegularExpression::DotMatchesEverythingOption);
}

struct Expression {
  const char* sentence;
  QRegularExpression expression;
};

/// Every sentence; made once.
const std::vector<Expression>& expressions()
{
  static const std::vector<Expression> all = [] {
    std::vector<Expression> made;
    const auto add = [&made](const char* sentence) {
      made.push_back({sentence, expressionOf(QString::fromUtf8(sentence))});
    };
    for (const char* sentence : messages) add(sentence);
    for (const char* sentence : volumeErrors()) add(sentence);
    for (const char* sentence : resultErrors()) add(sentence);
    return made;
  }();
  return all;
}

}  // namespace

QString engineError(const std::string& message)
{
  const QString english = QString::fromStdString(message);
  static const QRegularExpression others(
      QStringLiteral("^(.*) Other files have such faults: ([0-9]+)[.]$"));
  if (const auto more = others.match(english); more.hasMatch())
    return engineError(more.captured(1).toStdString()) + QLatin1Char(' ') +
           QCoreApplication::translate("Data", "Other files have such faults: %1.")
               .arg(more.captured(2));
  if (const auto twice = statedTwice(english)) return *twice;
  for (const auto& [sentence, expression] : expressions()) {
    const auto found = expression.match(english);
    if (!found.hasMatch()) continue;
    QString filled = QCoreApplication::translate("Data", sentence);
    for (int i = found.lastCapturedIndex(); i > 1; --i)
      filled.replace(QStringLiteral("%%1").arg(i - 1), localized(found.captured(i)));
    return subjectOf(found.captured(1)) + filled;
  }
  return english;
}

QString seriesWarning(const std::string& warning)
{
  return engineError(dataText(warning).toStdString());
}

}  // namespace perilymph::gui
