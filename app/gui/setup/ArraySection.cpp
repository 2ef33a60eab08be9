// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/ArraySection.h"

#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/run/ScenarioApproach.h"
#include "gui/setup/EarApproach.h"
#include "gui/setup/NumberField.h"
#include "gui/setup/StopTravel.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "perilymph/mechanics/InsertionState.h"
#include "perilymph/mechanics/PointSet.h"

namespace perilymph::gui {

namespace {

std::string tomlFloat(double value)
{
  QString text = QString::number(value, 'g', 12);
  if (!text.contains(QLatin1Char('.')) && !text.contains(QLatin1Char('e')))
    text += QStringLiteral(".0");
  return text.toStdString();
}

QLabel* quietLine(QWidget* parent, const char* name)
{
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(name));
  label->setFont(typeface(11));
  label->setProperty("quiet", true);
  label->setWordWrap(true);
  return label;
}

}  // namespace

ArraySection::ArraySection(QWidget* parent)
    : Section(tr("Array"), "arrayFold", parent),
      expert_(new Section(tr("Expert"), "expertFold", parent)),
      arrays_(catalogArrays()),
      frictions_(catalogFrictions())
{
  addArrays();
  addMotion();
  addContact();
  addModel();
}

void ArraySection::addArrays()
{
  array_ = new Selector("arraySelector", tr("Array"), body());
  QString maker;
  for (const CatalogArray& array : arrays_) {
    if (array.maker != maker) array_->addHeading(array.maker);
    maker = array.maker;
    array_->addChoice(array.title + QStringLiteral(" · ") + array.summary, array.name, array.note);
  }
  connect(array_, &Selector::chosen, this, [this](const QString& name) {
    QString title = name;
    for (const CatalogArray& array : arrays_)
      if (array.name == name) title = array.title;
    Q_EMIT changeRequested(
        {SetupField::array, {{"array", tomlQuoted(name)}}, tr("array %1").arg(title), {}});
  });
  rows().addWidget(array_);
  summary_ = quietLine(body(), "arraySummary");
  rows().addWidget(summary_);

  technique_ = new Selector("techniqueSelector", tr("Technique"), body());
  technique_->setAccessibleDescription(tr("Handling of the stylet during the insertion."));
  technique_->addChoice(tr("Standard"), QLatin1String(nameOf(session::Technique::standard)),
                        tr("The stylet stays in place until full depth."));
  technique_->addChoice(
      tr("Advance off-stylet"), QLatin1String(nameOf(session::Technique::advanceOffStylet)),
      tr("The stylet is held at a fixed depth and the array is advanced off it."));
  connect(technique_, &Selector::chosen, this, [this](const QString& technique) {
    Q_EMIT changeRequested({SetupField::technique,
                            {{"technique", tomlQuoted(technique)}},
                            tr("technique: %1").arg(technique_->currentText()),
                            {}});
  });
  rows().addWidget(namedRow(tr("Technique"), technique_, body()));
}

void ArraySection::addMotion()
{
  speed_ = new NumberField(
      {tr("Speed"), "panelSpeed", tr("mm/s"), 1, tr("Insertion speed of the scripted insertion.")},
      body());
  // as allowed in a scenario: robots move at 0.1 to 1 mm/s, a slip of the hand reaches 200
  speed_->setRange({0.01, 200.0});
  stop_ = new NumberField(
      {tr("Stop at"), "panelStop", tr("mm"), 1, tr("Travel at which the insertion stops.")},
      body());
  askNumber(speed_, SetupField::speed, "speed_mm_s", tr("speed %1 mm/s"));
  askNumber(stop_, SetupField::stopTravel, "stop_travel_mm", tr("stop at %1 mm"));
  rows().addWidget(speed_);
  rows().addWidget(stop_);
  stopNote_ = quietLine(body(), "stopNote");
  stopNote_->setAlignment(Qt::AlignRight);
  rows().addWidget(stopNote_);
}

void ArraySection::addContact()
{
  friction_ = new Selector("frictionSelector", tr("Friction"), body());
  friction_->setAccessibleDescription(
      tr("Friction between array and wall. A choice with its source is in the list."));
  for (const CatalogFriction& friction : frictions_)
    friction_->addChoice(friction.title, friction.name, friction.source);
  connect(friction_, &Selector::chosen, this, [this](const QString& name) {
    Q_EMIT changeRequested(
        {SetupField::friction, {{"friction", tomlQuoted(name)}}, tr("friction: %1").arg(name), {}});
  });
  rows().addWidget(namedRow(tr("Friction"), friction_, body()));
  coefficients_ = quietLine(body(), "frictionCoefficients");
  coefficients_->setToolTip(
      tr("Coulomb friction between array and wall: static and kinetic coefficient."));
  coefficients_->setAlignment(Qt::AlignRight);
  rows().addWidget(coefficients_);

  opening_ = new Selector("openingSelector", tr("Opening"), body());
  opening_->setAccessibleDescription(
      tr("Opening through which the array enters the scala tympani."));
  opening_->addChoice(tr("Cochleostomy"), QLatin1String(nameOf(session::OpeningKind::cochleostomy)),
                      tr("A drilled round opening; marker ribs contact its edge."));
  opening_->addChoice(tr("Round window"), QLatin1String(nameOf(session::OpeningKind::roundWindow)),
                      tr("1.37 × 1.91 mm, mean, n = 20 (Benha Med J 2018;35:246)."));
  opening_->addChoice(tr("Wide opening (no edge contact)"),
                      QLatin1String(nameOf(session::OpeningKind::none)),
                      tr("The array contacts the scala wall only."));
  connect(opening_, &Selector::chosen, this, [this](const QString& opening) {
    Q_EMIT changeRequested({SetupField::opening,
                            {{"opening", tomlQuoted(opening)}},
                            tr("opening: %1").arg(opening_->currentText()),
                            {}});
  });
  rows().addWidget(namedRow(tr("Opening"), opening_, body()));
  approach_ = quietLine(body(), "approachNote");
  approach_->setToolTip(
      tr("The line of approach. It is turned on the page CT, in the picture of the bone."));
  rows().addWidget(approach_);
}

void ArraySection::addModel()
{
  model_ = new Selector("modelSelector", tr("Model"), expert_->body());
  model_->setAccessibleDescription(tr("Mechanical model of the array."));
  model_->addChoice(tr("Elastic rod"), QLatin1String(session::nameOf(mechanics::ModelKind::rod)),
                    tr("The array is an elastic rod discretized into nodes."));
  model_->addChoice(
      tr("Point set (published)"), QLatin1String(session::nameOf(mechanics::ModelKind::points)),
      tr("The published model: sample points coupled by springs, with its known limits."));
  connect(model_, &Selector::chosen, this, [this](const QString& model) {
    Q_EMIT changeRequested({SetupField::model,
                            {{"model", tomlQuoted(model)}},
                            tr("model: %1").arg(model_->currentText()),
                            {}});
  });
  expert_->rows().addWidget(namedRow(tr("Model"), model_, expert_->body()));
  nodes_ = new NumberField({tr("Nodes"), "panelNodes", QString(), 0,
                            tr("Number of nodes of the rod, or of sample points.")},
                           expert_->body());
  connect(nodes_, &NumberField::given, this, [this](double value) {
    const QString count = numberText(value, 0);
    Q_EMIT changeRequested({SetupField::nodes,
                            {{"nodes", QString::number(qRound(value)).toStdString()}},
                            tr("%1 nodes").arg(count),
                            {}});
  });
  expert_->rows().addWidget(nodes_);
  timing_ = quietLine(expert_->body(), "timingLabel");
  timing_->setToolTip(
      tr("Sample rate of the haptic loop, samples that started more than one period late, and "
         "frames per second of the window."));
  expert_->rows().addWidget(timing_);
  expert_->setFolded(true);
}

void ArraySection::askNumber(NumberField* field, SetupField what, const char* key,
                             const QString& caption)
{
  connect(field, &NumberField::given, this, [this, what, key, caption](double value) {
    Q_EMIT changeRequested(
        {what, {{key, tomlFloat(value)}}, caption.arg(numberText(value, 1)), {}});
  });
}

void ArraySection::show(const Setup& setup)
{
  const session::Scenario& scenario = setup.scenario;
  const electrode::ArrayDesign& array = scenario.array();
  array_->show(QString::fromStdString(scenario.arrayName()), QString::fromStdString(array.name));
  array_->setShown(QString::fromStdString(array.name));
  summary_->setText(summaryOf(array));
  summary_->setToolTip(QString::fromStdString(array.note).simplified());
  setNote(scenario.calibrationName().empty() ? QString() : tr("calibrated"),
          tr("Stiffness and curvature were fitted to published forces: %1.")
              .arg(QString::fromStdString(scenario.calibrationName())));

  const bool canHold = array.hasStylet && array.stylet.holdDepth.has_value();
  technique_->setPossible(QLatin1String(nameOf(session::Technique::advanceOffStylet)), canHold,
                          array.hasStylet ? tr("no stylet depth is known for this array")
                                          : tr("this array has no stylet"));
  technique_->show(QLatin1String(nameOf(scenario.technique())), {});
  speed_->setValue(inMillimetersPerSecond(scenario.speed()));
  stop_->setRange({0.1, inMillimeters(array.insertable - scenario.startInside())});
  stop_->setValue(inMillimeters(scenario.stopTravel()));
  stopNote_->setText(stopText(scenario));
  showFriction(scenario);
  opening_->show(QLatin1String(nameOf(scenario.openingKind())), {});
  const anatomy::Approach approach = approachOf(scenario);
  approach_->setVisible(!isAlongAxis(approach));
  if (!isAlongAxis(approach))
    approach_->setText(
        tr("Approach: %1").arg(approachText(scenario.parameters().cochlea, approach)));

  const bool isRod = scenario.model() == mechanics::ModelKind::rod;
  model_->show(QLatin1String(session::nameOf(scenario.model())), {});
  // as allowed in a scenario
  nodes_->setRange(isRod ? Range{8.0, double(mechanics::maxNodes)}
                         : Range{2.0, double(mechanics::maxStablePoints)});
  nodes_->setValue(scenario.nodes());
}

void ArraySection::showFriction(const session::Scenario& scenario)
{
  std::string name = "paper";
  for (const auto& [key, value] : scenario.values())
    if (key == "friction") name = value.substr(1, value.size() - 2);
  friction_->show(QString::fromStdString(name), QString::fromStdString(name));
  const mechanics::FrictionLaw& law = scenario.friction();
  const QString staticCoefficient = numberText(law.staticCoefficient, 4);
  coefficients_->setText(
      law.bySpeed.isEmpty()
          ? tr("static %1 · kinetic %2")
                .arg(staticCoefficient, numberText(law.kineticCoefficient, 4))
          : tr("%1–%2, speed-dependent")
                .arg(numberText(law.bySpeed.minimum(), 2), numberText(law.bySpeed.maximum(), 2)));
}

void ArraySection::setChangeable(bool isChangeable)
{
  body()->setEnabled(isChangeable);
  model_->setEnabled(isChangeable);
  nodes_->setEnabled(isChangeable);
}

void ArraySection::setTiming(const QString& text) { timing_->setText(text); }

QString ArraySection::commit()
{
  const std::pair<NumberField*, QString> fields[] = {
      {speed_, tr("Speed")}, {stop_, tr("Stop")}, {nodes_, tr("Nodes")}};
  for (const auto& [field, title] : fields) {
    if (field->commit()) continue;
    return tr("%1 %2. Enter a valid value or press Esc.").arg(title, field->error());
  }
  return {};
}

}  // namespace perilymph::gui
