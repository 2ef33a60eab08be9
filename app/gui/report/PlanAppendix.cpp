// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/PlanAppendix.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/report/CtPicture.h"
#include "gui/setup/EarApproach.h"
#include "gui/setup/PlannedFriction.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

namespace {

constexpr std::size_t blocksPerRow = 2;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString heading(const QString& text) { return QStringLiteral("<h2>%1</h2>").arg(text); }

/// @param header  Its first row, repeated on every page.
QString table(const QString& rows, const QString& header = {})
{
  const QString head =
      header.isEmpty() ? QString() : QStringLiteral("<thead>%1</thead>").arg(header);
  return QStringLiteral("<table cellspacing=\"0\" width=\"100%\">%1%2</table>").arg(head, rows);
}

constexpr int contactColumns = 7;

/// The cells of a contact, in columns of fixed width: text would break within its brackets.
QString contactCells(const QStringList& texts, const char* kind)
{
  static constexpr int percents[contactColumns] = {3, 13, 15, 7, 6, 3, 3};
  QString cells;
  for (int i = 0; i < texts.size(); ++i)
    cells += QStringLiteral("<td width=\"%1%\" class=\"%2\">%3</td>")
                 .arg(percents[i])
                 .arg(QLatin1String(kind), texts[i]);
  return cells;
}

/// A cell as wide as those of a contact.
QString wideCell(const QString& text)
{
  return QStringLiteral("<td colspan=\"%1\" class=\"tight\">%2</td>").arg(contactColumns).arg(text);
}

/// Median mismatch in semitones; "–" without a default filter.
QString mismatchText(const planning::ContactBand& contact)
{
  return contact.filter_Hz > 0.0 ? numberText(contact.mismatch_semitones.median, 0)
                                 : QStringLiteral("–");
}

/// The cells of the contacts of one array, from the tip; those that are inserted in no simulation in one.
QStringList contactsOf(const planning::ArrayPlan& array)
{
  QStringList rows, absent;
  for (const planning::ContactBand& each : array.contacts) {
    const QString number = QString::number(each.number);
    if (each.draws == 0)
      absent << number;
    else
      rows << contactCells(
          {number, medianText(each.angle_deg, 0), medianText(each.toModiolus_mm, 2),
           kilohertzText(each.greenwood_Hz), kilohertzText(each.spiralGanglion_Hz),
           mismatchText(each), QString::number(each.draws)},
          "tight");
  }
  if (!absent.isEmpty())
    rows << wideCell(QStringLiteral("<span class=\"quiet\">%1</span>")
                         .arg(tr("Not inserted: %1").arg(absent.join(QStringLiteral(", ")))));
  return rows;
}

/// The contacts of arrays side by side. Not a table within a table: Qt repeats the header of each such
/// table in one place.
QString contactTable(const std::vector<planning::ArrayPlan>& arrays, std::size_t first)
{
  const QString titles = contactCells({QStringLiteral("#"), tr("Angle, °"), tr("Modiolus, mm"),
                                       tr("GW"), tr("SG"), tr("st"), tr("in")},
                                      "quiet tight");
  QString names, columns;
  std::vector<QStringList> cells;
  int count = 0;
  for (std::size_t k = first; k < first + blocksPerRow; ++k) {
    const bool isThere = k < arrays.size();
    names += wideCell(
        isThere ? QStringLiteral("<b>%1</b>").arg(numberedName(arrays[k], k).toHtmlEscaped())
                : QString());
    columns += isThere ? titles : wideCell({});
    cells.push_back(isThere ? contactsOf(arrays[k]) : QStringList());
    count = std::max(count, int(cells.back().size()));
  }
  QString rows;
  for (int i = 0; i < count; ++i) {
    rows += QStringLiteral("<tr>");
    for (const QStringList& own : cells) rows += i < own.size() ? own[i] : wideCell({});
    rows += QStringLiteral("</tr>");
  }
  return table(rows, QStringLiteral("<tr>%1</tr><tr>%2</tr>").arg(names, columns));
}

/// A row of the table of resistances, in columns of fixed width.
QString resistanceRow(const QStringList& texts, const char* kind)
{
  static constexpr int percents[] = {28, 18, 18, 18, 18};
  QString row;
  for (int i = 0; i < texts.size(); ++i)
    row += QStringLiteral("<td width=\"%1%\" class=\"%2\">%3</td>")
               .arg(percents[i])
               .arg(QLatin1String(kind), texts[i]);
  return QStringLiteral("<tr>%1</tr>").arg(row);
}

/// Where a surgeon would feel the first resistance, and how often the published strengths of the
/// partition are reached.
QString resistances(const PlanReportContent& content, References& references)
{
  const planning::Thresholds& thresholds = content.plan().thresholds;
  const auto force = [](Force value) { return numberText(inMillinewtons(value), 1); };
  const QString felt = force(thresholds.felt), weakest = force(thresholds.ruptureLow),
                strongest = force(thresholds.ruptureHigh);
  const auto& arrays = content.plan().arrays;
  const bool isCounted = arrays.front().draws < analysis::fewestForPercent;
  const QString reaches = isCounted ? tr("≥ %1 mN") : tr("≥ %1 mN, %");
  const QString header = resistanceRow(
      {tr("Array"), tr("First resistance, mm"), isCounted ? tr("felt") : tr("felt, %"),
       reaches.arg(weakest), reaches.arg(strongest)},
      "quiet tight");
  QString rows;
  for (std::size_t i = 0; i < arrays.size(); ++i)
    rows += resistanceRow({numberedName(arrays[i], i).toHtmlEscaped(),
                           arrays[i].felt.value > 0.0 ? medianText(arrays[i].firstResistance_mm, 1)
                                                      : QStringLiteral("–"),
                           chanceText(arrays[i].felt, arrays[i].draws),
                           chanceText(arrays[i].reachesWeakest, arrays[i].draws),
                           chanceText(arrays[i].reachesStrongest, arrays[i].draws)},
                          "tight");
  return heading(tr("First resistance and force on the partition: median (band)")) +
         table(rows, header) +
         QStringLiteral("<p class=\"quiet\">%1</p>")
             .arg(tr("First resistance: depth of the tip past the opening where the insertion "
                     "force first reaches %1 mN, the median force that surgeons detect %4, over "
                     "the simulations in which it does; felt: that it does. ≥ %2 and ≥ %3 mN: that "
                     "the "
                     "force on the cochlear partition reaches its weakest and its strongest "
                     "assumed strength; original not available.")
                      .arg(felt, weakest, strongest, references.label("Kratchman")));
}

/// Forces on the hand at the end of the push and at rest.
QString endForces(const PlanReportContent& content)
{
  const QString header = resistanceRow(
      {tr("Array"), tr("End force, mN"), tr("after 1 s, mN"), tr("after 10 s, mN"), QString()},
      "quiet tight");
  QString rows;
  const auto& arrays = content.plan().arrays;
  bool isOfRest = true;  // of a version that read the end force after 2 s of rest
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    QStringList cells{numberedName(arrays[i], i).toHtmlEscaped(), medianText(arrays[i].end_mN, 1)};
    for (const planning::Band& band : {arrays[i].after1s_mN, arrays[i].after10s_mN}) {
      const bool isKnown = band.low != 0.0 || band.high != 0.0;
      cells << (isKnown ? medianText(band, 1) : QStringLiteral("–"));
      isOfRest = isOfRest && !isKnown;
    }
    rows += resistanceRow(cells << QString(), "tight");
  }
  const QString method =
      isOfRest ? tr("End force: mean of the last half second of 2 s of rest, as the program that "
                    "made this plan read it.")
               : tr("End force: at the stop, by the line through the last half second of motion; "
                    "then means of the half second before 1 s and before 10 s of rest.");
  return heading(tr("Force at the end and at rest: median (band)")) + table(rows, header) +
         QStringLiteral("<p class=\"quiet\">%1</p>").arg(method);
}

/// Angle and forces at the median of the drawn friction; nothing where it states no spread.
QString atMedianFriction(const PlanReportContent& content)
{
  const QString header = resistanceRow({tr("Array"), tr("Angular depth, °"), tr("Depth, mm"),
                                        tr("Peak force, mN"), tr("End force, mN")},
                                       "quiet tight");
  QString rows;
  const auto& arrays = content.plan().arrays;
  bool isKnown = false;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const auto& found = arrays[i].atMedianFriction;
    if (!found) continue;
    isKnown = true;
    rows += resistanceRow({numberedName(arrays[i], i).toHtmlEscaped(),
                           medianText(found->angle_deg, 0), medianText(found->depth_mm, 1),
                           medianText(found->peak_mN, 1), medianText(found->end_mN, 1)},
                          "tight");
  }
  if (!isKnown) return {};
  return heading(tr("At friction %1 only: median (band)")
                     .arg(numberText(content.plan().friction.low, 3))) +
         table(rows, header) +
         QStringLiteral("<p class=\"quiet\">%1</p>")
             .arg(tr("From the same simulations, less what follows the logarithm of their "
                     "friction (least squares). All else is still drawn."));
}

/// What two arrays differ by in the same ear; nothing for one array.
QString differences(const PlanReportContent& content)
{
  const planning::Plan& plan = content.plan();
  if (plan.differences.empty()) return {};
  const QString header = resistanceRow({tr("First against second"), tr("Angular depth, °"),
                                        tr("deeper"), tr("Peak force, mN"), tr("higher")},
                                       "quiet tight");
  QString rows;
  for (const planning::ArrayDifference& each : plan.differences)
    rows += resistanceRow({tr("%1 against %2")
                               .arg(QString::fromStdString(plan.arrays[each.first].name),
                                    QString::fromStdString(plan.arrays[each.second].name))
                               .toHtmlEscaped(),
                           differenceText(each.angle_deg), chanceText(each.deeper, each.draws),
                           differenceText(each.peak_mN), chanceText(each.harder, each.draws)},
                          "tight");
  return heading(tr("Differences between arrays in the same ear: median (band)")) +
         table(rows, header) +
         QStringLiteral("<p class=\"quiet\">%1</p>")
             .arg(tr("First minus second, simulation by simulation: cochlea, hand and friction are "
                     "the same for both, so their spread is not in these bands."));
}

QString contacts(const PlanReportContent& content)
{
  const auto& arrays = content.plan().arrays;
  QString tables;
  for (std::size_t i = 0; i < arrays.size(); i += blocksPerRow) tables += contactTable(arrays, i);
  return heading(tr("Contacts, numbered from the tip: median (band)")) + tables +
         QStringLiteral("<p class=\"quiet\">%1</p>")
             .arg(tr(
                 "Angle from the center of the round window. Modiolus: distance from the center "
                 "line of the array to the inner wall. GW: frequency by Greenwood's map, kHz, "
                 "at the "
                 "place on the organ of Corti. SG: frequency of the spiral ganglion, kHz, at the "
                 "angle; st: its semitones above the center of the default filter; in: "
                 "number of simulations in which the contact is inside; its row is of these."));
}

/// A row with a name and a text.
QString row(const QString& name, const QString& text)
{
  return QStringLiteral(
             "<tr><td width=\"18%\" class=\"quiet tight\">%1</td><td class=\"tight\">%2</td></tr>")
      .arg(name, text);
}

QString confidenceText(const std::string& confidence)
{
  if (confidence == "high") return tr("confidence high");
  if (confidence == "medium") return tr("confidence medium");
  return confidence == "low" ? tr("confidence low") : QString();
}

/// A table of a distribution's file, for people.
QString inputName(const std::string& name)
{
  static constexpr const char* names[][2] = {
      {"speed", QT_TRANSLATE_NOOP("perilymph::gui", "Insertion speed")},
      {"tremor", QT_TRANSLATE_NOOP("perilymph::gui", "Tremor")},
      {"free_length", QT_TRANSLATE_NOOP("perilymph::gui", "Grip: length before the opening")},
      {"stop", QT_TRANSLATE_NOOP("perilymph::gui", "Force limit of the surgeon")},
      {"intended_depth", QT_TRANSLATE_NOOP("perilymph::gui", "Depth that the surgeon intends")},
      {"rest", QT_TRANSLATE_NOOP("perilymph::gui", "Rest before the final force")},
      {"buckling", QT_TRANSLATE_NOOP("perilymph::gui", "Visible buckling")},
      {"friction", QT_TRANSLATE_NOOP("perilymph::gui", "Friction")},
      {"rupture", QT_TRANSLATE_NOOP("perilymph::gui", "Strength of the cochlear partition")},
      {"stiffness", QT_TRANSLATE_NOOP("perilymph::gui", "Stiffness of the array")},
      {"wires", QT_TRANSLATE_NOOP("perilymph::gui", "Packing of the wires")},
      {"taper", QT_TRANSLATE_NOOP("perilymph::gui", "Taper of the array")},
      {"approach", QT_TRANSLATE_NOOP("perilymph::gui", "Approach to the opening")},
      {"section", QT_TRANSLATE_NOOP("perilymph::gui", "Sections of the scala tympani")},
      {"course", QT_TRANSLATE_NOOP("perilymph::gui", "Course of the center line")},
      {"radius", QT_TRANSLATE_NOOP("perilymph::gui", "Waves of the outer wall")},
      {"height", QT_TRANSLATE_NOOP("perilymph::gui", "Height without a measured H")},
      {"lining", QT_TRANSLATE_NOOP("perilymph::gui", "Soft lining of the wall")},
      {"membrane", QT_TRANSLATE_NOOP("perilymph::gui", "Stiffness of the basilar membrane")}};
  for (const auto& [key, text] : names)
    if (name == key) return tr(text);
  return tr("Default filters: %1").arg(QString::fromStdString(name));
}

QString sources(const PlanReportContent& content, References& references)
{
  constexpr std::size_t inARow = 2;
  QString rows;
  const auto& all = content.stored.sources;
  for (std::size_t i = 0; i < all.size(); i += inARow) {
    rows += QStringLiteral("<tr>");
    for (std::size_t k = i; k < std::min(all.size(), i + inARow); ++k)
      rows += QStringLiteral(
                  "<td width=\"24%\" class=\"quiet tight\">%1</td><td width=\"10%\" "
                  "class=\"tight\">%2</td><td width=\"16%\" class=\"quiet tight\">%3</td>")
                  .arg(inputName(all[k].table).toHtmlEscaped(), references.label(all[k].source),
                       confidenceText(all[k].confidence));
    rows += QStringLiteral("</tr>");
  }
  return heading(tr("Inputs and their sources")) + table(rows);
}

QString limits(const PlanReportContent& content)
{
  QString items;
  for (const Sentence& limit : content.stored.limits)
    items += QStringLiteral("<li>%1</li>").arg(dataText(limit).toHtmlEscaped());
  return heading(tr("Limits")) + QStringLiteral("<ul>%1</ul>").arg(items);
}

QString marks(const PlanReportContent& content)
{
  const planning::Plan& plan = content.plan();
  const anatomy::MeasurementOrigin& origin = plan.request.patient.origin;
  const auto from = [](const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped();
  };
  QString rows =
      row(tr("Plan, SHA-256"), content.number().toHtmlEscaped()) +
      row(tr("Planned by"), from(content.stored.program)) + row(tr("Report by"), from(buildId())) +
      row(tr("Scenario"), from(plan.request.scenario)) +
      row(tr("Friction"), plannedFriction(plan).toHtmlEscaped()) +
      row(tr("Approach"), approachText({anatomy::AnatomySource::mean, plan.request.patient},
                                       plan.request.approach.value_or(anatomy::Approach{}))
                              .toHtmlEscaped()) +
      row(tr("Seed"), QString::number(plan.request.seed));
  rows += row(tr("CT series, SHA-256"), plan.request.patient.seal == Seal::changed
                                            ? tr("none: the measures were changed")
                                        : origin.seriesKey.empty() ? tr("none stated")
                                                                   : from(origin.seriesKey));
  return heading(tr("Traceability")) + table(rows);
}

}  // namespace

QString planAppendixText(const PlanReportContent& content, References& references)
{
  const QString text =
      QStringLiteral("<h1>%1</h1>").arg(tr("Appendix: resistance, contacts and sources")) +
      ctPictureText(content.plan().request.patient) + atMedianFriction(content) +
      differences(content) + resistances(content, references) + endForces(content) +
      contacts(content) + limits(content) + sources(content, references) + marks(content);
  return text + references.list();  // of what the text cites
}

}  // namespace perilymph::gui
