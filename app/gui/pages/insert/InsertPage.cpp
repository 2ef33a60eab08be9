// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/InsertPage.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <cmath>

#include "gui/pages/insert/BottomBar.h"
#include "gui/pages/insert/BuildingNote.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/FrameLoop.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/InsertionText.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/LoadingStage.h"
#include "gui/pages/insert/ReplayBar.h"
#include "gui/pages/insert/ReplayControl.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/pages/insert/ResultCard.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/report/InsertionReport.h"
#include "gui/run/WorkflowPredicates.h"
#include "gui/scene/OperationView.h"
#include "gui/setup/PatientSetup.h"
#include "gui/setup/SetupTitle.h"
#include "gui/text/DataText.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr double magnify = 1.1;  // per notch of the wheel
constexpr auto recordingEnding = ".insertion";
constexpr auto patientEnding = ".toml";

QFrame* line(QWidget* parent)
{
  auto* made = new QFrame(parent);
  made->setObjectName(QStringLiteral("line"));
  return made;
}

}  // namespace

InsertPage::InsertPage(InsertionController& insertion, QWidget* parent)
    : Page("insert", tr("Insert"), Icon::insert, parent),
      insertion_(insertion),
      side_(new SidePanel(insertion.control().cochleae(), this)),
      views_(new InsertionViews(this)),
      bottom_(new BottomBar(this)),
      building_(new BuildingNote(views_->operation())),
      result_(new ResultCard(views_)),
      loading_(new LoadingStage(this)),
      replay_(new ReplayControl(insertion.replay(), *views_, this)),
      saving_(new ReportSaving(this)),
      bars_(new QStackedWidget(this)),
      frames_(new FrameLoop(
          {[this](double elapsed_s) { step(elapsed_s); }, [this] { updateReadouts(); },
           [this] { return views_->operation()->renderIfDirty(); },
           [this] { return views_->charts()->renderNext(); }, [this] { return isShown(); }},
          this)),
      presenter_(insertion, {side_, views_, bottom_, building_})
{
  layOut();
  connectInsertion();
  connectPanel();
  connectBars();
  connectResult();
  side_->showSetup(insertion.history());
  showState();
  bottom_->setMain(BottomBar::Main::start, false);
}

InsertPage::~InsertPage() = default;

void InsertPage::layOut()
{
  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  QFrame* leftLine = line(this);
  leftLine->setFixedWidth(1);
  middle->addWidget(side_);
  middle->addWidget(leftLine);
  middle->addWidget(views_, 1);

  QFrame* bottomLine = line(this);
  bottomLine->setFixedHeight(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(middle, 1);
  column->addWidget(bottomLine);
  bars_->addWidget(bottom_);
  bars_->addWidget(replay_->bar());
  bars_->setFixedHeight(shownLengths().bar);
  column->addWidget(bars_);
}

void InsertPage::connectInsertion()
{
  using Insertion = InsertionController;
  insertion_.commitBy([this] { return side_->commit(); });
  connect(&insertion_, &Insertion::opened, this, [this] { frames_->start(); });
  connect(&insertion_, &Insertion::prepared, this, [this] {
    presenter_.showPrepared();
    updateReadouts();
  });
  connect(&insertion_, &Insertion::cochleaEnding, views_, &InsertionViews::releaseScene);
  connect(&insertion_, &Insertion::cochleaChanged, this, [this] { presenter_.showCochlea(); });
  connect(&insertion_, &Insertion::setupChanged, this,
          [this] { side_->showSetup(insertion_.history()); });
  connect(&insertion_, &Insertion::stateChanged, this, &InsertPage::showState);
  connect(&insertion_, &Insertion::subjectChanged, this, [this] {
    const session::Scenario* scenario = insertion_.loading();
    loading_->show(scenario != nullptr ? subjectText(*scenario) : QString());
  });
  connect(loading_, &LoadingStage::cancelRequested, &insertion_.setup(), &SetupControl::cancel);
  connect(loading_, &LoadingStage::cancelRequested, &insertion_, &Insertion::cancelOpening);
  connect(&insertion_, &Insertion::openingChanged, this, [this] {
    if (insertion_.loading() == nullptr) loading_->showDevice(insertion_.openingText());
    presenter_.showInput();
  });
  connect(&insertion_, &Insertion::referenceChanged, this, [this] { presenter_.showReference(); });
  connect(&insertion_, &Insertion::planChanged, this, [this] { presenter_.showPlan(); });
  connect(&insertion_, &Insertion::errorChanged, this, [this] { presenter_.showBanner(); });
  connect(&insertion_, &Insertion::replayOpened, this, &InsertPage::showReplay);
  connect(&insertion_, &Insertion::replayClosed, this, &InsertPage::showInsertion);
  connect(&insertion_, &Insertion::noted, this, &Page::noted);
  connect(&insertion_.held(), &GraspControl::heldChanged, side_, &SidePanel::setHeld);
}

void InsertPage::connectPanel()
{
  using Insertion = InsertionController;
  connect(side_, &SidePanel::inputChosen, &insertion_, &Insertion::chooseInput);
  connect(side_, &SidePanel::devicesRequested, this, &InsertPage::devicesRequested);
  connect(side_, &SidePanel::holdChanged, &insertion_.held(), &GraspControl::hold);
  connect(side_, &SidePanel::styletRequested, this, [this] { insertion_.control().pullStylet(); });
  connect(side_, &SidePanel::partShown, views_->operation(), &OperationView::setPartVisible);
  connect(side_, &SidePanel::removeReferenceRequested, &insertion_,
          [this] { insertion_.setReference(std::nullopt); });
  connect(side_, &SidePanel::experimentShown, views_->charts(), &ForceCharts::setExperimentVisible);
  connect(side_, &SidePanel::changeRequested, &insertion_, &Insertion::change);
  connect(side_, &SidePanel::restoreRequested, &insertion_, &Insertion::restore);
  connect(side_, &SidePanel::patientChosen, &insertion_, &Insertion::loadPatient);
  connect(side_, &SidePanel::allPatientsRequested, this, &InsertPage::allPatientsRequested);
  connect(side_, &SidePanel::newPatientRequested, this, &InsertPage::newPatientRequested);
  connect(side_, &SidePanel::undoRequested, &insertion_, &Insertion::undo);
  connect(side_, &SidePanel::redoRequested, &insertion_, &Insertion::redo);
}

void InsertPage::connectBars()
{
  using Insertion = InsertionController;
  connect(bottom_, &BottomBar::startRequested, &insertion_, &Insertion::start);
  connect(bottom_, &BottomBar::pauseRequested, &insertion_, &Insertion::pause);
  connect(bottom_, &BottomBar::withdrawRequested, &insertion_, &Insertion::withdraw);
  connect(bottom_, &BottomBar::resetRequested, &insertion_, &Insertion::reset);
  connect(building_, &BuildingNote::cancelRequested, &insertion_.setup(), &SetupControl::cancel);
  connect(replay_, &ReplayControl::closeRequested, &insertion_, &Insertion::closeReplay);
  views_->charts()->setExperiment(charts::publishedExperiment());
  for (const auto* view : findChildren<PlainVtkWidget*>())
    connect(view, &PlainVtkWidget::presented, frames_, &FrameLoop::present);
  const auto pace = [this] {
    frames_->setInterval(visualization::traitsOf(views_->quality()).frameInterval_ms);
  };
  connect(views_, &InsertionViews::qualityChanged, frames_, pace);
  pace();
}

void InsertPage::connectResult()
{
  connect(&insertion_, &InsertionController::resultChanged, this, &InsertPage::showResult);
  connect(result_, &ResultCard::reportRequested, this, &InsertPage::saveReport);
  connect(result_, &ResultCard::sendRequested, this, &InsertPage::sendResult);
  connect(saving_, &ReportSaving::saved, this,
          [this](const std::filesystem::path&, const QString& sentence) { noted(sentence); });
  connect(saving_, &ReportSaving::failed, this, &InsertPage::noted);
  connect(result_, &ResultCard::againRequested, &insertion_, &InsertionController::again);
  connect(result_, &ResultCard::compareRequested, this, [this] {
    std::vector<std::filesystem::path> files;
    if (insertion_.recordingBefore()) files.push_back(*insertion_.recordingBefore());
    files.push_back(insertion_.result()->file);
    Q_EMIT compareRequested(files);
  });
}

void InsertPage::showResult()
{
  if (!insertion_.result()) return result_->clear();
  const InsertionControl& control = insertion_.control();
  const bool isInside = control.isAtDepth() || control.earlyEnd() != haptics::InsertionEnd::none;
  if (isInside) views_->charts()->showRecorded(insertion_.result()->insertion.profile);
  result_->show(*insertion_.result(), endTitle(control));
}

void InsertPage::saveReport()
{
  const std::shared_ptr<const ReportContent> content = insertion_.result();
  if (const auto place = askReportPlace(content->file, this))
    saving_->save(
        [content](const std::filesystem::path& pdf) { return writeReport(*content, pdf); },
        content->identity(), *place);
}

void InsertPage::sendResult()
{
  const std::shared_ptr<const ReportContent> content = insertion_.result();
  const auto pdf = pdfToSend(
      [&content](const std::filesystem::path& place) { return writeReport(*content, place); },
      content->identity());
  if (!pdf) return noted(dataText(pdf.error().message));
  sendReport(insertionReportName(), *pdf, content->identity(), ctPlaces_, this);
}

Page::Acceptance InsertPage::accepts(const std::filesystem::path& file) const
{
  const bool isKnown = file.extension() == recordingEnding || file.extension() == patientEnding;
  return isKnown ? Acceptance::always : Acceptance::none;
}

void InsertPage::open(const std::filesystem::path& file)
{
  if (file.extension() == recordingEnding) return replayRequested(file);
  const auto setup = setupOfPatientFile(file);
  if (!setup) return noted(dataText(setup.error().message));
  Q_EMIT insertionRequested({*setup});
}

std::optional<Page::Unfinished> InsertPage::unfinished() const
{
  const InsertionControl& control = insertion_.control();
  if (isBetweenInsertions(stateOf(control))) return std::nullopt;
  return Unfinished{inProgressText(control), tr("Keep inserting")};
}

void InsertPage::endUnfinished() { insertion_.reset(); }

bool InsertPage::takeKey(const QKeyEvent& event) { return replay_->takeKey(event); }

void InsertPage::onHidden()
{
  if (insertion_.safety().onPageHidden()) insertion_.pause();
}

bool InsertPage::leavePanel()
{
  if (!isShown() || !side_->isAncestorOf(window()->focusWidget())) return false;
  window()->setFocus();
  return true;
}

void InsertPage::togglePanel() { side_->setCollapsed(!side_->isCollapsed()); }

void InsertPage::toggleLandmarks() { side_->togglePart(visualization::Part::landmarks); }

void InsertPage::wheelEvent(QWheelEvent* event)
{
  const double notches = event->angleDelta().y() / 120.0;
  const bool isZoom = (event->modifiers() & Qt::ControlModifier) != 0;
  if (isZoom || !insertion_.held().turnWheel(notches))
    views_->operation()->zoom(std::pow(magnify, notches));
  event->accept();
}

void InsertPage::showReplay()
{
  bars_->setCurrentWidget(replay_->bar());
  side_->hide();  // it belongs to the next insertion, not to this recording
  replay_->begin();
}

void InsertPage::showInsertion()
{
  bars_->setCurrentWidget(bottom_);
  side_->show();
}

void InsertPage::step(double elapsed_s)
{
  insertion_.held().drive();
  if (insertion_.replay().isOpen())
    replay_->step(elapsed_s, isShown());
  else
    presenter_.step();
  insertion_.followEnd();
  views_->operation()->stepCamera(elapsed_s);
}

void InsertPage::updateReadouts()
{
  if (insertion_.replay().isOpen()) return replay_->updateReadouts();
  presenter_.updateReadouts(frames_->meter());
  showState();
}

void InsertPage::showState()
{
  presenter_.showState(frames_->meter());
  Q_EMIT stateShown();
}

}  // namespace perilymph::gui
