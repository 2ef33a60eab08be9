// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/OutcomeWords.h"

#include <QCoreApplication>
#include <array>
#include <cmath>
#include <utility>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/outcome/ClinicLibrary.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

QString contactText(const outcome::FoundContact& contact)
{
  const QString number = QString::number(contact.number);
  return contact.makerElectrode ? tr("%1 (E%2)").arg(number).arg(*contact.makerElectrode) : number;
}

QString angleText(const outcome::FoundContact& contact)
{
  if (!contact.isInside) return tr("outside");
  const auto interval = contact.angle_deg.interval95();
  // a minus beside a dash is misread
  const QString form = interval[0] < 0.0 ? tr("%1 (%2 to %3)°") : tr("%1 (%2–%3)°");
  return form.arg(numberText(contact.angle_deg.value, 0), numberText(interval[0], 0),
                  numberText(interval[1], 0));
}

QString scalaText(const outcome::FoundContact& contact)
{
  return contact.isInside ? tr("%1 %").arg(numberText(100.0 * contact.inScalaTympani, 0)) : tr("–");
}

QString placementText(const outcome::FoundContact& contact)
{
  if (contact.isByHand) return tr("by hand");
  return contact.isSeenSingly ? tr("singly") : tr("by spacing");
}

QString frequencyText(const std::array<double, 3>& frequency_Hz)
{
  if (frequency_Hz[0] <= 0.0) return tr("–");
  return tr("%1 (%2–%3) kHz")
      .arg(kilohertzText(frequency_Hz[0]), kilohertzText(frequency_Hz[1]),
           kilohertzText(frequency_Hz[2]));
}

QString mismatchText(const outcome::FoundContact& contact)
{
  if (contact.filter_Hz <= 0.0) return tr("–");
  const auto [low, high] = contact.mismatch95_semitones();
  const QString form = low < 0.0 ? tr("%1 (%2 to %3)") : tr("%1 (%2–%3)");
  return form.arg(numberText(contact.mismatch_semitones, 0), numberText(low, 0),
                  numberText(high, 0));
}

std::optional<double> percentileIn(const planning::Band& band, double value)
{
  const std::array<std::pair<double, double>, 5> quantiles{{{5.0, band.low},
                                                            {25.0, band.lowerQuartile},
                                                            {50.0, band.median},
                                                            {75.0, band.upperQuartile},
                                                            {95.0, band.high}}};
  for (std::size_t k = 0; k + 1 < quantiles.size(); ++k) {
    const auto& [below, from] = quantiles[k];
    const auto& [above, to] = quantiles[k + 1];
    if (value < from || value > to) continue;
    return to > from ? below + (above - below) * (value - from) / (to - from) : below;
  }
  return std::nullopt;
}

QString percentileText(const planning::Band& band, double value)
{
  const auto percentile = percentileIn(band, value);
  if (percentile) return tr("%1 %").arg(numberText(*percentile, 0));
  return value < band.low ? tr("below 5 %") : tr("above 95 %");
}

QString percentileText(const std::vector<double>& simulated, const planning::Band& band,
                       const outcome::Uncertain& found)
{
  if (simulated.empty()) return percentileText(band, found.value);
  return tr("%1 %").arg(numberText(100.0 * outcome::percentileAmong(simulated, found), 0));
}

QString bandWords(const planning::Band& band, int decimals, const QString& unit)
{
  return tr("%1 (%2–%3)%4")
      .arg(numberText(band.median, decimals), numberText(band.low, decimals),
           numberText(band.high, decimals), unit);
}

QString arrayTitle(const std::string& name)
{
  if (const auto file = findByName("array", "plugins/electrodes", name))
    if (const auto array = electrode::loadArray(*file)) return QString::fromStdString(array->name);
  return QString::fromStdString(name);
}

QString textOf(outcome::StopReason reason)
{
  switch (reason) {
    case outcome::StopReason::unknown:
      return tr("not known");
    case outcome::StopReason::mark:
      return tr("mark reached");
    case outcome::StopReason::resistance:
      return tr("resistance");
    case outcome::StopReason::buckling:
      return tr("bowed outside");
    case outcome::StopReason::hearing:
      return tr("hearing");
    case outcome::StopReason::bleeding:
      return tr("bleeding");
    case outcome::StopReason::other:
      break;
  }
  return tr("other");
}

QString textOf(outcome::Opening opening)
{
  switch (opening) {
    case outcome::Opening::unknown:
      return tr("not known");
    case outcome::Opening::roundWindow:
      return tr("round window");
    case outcome::Opening::extendedRoundWindow:
      return tr("extended RW");
    case outcome::Opening::cochleostomy:
      break;
  }
  return tr("cochleostomy");
}

QString textOf(outcome::Tool tool)
{
  switch (tool) {
    case outcome::Tool::unknown:
      return tr("not known");
    case outcome::Tool::forceps:
      return tr("forceps");
    case outcome::Tool::sheath:
      return tr("sheath");
    case outcome::Tool::stylet:
      return tr("stylet");
    case outcome::Tool::advanceOffStylet:
      return tr("off-stylet");
    case outcome::Tool::robot:
      break;
  }
  return tr("robot");
}

QString depthText(const outcome::FoundArray& found)
{
  const auto interval = found.angularInsertionDepth_deg.interval95();
  return tr("%1 (%2–%3)°")
      .arg(numberText(found.angularInsertionDepth_deg.value, 0), numberText(interval[0], 0),
           numberText(interval[1], 0));
}

QString insertedText(const outcome::FoundArray& found)
{
  const outcome::Uncertain length{found.insertedLength_mm, found.insertedLengthSd_mm};
  const auto interval = length.interval95();
  return tr("%1 (%2–%3) mm")
      .arg(numberText(length.value, 1), numberText(interval[0], 1), numberText(interval[1], 1));
}

QString insideText(const outcome::FoundArray& found)
{
  return tr("%1 of %2").arg(found.contactsInside).arg(found.contacts.size());
}

QString earSourceText(const outcome::FoundArray& found)
{
  return found.isRegistered ? tr("ear carried over from the CT before surgery, residual %1 mm")
                                  .arg(numberText(found.residual_mm, 2))
                            : tr("the ear is measured in this CT, with wider errors");
}

QString predictionDoubt(const std::string& planMadeUtc, const std::string& ctDay,
                        const outcome::Surgery& surgery)
{
  const std::string surgeryDay = outcome::surgeryDay(ctDay, surgery);
  if (ctDay.empty())
    return tr(
        "Whether the plan was made before surgery is not known: the CT states no day. Type Day of "
        "the CT, else it is not counted among the outcomes.");
  if (surgeryDay.empty())
    return tr(
        "Whether the plan was made before surgery is not known. Type Days from surgery to CT, else "
        "it is not counted among the outcomes.");
  if (!outcome::isPrediction(planMadeUtc, surgeryDay))
    return tr(
        "The plan was made after surgery: it is no prediction, and is not counted among the "
        "outcomes.");
  return {};
}

QStringList flagTexts(const outcome::FoundArray& found)
{
  QStringList sentences;
  for (const outcome::Flag flag : found.flags) sentences << dataText(outcome::sentenceOf(flag));
  return sentences;
}

QStringList contradictionTexts(const outcome::Surgery& surgery, const outcome::FoundArray& found)
{
  QStringList sentences;
  const int outside = int(found.contacts.size()) - found.contactsInside;
  if (surgery.contactsOutside && *surgery.contactsOutside != outside)
    sentences << tr("Contacts outside: %1 as the surgeon states, %2 in the CT.")
                     .arg(*surgery.contactsOutside)
                     .arg(outside);
  if (surgery.isMarkReached == true && surgery.intendedDepth) {
    constexpr double mark_mm = 1.0;  // a mark is read, and the array slips back, within it (choice)
    const double intended_mm = inMillimeters(*surgery.intendedDepth);
    if (std::fabs(intended_mm - found.insertedLength_mm) >
        mark_mm + 1.96 * found.insertedLengthSd_mm)
      sentences << tr("The mark at %1 mm was reached as the surgeon states, and %2 mm are inserted "
                      "in the "
                      "CT.")
                       .arg(numberText(intended_mm, 1), numberText(found.insertedLength_mm, 1));
  }
  return sentences;
}

}  // namespace perilymph::gui
