// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportText.h"

// In this order: CT, all results, technique score, limits, traceability, parameters,
// references.

#include <QCoreApplication>
#include <cmath>

#include "gui/report/CtPicture.h"
#include "gui/report/ReportParameters.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/analysis/PublishedConditions.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* caption) { return QCoreApplication::translate("perilymph::gui", caption); }

QString from(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

/// A sentence of a shipped file or of the replay, translated.
QString sentence(const Sentence& text) { return dataText(text).toHtmlEscaped(); }

QString cell(const QString& caption, const char* kind = "")
{
  return QStringLiteral("<td class=\"%1\">%2</td>").arg(QLatin1String(kind), caption);
}

QString row(const QString& name, const QString& value, const QString& origin = {})
{
  return QStringLiteral("<tr>%1%2%3</tr>")
      .arg(cell(name, "quiet"), cell(value), cell(origin, "quiet"));
}

/// A value that takes the column of the origin, too.
QString wideRow(const QString& name, const QString& value)
{
  return QStringLiteral("<tr>%1<td colspan=\"2\">%2</td></tr>").arg(cell(name, "quiet"), value);
}

QString table(const QStringList& rows)
{
  return QStringLiteral("<table cellspacing=\"0\">%1</table>").arg(rows.join(QString()));
}

QString heading(const char* caption) { return QStringLiteral("<h2>%1</h2>").arg(tr(caption)); }

QString mm(double length) { return tr("%1 mm").arg(numberText(inMillimeters(meters(length)), 1)); }

QString mN(double force) { return tr("%1 mN").arg(forceNumber(inMillinewtons(newtons(force)))); }

/// A table of an array's file, for people.
QString partName(const std::string& part)
{
  static constexpr const char* names[][2] = {
      {"length", QT_TRANSLATE_NOOP("perilymph::gui", "Length")},
      {"insertable", QT_TRANSLATE_NOOP("perilymph::gui", "Insertable length")},
      {"diameter", QT_TRANSLATE_NOOP("perilymph::gui", "Diameter")},
      {"thickness", QT_TRANSLATE_NOOP("perilymph::gui", "Thickness")},
      {"taper", QT_TRANSLATE_NOOP("perilymph::gui", "Taper")},
      {"tip", QT_TRANSLATE_NOOP("perilymph::gui", "Tip")},
      {"bending", QT_TRANSLATE_NOOP("perilymph::gui", "Bending stiffness")},
      {"bending_across", QT_TRANSLATE_NOOP("perilymph::gui", "Bending stiffness, other axis")},
      {"twisting", QT_TRANSLATE_NOOP("perilymph::gui", "Torsional stiffness")},
      {"rest_curvature", QT_TRANSLATE_NOOP("perilymph::gui", "Curvature at rest")},
      {"contacts", QT_TRANSLATE_NOOP("perilymph::gui", "Contacts")},
      {"ribs", QT_TRANSLATE_NOOP("perilymph::gui", "Marker ribs")},
      {"wires", QT_TRANSLATE_NOOP("perilymph::gui", "Wires")},
      {"stylet", QT_TRANSLATE_NOOP("perilymph::gui", "Stylet")}};
  for (const auto& [key, name] : names)
    if (part == key) return tr(name);
  return QString::fromStdString(part);
}

QString confidenceName(electrode::Confidence confidence)
{
  switch (confidence) {
    case electrode::Confidence::high:
      return tr("confidence high");
    case electrode::Confidence::medium:
      return tr("confidence medium");
    case electrode::Confidence::low:
      return tr("confidence low");
  }
  return {};
}

QString numbers(const ReportContent& content)
{
  const analysis::ForceProfile& profile = content.insertion.profile;
  const QString ofTicks = tr("maximum of %1 recorded samples").arg(profile.ticks);
  QStringList rows = {
      row(tr("Peak insertion force"),
          tr("%1 at %2 travel, insertion depth %3")
              .arg(mN(profile.peak.force), mm(profile.peak.travel), mm(profile.peakDepth)),
          tr("axial, %1").arg(ofTicks)),
      row(tr("Maximum wall force"), mN(profile.wallForceMax),
          tr("normal to the wall, at one node; %1").arg(ofTicks)),
      row(tr("Maximum force on the cochlear partition"),
          std::isnan(profile.partitionForceMax) ? tr("not recorded")
                                                : mN(profile.partitionForceMax),
          ofTicks),
      row(tr("Insertion work"), tr("%1 mJ").arg(numberText(profile.work * 1e3, 2)),
          tr("integral of force over displacement (trapezoidal rule)")),
      row(tr("Maximum insertion depth"), mm(profile.deepest),
          tr("length of array past the opening")),
      row(tr("At the end"),
          tr("%1, %2°").arg(mm(profile.finalDepth),
                            numberText(inDegrees(radians(profile.finalAngle)), 0)),
          tr("insertion depth; tip angle")),
      row(tr("Insertion time"), tr("%1 s").arg(numberText(profile.duration, 1)),
          tr("first to last motion, pauses included")),
      row(tr("Mean speed"),
          tr("%1 mm/s").arg(numberText(1e3 * content.insertion.motion.meanSpeed(), 2)),
          tr("inward motion up to the maximum depth by its time, pauses included")),
      row(tr("Reversals"), QString::number(content.insertion.reversals),
          tr("withdrawal of 0.1 mm or more"))};
  if (profile.basalTurnPeak && analysis::hasPublishedBasalTurn(content.scenario))
    rows.insert(1,
                row(tr("Basal-turn peak"),
                    tr("%1 at %2 travel")
                        .arg(mN(profile.basalTurnPeak->force), mm(profile.basalTurnPeak->travel)),
                    tr("of the curve smoothed over 0.5 mm")));
  if (profile.ticksNotConverged > 0)
    rows << row(tr("Samples not converged"), QString::number(profile.ticksNotConverged),
                tr("solver residual above tolerance"));
  return table(rows);
}

QString howItWasDone(const ReportContent& content, References& references)
{
  if (!content.score) return {};
  QStringList rows;
  for (const analysis::ScoreCriterion& each : content.score->criteria)
    rows << row(
        dataText(each.name).toHtmlEscaped(),
        tr("%1 %: %2")
            .arg(numberText(100.0 * each.fraction, 0), dataText(each.found).toHtmlEscaped()),
        tr("%1 %2").arg(dataText(each.band).toHtmlEscaped(), references.label(each.source)));
  return heading(QT_TRANSLATE_NOOP("perilymph::gui", "Technique score")) +
         QStringLiteral("<p>%1</p>")
             .arg(tr("%1 of 100: the fractions of insertion and peak force, times the geometric "
                     "mean "
                     "of the fractions of speed, reversals and smoothness; none can be made good "
                     "by the others. Rates technique only; it does not assess trauma.")
                      .arg(numberText(content.score->total, 0))) +
         table(rows);
}

QString parameters(const ReportContent& content, References& references)
{
  // two parameters in a row
  QStringList cells;
  for (const auto& [name, value] : parametersOf(content.scenario))
    cells << cell(name.toHtmlEscaped(), "quiet") + cell(value.toHtmlEscaped());
  if (cells.size() % 2 == 1) cells << QString();
  const int half = int(cells.size()) / 2;
  QStringList rows;
  for (int i = 0; i < half; ++i)
    rows << QStringLiteral("<tr>%1%2</tr>").arg(cells[i], cells[half + i]);
  QStringList sources;
  for (const auto& [part, provenance] : content.scenario.array().provenance)
    sources << row(partName(part).toHtmlEscaped(), references.label(provenance.source),
                   confidenceName(provenance.confidence));
  return heading(QT_TRANSLATE_NOOP("perilymph::gui", "Simulation parameters")) + table(rows) +
         heading(QT_TRANSLATE_NOOP("perilymph::gui", "Array: sources of the values")) +
         table(sources);
}

QString limits(const ReportContent& content)
{
  QStringList sentences = {
      tr("Forces are computed with a model, not measured in an ear."),
      tr("The array model is based on published data and is not manufacturer data."),
      tr("No value in this report shows that an insertion is atraumatic: trauma thresholds vary "
         "between ears and are not known for the insertion force.")};
  if (content.rupture)
    sentences << tr("Strength of the cochlear partition, %1 to %2 mN: assumed; original not "
                    "available. The model gives fewer translocations than clinics report.")
                     .arg(numberText(content.rupture->low * 1e3, 0),
                          numberText(content.rupture->high * 1e3, 0));
  for (const Sentence& note : content.verification.notes) sentences << sentence(note);
  for (const std::string& note : content.scenario.notes()) sentences << sentence(note);
  if (content.lostRecords > 0)
    sentences << tr("%1 samples were lost during recording.").arg(content.lostRecords);
  return heading(QT_TRANSLATE_NOOP("perilymph::gui", "Limits")) +
         QStringLiteral("<ul><li>%1</li></ul>").arg(sentences.join(QStringLiteral("</li><li>")));
}

QString marks(const ReportContent& content)
{
  const session::Verification& verification = content.verification;
  const QString replay =
      verification.isIdentical
          ? tr("Replay verified: %1 samples identical").arg(verification.ticksCompared)
      : verification.difference && !verification.otherVersion.empty()
          ? tr("computed by version %1; not recomputed").arg(from(verification.otherVersion))
      : verification.difference ? tr("differs from sample %1, in %2")
                                      .arg(verification.difference->tick)
                                      .arg(from(verification.difference->field))
                                : tr("could not be verified");
  return heading(QT_TRANSLATE_NOOP("perilymph::gui", "Traceability")) +
         table({row(tr("Recording"), from(content.file.filename().string()),
                    tr("%1 bytes").arg(content.bytes)),
                wideRow(content.mayGoOn
                            ? tr("SHA-256 when this report was made; later motion is recorded, too")
                            : tr("SHA-256"),
                        content.sha256),
                row(tr("Replay"), replay, {}),
                row(tr("Patient"), from(content.scenario.patient().label), {}),
                row(tr("Scenario"), from(content.facts.scenarioName), {}),
                row(tr("Input device"), sentence(content.facts.device), {}),
                row(tr("Recorded by"), from(content.facts.buildId), {}),
                row(tr("Report by"), from(buildId()), {}),
                row(tr("Model"),
                    QStringLiteral("%1").arg(content.facts.modelFingerprint, 16, 16,
                                             QLatin1Char('0')),
                    tr("hash of cochlea, array and physical parameters")),
                row(tr("Array file"), from(content.scenario.arrayFingerprint()), tr("hash")),
                row(tr("Seed"), QString::number(content.facts.seed), {})});
}

}  // namespace

QString appendixText(const ReportContent& content, References& references)
{
  const QString text = QStringLiteral("<h1>%1</h1>").arg(tr("Appendix: data for reproduction")) +
                       ctPictureText(content.patient()) +
                       heading(QT_TRANSLATE_NOOP("perilymph::gui", "All results")) +
                       numbers(content) + howItWasDone(content, references) + limits(content) +
                       marks(content) + parameters(content, references);
  return text + references.list();  // of what the text cites
}

}  // namespace perilymph::gui
