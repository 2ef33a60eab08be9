#include "gui/shell/MainWindow.h"

#include <spdlog/spdlog.h>

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cstring>

#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/devices/DevicePage.h"
#include "gui/pages/insert/BottomBar.h"
#include "gui/pages/insert/BuildingNote.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/ReplayBar.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/pages/start/StartPage.h"
#include "gui/pages/validate/ValidatePage.h"
#include "gui/parts/Notice.h"
#include "gui/parts/Theme.h"
#include "gui/scene/OperationView.h"
#include "gui/setup/SetupHistory.h"
#include "gui/shell/GuideSheet.h"
#include "gui/shell/KeyList.h"
#include "gui/shell/SettingsSheet.h"
#include "gui/shell/TopBar.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;

constexpr int slowInterval_ms = 66;    // charts and numbers: 15 Hz
constexpr double longestStep_s = 0.1;  // after a stall, keys do not catch up

QFrame* line(QWidget* parent)
{
  auto* made = new QFrame(parent);
  made->setObjectName(QStringLiteral("line"));
  return made;
}

}  // namespace

MainWindow::MainWindow(session::Scenario scenario, std::optional<std::filesystem::path> record)
    : control_(std::move(scenario), std::move(record)),
      safety_(control_),
      setup_(new SetupHistory(this)),
      top_(new TopBar(this)),
      side_(new SidePanel(this)),
      views_(new InsertionViews(this)),
      view_(views_->operation()),
      charts_(views_->charts()),
      bottom_(new BottomBar(this)),
      guide_(new GuideSheet(this)),
      settings_(new SettingsSheet(this)),
      notice_(new Notice(this)),
      devices_(new DevicePage(view_)),
      startPage_(new StartPage(this)),
      validation_(new ValidatePage(this)),
      comparison_(new ComparePage(this)),
      sessions_(new SessionsPage(this)),
      replayBar_(new ReplayBar(this)),
      replay_(new ReplayPlayer(this)),
      bars_(new QStackedWidget(this)),
      reading_(this),
      modelBuilder_(this),
      building_(new BuildingNote(view_)),
      pages_(new QStackedWidget(this))
{
  setObjectName(QStringLiteral("mainWindow"));
  setFont(typeface(13));
  setStyleSheet(windowStyle());
  setMinimumSize(1024, 640);
  resize(1280, 800);
  setFocusPolicy(Qt::StrongFocus);
  layOut();
  connectZones();
  addKeys();
  keys_ = new KeyList(keyActions_, this);
  connect(keys_, &KeyList::guideAsked, this, &MainWindow::toggleGuide);
  connectSetup();
  setup_->begin({control_.scenario(), {}}, SetupOrigin::Kind::preset);
  showScenario();
  top_->setDevice(DeviceState::off, tr("preparing"), {});
  bottom_->setMain(BottomBar::Main::start, false);

  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(visualization::traitsOf(views_->quality()).frameInterval_ms);
  connect(views_, &InsertionViews::qualityChanged, this, [this] {
    timer_.setInterval(visualization::traitsOf(views_->quality()).frameInterval_ms);
  });
  connect(&timer_, &QTimer::timeout, this, &MainWindow::onFrame);
}

MainWindow::~MainWindow() = default;

QWidget* MainWindow::insertPage()
{
  auto* page = new QWidget(this);
  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  QFrame* leftLine = line(this);
  leftLine->setFixedWidth(1);
  middle->addWidget(side_);
  middle->addWidget(leftLine);
  middle->addWidget(views_, 1);

  QFrame* bottomLine = line(this);
  bottomLine->setFixedHeight(1);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(middle, 1);
  column->addWidget(bottomLine);
  bars_->addWidget(bottom_);
  bars_->addWidget(replayBar_);
  bars_->setFixedHeight(barHeight);
  column->addWidget(bars_);
  return page;
}

void MainWindow::layOut()
{
  // in the order of Page
  pages_->addWidget(startPage_);
  pages_->addWidget(insertPage());
  pages_->addWidget(comparison_);
  pages_->addWidget(validation_);
  pages_->addWidget(sessions_);

  QFrame* topLine = line(this);
  topLine->setFixedHeight(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(top_);
  column->addWidget(topLine);
  column->addWidget(pages_, 1);
  top_->setPage(page_);
  pages_->setCurrentIndex(static_cast<int>(page_));
}

void MainWindow::connectZones()
{
  connect(top_, &TopBar::pageChosen, this, &MainWindow::showPage);
  connect(startPage_, &StartPage::patientGiven, this,
          [this](const anatomy::Patient& patient) { begin(patient); });
  connect(startPage_, &StartPage::meanAsked, this,
          [this] { beginShipped("mean-contour", AfterLoading::rest); });
  connect(startPage_, &StartPage::demonstrationAsked, this,
          [this] { beginShipped("contour-published", AfterLoading::insert); });
  connect(top_, &TopBar::keysAsked, this, &MainWindow::toggleKeyList);
  connect(top_, &TopBar::settingsAsked, this, &MainWindow::toggleSettings);
  connect(guide_, &GuideSheet::closeAsked, this, &MainWindow::toggleGuide);
  connect(settings_, &SettingsSheet::closeAsked, this, &MainWindow::toggleSettings);
  connect(settings_, &SettingsSheet::chosen, this, &MainWindow::anewAsked);
  connect(side_, &SidePanel::handChosen, this, &MainWindow::chooseHand);
  connect(side_, &SidePanel::devicesAsked, this, &MainWindow::toggleDevices);
  connect(devices_, &DevicePage::closeAsked, this, &MainWindow::toggleDevices);
  connect(devices_, &DevicePage::deviceChosen, this, &MainWindow::useDevice);
  connect(side_, &SidePanel::holdChanged, this, &MainWindow::hold);
  connect(side_, &SidePanel::styletAsked, this, [this] { control_.pullStylet(); });
  connect(side_, &SidePanel::partShown, view_, &OperationView::setPartVisible);
  connect(side_, &SidePanel::experimentShown, charts_, &ForceCharts::setExperimentVisible);
  connect(bottom_, &BottomBar::startAsked, this, &MainWindow::start);
  connect(bottom_, &BottomBar::pauseAsked, this, &MainWindow::pause);
  connect(bottom_, &BottomBar::withdrawAsked, this, &MainWindow::withdraw);
  connect(bottom_, &BottomBar::resetAsked, this, &MainWindow::reset);
  connect(view_, &QOpenGLWidget::frameSwapped, this, &MainWindow::onPresented);
  connectSessions();
}

void MainWindow::start()
{
  // What is typed counts, and is built first.
  const QString error = isChangeable() ? side_->commit() : QString();
  if (!error.isEmpty()) return showError(error);
  setup_->seal();
  isStartAsked_ = modelBuilder_.isBusy();
  if (isStartAsked_) return showState();
  const Result<Done> begun = control_.begin();
  if (!begun) showError(QString::fromStdString(begun.error().message));
  showState();
}

void MainWindow::pause()
{
  pressed_.clear();
  isStartAsked_ = false;
  control_.pause();
  side_->setHeld(false);
  showState();
}

void MainWindow::withdraw()
{
  control_.withdraw();
  showState();
}

void MainWindow::reset() { prepare(control_.hand()); }

void MainWindow::chooseHand(InputSource hand)
{
  if (hand != control_.hand()) prepare(hand);
}

void MainWindow::hold(bool isHeld)
{
  if (control_.hand() != InputSource::pointer) return;
  control_.hold(isHeld);
  side_->setHeld(control_.isHeld());
}

void MainWindow::showError(const QString& sentence)
{
  spdlog::warn("{}", sentence.toStdString());
  error_ = sentence;
  view_->setBanner(errorText());
}

bool MainWindow::isNewToTheEye(const haptics::Snapshot& now)
{
  const std::size_t nodes = now.nodes;
  const bool isSame =
      nodes == drawn_.nodes && now.output.styletWithdrawal == drawn_.output.styletWithdrawal &&
      std::memcmp(now.node_W.data(), drawn_.node_W.data(), nodes * sizeof now.node_W[0]) == 0 &&
      std::memcmp(now.normalForce.data(), drawn_.normalForce.data(),
                  nodes * sizeof now.normalForce[0]) == 0;
  if (!isSame) drawn_ = now;
  return !isSame;
}

void MainWindow::onFrame()
{
  meter_.begin(FrameMeter::Clock::now());
  const double elapsed_s = std::min(double(sinceFrame_.restart()) / 1e3, longestStep_s);

  const int direction = int(pressed_.count(Qt::Key_Down)) - int(pressed_.count(Qt::Key_Up));
  if (direction != 0)
    control_.advanceBy(Length::fromSi(direction * control_.scenario().speed.si() * elapsed_s));

  if (!frameOfReplay(elapsed_s) && control_.update()) {
    const haptics::Snapshot& now = control_.now();
    if (isNewToTheEye(now)) view_->showArray(now);
    if (now.output.workflow != Workflow::idle && now.output.workflow != Workflow::armed)
      charts_->append(now.output);
  }
  view_->stepCamera(elapsed_s);

  const bool isSeen = page_ == Page::insert;
  bool isDrawn = isSeen && view_->renderIfDirty();
  if (sinceSlow_.elapsed() >= slowInterval_ms) {
    sinceSlow_.restart();
    showSlowly();
    if (isSeen && charts_->renderIfDirty()) isDrawn = true;
  }
  if (!isDrawn) meter_.cancel();
  if (!isSeen && isFirstFrame_) {
    isFirstFrame_ = false;
    Q_EMIT firstFrameShown();
  }
}

void MainWindow::onPresented()
{
  meter_.present(FrameMeter::Clock::now());
  if (!isFirstFrame_ || !timer_.isActive() || meter_.frames() == 0) return;
  isFirstFrame_ = false;
  Q_EMIT firstFrameShown();
}

void MainWindow::showSlowly()
{
  if (replay_->isOpen()) return showReplay();
  const haptics::TickOutput& now = control_.now().output;
  view_->showNumbers(now, control_.scenario().stopTravel);
  views_->showSlowly(control_.now());
  views_->weigh(meter_);
  bottom_->setProgress(now.travel / control_.scenario().stopTravel.si(), now.time);
  showState();
}

}  // namespace perilymph::gui
