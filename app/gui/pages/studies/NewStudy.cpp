// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/NewStudy.h"

#include <QDate>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "gui/pages/studies/StoredStudies.h"
#include "gui/pages/studies/StudyText.h"
#include "gui/setup/Catalog.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/Section.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

constexpr int fieldWidth_px = 64;
constexpr int pause_ms = 600;  // after the last change, before it is checked
/// Allowed whole numbers, as study::loadStudy() has them.
constexpr double maxWhole = 1'000'000;

/// Nodes of the array and time step [ms]: the shipped study's, a coarse and a fine one.
struct Resolution {
  const char* name;
  int nodes;
  double timeStep_ms;
};
constexpr Resolution resolutions[] = {
    {"coarse", 30, 10.0}, {"usual", 100, 5.0}, {"fine", 100, 1.0}};

std::optional<double> wholeIn(const QLineEdit& field, double low)
{
  const auto value = typedNumber(field.text());
  if (!value || *value < low || *value > maxWhole || std::floor(*value) != *value)
    return std::nullopt;
  return value;
}

std::vector<std::string> checkedOf(const auto& list)
{
  std::vector<std::string> names;
  for (const auto& each : list)
    if (each.box->isChecked()) names.push_back(each.name);
  return names;
}

}  // namespace

NewStudy::NewStudy(QWidget* parent) : QWidget(parent), estimate_(this)
{
  waiting_.setSingleShot(true);
  waiting_.setInterval(pause_ms);
  connect(&waiting_, &QTimer::timeout, this, &NewStudy::check);
  auto* content = new QWidget(this);
  auto* columns = new QHBoxLayout(content);
  columns->setContentsMargins(3 * spacing, 2 * spacing, 3 * spacing, spacing);
  columns->setSpacing(3 * spacing);
  QVBoxLayout *arrays = nullptr, *cochleae = nullptr, *hand = nullptr, *run = nullptr;
  for (QWidget* part : {addColumn(tr("Arrays"), arrays), addColumn(tr("Cochleae"), cochleae),
                        addColumn(tr("Hand and friction"), hand), addColumn(tr("New study"), run)})
    columns->addWidget(part, 1);
  addRun(*run);  // its note tells of the others
  addArrays(*arrays);
  addCochleae(*cochleae);
  addHand(*hand);
  setFocusProxy(title_);
  for (QVBoxLayout* each : {arrays, cochleae, hand, run}) each->addStretch();
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(verticalScroll(content, this));
  connect(&estimate_, &StudyEstimateWork::refused, this,
          [this](const QString& sentence) { showMessage(sentence, false); });
  connect(&estimate_, &StudyEstimateWork::estimated, this,
          [this](const study::StudyEstimate& cost, std::size_t insertions) {
            showMessage(
                tr("%1 insertions, about %2 on %3 of %4 cores: an estimate from %5 that were run "
                   "now.")
                    .arg(QLocale().toString(qulonglong(insertions)),
                         durationText(cost.processorTime_s / jobs()))
                    .arg(jobs())
                    .arg(processors())
                    .arg(cost.measured),
                true);
          });
}

QWidget* NewStudy::addColumn(const QString& title, QVBoxLayout*& column)
{
  auto* part = new QWidget(this);
  column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing / 2);
  auto* head = new WrappedLabel(title, part);
  head->setFont(typeface(15, QFont::DemiBold));
  column->addWidget(head);
  return part;
}

CheckBox* NewStudy::box(std::vector<Listed>& list, const QString& text, const std::string& name,
                        const QString& object, bool isChecked)
{
  auto* box = new CheckBox(text, this);
  box->setObjectName(object);
  box->setChecked(isChecked);
  connect(box, &QAbstractButton::toggled, this, &NewStudy::edited);
  list.push_back({box, name});
  return box;
}

QLineEdit* NewStudy::field(const char* name, const QString& title, const char* value)
{
  auto* field = new QLineEdit(this);
  field->setText(QString(QLatin1String(value)).replace(QLatin1Char('.'), QLocale().decimalPoint()));
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(title);
  field->setFont(typeface(13));
  field->setFixedHeight(sized(26));
  connect(field, &QLineEdit::textChanged, this, &NewStudy::edited);
  return field;
}

void NewStudy::addArrays(QVBoxLayout& column)
{
  QString maker;
  for (const CatalogArray& each : catalogArrays()) {
    if (each.maker != maker) column.addWidget(panelHeading(maker = each.maker, this));
    const std::string name = each.name.toStdString();
    const bool isUsual = name == "flex24" || name == "flex28";  // those of the shipped study
    CheckBox* const array =
        box(arrays_, each.title, name, QStringLiteral("newStudy-array-%1").arg(each.name), isUsual);
    array->setToolTip(each.summary);
    column.addWidget(array);
  }
}

void NewStudy::addCochleae(QVBoxLayout& column)
{
  simulated_ = field("newStudySimulated", tr("Simulated, from the population"), "20");
  simulated_->setFixedWidth(sized(fieldWidth_px));
  simulated_->setToolTip(
      tr("Drawn by the seed from the mean, the spread and the correlation of A and B"));
  column.addWidget(namedRow(tr("Simulated, from the population"), simulated_, this));
  mean_ = new CheckBox(tr("Average cochlea"), this);
  mean_->setObjectName(QStringLiteral("newStudyMean"));
  connect(mean_, &QAbstractButton::toggled, this, &NewStudy::edited);
  column.addWidget(mean_);
  patientRows_ = new QVBoxLayout;
  column.addLayout(patientRows_);
}

void NewStudy::addLimits(QVBoxLayout& column, const char* key, const QString& name, double divisor,
                         const char* low, const char* high, const QString& tip)
{
  auto* both = new QWidget(this);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing / 2);
  const QByteArray object = QByteArray("newStudy-") + key;
  Limits limits{key, divisor, field((object + "-low").constData(), tr("%1, from").arg(name), low),
                field((object + "-high").constData(), tr("%1, to").arg(name), high)};
  auto* to = new QLabel(tr("to"), both);
  to->setFont(typeface(13));
  row->addStretch();
  for (QLineEdit* each : {limits.low, limits.high}) {
    each->setFixedWidth(sized(fieldWidth_px));
    if (each == limits.high) row->addWidget(to);
    row->addWidget(each);
  }
  both->setToolTip(tip);
  auto* title = new WrappedLabel(name, this);
  title->setFont(typeface(13));
  column.addWidget(title);
  column.addWidget(both);
  limits_.push_back(limits);
}

void NewStudy::addHand(QVBoxLayout& column)
{
  addLimits(column, "speed_mm_s", tr("Speed, mm/s"), 1.0, "0.35", "0.97",
            tr("By hand, 0.66 ± 0.31 mm/s in cadaver heads (Kesler et al. 2017)"));
  addLimits(column, "stop_force_N", tr("Force limit, mN"), 1e3, "100", "100",
            tr("The surgeon stops there: highest peak in vivo (Rau et al. 2024); 0: never"));
  addLimits(column, "approach_tilt_deg", tr("Approach angle, tilt, °"), 1.0, "0", "0",
            tr("From the axis of the opening"));
  addLimits(column, "approach_turn_deg", tr("Approach angle, rotation, °"), 1.0, "0", "0",
            tr("From the axis of the opening"));
  samples_ = field("newStudySamples", tr("Samples in each cochlea"), "1");
  samples_->setFixedWidth(sized(fieldWidth_px));
  samples_->setToolTip(tr("Of values that go from one limit to another: a Latin hypercube"));
  column.addWidget(namedRow(tr("Samples in each cochlea"), samples_, this));
  column.addWidget(panelHeading(tr("FRICTION"), this));
  const std::string usual = "estimate-from-pig-tissue";  // that of the scenario
  for (const CatalogFriction& each : catalogFrictions()) {
    const std::string name = each.name.toStdString();
    CheckBox* const friction =
        box(frictions_, each.title, name, QStringLiteral("newStudy-friction-%1").arg(each.name),
            name == usual);
    friction->setToolTip(each.source);
    column.addWidget(friction);
  }
}

void NewStudy::addRun(QVBoxLayout& column)
{
  title_ = field("newStudyTitle", tr("Title"), "");
  title_->setMaxLength(80);
  connect(title_, &QLineEdit::textEdited, this, [this] { hasOwnTitle_ = true; });
  column.addWidget(title_);
  seed_ = field("newStudySeed", tr("Seed"), "1");
  seed_->setFixedWidth(sized(fieldWidth_px));
  seed_->setToolTip(
      tr("Everything that is drawn depends on it; the same seed gives the same study"));
  column.addWidget(namedRow(tr("Seed"), seed_, this));
  resolution_ = new Selector("newStudyResolution", tr("Resolution"), this);
  const QString names[] = {tr("Coarse and fast"), tr("Usual"), tr("Fine and slow")};
  for (std::size_t i = 0; i < std::size(resolutions); ++i)
    resolution_->addChoice(tr("%1: %2 nodes, %3 ms")
                               .arg(names[i])
                               .arg(resolutions[i].nodes)
                               .arg(numberText(resolutions[i].timeStep_ms, 0)),
                           QString::fromLatin1(resolutions[i].name));
  resolution_->show(QStringLiteral("usual"), {});
  cores_ = new Selector("newStudyCores", tr("Cores"), this);
  for (unsigned i = 1; i <= processors(); ++i)
    cores_->addChoice(i == 1 ? tr("1 core") : tr("%1 cores").arg(i), QString::number(i));
  cores_->show(QString::number(std::max(2u, processors()) - 1), {});
  for (Selector* each : {resolution_, cores_}) {
    column.addWidget(each);
    connect(each, &Selector::chosen, this, &NewStudy::edited);
  }
  note_ = new WrappedLabel({}, this);
  note_->setObjectName(QStringLiteral("newStudyNote"));
  note_->setFont(typeface(13));
  column.addSpacing(spacing);
  column.addWidget(note_);
  start_ = panelButton(tr("Start"), "startStudyButton", this);
  start_->setProperty("primary", true);
  connect(start_, &QPushButton::clicked, this, [this] {
    const auto asked = draft();
    if (!asked) return;
    hasOwnTitle_ = false;  // the next study has another
    Q_EMIT startRequested(*asked);
  });
  auto* back = panelButton(tr("Back"), "leaveNewStudyButton", this);
  back->setToolTip(tr("Esc"));
  connect(back, &QPushButton::clicked, this, &NewStudy::leaveRequested);
  column.addWidget(start_);
  column.addWidget(back);
  column.addSpacing(2 * spacing);
  stored_ = new StoredStudies(this);
  column.addWidget(stored_);
  connect(stored_, &StoredStudies::asked, this, &NewStudy::storedRequested);
}

void NewStudy::proposeTitle()
{
  const QString usual =
      tr("Study of %1").arg(QLocale().toString(QDate::currentDate(), QLocale::ShortFormat));
  const QStringList taken = storedTitles();
  QString title = usual;
  for (int number = 2; taken.contains(title); ++number)
    title = tr("%1 (%2)").arg(usual).arg(number);
  title_->setText(title);
}

void NewStudy::refresh()
{
  if (!hasOwnTitle_ || title_->text().trimmed().isEmpty()) proposeTitle();
  listPatients();
  stored_->refresh();
  edited();
}

void NewStudy::listPatients()
{
  const std::vector<std::string> before = checkedOf(patients_);
  delete patientList_;
  patients_.clear();
  patientList_ = new QWidget(this);
  auto* rows = new QVBoxLayout(patientList_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(spacing / 2);
  const auto add = [&](const anatomy::Patient& patient, const std::filesystem::path& file) {
    const std::string name = file.string();
    rows->addWidget(
        box(patients_, nameOfPatient(patient), name,
            QStringLiteral("newStudy-patient-%1").arg(QString::fromStdString(file.stem().string())),
            std::find(before.begin(), before.end(), name) != before.end()));
    patients_.back().box->setToolTip(numbersOfPatient(patient));
  };
  rows->addWidget(panelHeading(tr("PATIENTS"), patientList_));
  for (const SavedPatient& each : savedPatients())
    if (each.patient.basalTurn) add(each.patient, std::filesystem::absolute(each.file));
  if (patients_.empty()) {
    auto* none = new WrappedLabel(tr("No saved patient has A and B."), patientList_);
    none->setFont(typeface(12));
    none->setProperty("quiet", true);
    rows->addWidget(none);
  }
  rows->addWidget(panelHeading(tr("SHIPPED EXAMPLES"), patientList_));
  for (const std::string& name : shippedNames("resources/patients"))
    if (const auto file = findByName("patient", "resources/patients", name))
      if (const auto patient = anatomy::loadPatient(*file); patient && patient->basalTurn)
        add(*patient, std::filesystem::absolute(*file));
  patientRows_->addWidget(patientList_);
}

unsigned NewStudy::jobs() const { return std::max(1u, cores_->value().toUInt()); }

std::optional<StudyDraft> NewStudy::draft() const
{
  StudyDraft draft;
  draft.title = title_->text().trimmed().toStdString();
  draft.arrays = checkedOf(arrays_);
  draft.frictions = checkedOf(frictions_);
  draft.hasMean = mean_->isChecked();
  for (const std::string& file : checkedOf(patients_)) draft.patients.emplace_back(file);
  const auto simulated = wholeIn(*simulated_, 0.0), samples = wholeIn(*samples_, 1.0),
             seed = wholeIn(*seed_, 0.0);
  if (!simulated || !samples || !seed) return std::nullopt;
  draft.simulated = std::size_t(*simulated);
  draft.samples = std::size_t(*samples);
  draft.seed = std::uint64_t(*seed);
  for (const Limits& each : limits_) {
    const auto low = typedNumber(each.low->text()), high = typedNumber(each.high->text());
    if (!low || !high) return std::nullopt;
    draft.values.push_back({each.key, *low / each.divisor, *high / each.divisor});
  }
  for (const Resolution& each : resolutions)
    if (resolution_->value() == QLatin1String(each.name)) {
      draft.nodes = each.nodes;
      draft.timeStep_ms = each.timeStep_ms;
    }
  return draft;
}

void NewStudy::edited()
{
  if (note_ == nullptr || seed_ == nullptr || limits_.empty()) return;  // still being made
  estimate_.cancel();
  showMessage(tr("Estimating the time…"), false);
  waiting_.start();
}

void NewStudy::check()
{
  for (const QLineEdit* each : {simulated_, samples_, seed_})
    if (!wholeIn(*each, each == samples_ ? 1.0 : 0.0))
      return showMessage(tr("%1 is “%2”; a whole number from %3 to 1,000,000 is needed.")
                             .arg(each->accessibleName(), each->text())
                             .arg(each == samples_ ? 1 : 0),
                         false);
  for (const Limits& each : limits_)
    for (const QLineEdit* end : {each.low, each.high})
      if (!typedNumber(end->text()))
        return showMessage(
            tr("%1: “%2” is no number. Enter one.").arg(end->accessibleName(), end->text()), false);
  const auto entered = draft();
  if (!entered) return;
  for (std::size_t i = 0; i < limits_.size(); ++i)
    if (entered->values[i].low > entered->values[i].high)
      return showMessage(tr("%1 is %2, above the other limit, %3. Exchange them.")
                             .arg(limits_[i].low->accessibleName(), limits_[i].low->text(),
                                  limits_[i].high->text()),
                         false);
  if (entered->title.empty()) return showMessage(tr("The study has no title. Enter one."), false);
  if (entered->arrays.empty())
    return showMessage(tr("No array is chosen. Choose one or more."), false);
  if (entered->frictions.empty())
    return showMessage(tr("No friction is chosen. Choose one or more."), false);
  if (entered->simulated == 0 && !entered->hasMean && entered->patients.empty())
    return showMessage(
        tr("There is no cochlea. Enter a number of simulated ones, or choose another."), false);
  estimate_.check(*entered);
}

void NewStudy::showMessage(const QString& sentence, bool canStart)
{
  note_->setText(sentence);
  canStart_ = canStart;
  showState();
}

void NewStudy::setBusy(bool isBusy)
{
  isBusy_ = isBusy;
  stored_->setBusy(isBusy);
  showState();
}

void NewStudy::showState()
{
  start_->setEnabled(canStart_ && !isBusy_);
  start_->setToolTip(isBusy_ ? tr("A study is running.") : QString());
}

}  // namespace perilymph::gui
