// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/DataText.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include "gui/parts/CtSentences.h"
#include "gui/parts/SourceText.h"

namespace perilymph::gui {

namespace {

// Texts with their numbers replaced by %1, %2 and so on. lupdate reads them here.
constexpr const char* shipped[] = {
    // titles of the shipped scenarios
    QT_TRANSLATE_NOOP("Data", "Booth: FLEX24 in the mean cochlea, tissue-like friction"),
    QT_TRANSLATE_NOOP("Data", "Published experiment: Nucleus %1 Contour, %2 mm/s, soap"),
    QT_TRANSLATE_NOOP("Data", "Mean scala tympani: Nucleus %1 Contour, %2 mm/s, soap"),
    QT_TRANSLATE_NOOP("Data", "Mean scala tympani: FLEX28, %1 mm/s, soap %2 %"),
    // what differs from a preset; "speed" is one of the score
    QT_TRANSLATE_NOOP("Data", "patient"), QT_TRANSLATE_NOOP("Data", "ear"),
    QT_TRANSLATE_NOOP("Data", "anatomy"), QT_TRANSLATE_NOOP("Data", "array"),
    QT_TRANSLATE_NOOP("Data", "calibration"), QT_TRANSLATE_NOOP("Data", "technique"),
    QT_TRANSLATE_NOOP("Data", "full depth"), QT_TRANSLATE_NOOP("Data", "friction"),
    QT_TRANSLATE_NOOP("Data", "opening"), QT_TRANSLATE_NOOP("Data", "model"),
    QT_TRANSLATE_NOOP("Data", "nodes"), QT_TRANSLATE_NOOP("Data", "force scale"),
    // input devices without hardware
    QT_TRANSLATE_NOOP("Data", "Scripted insertion"),
    QT_TRANSLATE_NOOP("Data", "Mouse and keyboard"), QT_TRANSLATE_NOOP("Data", "Recorded hand"),
    QT_TRANSLATE_NOOP("Data", "Surgery: FLEX28 through the round window"),
    QT_TRANSLATE_NOOP("Data", "largest difference of the predicted"),
    QT_TRANSLATE_NOOP("Data", "raw force at the basal turn"),
    // titles of frictions
    QT_TRANSLATE_NOOP("Data", "Lubricated silicone (published)"),
    QT_TRANSLATE_NOOP("Data", "Soap %1 %: speed-independent"),
    QT_TRANSLATE_NOOP("Data", "Soap %1 %: decreases with speed"),
    QT_TRANSLATE_NOOP("Data", "Soap %1 %: increases with speed"),
    QT_TRANSLATE_NOOP("Data", "Tissue-like (endosteum simulant)"),
    QT_TRANSLATE_NOOP("Data", "Endosteum: low end of the reported range"),
    // score
    QT_TRANSLATE_NOOP("Data", "speed"), QT_TRANSLATE_NOOP("Data", "reversals"),
    QT_TRANSLATE_NOOP("Data", "peak force"), QT_TRANSLATE_NOOP("Data", "smoothness"),
    QT_TRANSLATE_NOOP("Data", "%1 % of the insertion at %2–%3 mm/s"),
    QT_TRANSLATE_NOOP("Data", "%1 before maximum insertion depth"),
    QT_TRANSLATE_NOOP("Data", "%1 % of the time at rest (below %2 mm/s)"),
    QT_TRANSLATE_NOOP("Data",
                      "full score if the whole insertion is within %1–%2 mm/s, none at %3 %"),
    QT_TRANSLATE_NOOP("Data", "full score at %1, none from %2"),
    QT_TRANSLATE_NOOP("Data", "full score at %1 %, none from %2 %"),
    QT_TRANSLATE_NOOP("Data", "full score up to %1 mN, none from %2 mN"),
    QT_TRANSLATE_NOOP("Data",
                      "robotic insertion %1–%2 mm/s (iotaSOFT); manual insertion in cadaver heads "
                      "%3 ± %4 mm/s; phantom study %5–%6 mm/s (Froehlich et al. %7)"),
    QT_TRANSLATE_NOOP(
        "Data", "Kesler et al. %1: %2 reversals in manual insertions at a target of %3 mm/min"),
    QT_TRANSLATE_NOOP(
        "Data",
        "Kesler et al. %1: manual insertions at a target of %2 mm/min paused %3 % of the time"),
    QT_TRANSLATE_NOOP("Data", "Rau et al. %1: peaks %2 to %3 mN"),
    // validation
    QT_TRANSLATE_NOOP("Data", "force at %1 mm, peak"),
    QT_TRANSLATE_NOOP("Data", "force at %1 mm, dip"),
    QT_TRANSLATE_NOOP("Data", "force at %1 mm, maximum"),
    QT_TRANSLATE_NOOP("Data", "force at %1 mm, end"),
    QT_TRANSLATE_NOOP("Data", "largest of these differences"),
    QT_TRANSLATE_NOOP("Data", "largest difference below perception"),
    QT_TRANSLATE_NOOP("Data", "position of the basal-turn peak"),
    QT_TRANSLATE_NOOP("Data", "position of the following dip"),
    QT_TRANSLATE_NOOP("Data", "small early peak"),
    QT_TRANSLATE_NOOP("Data", "raw force just before the first rib"),
    QT_TRANSLATE_NOOP("Data", "raw force at the first rib"),
    QT_TRANSLATE_NOOP("Data", "standard deviation at %1 mm, peak"),
    QT_TRANSLATE_NOOP("Data", "standard deviation at %1 mm, dip"),
    QT_TRANSLATE_NOOP("Data", "standard deviation at %1 mm, maximum"),
    QT_TRANSLATE_NOOP("Data", "standard deviation at %1 mm, end"),
    QT_TRANSLATE_NOOP("Data", "at most %1 N"), QT_TRANSLATE_NOOP("Data", "at most %1 mN"),
    QT_TRANSLATE_NOOP("Data", "between %1 and %2 mm"), QT_TRANSLATE_NOOP("Data", "%1 to %2 N"),
    QT_TRANSLATE_NOOP("Data", "%1 to %2 mN"), QT_TRANSLATE_NOOP("Data", "none"),
    QT_TRANSLATE_NOOP("Data", "%1 N"), QT_TRANSLATE_NOOP("Data", "%1 mN"),
    QT_TRANSLATE_NOOP("Data", "%1 mm"), QT_TRANSLATE_NOOP("Data", "%1 ± %2 N"),
    QT_TRANSLATE_NOOP("Data", "%1 ± %2 mN"), QT_TRANSLATE_NOOP("Data", "%1 mm ± %2 mm"),
    // figures
    QT_TRANSLATE_NOOP("Data", "travel, mm"), QT_TRANSLATE_NOOP("Data", "insertion force, N"),
    QT_TRANSLATE_NOOP("Data", "insertion force, mN"),
    QT_TRANSLATE_NOOP("Data", "difference of mean insertion force, N"),
    QT_TRANSLATE_NOOP("Data", "difference of mean insertion force, mN"),
    QT_TRANSLATE_NOOP("Data", "Published forces"),
    QT_TRANSLATE_NOOP("Data", "experiment, mean ± SD"),
    QT_TRANSLATE_NOOP("Data", "published simulator, mean ± SD"),
    QT_TRANSLATE_NOOP("Data", "published measurements, mean ± SD"),
    QT_TRANSLATE_NOOP(
        "Data", "Todd and Naghdy: Nucleus %1 Contour, synthetic scala tympani, soap, %2 mm/s."),
    QT_TRANSLATE_NOOP("Data", "Values between points were not reported."),
    QT_TRANSLATE_NOOP("Data", "Simulated insertions and the published experiment"),
    QT_TRANSLATE_NOOP("Data", "± SD between insertions"),
    QT_TRANSLATE_NOOP("Data", "%1 % confidence interval of the mean"),
    QT_TRANSLATE_NOOP("Data", "mean of %1 simulated insertions"),
    QT_TRANSLATE_NOOP("Data", "perception threshold, median %1 mN"),
    QT_TRANSLATE_NOOP("Data", "perception threshold ± %1 mN"),
    QT_TRANSLATE_NOOP(
        "Data", "Seed %1; least-squares spline through each insertion, resampled every %2 mm."),
    QT_TRANSLATE_NOOP("Data", "All %1 insertions reached the end."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 insertions reached the end; %3 bowed in front of the opening and "
                      "slipped out of it (number %4)."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 insertions reached the end; %3 bowed in front of the opening and "
                      "slipped out of it (numbers %4 and %5)."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 insertions reached the end; %3 bowed in front of the opening and "
                      "slipped out of it (numbers %4, %5 and %6)."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 of %2 insertions reached the end; %3 buckled in front of the opening (number %4)."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 insertions reached the end; %3 buckled in front of the opening "
                      "(numbers %4 and %5)."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 insertions reached the end; %3 buckled in front of the opening "
                      "(numbers %4, %5 and %6)."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 of %2 insertions reached the end; %3 stopped with a fault (number %4)."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 of %2 insertions reached the end; %3 stopped with a fault (numbers %4 and %5)."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 of %2 insertions reached the end; %3 stopped with a fault (numbers %4, %5 and %6)."),
    // plans
    QT_TRANSLATE_NOOP("Data", "%1 % at friction %2"),
    QT_TRANSLATE_NOOP("Data", "%1 % at friction %2 to %3"),
    QT_TRANSLATE_NOOP("Data", "%1 % at one friction"), QT_TRANSLATE_NOOP("Data", "approach tilt"),
    QT_TRANSLATE_NOOP("Data", "approach turn"), QT_TRANSLATE_NOOP("Data", "stiffness"),
    QT_TRANSLATE_NOOP("Data", "force limit"), QT_TRANSLATE_NOOP("Data", "share of A"),
    QT_TRANSLATE_NOOP("Data", "share of B"), QT_TRANSLATE_NOOP("Data", "section at the base"),
    QT_TRANSLATE_NOOP("Data", "section in the second turn"),
    QT_TRANSLATE_NOOP("Data", "dip of the basal turn"),
    QT_TRANSLATE_NOOP("Data", "wave of the outer wall"),
    QT_TRANSLATE_NOOP("Data", "height without H"), QT_TRANSLATE_NOOP("Data", "lining"),
    QT_TRANSLATE_NOOP("Data", "membrane"),
    QT_TRANSLATE_NOOP("Data",
                      "The shape of the cochlea is the mean one, scaled to A, B and H; sections, "
                      "course of the center line and outer wall vary along it as in few measured "
                      "ears. Outline and tilt of the sections are those of the mean."),
    QT_TRANSLATE_NOOP("Data",
                      "The force on the partition is the sum on the basilar membrane, as former "
                      "versions computed it: not the force that ruptures."),
    QT_TRANSLATE_NOOP("Data",
                      "Insertions have longer steps than the scenario: their median angle differs "
                      "by up to %1 degrees."),
    QT_TRANSLATE_NOOP("Data",
                      "The partition ruptures at one strength, bone and membrane alike, into a "
                      "mirrored scala vestibuli. The model gives fewer translocations than clinics "
                      "report."),
    QT_TRANSLATE_NOOP("Data",
                      "No friction in a living ear is known. The default, %1, is the low end of "
                      "what is reported for arrays on endosteum, chosen with the depths in view "
                      "that clinics report: four of five straight arrays come within %2 degrees of "
                      "them, FLEXSOFT stops %3 short. With the friction of a tissue simulant "
                      "straight arrays stop at %4 to %5."),
    QT_TRANSLATE_NOOP("Data",
                      "Errors of A, B and H are independent unless the patient's file states their "
                      "correlations."),
    QT_TRANSLATE_NOOP("Data",
                      "The strength of the cochlear partition and the surgeon's force limit rest "
                      "on few publications; see sources."),
    QT_TRANSLATE_NOOP("Data", "Ends are those of the model: a probability is not a clinical risk."),
    QT_TRANSLATE_NOOP("Data", "Simulator minus experiment"),
    QT_TRANSLATE_NOOP("Data", "this simulator, %1 % confidence interval"),
    QT_TRANSLATE_NOOP(
        "Data", "published simulator, %1 % confidence interval where reported (sign corrected)"),
    QT_TRANSLATE_NOOP("Data",
                      "Shown only where the experiment was reported; its means are from about %1 "
                      "insertions."),
    QT_TRANSLATE_NOOP("Data", "Recorded insertions: insertion force over travel"),
    // formulas of a patient's measures, and their sources
    QT_TRANSLATE_NOOP("Data", "path of the organ of Corti in the plan, round window to apex"),
    QT_TRANSLATE_NOOP("Data", "measured in this model, defined as in Todd and Naghdy"),
    QT_TRANSLATE_NOOP("Data", "Alexiades et al. %1, Otol Neurotol %2:%3"),
    QT_TRANSLATE_NOOP("Data",
                      "turn angle of the likeliest half-diameters with these A and B / %1 deg"),
    QT_TRANSLATE_NOOP("Data", "Pietsch et al. %1, Sci Rep, n = %2; constants seen in public code"),
    QT_TRANSLATE_NOOP("Data",
                      "angle at which a path along the lateral wall is as long as the array"),
    QT_TRANSLATE_NOOP("Data", "organ-of-Corti path up to that angle / whole path"),
    QT_TRANSLATE_NOOP("Data", "geometry of this model; real insertions end earlier")};

/// A text with placeholders, and the numbers they stand for.
struct Pattern {
  QString text;
  QStringList numbers;
};

Pattern patternOf(const QString& text)
{
  static const QRegularExpression number(QStringLiteral("(?<![A-Za-z0-9.])[0-9]+(\\.[0-9]+)?"));
  Pattern pattern;
  int end = 0;
  for (auto found = number.globalMatch(text); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    pattern.numbers << match.captured();
    pattern.text += text.mid(end, match.capturedStart() - end) +
                    QStringLiteral("%%1").arg(pattern.numbers.size());
    end = match.capturedEnd();
  }
  pattern.text += text.mid(end);
  return pattern;
}

bool isShipped(const QString& pattern)
{
  for (const char* text : shipped)
    if (pattern == QString::fromUtf8(text)) return true;
  return isShippedSource(pattern) || isCtSentence(pattern);
}

}  // namespace

QString dataText(const std::string& text)
{
  const QString english = QString::fromStdString(text);
  const Pattern pattern = patternOf(english);
  if (!isShipped(pattern.text)) return english;
  QString filled = QCoreApplication::translate("Data", pattern.text.toUtf8().constData());
  // the highest first, so that %1 does not match the beginning of %10
  for (int i = pattern.numbers.size(); i > 0; --i) {
    QString number = pattern.numbers[i - 1];
    number.replace(QLatin1Char('.'), QLocale().decimalPoint());
    filled.replace(QStringLiteral("%%1").arg(i), number);
  }
  return filled;
}

figures::Figure translated(figures::Figure figure)
{
  const auto translate = [](std::string& text) { text = dataText(text).toStdString(); };
  translate(figure.title);
  translate(figure.x.title);
  translate(figure.y.title);
  for (auto& band : figure.bands) translate(band.label);
  for (auto& level : figure.levels) translate(level.label);
  for (auto& curve : figure.curves) translate(curve.label);
  for (auto& values : figure.values) translate(values.label);
  for (std::string& note : figure.notes) translate(note);
  return figure;
}

}  // namespace perilymph::gui
