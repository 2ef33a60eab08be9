// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanPage.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/pages/plan/PlanHeader.h"
#include "gui/pages/plan/PlanList.h"
#include "gui/pages/plan/PlanNotes.h"
#include "gui/pages/plan/PlanPanel.h"
#include "gui/pages/plan/PlanView.h"
#include "gui/pages/plan/PlannedSetup.h"
#include "gui/run/ScenarioApproach.h"
#include "gui/setup/Catalog.h"
#include "gui/setup/MeasureVersions.h"
#include "gui/setup/PlannedForces.h"
#include "gui/setup/PlannedFriction.h"
#include "gui/text/ClinicalText.h"
#include "gui/text/DataText.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int emptyStage = 0, planStage = 1, arraysStage = 2;

/// Plans without an approach have the scenario's, along the axis of the opening.
bool isSameApproach(const std::optional<anatomy::Approach>& one,
                    const std::optional<anatomy::Approach>& other)
{
  return areSame(one.value_or(anatomy::Approach{}), other.value_or(anatomy::Approach{}));
}

}  // namespace

PlanPage::PlanPage(QWidget* parent)
    : Page("plan", tr("Plan"), Icon::plan, parent),
      work_(this),
      reporting_(this),
      scenario_(planning::PlanRequest{}.scenario),
      panel_(new PlanPanel(this)),
      stages_(new QStackedWidget(this)),
      empty_(new EmptyPage({}, {}, this)),
      head_(new PlanHeader(this)),
      list_(new PlanList(this)),
      view_(new PlanView(this)),
      open_(panelButton(QString(), "openPlanArrayButton", this)),
      insert_(panelButton(tr("Insert this array"), "insertPlanArrayButton", this)),
      report_(panelButton(tr("Report…"), "planReportButton", this)),
      send_(panelButton(tr("Send to the archive…"), "sendPlanButton", this)),
      back_(panelButton(tr("Back to the table"), "planTableButton", this)),
      notes_(new PlanNotes(this)),
      status_(new StatusLine("planStatus", this))
{
  stages_->addWidget(empty_);
  stages_->addWidget(addPlan());
  stages_->addWidget(addArrays());
  auto* right = new QVBoxLayout;
  right->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, spacing);
  right->setSpacing(spacing);
  right->addWidget(head_);
  right->addWidget(stages_, 1);
  right->addWidget(status_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(panel_);
  row->addLayout(right, 1);
  connectPanel();
  connectWork();
  showEmpty();
  discardPlan();
}

void PlanPage::showEmpty()
{
  if (progress_.isEmpty())
    return empty_->showMessage(
        tr("Plan an insertion"),
        tr("Choose a patient with the measures A and B, or measure a CT on the page CT. Choose the "
           "arrays to be compared and press Compute. Each array is inserted many times; the table "
           "shows what to expect, as bands."));
  QStringList arrays;
  const std::vector<std::string> chosen = panel_->request().arrays;
  for (const CatalogArray& each : catalogArrays())
    if (std::ranges::find(chosen, each.name.toStdString()) != chosen.end()) arrays << each.title;
  empty_->showMessage(tr("Computing the plan"),
                      tr("%1\n\n%2\n\nThe first bands come after 8 simulations of each array.")
                          .arg(arrays.join(tr(" · ")), progress_));
}

QWidget* PlanPage::addPlan()
{
  auto* page = new QWidget(this);
  auto* limits = new WrappedLabel(planLimitsText(), page);
  limits->setObjectName(QStringLiteral("planLimits"));
  limits->setFont(typeface(11));
  limits->setProperty("quiet", true);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(list_, 1);
  auto* verbs = new QHBoxLayout;
  addVerbs(*verbs);
  column->addLayout(verbs);
  column->addWidget(limits);
  column->addWidget(notes_);
  return page;
}

QWidget* PlanPage::addArrays()
{
  auto* page = new QWidget(this);
  back_->setToolTip(tr("Esc"));
  auto* head = new QHBoxLayout;
  head->addWidget(back_);
  head->addStretch();
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addLayout(head);
  column->addWidget(view_, 1);
  connect(back_, &QPushButton::clicked, this, &PlanPage::leaveArrays);
  connect(view_, &PlanView::failed, this,
          [this](const QString& sentence) { showMessage(sentence, true); });
  return page;
}

void PlanPage::addVerbs(QHBoxLayout& row)
{
  open_->setToolTip(tr("Enter, or a double click on a row. Ctrl and Shift select several rows."));
  row.setSpacing(spacing);
  row.addWidget(open_);
  insert_->setToolTip(
      tr("Sets patient and array on the page Insert, where the force is compared "
         "with this plan."));
  row.addWidget(insert_);
  report_->setToolTip(
      tr("Report of this plan as PDF or DICOM: a page for the record and an appendix"));
  row.addWidget(report_);
  send_->setToolTip(tr("Report of this plan into the study of the patient’s CT, as DICOM"));
  row.addWidget(send_);
  row.addStretch();
  connect(report_, &QPushButton::clicked, this, &PlanPage::askReport);
  connect(send_, &QPushButton::clicked, this, [this] {
    if (!plan_) return;
    showMessage(tr("Preparing the report…"));
    reporting_.prepare(plan_, folder_);
  });
  connect(&reporting_, &PlanReportWork::prepared, this, &PlanPage::send);
  connect(&reporting_, &PlanReportWork::failed, this,
          [this](const QString& sentence) { showMessage(sentence, true); });
  connect(&reporting_, &PlanReportWork::written, this,
          [this](const std::filesystem::path& report, const QString& sentence) {
            status_->sayWritten(sentence, report.parent_path());
          });
  connect(insert_, &QPushButton::clicked, this, &PlanPage::insertArray);
  connect(open_, &QPushButton::clicked, this, &PlanPage::openArrays);
  connect(list_, &PlanList::openRequested, this, &PlanPage::openArrays);
  connect(list_, &PlanList::selectionMoved, this, &PlanPage::showVerbs);
  showVerbs();
}

void PlanPage::showVerbs()
{
  const std::size_t count = list_->selected().size();
  open_->setText(count > 1 ? tr("Compare %1 arrays").arg(count) : tr("Open array"));
  insert_->setEnabled(count == 1);
  open_->setEnabled(count >= 1 && count <= PlanView::maxArrays);
}

void PlanPage::openArrays()
{
  if (!plan_ || !open_->isEnabled()) return;
  showMessage({});
  view_->show(plan_, list_->selected(), madeUtc_);
  stages_->setCurrentIndex(arraysStage);
  panel_->hide();
  back_->setFocus();
}

void PlanPage::insertArray()
{
  const std::vector<std::size_t> rows = list_->selected();
  if (!plan_ || rows.size() != 1) return;
  const auto setup = plannedSetup(*plan_, rows.front());
  if (!setup) return showMessage(dataText(setup.error().message), true);
  Q_EMIT insertionRequested({*setup, SetupOrigin::Kind::own, AfterLoading::rest,
                             plannedForce(*plan_, rows.front(), madeUtc_)});
  const QString superseded = supersededText(plan_->request.patient);
  if (!superseded.isEmpty())
    Q_EMIT noted(tr("%1 The insertion is into the cochlea of the plan.").arg(superseded));
}

void PlanPage::askReport()
{
  if (!plan_) return;
  const anatomy::Patient& patient = plan_->request.patient;
  const QString ear =
      QString::fromStdString(fileStemOf(patient.label) + "-" + anatomy::nameOf(patient.side));
  if (const auto place =
          askReportPlace(tr("Report of the plan"), QStringLiteral("%1-plan").arg(ear), this))
    writeReport(*place);
}

void PlanPage::send(const std::string& pdf, const ReportIdentity& identity)
{
  showMessage({});
  sendReport(tr("Report of the plan (PDF)"), pdf, identity, ctPlaces_, this);
}

void PlanPage::writeReport(const ReportPlace& place)
{
  if (!plan_) return;
  showMessage(tr("Preparing the report…"));
  reporting_.write(plan_, folder_, place);
}

bool PlanPage::leaveArrays()
{
  if (stages_->currentIndex() != arraysStage) return false;
  view_->cancel();
  panel_->show();
  stages_->setCurrentIndex(planStage);
  list_->setFocus();
  return true;
}

void PlanPage::connectPanel()
{
  connect(empty_, &EmptyPage::actionRequested, panel_, &PlanPanel::compute);
  connect(panel_, &PlanPanel::readyChanged, this,
          [this](bool isReady) { empty_->offer(isReady ? tr("Compute") : QString()); });
  connect(panel_, &PlanPanel::patientChosen, this, &PlanPage::discardPlan);
  connect(panel_, &PlanPanel::computeRequested, this, &PlanPage::compute);
  connect(panel_, &PlanPanel::cancelRequested, this, &PlanPage::stop);
  connect(notes_, &PlanNotes::failed, this,
          [this](const QString& sentence) { showMessage(sentence, true); });
  connect(panel_, &PlanPanel::planChosen, this, &PlanPage::openStored);
}

Page::Acceptance PlanPage::accepts(const std::filesystem::path& file) const
{
  std::error_code ignored;
  const bool isPlan = file.filename() == "plan.json" ||
                      std::filesystem::is_regular_file(file / "plan.json", ignored);
  return isPlan ? Acceptance::always : Acceptance::none;
}

void PlanPage::open(const std::filesystem::path& folder)
{
  stop();
  const auto stored =
      planning::readPlanFolder(folder.filename() == "plan.json" ? folder.parent_path() : folder);
  if (!stored) return showMessage(dataText(stored.error().message), true);
  panel_->refresh();
  openStored(*stored);
}

void PlanPage::openStored(const StoredPlan& stored)
{
  panel_->showPlan(stored);
  if (stored.shownDraws == 0) {
    discardPlan();
    return showMessage(
        stored.folder == folderOfPlan(stored.request)
            ? tr("This plan was interrupted before its first bands; Compute continues it.")
            : tr("This plan was interrupted before its first bands, and an array, the "
                 "scenario, a distribution or the program was changed since; Compute makes "
                 "a new one."));
  }
  leaveArrays();
  showMessage(tr("Opening the plan…"));
  panel_->showProgress(0.0);
  work_.open(stored);
}

void PlanPage::connectWork()
{
  connect(&work_, &PlanWork::progressed, this, &PlanPage::showProgress);
  connect(&work_, &PlanWork::shown, this, &PlanPage::showPlan);
  connect(&work_, &PlanWork::ended, this, [this](const QString& sentence) {
    endProgress();
    panel_->refresh();
    if (sentence.isEmpty() && plan_ && plan_->seal == Seal::changed)
      return showMessage(dataText(noteOn(Seal::changed)), true);
    if (sentence.isEmpty() && plan_ && !plan_->isCurrent)
      return showMessage(
          tr("An array, the scenario, a distribution or the program was changed since this "
             "plan: it is shown as it was made, and Compute makes a new one."));
    showMessage(sentence, !sentence.isEmpty());
  });
}

void PlanPage::compute()
{
  planning::PlanRequest request = panel_->request();
  request.scenario = scenario_;
  request.resolution = resolution_;
  request.approach = wantedApproach(request.patient);
  if (plan_ &&
      (plan_->request.arrays != request.arrays || plan_->request.friction != request.friction ||
       !isSameApproach(plan_->request.approach, request.approach) ||
       anatomy::patientText(plan_->request.patient) != anatomy::patientText(request.patient)))
    discardPlan();
  if (const auto done = planning::checkDraws(request.draws); !done)
    return showMessage(dataText(done.error().message), true);
  progress_ = tr("Preparing…");
  sinceFirst_.invalidate();
  showEmpty();
  showMessage(progress_);
  panel_->showProgress(0.0);
  work_.compute(request);
}

std::optional<anatomy::Approach> PlanPage::wantedApproach(const anatomy::Patient& patient) const
{
  if (auto ofCt = approachSource_ ? approachSource_(patient) : std::nullopt) {
    // along the axis of the opening is the scenario's own, and one plan with plans made without a CT
    return isAlongAxis(*ofCt) ? std::nullopt : ofCt;
  }
  const bool isSame =
      plan_ && anatomy::patientText(plan_->request.patient) == anatomy::patientText(patient);
  return isSame ? plan_->request.approach : std::nullopt;
}

void PlanPage::showApproach()
{
  const auto patient = plan_ ? std::optional(plan_->request.patient) : panel_->patient();
  if (!patient) return;
  const auto wanted = wantedApproach(*patient);
  const auto shown = plan_ ? plan_->request.approach : wanted;
  head_->showApproach(*patient, shown,
                      isSameApproach(shown, wanted)
                          ? std::nullopt
                          : std::optional(wanted.value_or(anatomy::Approach{})));
}

bool PlanPage::cancel() { return leaveArrays() || stop(); }

bool PlanPage::stop()
{
  if (!work_.isBusy()) return false;
  work_.cancel();
  endProgress();
  panel_->refresh();
  showMessage(tr("Canceled. What is done is kept; Compute continues there."));
  return true;
}

void PlanPage::planFor(const anatomy::Patient& patient)
{
  stop();
  panel_->refresh();
  panel_->setPatient(patient);
  discardPlan();
  Q_EMIT pageRequested(id());
}

void PlanPage::onShown()
{
  if (!work_.isBusy()) panel_->refresh();
  // other measures may be in use by now
  if (plan_)
    head_->show(plan_->request.patient);
  else if (panel_->patient())
    head_->show(*panel_->patient());
  showApproach();
}

void PlanPage::showPlan(const PlanWork::SharedPlan& plan, const StoredPlan& stored)
{
  plan_ = plan;
  folder_ = stored.folder;
  madeUtc_ = stored.madeUtc;
  head_->show(plan->request.patient);
  showApproach();
  const auto draws = plan->arrays.empty() ? 0 : int(plan->arrays.front().draws);
  const QString run = tr("%1 simulations, %2 insertions").arg(draws).arg(plan->insertions.size());
  const QString seal = plan->seal == Seal::changed ? tr("changed by hand, ") : QString();
  head_->setNote(
      tr("%1%2, %3. Medians; bands: %4").arg(seal, run, plannedFriction(*plan), bandsHold(*plan)));
  list_->show(plan);
  showVerbs();
  panel_->showPlan(stored);
  notes_->show(stored.folder);
  if (stages_->currentIndex() == emptyStage) stages_->setCurrentIndex(planStage);
}

void PlanPage::showProgress(std::size_t done, std::size_t all)
{
  if (!work_.isBusy()) return;
  panel_->showProgress(double(done) / double(all));
  progress_ = tr("%1 of at most %2 insertions.").arg(done).arg(all);
  if (const QString left = timeLeft(done, all); !left.isEmpty())
    progress_ = tr("%1 %2").arg(progress_, left);
  showEmpty();
  showMessage(tr("%1 Another page can be shown meanwhile.").arg(progress_));
}

QString PlanPage::timeLeft(std::size_t done, std::size_t all)
{
  if (!sinceFirst_.isValid()) {
    sinceFirst_.start();
    firstDone_ = done;
  }
  // fewer and sooner say little of the rest
  constexpr std::size_t fewest = 4;
  constexpr qint64 shortest_ms = 3000, minute_ms = 60000;
  if (done < firstDone_ + fewest || sinceFirst_.elapsed() < shortest_ms) return {};
  const double left_ms =
      double(sinceFirst_.elapsed()) * double(all - done) / double(done - firstDone_);
  if (left_ms < minute_ms) return tr("Less than a minute left.");
  return tr("At most about %1 min left.").arg(qRound(left_ms / minute_ms));
}

void PlanPage::endProgress()
{
  progress_.clear();
  showEmpty();
  panel_->showProgress(std::nullopt);
}

void PlanPage::discardPlan()
{
  leaveArrays();
  plan_.reset();
  list_->show(nullptr);
  head_->setNote({});
  notes_->show({});
  stages_->setCurrentIndex(emptyStage);
  if (panel_->patient()) head_->show(*panel_->patient());
  showApproach();
  showMessage({});
}

void PlanPage::showMessage(const QString& sentence, bool isError)
{
  status_->showMessage(sentence, isError);
}

}  // namespace perilymph::gui
