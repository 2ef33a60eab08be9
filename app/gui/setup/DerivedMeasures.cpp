// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/DerivedMeasures.h"

#include <QGridLayout>
#include <QLabel>
#include <QStringList>
#include <QVariant>
#include <algorithm>
#include <stop_token>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/analysis/ErrorBand.h"

namespace perilymph::gui {

namespace {

using analysis::Measure;

constexpr int delay_ms = 250;  // after the last change, so that typing does not build each digit

struct RowFormat {
  const char* key;
  const char* name;
  const char* value;  ///< With %1 for the number and its uncertainty.
  int decimals;
};

// Order of the rows.
constexpr RowFormat formats[] = {
    {CochleaMeasures::ductLength,
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "Cochlear duct length"),
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "%1 mm"), 1},
    {CochleaMeasures::angularDepth,
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures",
                       "Angular insertion depth at the lateral wall"),
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "%1°"), 0},
    {"coverage_percent",
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "Cochlear coverage at the lateral wall"),
     QT_TRANSLATE_NOOP("perilymph::gui::DerivedMeasures", "%1 %"), 0},
};

}  // namespace

DerivedMeasures::DerivedMeasures(std::shared_ptr<CochleaStore> cochleae, QWidget* parent)
    : QWidget(parent),
      cochleae_(std::move(cochleae)),
      note_(new WrappedLabel({}, this)),
      background_(this)
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

void DerivedMeasures::showMessage(const QString& sentence) { note_->setText(sentence); }

void DerivedMeasures::show(const anatomy::Cochlea& cochlea, const electrode::ArrayDesign& array)
{
  std::string key = MeasureStore::keyOf(cochlea, array);
  if (key == shown_) return;
  shown_ = std::move(key);
  cochlea_ = cochlea;
  array_ = array;
  for (const auto& [name, value] : rows_)
    value->setText(tr("–"));  // those shown are of another one
  showMessage(tr("computing…"));
  note_->show();
  delay_.start();
}

void DerivedMeasures::showNone(const QString& sentence)
{
  delay_.stop();
  background_.cancel();
  shown_.clear();
  for (const auto& [name, value] : rows_) value->setText(tr("–"));
  showMessage(sentence);
  note_->setVisible(!sentence.isEmpty());
}

void DerivedMeasures::compute()
{
  background_.run(
      "The measures",
      [cochleae = cochleae_, cochlea = cochlea_, array = array_](const std::stop_token&) {
        return cochleae->measures().of(cochlea, array);
      },
      [this](const Result<CochleaMeasures>& content) { showContent(content); });
}

void DerivedMeasures::showContent(const Result<CochleaMeasures>& content)
{
  if (!content) return showNone(dataText(content.error().message));
  bool hasInsertion = false;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const RowFormat& format = formats[row];
    const auto& [name, value] = rows_[row];
    value->setText(tr("–"));
    for (std::size_t i = 0; i < content->measures.size(); ++i) {
      const Measure& measure = content->measures[i];
      if (measure.key != format.key) continue;
      hasInsertion = hasInsertion || measure.key == CochleaMeasures::angularDepth;
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
  notes << (hasInsertion ? tr("Angle and coverage for %1 along the lateral wall, fully inserted: "
                              "geometry alone. In a plan it may lie nearer the modiolus, at a "
                              "larger angle, or stop earlier.")
                               .arg(QString::fromStdString(array_.name))
                         : tr("Angle and coverage are estimated for straight arrays only."));
  if (!content->bands.empty() && cochlea_.patient.errors)
    notes << tr("± 95 % interval of the errors in the CT and of the duct length’s formula.");
  else if (!content->bands.empty())
    notes << tr("± 95 % interval of an error of %1 mm (SD) in each measure and of the duct "
                "length’s formula.")
                 .arg(numberText(inMillimeters(analysis::measuringError), 1));
  showMessage(notes.join(QLatin1Char(' ')));
  note_->show();
}

}  // namespace perilymph::gui
