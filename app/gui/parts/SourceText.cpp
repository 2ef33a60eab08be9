// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/SourceText.h"

#include <QCoreApplication>

namespace perilymph::gui {

namespace {

// Sources of values in shipped files, with their numbers replaced by %1, %2 and so on. lupdate reads
// them here.
constexpr const char* sources[] = {
    // resources/clinical, resources/planning
    QT_TRANSLATE_NOOP("Data",
                      "Clinical and Experimental Otorhinolaryngology, nine neurotologists in "
                      "cadaver heads: %1 +- %2 mm/s; a robot's %3 as the lower limit."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Microsurgeons: %1 mm in vivo, %2 at rest, %3 while actuating; that these are distances in "
        "three axes is an assumption. %4 Hz: otosurgery (Muerbe %5)."),
    QT_TRANSLATE_NOOP("Data",
                      "Choice: forceps take the array a few millimeters in front of the opening "
                      "and advance it in strokes."),
    QT_TRANSLATE_NOOP("Data",
                      "Peak forces in vivo, %1 to %2 mN (Rau et al. %3, Front Neurol %4:%5), read "
                      "as the forces at which surgeons stop: the predicted peak rests on it."),
    QT_TRANSLATE_NOOP("Data", "Choice. Relaxation of the silicone itself is not computed."),
    QT_TRANSLATE_NOOP("Data", "Choice: a bow of %1 mm on %2 mm."),
    QT_TRANSLATE_NOOP("Data",
                      "Dohr et al. %1, Appl. Sci. %2:%3: %4 +- %5 and %6 +- %7, a fifth to a "
                      "quarter; %8 +- %9 at %10 mm/s is wider."),
    QT_TRANSLATE_NOOP("Data",
                      "Schuster et al. %1, Otol Neurotol %2:%3, fresh human partition: %4 to %5 "
                      "mN, mean %6, as recalled, not read; the standard deviation is a choice."),
    QT_TRANSLATE_NOOP("Data",
                      "Choice by the confidence that the array's file gives its bending stiffness: "
                      "no maker publishes a stiffness or its tolerance."),
    QT_TRANSLATE_NOOP("Data",
                      "Choice: what the view through the facial recess leaves to correct. No "
                      "source states it for insertions by hand."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 to %2 Hz on %3 channels, the default of MAESTRO for fine-structure strategies, as "
        "listed in public fitting-research code that cites the MAESTRO user manual."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 to %2 Hz on %3 channels: CI Select App manual (NYU Langone) and "
                      "PMC11493529, as listed in public fitting-research code that cites both."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 to %2 Hz on %3 channels (extended low): SoundWave %4 quick reference, as "
                      "listed in public fitting-research code that cites it."),
    // plugins/electrodes
    QT_TRANSLATE_NOOP(
        "Data",
        "Todd and Naghdy: the second rib is at the opening at full insertion, %1 mm of travel "
        "after a start %2 to %3 mm inside, so it touches %4 to %5 mm from the tip; with the latest "
        "start of the validation, %6 mm, at %7 mm, its middle %8 mm behind. The first rib touches "
        "where the forces rise between %9 and %10 mm of travel: %11 to %12 mm from the tip. Height "
        "above the carrier: chosen such that entering a passage %13 mm wide takes the %14 mN by "
        "which the raw record rises at the first rib; length along it: a choice. Low confidence."),
    QT_TRANSLATE_NOOP("Data", "Choice: the tweezers hold %1 mm behind the greatest depth."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 mm: general literature; contacts %2 to %3 mm deep as listed in public research code."),
    QT_TRANSLATE_NOOP("Data",
                      "Tip %1 mm, base %2 mm: general literature, not measured. Between them a "
                      "straight line, a choice."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Estimate by the model of plugins/README.md: silicone of %1 MPa and N(s) platinum-iridium "
        "wires of %2 um, one for each contact nearer to the tip, EI = E_s I + E_w I_w (N + c N^%3) "
        "with c = %4. Order of the published moduli of a straight array (Kha et al. %5)."),
    QT_TRANSLATE_NOOP("Data",
                      "Estimate: a curl that holds the array in the middle of the scala, wider "
                      "than that of a perimodiolar array: radius %1 mm behind, %2 mm near the tip; "
                      "the tip and what lies behind the active part are straight: choices."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 contacts over %2 mm (%3 to %4 mm of depth), pitch about %5 mm, as listed in public "
        "research code. The first contact's place and the contact's length are choices."),
    QT_TRANSLATE_NOOP(
        "Data",
        "EI = E pi d^%1 / %2 of a platinum wire, E = %3 GPa, d = %4 mm, as estimated for the "
        "Contour. Where it ends and the hold depth, about the straight stretch from the round "
        "window to the outer wall of the basal turn, are choices."),
    QT_TRANSLATE_NOOP("Data", "%1 mm: general literature, not measured."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 contacts, pitch %2 mm, %3 mm over all: general literature; public "
                      "research code has %4 mm from the first to the last (%5 to %6 mm of depth). "
                      "The first contact's place and the contact's length are choices."),
    QT_TRANSLATE_NOOP("Data",
                      "Array of %1 to %2 mm, as listed in public research code; its most apical "
                      "contact lies %3 mm deep there, %4 mm behind the tip."),
    QT_TRANSLATE_NOOP("Data",
                      "Tip %1 mm and base %2 mm as the Contour: general literature, not measured. "
                      "Between them the Contour's quarter sine, a choice."),
    QT_TRANSLATE_NOOP("Data",
                      "The soft, conical tip (Softip) is general literature; its radius and the "
                      "length of the cone are choices."),
    QT_TRANSLATE_NOOP("Data",
                      "Estimate: taken to be the carrier of the Contour; the table of contour.toml "
                      "before any calibration."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Estimate: %1 times the curvature of implanted arrays, from the mean angles between "
        "neighboring contacts (Landsberger et al. %2, as tabulated in public research code) and "
        "the pitch below: a carrier that hugs the modiolus curls at least as tightly when free. "
        "The tip and what lies behind the active part are straight: choices."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 contacts over %2 mm (%3 to %4 mm of depth), as listed in public research "
                      "code. The law of the pitch is the Contour's, a choice."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Three marker ribs at the end of the array: general literature; that the last is at the "
        "opening at full depth, their distance of %1 mm, height and length are choices."),
    QT_TRANSLATE_NOOP("Data",
                      "EI = E pi d^%1 / %2 of a platinum wire, E = %3 GPa, d = %4 mm, as estimated "
                      "for the Contour. It ends %5 mm behind the tip, before the soft tip: a "
                      "choice. Hold depth: a choice of the length of the straight stretch from the "
                      "round window to the outer wall of the basal turn."),
    QT_TRANSLATE_NOOP("Data", "Choice: the tweezers hold %1 mm behind the second rib."),
    QT_TRANSLATE_NOOP("Data",
                      "Todd and Naghdy, Real-time haptic modeling and simulation for prosthetic "
                      "insertion: greatest depth %1 mm."),
    QT_TRANSLATE_NOOP("Data",
                      "Tip: Todd and Naghdy, radius %1 mm as measured. Base %2 mm: general "
                      "literature, not measured. Between them a quarter sine, a choice."),
    QT_TRANSLATE_NOOP("Data",
                      "Estimate: %1e-%2 to %3e-%4, growing tenfold from tip to base by exp(%5 s / "
                      "%6 mm), chosen for the order of the published insertion forces. Physical "
                      "bounds %7e-%8 to %9e-%10 N m2, from moduli of the order reported for a "
                      "straight array (Kha et al. %11) and a diameter of %12 to %13 mm."),
    QT_TRANSLATE_NOOP("Data",
                      "Estimate: a perimodiolar curl of radius %1 mm that closes to %2 mm near the "
                      "tip; the tip itself and what lies behind the active part are straight."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 half-band contacts over an active length of %2 mm, pitch %3 to %4 mm "
                      "growing from the tip: general literature, not measured. The first contact's "
                      "place, the law of the pitch and the contact's length are choices."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Centers %1 mm behind where a rib first touches the opening. Second rib: full insertion, "
        "%2 mm (Todd and Naghdy). First rib: the published curves end before it, %3 mm of travel "
        "after a start up to %4 mm inside, so it touches at %5 mm or later; low confidence. Height "
        "above the carrier and length along it: choices, low confidence; the height such that the "
        "rise at the first rib is of the order of the raw record's, %6 to %7 N."),
    QT_TRANSLATE_NOOP(
        "Data",
        "EI = E pi d^%1 / %2 of a platinum wire, E = %3 GPa, d = %4 mm (estimate; %5 to %6 mm "
        "gives %7e-%8 to %9e-%10). That the carrier is straight where it is, is a choice; the "
        "published experiment saw a slight curvature. That it ends %11 mm behind the tip is a "
        "choice made with a look at the experiment: with %12 mm the peak at the basal turn comes "
        "%13 mm earlier and stands higher; the forces behind it hardly depend on it. Hold depth: a "
        "choice, about the straight stretch from the round window to the outer wall of the basal "
        "turn; the published experiment used the standard technique."),
    QT_TRANSLATE_NOOP("Data", "%1 mm, as listed in public research code."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Tip %1 by %2 mm, base %3 by %4 mm: general literature, not measured. That the smaller one "
        "lies within the plane of curl, and the straight line between, are choices."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 contacts over %2 mm, as listed in public research code. The first "
                      "contact's place and the contact's length are choices."),
    QT_TRANSLATE_NOOP("Data",
                      "Tip %1 mm, base %2 mm: general literature, not measured. Between them a "
                      "straight line over the contacts, a choice."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 full bands, %2 mm wide, pitch %3 mm, as listed in public research code. "
                      "The first contact's place is a choice."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 to %2 mm: general literature; its most apical contact lies %3 mm deep as "
                      "listed in public research code, %4 mm behind the tip."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Tip %1 by %2 mm, base %3 by %4 mm: general literature, not measured. That the smaller one "
        "lies within the plane of curl, and the straight line between tip and base, are choices."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Estimate: a perimodiolar curl of radius %1 mm behind that closes to %2 mm near the tip, "
        "at least as tight as implanted perimodiolar arrays (angles of contacts in Landsberger et "
        "al. %3); the tip and what lies behind the active part are straight: choices."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 contacts over %2 mm (%3 to %4 mm of depth), pitch about %5 mm, as listed "
                      "in public research code. The contact's length is a choice."),
    QT_TRANSLATE_NOOP("Data",
                      "EI = E pi (D^%1 - d^%2) / %3 of a polyimide tube, E = %4 GPa, %5 mm outside "
                      "and %6 mm inside: an estimate. It reaches %7 mm past the opening, where the "
                      "basal turn begins, and is held there: a choice."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 to %2 mm: %3 mm possible, %4 mm recommended, as reported in clinical "
                      "studies of the CI422."),
    QT_TRANSLATE_NOOP("Data",
                      "Tip %1 mm, base %2 mm: reported in clinical studies of the CI422. Between "
                      "them a straight line over %3 mm, a choice."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 half-band contacts over %2 mm, pitch about %3 mm, as listed in public research code. "
        "The first contact's place and the contact's length are choices."),
    QT_TRANSLATE_NOOP("Data", "%1 mm: reported in clinical studies of the device."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Tip %1 by %2 mm, base %3 mm: general literature, not measured. That the smaller one lies "
        "within the plane of curl, and the straight line to a round base, are choices."),
    QT_TRANSLATE_NOOP("Data",
                      "Estimate by the model of plugins/README.md: silicone of %1 MPa and N(s) "
                      "platinum-iridium wires of %2 um, one for each contact nearer to the tip, EI "
                      "= E_s I + E_w I_w (N + c N^%3) with c = %4, where the others have %5: a "
                      "waved wire stretches by straightening. Below the published moduli of a "
                      "straight array (Kha et al. %6), whose wires are straight."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 channels with a pitch of %2 mm, %3 mm from the first to the last: "
                      "general literature and clinical studies of the device. The first contact's "
                      "place and the contact's length are choices."),
    QT_TRANSLATE_NOOP("Data", "About %1 to %2 mm: reported in clinical studies of the device."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 contacts, pitch %2 mm (%3 mm with the last pitch counted): general literature, not "
        "measured. The first contact's place and the contact's length are choices."),
    // resources/reference
    QT_TRANSLATE_NOOP("Data",
                      "Schuster et al. %1, Otol Neurotol %2:%3: fresh human cochlear partition, "
                      "mean %4 mN (unverified: original not consulted); force normal to the "
                      "partition, not the insertion force"),
    // notes on a replay
    QT_TRANSLATE_NOOP("Data",
                      "The recording was not closed: it ends where the program was interrupted."),
    QT_TRANSLATE_NOOP(
        "Data", "The model built from the recorded scenario differs from the recorded model."),
    QT_TRANSLATE_NOOP("Data",
                      "Recorded in format %1, which has no hash: that nothing was changed is shown "
                      "by counts, columns, events and the replay alone."),
    QT_TRANSLATE_NOOP("Data", "The recording contains no samples."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 ticks before tick %2 were lost; nothing after them can be compared.")};

}  // namespace

bool isShippedSource(const QString& pattern)
{
  for (const char* text : sources)
    if (pattern == QString::fromUtf8(text)) return true;
  return false;
}

}  // namespace perilymph::gui
