// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/OutcomePage.h"

#include <QDate>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QStackedWidget>
#include <QStringList>
#include <algorithm>

#include "gui/archive/ArchiveView.h"
#include "gui/pages/ct/CtSeriesList.h"
#include "gui/pages/ct/CtSource.h"
#include "gui/pages/outcome/EarQuestion.h"
#include "gui/pages/outcome/OutcomePanel.h"
#include "gui/pages/outcome/OutcomeView.h"
#include "gui/pages/outcome/SurgeryForm.h"
#include "gui/report/OutcomeReport.h"
#include "gui/setup/OutcomeWords.h"
#include "gui/setup/ScanFolders.h"
#include "gui/setup/Setup.h"
#include "gui/setup/TableFiles.h"
#include "gui/text/DataText.h"
#include "gui/text/TaskText.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/UtcTime.h"
#include "perilymph/imaging/AcquisitionDay.h"
#include "perilymph/outcome/ClinicLibrary.h"

namespace perilymph::gui {

namespace {

constexpr double outcomeZoom =
    1.5;  // contacts apart enough to be dragged, the basal turn whole (choice)
constexpr double outcomeSlab_mm = 2.0;  // a contact is seen in it where the plane passes beside it
// Of the unrolled scala on paper [px].
constexpr double paperWidth_px = 760.0, paperHeight_px = 170.0;

QString stepText(OutcomeStep step)
{
  switch (step) {
    case OutcomeStep::readBefore:
      return OutcomePage::tr("Reading the CT before surgery…");
    case OutcomeStep::measureBefore:
      return OutcomePage::tr("Measuring the ear in the CT before surgery…");
    case OutcomeStep::carryOver:
      return OutcomePage::tr("Carrying the ear over from the CT before surgery…");
    case OutcomeStep::measureHere:
      return OutcomePage::tr("Measuring the ear in this CT…");
    case OutcomeStep::findContacts:
      break;
  }
  return OutcomePage::tr("Finding the contacts…");
}

Result<electrode::ArrayDesign> arrayNamed(const std::string& name)
{
  const auto file = findByName("array", "plugins/electrodes", name);
  if (!file) return file.error();
  return electrode::loadArray(*file);
}

}  // namespace

OutcomePage::OutcomePage(const InsertionControl& control, QWidget* parent)
    : Page("outcome", tr("Outcome"), Icon::outcome, parent),
      control_(control),
      ct_(this),
      thumbnails_(this),
      work_(this),
      planning_(this),
      saving_(this),
      panel_(new OutcomePanel(this)),
      stages_(new QStackedWidget(this)),
      empty_(new EmptyPage(
          tr("Plan and outcome"),
          tr("Choose a patient and open the CT after surgery, or drop it here. The contacts of the "
             "array are found, measured and shown beside the plan."),
          this)),
      view_(new OutcomeView(study_, this)),
      archive_(new ArchiveView(this, QStringLiteral("outcome-")))
{
  empty_->offer(tr("Open folder…"));
  empty_->offerAlso(tr("From the archive…"));
  for (QWidget* each : {static_cast<QWidget*>(empty_), static_cast<QWidget*>(view_),
                        static_cast<QWidget*>(archive_)})
    stages_->addWidget(each);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(panel_);
  row->addWidget(stages_, 1);
  connectCt();
  connectPanel();
  connectWork();
}

Page::Acceptance OutcomePage::accepts(const std::filesystem::path& /*file*/) const
{
  // which files hold a CT is known after reading only
  return Acceptance::whileShown;
}

void OutcomePage::onShown()
{
  const bool hadPatient = panel_->patient().has_value();
  panel_->refresh();
  if (hadPatient && !panel_->patient()) return leavePatient();  // removed on another page
  if (!panel_->patient()) takePatientOver();
  // plans and insertions are made on other pages
  if (panel_->patient()) readPlanned(planned_.array.empty());
}

void OutcomePage::takePatientOver()
{
  const auto savedFile = [](const std::optional<anatomy::Patient>& patient) {
    const auto saved = patient ? findSavedPatient(patient->label, patient->side) : std::nullopt;
    return saved ? saved->file : std::filesystem::path();
  };
  const std::filesystem::path inserted = savedFile(control_.scenario().patient()),
                              planned =
                                  savedFile(plannedPatient_ ? plannedPatient_() : std::nullopt);
  // two patients: which one is meant is not known
  if (!inserted.empty() && !planned.empty() && inserted != planned) return;
  const std::filesystem::path& file = inserted.empty() ? planned : inserted;
  if (!file.empty()) panel_->choosePatient(file);
}

void OutcomePage::showServers() { archive_->showServers(); }

bool OutcomePage::isBusy() const { return ct_.isBusy() || work_.isBusy() || archive_->isBusy(); }

bool OutcomePage::cancel()
{
  if (stages_->currentWidget() == archive_) {
    if (!archive_->cancel()) showArchive(false);
    return true;
  }
  if (!ct_.isBusy() && !work_.isBusy()) return false;
  ct_.cancel();
  work_.cancel();
  return true;
}

bool OutcomePage::takeKey(const QKeyEvent& event)
{
  const bool isUndo = event.matches(QKeySequence::Undo), isRedo = event.matches(QKeySequence::Redo);
  if (isUndo && history_.canUndo()) step(&FoundHistory::undo);
  if (isRedo && history_.canRedo()) step(&FoundHistory::redo);
  return isUndo || isRedo;
}

std::optional<Page::Unfinished> OutcomePage::unfinished() const
{
  if (isSaved_ || !panel_->patient() || !(found() || panel_->form().hasAnswers()))
    return std::nullopt;
  const QString name = nameOfPatient(panel_->patient()->patient);
  return Unfinished{found()
                        ? tr("The outcome of %1 is not saved in the record.").arg(name)
                        : tr("What the surgeon knows of %1 is not saved in the record.").arg(name),
                    tr("Keep it")};
}

void OutcomePage::endUnfinished()
{
  leaveFound();
  isSaved_ = true;
}

void OutcomePage::leaveCt(const std::function<void()>& act)
{
  // answers stay with the patient
  if (!found()) return act();
  Q_EMIT endingRequested(tr("Open without saving"), act);
}

void OutcomePage::connectCt()
{
  connect(&ct_, &CtWork::progressed, this, &OutcomePage::showProgress);
  connect(&ct_, &CtWork::listed, this, [this](const imaging::CtSeriesList& list) {
    list_ = list;
    panel_->source().series().show(list);
    thumbnails_.readThumbnails(list);
  });
  connect(&thumbnails_, &CtWork::thumbnailsRead, &panel_->source().series(),
          &CtSeriesList::showThumbnails);
  connect(&ct_, &CtWork::ctRead, this,
          [this](const std::shared_ptr<imaging::LoadedCt>& loaded) { showCt(std::move(*loaded)); });
  connect(&ct_, &CtWork::seriesMissed, this, [this] {
    wanted_.clear();
    panel_->showIdle(tr("The CT of this outcome is no longer where it was read."), true);
  });
  connect(&ct_, &CtWork::failed, this, [this](const QString& sentence) {
    wanted_.clear();
    panel_->showIdle(sentence, true);
  });
  connect(archive_, &ArchiveView::leaveRequested, this, [this] { showArchive(false); });
  connect(archive_, &ArchiveView::serversRequested, this, &OutcomePage::serversRequested);
  connect(archive_, &ArchiveView::fetched, this, [this](const std::filesystem::path& folder) {
    leaveCt([this, folder] { read(folder, {}); });
  });
}

void OutcomePage::connectPanel()
{
  const CtSource& source = panel_->source();
  connect(empty_, &EmptyPage::actionRequested, &source, &CtSource::askFolder);
  connect(empty_, &EmptyPage::otherRequested, this, [this] { showArchive(true); });
  connect(&source, &CtSource::opened, this, &OutcomePage::open);
  connect(&source, &CtSource::archiveRequested, this, [this] { showArchive(true); });
  connect(&source, &CtSource::recentRequested, this, [this](const CtRequest& request) {
    leaveCt([this, request] { read(placeOfScan(request.series), request.series); });
  });
  connect(&source, &CtSource::seriesChosen, this, [this](const std::string& uid) {
    if (study_.hasCt() && study_.series().uid == uid) return;
    leaveCt([this, uid] {
      endSearch();
      beginTask(tr("Reading the CT…"));
      ct_.read(list_, uid);
    });
  });
  connect(panel_, &OutcomePanel::patientWanted, this, [this](const std::filesystem::path& patient) {
    Q_EMIT endingRequested(tr("Change without saving"),
                           [this, patient] { panel_->choosePatient(patient); });
  });
  connect(panel_, &OutcomePanel::patientChosen, this, &OutcomePage::choosePatient);
  connect(panel_, &OutcomePanel::versionWanted, this, [this](std::size_t place) {
    Q_EMIT endingRequested(tr("Open without saving"), [this, place] { openVersion(place); });
  });
  connect(panel_, &OutcomePanel::findRequested, this, &OutcomePage::find);
  connect(panel_, &OutcomePanel::cancelRequested, this, &OutcomePage::cancel);
  connect(panel_, &OutcomePanel::undoRequested, this, [this] { step(&FoundHistory::undo); });
  connect(panel_, &OutcomePanel::redoRequested, this, [this] { step(&FoundHistory::redo); });
  connect(panel_, &OutcomePanel::saveRequested, this, &OutcomePage::save);
  connect(panel_, &OutcomePanel::exportRequested, this, &OutcomePage::askExport);
  connect(panel_, &OutcomePanel::reportRequested, this, &OutcomePage::askReport);
  connect(&panel_->form(), &SurgeryForm::changed, this, [this] {
    const std::string array = panel_->form().surgery().array;
    const bool isOther = !array.empty() && array != planned_.array;
    if (!array.empty() && !searched_.empty() && searched_ != array) endSearch();
    if (isOther && found() && found()->array != array) {
      planNumber_.clear();
      leaveFound();
    }
    const bool isOtherDay = surgeryDay() != plannedFor_;
    if (isOtherDay) planNumber_.clear();
    if ((isOther || isOtherDay) && panel_->patient()) readPlanned(isOther || planning_.isBusy());
    // a form that is shown again with what it had is no change
    const outcome::Surgery answered = panel_->form().surgery();
    const std::string day = panel_->form().ctDay();
    if (answered_ != answered || answeredDay_ != day) isSaved_ = false;
    answered_ = answered;
    answeredDay_ = day;
    showFound();
  });
  connect(view_, &OutcomeView::contactMoved, this, &OutcomePage::moveContact);
}

void OutcomePage::connectWork()
{
  connect(&work_, &OutcomeWork::progressed, this, &OutcomePage::showStep);
  connect(&work_, &OutcomeWork::earFound, this,
          [this](const OutcomeWork::SharedEar& ear, const QString& note) {
            earNote_ = note;
            if (isReopened_)
              showReopened(ear);
            else
              acceptEar(ear);
          });
  connect(&work_, &OutcomeWork::found, this,
          [this](const std::shared_ptr<const outcome::FoundArray>& found) {
            searched_.clear();
            history_.setFound(found);
            series_ = study_.series().key;
            isSaved_ = false;
            panel_->showIdle(earNote_);
            showFound();
          });
  connect(&work_, &OutcomeWork::failed, this, [this](const QString& sentence) {
    searched_.clear();
    isReopened_ = false;
    panel_->showIdle(sentence, true);
  });
  connect(&saving_, &ReportSaving::saved, this,
          [this](const std::filesystem::path&, const QString& sentence) {
            panel_->showIdle(sentence);
          });
  connect(&saving_, &ReportSaving::failed, this,
          [this](const QString& sentence) { panel_->showIdle(sentence, true); });
}

void OutcomePage::showArchive(bool isShown)
{
  if (!isShown && stages_->currentWidget() == archive_) archive_->leave();
  if (isShown)
    stages_->setCurrentWidget(archive_);
  else
    stages_->setCurrentWidget(study_.hasCt() || found() ? static_cast<QWidget*>(view_) : empty_);
  if (isShown) archive_->enter();
}

void OutcomePage::open(const std::filesystem::path& path)
{
  Q_EMIT pageRequested(id());  // it may have been dropped on another page
  leaveCt([this, path] {
    panel_->source().remember(path);
    read(path, {});
  });
}

void OutcomePage::read(const std::filesystem::path& path, const std::string& series)
{
  endSearch();
  beginTask(tr("Reading the CT…"));
  ct_.open(path, series);
}

void OutcomePage::endSearch()
{
  work_.cancel();
  // it was asked of another CT or patient
  if (question_) question_->reject();
}

void OutcomePage::showCt(imaging::LoadedCt&& loaded)
{
  const bool isOfSaved = !wanted_.empty() && loaded.series.key == wanted_;
  wanted_.clear();
  if (!isOfSaved) leaveFound();
  acquired_ = imaging::acquisitionDay(list_, loaded.series.uid);
  SurgeryForm& form = panel_->form();
  if (!isOfSaved || form.ctDay().empty()) {
    form.setCtDay(acquired_);
    if (isOfSaved && !form.ctDay().empty()) isSaved_ = false;  // it was saved without the day
    if (panel_->patient() && surgeryDay() != plannedFor_) readPlanned(true);
  }
  ear_.reset();
  QStringList notes;
  for (const Sentence& warning : loaded.series.warnings) notes << dataText(warning);
  study_.setCt(std::move(loaded));
  study_.setSlab(outcomeSlab_mm, imaging::Projection::maximum);  // metal is brightest
  rememberScan(study_.series().key, list_.path);
  panel_->showIdle(notes.join(QLatin1Char('\n')));
  showArchive(false);
  showFound();
  if (!isOfSaved) return find();
  if (!panel_->patient()) return;
  isReopened_ = true;
  findEar();
}

void OutcomePage::beginTask(const QString& task)
{
  task_ = task;
  since_.start();
  shownFraction_ = 0.0;
  panel_->showTask(task_, 0.0);
}

void OutcomePage::showProgress(double fraction)
{
  panel_->showTask(taskText(task_, fraction, 1e-3 * double(since_.elapsed())), fraction);
}

void OutcomePage::showStep(OutcomeStep step, double fraction)
{
  task_ = stepText(step);
  if (fraction < shownFraction_) since_.start();  // the ear could not be carried over
  shownFraction_ = fraction;
  showProgress(fraction);
}

void OutcomePage::choosePatient()
{
  // answers that were typed before are of the first patient who is chosen
  const outcome::Surgery typed = hadPatient_ ? outcome::Surgery{} : panel_->form().surgery();
  leavePatient();
  if (typed != outcome::Surgery{}) panel_->form().setSurgery(typed);
  hadPatient_ = true;
  readPlanned(true);
}

void OutcomePage::leavePatient()
{
  endSearch();
  planning_.cancel();
  ear_.reset();
  planned_ = {};
  planNumber_.clear();
  wanted_.clear();
  leaveFound();
  panel_->form().setCtDay(study_.hasCt() ? acquired_ : std::string());
  panel_->form().setSurgery({});
}

void OutcomePage::readPlanned(bool isToFind)
{
  const anatomy::Patient patient = panel_->patient()->patient;
  const std::string array = panel_->form().surgery().array;
  plannedFor_ = surgeryDay();
  planning_.run(
      "The plan",
      [patient, array, number = planNumber_, day = plannedFor_,
       recorded = control_.openRecording().value_or(std::filesystem::path())](
          const std::stop_token& stop) -> Result<PlannedEar> {
        return plannedEar(patient, array, number, day, recorded, stop);
      },
      [this, isToFind](const Result<PlannedEar>& planned) {
        if (!planned) return panel_->showIdle(dataText(planned.error().message), true);
        const std::string now = panel_->form().surgery().array;
        if (!now.empty() && now != planned->array)
          return readPlanned(isToFind);  // chosen meanwhile
        planned_ = *planned;
        if (!planned_.array.empty()) panel_->form().proposeArray(planned_.array);
        showFound();
        if (isToFind && !found() && !isBusy()) find();
      });
}

std::optional<EarlierCt> OutcomePage::earlierCt() const
{
  const SavedPatient& saved = *panel_->patient();
  const std::string series = anatomy::statedSeries(saved.patient);
  const std::filesystem::path place =
      series.empty() ? std::filesystem::path() : placeOfScan(series);
  std::error_code ignored;
  if (place.empty() || !std::filesystem::exists(place, ignored) || series == study_.series().key)
    return std::nullopt;
  EarlierCt before{place, series, {}};
  for (const session::PatientVersion& version : saved.record.versions) {
    const auto measured = anatomy::patientIn(version.patient, saved.file.string());
    if (!measured || anatomy::statedSeries(*measured) != series) continue;
    before.marks = {};
    for (const session::PatientLandmark& each : version.landmarks)
      if (const auto mark = ct::markNamed(each.name); mark && each.isByHand)
        before.marks[*mark] = Eigen::Vector3d(each.lps_mm[0], each.lps_mm[1], each.lps_mm[2]);
  }
  return before;
}

void OutcomePage::find()
{
  const SurgeryForm& form = panel_->form();
  if (!study_.hasCt() || !panel_->patient() || form.surgery().array.empty() ||
      !form.error().isEmpty())
    return showFound();
  isReopened_ = false;
  if (ear_) return findContacts();
  findEar();
}

void OutcomePage::findEar()
{
  const auto before = earlierCt();
  beginTask(stepText(before ? OutcomeStep::readBefore : OutcomeStep::measureHere));
  work_.findEar(study_.volume(), before, panel_->patient()->patient.side);
}

void OutcomePage::acceptEar(const OutcomeWork::SharedEar& ear)
{
  const auto join = [this, ear] {
    ear_ = ear;
    showEar();
    findContacts();
  };
  const QStringList doubts = earDoubts(*panel_->patient(), *ear, study_.volume()->provenance());
  if (doubts.isEmpty()) return join();
  panel_->showIdle({});
  const QString name = nameOfPatient(panel_->patient()->patient);
  const anatomy::Side side = ear->measures.side;
  question_ = new EarQuestion(
      name, doubts, side != panel_->patient()->patient.side ? std::optional(side) : std::nullopt,
      this);
  connect(question_, &QDialog::accepted, this, join);
  connect(question_, &QDialog::rejected, this, [this, name] {
    leaveFound();
    panel_->showIdle(tr("This CT was not joined to %1.").arg(name));
  });
  question_->open();
}

void OutcomePage::showEar()
{
  study_.showEar(ear_->measures);
  study_.zoom(outcomeZoom);
}

void OutcomePage::showReopened(const OutcomeWork::SharedEar& ear)
{
  isReopened_ = false;
  ear_ = ear;
  showEar();
  panel_->showIdle(earNote_);
  showFound();
  if (!found() || history_.now().isStale) findContacts();
}

void OutcomePage::findContacts()
{
  const std::string name = panel_->form().surgery().array;
  if (name.empty()) return panel_->showIdle(tr("Choose the implanted array first."), true);
  const auto array = arrayNamed(name);
  if (!array) return panel_->showIdle(dataText(array.error().message), true);
  beginTask(stepText(OutcomeStep::findContacts));
  outcome::ContactsRequest request;
  request.array = *array;
  request.arrayName = name;
  request.byHand = history_.now().byHand;
  searched_ = name;
  work_.findContacts(study_.volume(), ear_, std::move(request));
}

void OutcomePage::moveContact(int number, const Eigen::Vector3d& point_P)
{
  if (!found()) return;
  FoundHistory::State next = history_.now();
  next.byHand[number] = point_P;
  auto moved = std::make_shared<outcome::FoundArray>(*next.found);
  for (outcome::FoundContact& each : moved->contacts)
    if (each.number == number) {
      each.position_P = point_P;
      each.isByHand = true;
    }
  next.found = moved;
  next.isStale = true;
  history_.change(std::move(next));
  isSaved_ = false;
  showFound();
  findAround();
}

void OutcomePage::findAround()
{
  // the ear of a saved outcome is on its way
  if (history_.now().isStale && !isReopened_) find();
}

void OutcomePage::step(void (FoundHistory::*way)())
{
  if (!isReopened_) work_.cancel();
  (history_.*way)();
  isSaved_ = false;
  showFound();
  findAround();
}

void OutcomePage::leaveFound()
{
  history_.begin({});
  series_.clear();
  if (!panel_->form().hasAnswers()) isSaved_ = true;
  showFound();
}

void OutcomePage::showFound()
{
  QStringList doubts;
  const QString impossible = obstacle();
  if (!impossible.isEmpty()) doubts << impossible;
  if (found()) doubts << contradictionTexts(panel_->form().surgery(), *found());
  view_->show(found(), planned_, planDoubt(), doubts);
  view_->setStale(history_.now().isStale);
  panel_->showState({study_.hasCt(), found() && !history_.now().isStale, history_.canUndo(),
                     history_.canRedo(), isSaved_, impossible});
  if (stages_->currentWidget() != archive_) showArchive(false);
}

void OutcomePage::openSaved(const std::filesystem::path& patient, std::size_t place)
{
  Q_EMIT pageRequested(id());
  Q_EMIT endingRequested(tr("Open without saving"), [this, patient, place] {
    if (panel_->choosePatient(patient)) openVersion(place);
  });
}

void OutcomePage::openVersion(std::size_t place)
{
  const SavedPatient saved = *panel_->patient();
  if (place >= saved.record.outcomes.size()) return;
  const session::PatientOutcome& version = saved.record.outcomes[place];
  auto content = outcome::outcomeIn(version.content, "record");
  if (!content) return panel_->showIdle(dataText(content.error().message), true);
  endSearch();
  ear_.reset();
  study_.clear();
  planned_ = {};
  std::map<int, Eigen::Vector3d> byHand;
  for (const outcome::FoundContact& each : content->found.contacts)
    if (each.isByHand) byHand[each.number] = each.position_P;
  panel_->form().setCtDay(outcome::ctDayOf(*content, version.utc));
  panel_->form().setSurgery(content->surgery);
  planNumber_ = content->plan;
  series_ = version.series;
  history_.begin({byHand, std::make_shared<const outcome::FoundArray>(std::move(content->found))});
  isSaved_ = true;
  panel_->showVersion(place);
  readPlanned(true);
  showFound();
  std::error_code ignored;
  const std::filesystem::path scan =
      series_.empty() ? std::filesystem::path() : placeOfScan(series_);
  if (scan.empty() || !std::filesystem::exists(scan, ignored))
    return panel_->showIdle(tr("Saved outcome. Its CT is no longer where it was read."));
  wanted_ = series_;
  read(scan, series_);
}

outcome::OutcomeContent OutcomePage::content() const
{
  outcome::Surgery surgery = panel_->form().surgery();
  surgery.array = found()->array;
  const bool isChosen =
      planned_.plan && !planning_.isBusy();  // else that which the outcomes choose
  return {*found(), surgery, isChosen ? planned_.plan->plan.fingerprint : std::string(), series_};
}

std::string OutcomePage::surgeryDay() const
{
  return outcome::surgeryDay(panel_->form().ctDay(), panel_->form().surgery());
}

QString OutcomePage::planDoubt() const
{
  if (!planned_.plan) return {};
  return predictionDoubt(planned_.planMadeUtc, panel_->form().ctDay(), panel_->form().surgery());
}

QString OutcomePage::obstacle() const
{
  if (!found()) return {};
  outcome::MeasuredOutcome measured;
  measured.array = found()->array;
  measured.depth_mm = {found()->insertedLength_mm, found()->insertedLengthSd_mm};
  if (found()->contactsInside > 0) measured.angle_deg = found()->angularInsertionDepth_deg;
  measured.plan.depths_mm = {found()->insertedLength_mm};
  if (const auto array = arrayNamed(found()->array))
    measured.plan.insertable_mm = inMillimeters(array->insertable);
  const auto checked = outcome::checkOutcome(measured, Sentence{"this ear"});
  return checked ? QString() : dataText(checked.error().message);
}

void OutcomePage::save()
{
  if (!found() || !panel_->patient() || !obstacle().isEmpty()) return;
  const std::string utc = utcNow();
  outcome::OutcomeContent saving = content();
  const QDate ctDay =
      QDate::fromString(QString::fromStdString(panel_->form().ctDay()), Qt::ISODate);
  const QDate today = QDate::fromString(QString::fromStdString(utc).left(10), Qt::ISODate);
  if (ctDay.isValid()) saving.ctAge_days = int(ctDay.daysTo(today));
  const auto saved =
      session::changePatientRecord(panel_->patient()->file, [&](session::PatientRecord& record) {
        record.outcomes.push_back({utc, series_, outcome::outcomeJson(saving)});
      });
  if (!saved) return panel_->showIdle(dataText(saved.error().message), true);
  isSaved_ = true;
  rememberScan(series_, placeOfScan(series_), panel_->patient()->patient.label);
  panel_->refresh();
  showFound();
  Q_EMIT kept();
  QStringList sentences{tr("Saved in the record of %1, version %2.")
                            .arg(nameOfPatient(panel_->patient()->patient))
                            .arg(saved->outcomes.size())};
  if (const QString doubt = planDoubt(); !doubt.isEmpty()) sentences << doubt;
  panel_->showIdle(sentences.join(QLatin1Char(' ')));
}

void OutcomePage::askExport(OutcomeExport kind)
{
  if (!found()) return;
  const QString code =
      panel_->patient()
          ? QString::fromStdString(fileStemOf(panel_->patient()->patient.label) + "-" +
                                   anatomy::nameOf(panel_->patient()->patient.side))
          : QStringLiteral("outcome");
  const std::pair<QString, QString> endings[] = {
      {QStringLiteral(".csv"), tr("Tables (*.csv)")},
      {QStringLiteral(".json"), tr("JSON (*.json)")},
      {QStringLiteral(".mrk.json"), tr("Markups (*.mrk.json)")},
      {QStringLiteral(".png"), tr("Pictures (*.png)")}};
  const auto& [ending, filter] = endings[std::size_t(kind)];
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the outcome"),
      QStringLiteral("%1/%2-outcome%3").arg(documentsFolder(), code, ending), filter);
  if (!file.isEmpty()) exportTo(kind, file.toStdString());
}

void OutcomePage::exportTo(OutcomeExport kind, const std::filesystem::path& file)
{
  if (!found()) return;
  const auto written = [&]() -> Result<void> {
    switch (kind) {
      case OutcomeExport::table:
        return writeTable(file, outcome::outcomeCsv(*found()), outcome::outcomeDictionaryCsv());
      case OutcomeExport::json:
        return writeWhole(file, outcome::outcomeJson(content()));
      case OutcomeExport::markups:
        return writeWhole(file, outcome::outcomeMarkups(*found()));
      case OutcomeExport::picture:
        break;
    }
    const QImage picture = view_->picture();
    return writeWhole(file, [&picture](const std::filesystem::path& place) {
      return picture.save(QString::fromStdString(place.string()), "PNG");
    });
  }();
  if (!written) return panel_->showIdle(dataText(written.error().message), true);
  panel_->showIdle(tr("Saved to %1.").arg(QString::fromStdString(file.string())));
}

void OutcomePage::askReport()
{
  if (!found() || !panel_->patient()) return;
  const anatomy::Patient& patient = panel_->patient()->patient;
  const QString ear =
      QString::fromStdString(fileStemOf(patient.label) + "-" + anatomy::nameOf(patient.side));
  if (const auto place =
          askReportPlace(tr("Report of the outcome"), QStringLiteral("%1-outcome").arg(ear), this))
    writeReport(*place);
}

void OutcomePage::writeReport(const ReportPlace& place)
{
  if (!found() || !panel_->patient()) return;
  OutcomeReportContent report{panel_->patient()->patient,
                              content(),
                              planned_.plan,
                              planned_.place,
                              planned_.planMadeUtc,
                              planned_.ends,
                              planDoubt(),
                              study_.hasCt() ? view_->picture() : QImage(),
                              view_->unrolledOnPaper(paperWidth_px, paperHeight_px)};
  saving_.save(
      [&report](const std::filesystem::path& pdf) { return writeOutcomeReport(report, pdf); },
      report.identity(), place);
}

}  // namespace perilymph::gui
