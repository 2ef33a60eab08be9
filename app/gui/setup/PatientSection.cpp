// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PatientSection.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <utility>

#include "gui/setup/DerivedMeasures.h"
#include "gui/setup/MeasureVersions.h"
#include "gui/setup/Populations.h"
#include "gui/setup/SavedPatientRow.h"
#include "gui/setup/ValueEdit.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/anatomy/Population.h"

namespace perilymph::gui {

namespace {

constexpr int earWidth_px = 92;

constexpr auto byLengths = "lengths";
constexpr auto byBasalTurn = "basalTurn";

using anatomy::AnatomySource;
using anatomy::PatientMeasures;

/// Key of a choice: the measures that scale the anatomy, or the anatomy itself if none do.
QString kindOf(AnatomySource source, PatientMeasures scaledBy)
{
  const QString name = QLatin1String(nameOf(source));
  if (scaledBy == PatientMeasures::none) return name;
  if (sourceScaledBy(scaledBy) != source) return name + QLatin1String("-scaled");
  return QLatin1String(scaledBy == PatientMeasures::threeLengths ? byLengths : byBasalTurn);
}

/// The measures that scale a scenario's anatomy.
PatientMeasures scaledBy(const session::Scenario& scenario)
{
  const bool isScaled = isScaledBy(scenario.anatomy(), scenario.patient());
  return isScaled ? traitsOf(scenario.anatomy()).takes : PatientMeasures::none;
}

std::string keyOf(const char* name) { return std::string("patient_numbers.") + name; }

std::string tomlMillimeters(Length length)
{
  QString text = QString::number(inMillimeters(length), 'g', 9);
  if (!text.contains(QLatin1Char('.'))) text += QStringLiteral(".0");
  return text.toStdString();
}

QString sourceText(ValueSource sources)
{
  switch (sources) {
    case ValueSource::typed:
      return PatientSection::tr("entered");
    case ValueSource::ct:
      return PatientSection::tr("from CT");
    case ValueSource::standard:
      break;
  }
  return PatientSection::tr("default");
}

std::optional<Length> numberOf(const anatomy::Patient& patient, SetupField field)
{
  switch (field) {
    case SetupField::scalaLength:
      return patient.scalaTympaniLength;
    case SetupField::windowWidth:
      return patient.roundWindowWidth;
    case SetupField::windowHeight:
      return patient.roundWindowHeight;
    case SetupField::lengthA:
      return patient.basalTurn ? std::optional(patient.basalTurn->a) : std::nullopt;
    case SetupField::widthB:
      return patient.basalTurn ? std::optional(patient.basalTurn->b) : std::nullopt;
    case SetupField::heightH:
      return patient.basalTurn ? patient.basalTurn->h : std::nullopt;
    default:
      return std::nullopt;
  }
}

/// The error of a measure as the CT states it; empty without one.
std::optional<Length> errorOf(const anatomy::Patient& patient, SetupField field)
{
  if (!patient.errors) return std::nullopt;
  if (field == SetupField::lengthA) return patient.errors->a;
  if (field == SetupField::widthB) return patient.errors->b;
  return field == SetupField::heightH ? patient.errors->h : std::nullopt;
}

}  // namespace

PatientSection::PatientSection(std::shared_ptr<CochleaStore> cochleae, QWidget* parent)
    : Section(tr("Patient"), "patientFold", parent),
      saved_(new SavedPatientRow(body())),
      label_(new ValueEdit(body())),
      labelError_(new QLabel(body())),
      ear_(new Selector("earSelector", tr("Ear"), body())),
      kind_(new Selector("anatomySelector", tr("Cochlea"), body())),
      derived_(new DerivedMeasures(std::move(cochleae), body())),
      change_(new WrappedLabel({}, body()))
{
  rows().addWidget(saved_);
  addWho();
  for (const anatomy::AnatomySourceTraits& traits : anatomy::anatomySources()) {
    if (traits.takes != PatientMeasures::none) addKind(traits, traits.takes);
    if (!traits.alwaysTakes) addKind(traits, PatientMeasures::none);
  }
  connect(kind_, &Selector::chosen, this, [this](const QString& kind) { askKind(kind); });
  rows().addWidget(namedRow(tr("Cochlea"), kind_, body()));
  addNumbers();
  change_->setObjectName(QStringLiteral("panelMeasureChange"));
  change_->setFont(typeface(11));
  change_->hide();
  rows().addWidget(change_);
  rows().addWidget(derived_);
  connect(saved_, &SavedPatientRow::patientChosen, this, &PatientSection::patientChosen);
  connect(saved_, &SavedPatientRow::allPatientsRequested, this,
          &PatientSection::allPatientsRequested);
  connect(saved_, &SavedPatientRow::newPatientRequested, this,
          &PatientSection::newPatientRequested);
  connect(saved_, &SavedPatientRow::otherCodeWanted, this, [this] {
    label_->setFocus();
    label_->selectAll();
  });
}

void PatientSection::addWho()
{
  label_->setObjectName(QStringLiteral("panelPatientName"));
  label_->setAccessibleName(tr("Patient code"));
  label_->setFont(typeface(13));
  label_->setFixedHeight(sized(26));
  label_->setMaxLength(60);
  label_->setToolTip(tr("Patient code (no names)"));
  connect(label_, &QLineEdit::editingFinished, this, [this] { askLabel(); });
  connect(label_, &QLineEdit::textChanged, this, [this] {
    labelError_->setText(codeError());
    labelError_->setVisible(!labelError_->text().isEmpty());
  });
  labelError_->setFont(typeface(11));
  labelError_->setProperty("error", true);
  labelError_->setWordWrap(true);
  labelError_->hide();
  ear_->addChoice(tr("right ear"), QStringLiteral("right"));
  ear_->addChoice(tr("left ear"), QStringLiteral("left"),
                  tr("A left ear is the mirror image of a right ear; the forces are identical."));
  connect(ear_, &Selector::chosen, this, [this](const QString& side) {
    Q_EMIT changeRequested(
        {SetupField::side, {{"side", tomlQuoted(side)}}, ear_->currentText(), {}});
  });
  ear_->setFixedWidth(std::max(sized(earWidth_px), ear_->widest_px()));
  auto* who = new QWidget(body());
  auto* row = new QHBoxLayout(who);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing);
  label_->setParent(who);
  ear_->setParent(who);
  row->addWidget(label_, 1);
  row->addWidget(ear_);
  rows().addWidget(who);
  rows().addWidget(labelError_);
}

void PatientSection::addNumbers()
{
  using Width = PopulationField::Width;
  const auto field = [this](const QString& title, const char* name, const Population& population,
                            bool mayBeEmpty) {
    return new PopulationField(title, name, population, mayBeEmpty, body(), Width::narrow);
  };
  lengths_ = addPage({
      {SetupField::scalaLength, "st_length_mm", tr("Cochlear duct length"),
       field(tr("Cochlear duct length"), "panelScalaLength", scalaLengthPopulation(), false),
       nullptr},
      {SetupField::windowWidth, "rw_width_mm", tr("Scala width at round window"),
       field(tr("Scala width at round window"), "panelWindowWidth", windowWidthPopulation(), false),
       nullptr},
      {SetupField::windowHeight, "rw_height_mm", tr("Scala height at round window"),
       field(tr("Scala height at round window"), "panelWindowHeight", windowHeightPopulation(),
             false),
       nullptr},
  });
  basalTurn_ = addPage({
      {SetupField::lengthA, "a_mm", tr("A: basal-turn diameter"),
       field(tr("A: basal-turn diameter"), "panelA", lengthAPopulation(), false), nullptr},
      {SetupField::widthB, "b_mm", tr("B: basal-turn width"),
       field(tr("B: basal-turn width"), "panelB", widthBPopulation(), false), nullptr},
      {SetupField::heightH, "h_mm", tr("H: cochlear height"),
       field(tr("H: cochlear height"), "panelH", heightHPopulation(), true), nullptr},
  });

  const anatomy::Patient average;
  lastLengths_ = {{keyOf("st_length_mm"), tomlMillimeters(average.scalaTympaniLength)},
                  {keyOf("rw_width_mm"), tomlMillimeters(average.roundWindowWidth)},
                  {keyOf("rw_height_mm"), tomlMillimeters(average.roundWindowHeight)}};
  lastBasalTurn_ = {{keyOf("a_mm"), tomlMillimeters(anatomy::spreadOfA().mean)},
                    {keyOf("b_mm"), tomlMillimeters(anatomy::spreadOfB().mean)}};
}

void PatientSection::addKind(const anatomy::AnatomySourceTraits& traits, PatientMeasures measures)
{
  struct Known {
    AnatomySource source;
    PatientMeasures measures;
    QString title, tip;
  };
  const Known known[] = {
      {AnatomySource::published, PatientMeasures::threeLengths, tr("CDL and section"),
       tr("The published scala tympani, scaled by three CT measurements.")},
      {AnatomySource::mean, PatientMeasures::basalTurn, tr("A, B and H"),
       tr("Average of 15 human scalae tympani, scaled by the basal-turn diameters. Adapted from "
          "Froehlich et al. 2024, CC BY 4.0.")},
      {AnatomySource::mean, PatientMeasures::none, tr("Average cochlea"),
       tr("Average of 15 human scalae tympani as measured. Adapted from Froehlich, Schurzig, Rau, "
          "Lenarz (2024), PLOS ONE, doi 10.1371/journal.pone.0295121, CC BY 4.0.")},
      {AnatomySource::clark, PatientMeasures::none, tr("Clark spiral"),
       tr("Spiral with a constant cross-section, for comparison with earlier models.")},
  };
  const QString kind = kindOf(traits.source, measures);
  kinds_.push_back({kind, traits.source, measures});
  for (const Known& each : known)
    if (each.source == traits.source && each.measures == measures)
      return kind_->addChoice(each.title, kind, each.tip);
  kind_->addChoice(QString::fromUtf8(traits.title), kind);
}

QWidget* PatientSection::addPage(std::vector<Number> numbers)
{
  auto* page = new QWidget(body());
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 2, 0, 0);
  column->setSpacing(4);
  for (Number& number : numbers) {
    number.page = page;
    column->addWidget(number.shown);
    connect(number.shown, &PopulationField::given, this,
            [this, number](std::optional<Length> value) { askNumber(number, value); });
    numbers_.push_back(number);
  }
  rows().addWidget(page);
  return page;
}

void PatientSection::show(const Setup& setup)
{
  const session::Scenario& scenario = setup.scenario;
  saved_->show(setup);
  derived_->show({scenario.anatomy(), scenario.patient(), scenario.leadIn()}, scenario.array());
  label_->setHeld(QString::fromStdString(scenario.patient().label));
  ear_->show(scenario.patient().side == anatomy::Side::left ? QStringLiteral("left")
                                                            : QStringLiteral("right"),
             {});
  if (std::string shown = anatomy::patientText(scenario.patient()); shown != changeOf_) {
    changeOf_ = std::move(shown);
    change_->setText(remeasuredText(scenario.patient()));
    change_->setVisible(!change_->text().isEmpty());
  }
  const PatientMeasures measures = scaledBy(scenario);
  heldKind_ = kindOf(scenario.anatomy(), measures);
  kind_->show(heldKind_, {});
  lengths_->setVisible(measures == PatientMeasures::threeLengths);
  basalTurn_->setVisible(measures == PatientMeasures::basalTurn);
  for (const Number& number : numbers_) {
    if (number.page->isHidden()) continue;
    const auto value = numberOf(scenario.patient(), number.field);
    number.shown->setMeasuringError(errorOf(scenario.patient(), number.field));
    number.shown->setHeld(value, value ? sourceText(setup.sourceOf(number.field)) : "");
    session::Overrides& last = number.page == lengths_ ? lastLengths_ : lastBasalTurn_;
    const std::string key = keyOf(number.key);
    last.erase(std::remove_if(last.begin(), last.end(),
                              [&key](const auto& entry) { return entry.first == key; }),
               last.end());
    if (value) last.emplace_back(key, tomlMillimeters(*value));
  }
}

QString PatientSection::commit()
{
  for (const Number& number : numbers_) {
    if (number.page->isHidden() || number.shown->commit()) continue;
    return tr("%1 %2. Enter a valid value or press Esc.").arg(number.title, number.shown->error());
  }
  if (const QString refused = codeError(); !refused.isEmpty()) return refused;
  askLabel();
  return {};
}

QString PatientSection::codeError() const
{
  const QString code = label_->text().trimmed();
  if (!label_->isPending() || code.isEmpty()) return {};
  const auto checked = anatomy::checkPatientCode(code.toStdString());
  return checked ? QString() : dataText(checked.error().message);
}

void PatientSection::askNumber(const Number& number, std::optional<Length> value)
{
  const QString caption =
      value ? tr("%1 %2 mm").arg(number.title, numberText(inMillimeters(*value), 2))
            : tr("%1 not given").arg(number.title);
  Q_EMIT changeRequested({number.field,
                          {{keyOf(number.key), value ? tomlMillimeters(*value) : std::string()}},
                          caption,
                          ValueSource::typed});
}

void PatientSection::askKind(const QString& kind)
{
  if (kind == heldKind_) return;
  SetupChange change{SetupField::anatomy, {}, tr("cochlea: %1").arg(kind_->currentText()), {}};
  const auto asked = std::find_if(kinds_.begin(), kinds_.end(),
                                  [&kind](const Kind& each) { return each.id == kind; });
  if (asked == kinds_.end()) return;
  if (asked->measures == PatientMeasures::threeLengths) change.values = lastLengths_;
  if (asked->measures == PatientMeasures::basalTurn) change.values = lastBasalTurn_;
  change.values.emplace_back("anatomy", tomlQuoted(QString::fromUtf8(nameOf(asked->source))));
  change.values.emplace_back("patient", "\"\"");
  Q_EMIT changeRequested(change);
}

void PatientSection::askLabel()
{
  if (!label_->isPending() || !codeError().isEmpty()) return;
  const QString label = label_->text().trimmed();
  if (label.isEmpty()) return label_->takeBack();
  Q_EMIT changeRequested({SetupField::patientLabel,
                          {{keyOf("label"), tomlQuoted(label)}},
                          tr("patient %1").arg(label),
                          {}});
}

}  // namespace perilymph::gui
