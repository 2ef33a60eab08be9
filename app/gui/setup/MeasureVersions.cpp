// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/MeasureVersions.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "gui/setup/EnteredMeasures.h"
#include "gui/text/Numbers.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/foundation/Normal.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

constexpr std::size_t ductLength = 3;

QString dash() { return QStringLiteral("–"); }

/// The first digits of a series' hash, as the history shows them.
QString shortOf(const std::string& series)
{
  constexpr std::size_t digits = 12;
  return QString::fromStdString(series.substr(0, digits));
}

/// The CT series from which measures of an ear were saved, that of the measures in use first.
std::vector<std::string> seriesOf(const SavedPatient& patient)
{
  std::vector<std::string> series;
  if (auto used = anatomy::statedSeries(patient.patient); !used.empty())
    series.push_back(std::move(used));
  for (const session::PatientScan& scan : patient.record.scans) series.push_back(scan.series);
  return series;
}

int decimalsOf(std::size_t which) { return which == ductLength ? 1 : 2; }

/// A value as its text shows it.
double asShown(double value, std::size_t which)
{
  return QString::number(value, 'f', decimalsOf(which)).toDouble();
}

QString howOf(const anatomy::Patient& patient)
{
  if (!anatomy::isFromCt(patient)) return tr("entered");
  const std::string& byHand = patient.origin.landmarksByHand;
  QString how =
      byHand.empty() ? tr("automatic") : tr("by hand: %1").arg(QString::fromStdString(byHand));
  for (const std::string& each : enteredMeasures(patient))
    how = tr("%1; %2 entered").arg(how, QString::fromStdString(each));
  return how;
}

bool haveSameNumbers(const anatomy::Patient& one, const anatomy::Patient& other)
{
  const auto numbers = [](anatomy::Patient patient) {
    patient.errors.reset();
    patient.origin = {};
    patient.seal = Seal::intact;
    return anatomy::patientText(patient);
  };
  return numbers(one) == numbers(other);
}

}  // namespace

std::vector<MeasureVersion> versionsOf(const SavedPatient& patient)
{
  const std::string used = anatomy::patientText(patient.patient);
  std::vector<MeasureVersion> versions;
  bool isUsedKnown = false;
  for (auto each = patient.record.versions.rbegin(); each != patient.record.versions.rend();
       ++each) {
    const auto read = anatomy::patientIn(each->patient, patient.file.string());
    if (!read) continue;
    const bool isUsed = !isUsedKnown && each->patient == used;
    isUsedKnown = isUsedKnown || isUsed;
    versions.push_back({*read, each->savedUtc, howOf(*read), isUsed});
  }
  if (!isUsedKnown)
    versions.insert(versions.begin(), {patient.patient, {}, howOf(patient.patient), true});
  return versions;
}

std::optional<MeasureVersion> versionBefore(const anatomy::Patient& patient)
{
  const auto saved = findSavedPatient(patient.label, patient.side);
  if (!saved || !haveSameNumbers(saved->patient, patient)) return std::nullopt;
  const std::vector<MeasureVersion> versions = versionsOf(*saved);
  const auto used = std::ranges::find_if(versions, &MeasureVersion::isUsed);
  const auto before = std::find_if(used, versions.end(), [&](const MeasureVersion& each) {
    return !haveSameNumbers(each.patient, patient);
  });
  if (before == versions.end()) return std::nullopt;
  return *before;
}

ComparedMeasures comparedOf(const anatomy::Patient& patient)
{
  ComparedMeasures found;
  if (!patient.basalTurn) return found;
  const anatomy::BasalTurn& turn = *patient.basalTurn;
  const anatomy::BasalTurnErrors errors = analysis::errorsOf(patient);
  found[0] = {inMillimeters(turn.a), inMillimeters(errors.a)};
  found[1] = {inMillimeters(turn.b), inMillimeters(errors.b)};
  if (turn.h)
    found[2] = {inMillimeters(*turn.h), inMillimeters(errors.h.value_or(analysis::measuringError))};
  found[ductLength] = {inMillimeters(anatomy::ellipticCircularDuctLength(turn.a, turn.b)),
                       inMillimeters(anatomy::ductLengthError(turn.a, turn.b, errors)),
                       inMillimeters(anatomy::ductLengthFormulaError(turn.a, turn.b))};
  return found;
}

std::array<QString, 4> comparedNames()
{
  return {QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("H"), tr("CDL")};
}

QString comparedText(const std::optional<ComparedMeasure>& measure, std::size_t which)
{
  if (!measure) return dash();
  return QStringLiteral("%1 ± %2").arg(
      numberText(measure->value, decimalsOf(which)),
      numberText(halfWidth95 * std::hypot(measure->sd, measure->formula), decimalsOf(which)));
}

MeasureDifference differenceOf(const std::optional<ComparedMeasure>& before,
                               const std::optional<ComparedMeasure>& after, std::size_t which)
{
  if (!before || !after) return {dash(), false, {}};
  const double by = after->value - before->value;
  const double shownBy = asShown(after->value, which) - asShown(before->value, which);
  // the formula is the same on both sides
  const double within = halfWidth95 * std::hypot(before->sd, after->sd);
  const bool isBeyond = std::fabs(by) > within;
  return {QStringLiteral("%1%2 ± %3")
              .arg(shownBy > 0.0 ? QStringLiteral("+") : QString(),
                   numberText(shownBy, decimalsOf(which)), numberText(within, decimalsOf(which))),
          isBeyond,
          isBeyond ? tr("Beyond the 95 % interval of the difference")
                   : tr("Within the 95 % interval of the difference")};
}

QString changeText(const anatomy::Patient& before, const anatomy::Patient& after)
{
  const ComparedMeasures old = comparedOf(before), now = comparedOf(after);
  const auto names = comparedNames();
  QStringList parts;
  for (std::size_t k = 0; k < old.size(); ++k) {
    if (!old[k] && !now[k]) continue;
    const auto number = [k](const std::optional<ComparedMeasure>& each) {
      return each ? numberText(each->value, decimalsOf(k)) : dash();
    };
    parts << tr("%1 %2 → %3 mm").arg(names[k], number(old[k]), number(now[k]));
  }
  return parts.join(QStringLiteral(", "));
}

QStringList seriesDoubts(const anatomy::Patient& measured)
{
  const std::string series = anatomy::statedSeries(measured);
  if (series.empty()) return {};
  QStringList doubts;
  for (const SavedPatient& each : savedPatients()) {
    const std::vector<std::string> saved = seriesOf(each);
    const bool isOfSeries = std::ranges::find(saved, series) != saved.end();
    const bool isOfCode = each.patient.label == measured.label;
    if (isOfCode && isOfSeries && each.patient.side == measured.side) return {};
    if (isOfCode == isOfSeries || saved.empty()) continue;
    const QString code = QString::fromStdString(each.patient.label);
    const QString ear = each.patient.side == anatomy::Side::left ? tr("left ear") : tr("right ear");
    doubts << (isOfSeries
                   ? tr("This series is already %1, %2.").arg(code, ear)
                   : tr("%1, %2, was measured in series %3; this is series %4. Check that both "
                        "are of one person.")
                         .arg(code, ear, shortOf(saved.front()), shortOf(series)));
  }
  return doubts;
}

QString supersededText(const anatomy::Patient& planned)
{
  const auto saved = findSavedPatient(planned.label, planned.side);
  if (!saved || !planned.basalTurn || !saved->patient.basalTurn) return {};
  const ComparedMeasures plan = comparedOf(planned), used = comparedOf(saved->patient);
  const auto names = comparedNames();
  QStringList before, now;
  for (std::size_t k = 0; k < ductLength; ++k) {
    const QString old = plan[k] ? numberText(plan[k]->value, decimalsOf(k)) : dash();
    const QString own = used[k] ? numberText(used[k]->value, decimalsOf(k)) : dash();
    if (old == own) continue;
    before << tr("%1 %2").arg(names[k], old);
    now << tr("%1 %2").arg(names[k], own);
  }
  if (before.isEmpty()) return {};
  return tr("This plan is of %1 mm; the measures in use are %2 mm.")
      .arg(before.join(QStringLiteral(", ")), now.join(QStringLiteral(", ")));
}

QString remeasuredText(const anatomy::Patient& before, const anatomy::Patient& after)
{
  return tr("Measured again (%1; before: %2): %3")
      .arg(howOf(after), howOf(before), changeText(before, after));
}

QString remeasuredText(const anatomy::Patient& patient)
{
  const auto before = versionBefore(patient);
  if (!before || !before->patient.basalTurn || !patient.basalTurn) return {};
  // versionBefore() is of a saved patient with these measures; that of a scenario has no origin
  return remeasuredText(before->patient, findSavedPatient(patient.label, patient.side)->patient);
}

}  // namespace perilymph::gui
