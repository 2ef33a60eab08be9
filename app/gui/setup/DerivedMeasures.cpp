// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/DerivedMeasures.h"

#include <QGridLayout>
#include <QLabel>
#include <QStringList>
#include <QVariant>
#include <algorithm>

#include "gui/parts/DataText.h"
#include "gui/parts/Numbers.h"
#include "gui/parts/Theme.h"
#include "gui/parts/WrappedLabel.h"
#include "perilymph/analysis/ClinicalEstimates.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/analysis/ExpectedInsertion.h"

namespace perilymph::gui {

namespace {

using analysis::Measure;

constexpr int delay_ms = 250;  // after the last change, so that typing does not build each digit

constexpr auto ductLength = "duct_length_mm";
constexpr auto twoTurns = "two_turn_length_mm";
constexpr auto turns = "turns";
constexpr auto insertionAngle = "insertion_angle_deg";

/// The measures a clinician chooses an array by. A and B are those of the built model.
std::vector<Measure> summaryOf(const anatomy::ScalaTympani& scala, anatomy::AnatomySource source,
                               const electrode::ArrayDesign& array)
{
  const auto [a, b] = analysis::basalDiameters(scala);
  const std::string alexiades = "Alexiades et al. 2015, Otol Neurotol 36:904";
  const bool isByLength = source == anatomy::AnatomySource::published;
  const Measure duct = isByLength
                           ? Measure{ductLength, inMillimeters(analysis::organOfCortiLength(scala)),
                                     "path of the organ of Corti in the plan, round window to apex",
                                     "measured in this model, defined as in Todd and Naghdy"}
                           : Measure{ductLength, inMillimeters(analysis::alexiadesDuctLength(a)),
                                     "4.16 A − 4 mm", alexiades};
  std::vector<Measure> measures = {
      duct,
      {twoTurns, inMillimeters(analysis::alexiadesTwoTurns(a)), "3.65 (A − 1 mm)", alexiades}};
  for (const Measure& each : analysis::clinicalEstimates(a, b))
    if (each.key == "pietsch_turns")
      measures.push_back({turns, each.value, each.formula, each.source});
  for (Measure& each : analysis::expectedInsertion(scala, array))
    measures.push_back(std::move(each));
  return measures;
}

struct RowFormat {
  const char* key;
  const char* name;
  const char* value;  ///< With %1 for the number and its uncertainty.
  int decimals;
};

// Order of the rows.
constexpr RowFormat formats[] = {
    {ductLength, QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "Cochlear duct length"),
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "%1 mm"), 1},
    {twoTurns, QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "Two-turn length"),
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "%1 mm"), 1},
    {turns, QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "Turns"), "%1", 2},
    {insertionAngle, QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "Insertion angle, up to"),
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "%1°"), 0},
    {"coverage_percent",
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "Cochlear coverage, up to"),
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "%1 %"), 0},
};

/// The inputs as text: equal texts give equal measures.
std::string keyOf(const anatomy::Cochlea& cochlea, const electrode::ArrayDesign& array)
{
  const anatomy::Patient& patient = cochlea.patient;
  std::string key = std::string(nameOf(cochlea.source)) + array.name;
  const auto add = [&key](Length length) { key += ' ' + std::to_string(inMillimeters(length)); };
  add(array.insertable);
  if (!isScaledBy(cochlea.source, patient)) return key;
  if (patient.basalTurn) {
    add(patient.basalTurn->a);
    add(patient.basalTurn->b);
    if (patient.basalTurn->h) add(*patient.basalTurn->h);
    return key;
  }
  add(patient.scalaTympaniLength);
  add(patient.roundWindowWidth);
  add(patient.roundWindowHeight);
  return key;
}

}  // namespace

DerivedMeasures::DerivedMeasures(QWidget* parent)
    : QWidget(parent), note_(new WrappedLabel({}, this)), background_(this)
{
  setObjectName(QStringLiteral("derivedMeasures"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(spacing);
  grid->setVerticalSpacing(2);
  for (const RowFormat& format : formats) {
    auto* name = new WrappedLabel(tr(format.name), this);
    auto* value = new QLabel(this);
    value->setObjectName(QLatin1String(format.key));
    name->setFont(typeface(11));
    value->setFont(typeface(11, QFont::Medium));
    name->setProperty("quiet", true);
    value->setAlignment(Qt::AlignRight);
    const int row = int(rows_.size());
    grid->addWidget(name, row, 0);
    grid->addWidget(value, row, 1);
    rows_.emplace_back(name, value);
  }
  note_->setFont(typeface(11));
  note_->setProperty("quiet", true);
  grid->addWidget(note_, int(rows_.size()), 0, 1, 2);
  grid->setColumnStretch(0, 1);
  delay_.setSingleShot(true);
  delay_.setInterval(delay_ms);
  connect(&delay_, &QTimer::timeout, this, &DerivedMeasures::compute);
  showNone({});
}

void DerivedMeasures::say(const QString& sentence) { note_->setText(sentence); }

void DerivedMeasures::show(const anatomy::Cochlea& cochlea, const electrode::ArrayDesign& array)
{
  std::string key = keyOf(cochlea, array);
  if (key == shown_) return;
  shown_ = std::move(key);
  cochlea_ = cochlea;
  array_ = array;
  say(tr("computing…"));
  note_->show();
  delay_.start();
}

void DerivedMeasures::showNone(const QString& sentence)
{
  delay_.stop();
  background_.forget();
  shown_.clear();
  for (const auto& [name, value] : rows_) value->setText(tr("–"));
  say(sentence);
  note_->setVisible(!sentence.isEmpty());
}

void DerivedMeasures::compute()
{
  background_.run(
      "The measures",
      [cochlea = cochlea_, array = array_](const std::atomic<bool>&) -> Result<Content> {
        const auto measuring = [&](const anatomy::ScalaTympani& scala) {
          return summaryOf(scala, cochlea.source, array);
        };
        const auto scala = anatomy::buildAnatomy(cochlea, cochlea.patient.label);
        if (!scala) return scala.error();
        Content content;
        content.measures = measuring(**scala);
        auto bands =
            analysis::errorBands(cochlea, content.measures, analysis::measuringError, measuring);
        if (!bands) return bands.error();
        content.bands = *std::move(bands);
        return content;
      },
      [this](const Result<Content>& content) { showContent(content); });
}

void DerivedMeasures::showContent(const Result<Content>& content)
{
  if (!content) return showNone(QString::fromStdString(content.error().message));
  bool hasInsertion = false;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const RowFormat& format = formats[row];
    const auto& [name, value] = rows_[row];
    value->setText(tr("–"));
    for (std::size_t i = 0; i < content->measures.size(); ++i) {
      const Measure& measure = content->measures[i];
      if (measure.key != format.key) continue;
      hasInsertion = hasInsertion || measure.key == insertionAngle;
      QString number = numberText(measure.value, format.decimals);
      const QString band =
          content->bands.empty() ? QString() : numberText(content->bands[i], format.decimals);
      if (band != numberText(0.0, format.decimals) && !band.isEmpty())
        number += QStringLiteral(" ± ") + band;
      value->setText(tr(format.value).arg(number));
      const QString tip = dataText(measure.formula) + QLatin1Char('\n') + dataText(measure.source);
      name->setToolTip(tip);
      value->setToolTip(tip);
    }
  }
  QStringList notes;
  notes << (hasInsertion ? tr("Angle and coverage for %1 along the lateral wall, fully inserted.")
                               .arg(QString::fromStdString(array_.name))
                         : tr("Angle and coverage are estimated for straight arrays only."));
  if (!content->bands.empty() && cochlea_.patient.errors)
    notes << tr("± for the errors of the measures in the CT.");
  else if (!content->bands.empty())
    notes << tr("± for an error of %1 mm in each measure.")
                 .arg(numberText(inMillimeters(analysis::measuringError), 1));
  say(notes.join(QLatin1Char(' ')));
  note_->show();
}

}  // namespace perilymph::gui
