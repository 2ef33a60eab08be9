// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/CtSentences.h"

#include <QCoreApplication>

namespace perilymph::gui {

namespace {

// With their numbers replaced by %1, %2 and so on. lupdate reads them here.
constexpr const char* sentences[] = {
    // flags of a measurement
    QT_TRANSLATE_NOOP(
        "Data",
        "A voxel is longer than %1 mm, the coarsest the measurement was tried with: take a finer "
        "series if there is one, or trust the measures less than their error bars say."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The cochlea is filled with air, as in a dried specimen: a patient's is filled with fluid, "
        "so check that this is the right place and the right series."),
    QT_TRANSLATE_NOOP("Data",
                      "The spiral winds as in the other ear: the file is mirrored or the side is "
                      "wrong; check both before anything is planned."),
    QT_TRANSLATE_NOOP("Data",
                      "A or B lies more than two standard deviations from the mean of %1 cochleae: "
                      "check the outline in the images before using the measures."),
    QT_TRANSLATE_NOOP("Data",
                      "The fitted cochlea explains the voxels near its wall badly: check the "
                      "outline in the images, and measure by hand if it does not lie on the wall."),
    QT_TRANSLATE_NOOP("Data",
                      "The wall found in sections through the modiolus lies apart from the fitted "
                      "one: check the outline in the images."),
    QT_TRANSLATE_NOOP("Data",
                      "No round window was found, so %1 degrees follows from the spiral alone: "
                      "mark the round window's center."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Part of the cochlea lies outside the volume, or where nothing was measured: take a series "
        "that shows all of it."),
    QT_TRANSLATE_NOOP("Data",
                      "A landmark placed by hand lies far from the fitted cochlea, and the voxels "
                      "contradict it: check that landmark in the images."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Fewer than %1 turns of the lumen were seen: the cochlea is malformed, or its "
        "upper turns are filled with bone. No duct length is given, because its "
        "formula assumes %2 turns."),
    QT_TRANSLATE_NOOP(
        "Data",
        "No modiolus was seen within the middle turn: middle and apical turn may be one "
        "cavity (incomplete partition). No duct length is given, because its formula "
        "assumes %1 turns, and H is that of the cavity."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Whether middle and apical turn are one cavity (incomplete partition) could not be "
        "judged: the modiolus is faint, the CT too coarse or too noisy, or the middle turn "
        "not empty. Look for the septum between both turns in a section through the axis, "
        "or take a finer series."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Along a fifth or more of the basal turn nothing distinguishes the lumen from "
        "the bone: it may be ossified; check the outline in the images."),
    QT_TRANSLATE_NOOP(
        "Data",
        "There is metal in or beside the cochlea (an implant?): it hides the wall, so take a CT "
        "from before the implantation."),
    QT_TRANSLATE_NOOP(
        "Data",
        "B does not fit A, or H is beyond that of known cochleae: check the outline in "
        "the images; a malformed cochlea has no A, B and H."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The volume shows a second cochlea: choose the ear by its side, or by a point "
        "in it."),
    QT_TRANSLATE_NOOP(
        "Data",
        "A, B or H between the landmarks placed by hand differs from the fitted one by "
        "more than the errors of both: check the landmarks in the images."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The files of the CT contradict themselves, or something of them is missing: read the "
        "warnings about the series before using the measures."),
    // warnings about a series
    QT_TRANSLATE_NOOP("Data", "%1 scout images were left out."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 slices lie at the position of another; they are dropped if their voxels "
                      "are the same, and the series is refused if not."),
    QT_TRANSLATE_NOOP(
        "Data", "The gantry is tilted by %1 degrees; the volume is resampled to right angles."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 images with its series number are of another patient or study and "
                      "are listed apart. Check which of them belong together."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 images with its series number are of another frame of reference "
                      "and are listed apart. Check which of them belong together."),
    QT_TRANSLATE_NOOP("Data",
                      "The folder holds images of %1 patients; this series is of one of them. "
                      "Check that it is the right one."),
    QT_TRANSLATE_NOOP("Data",
                      "None of the %1 files that the DICOMDIR names is there; the files in its "
                      "folder were read instead."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 files that the DICOMDIR names are not there; slices may be "
                      "missing. Copy the whole medium."),
    QT_TRANSLATE_NOOP("Data", "Its images were compressed with loss; fine edges may be gone."),
    QT_TRANSLATE_NOOP("Data",
                      "Its images were computed from others, as reformatted planes are; original "
                      "ones are sharper."),
    QT_TRANSLATE_NOOP("Data", "A voxel is %1 mm long; at most %2 mm is advised for a cochlea."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The volume is only %1 mm thick; a cochlea with its surroundings needs about %2 mm.")};

}  // namespace

bool isCtSentence(const QString& pattern)
{
  for (const char* text : sentences)
    if (pattern == QString::fromUtf8(text)) return true;
  return false;
}

}  // namespace perilymph::gui
