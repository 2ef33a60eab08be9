// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/MainWindow.h"

#include <QApplication>
#include <QFrame>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <utility>

#include "gui/pages/ct/CtPage.h"
#include "gui/pages/insert/FrameLoop.h"
#include "gui/pages/insert/ReplayControl.h"
#include "gui/parts/Notice.h"
#include "gui/parts/Theme.h"
#include "gui/shell/Help.h"
#include "gui/shell/InsertKeys.h"
#include "gui/shell/MainMenu.h"
#include "gui/shell/Navigation.h"
#include "gui/shell/Sheets.h"
#include "gui/shell/StopTriggers.h"
#include "gui/shell/TopBar.h"
#include "gui/shell/TypedKeys.h"
#include "gui/shell/WindowKeys.h"
#include "gui/shell/WindowPicture.h"
#include "gui/shell/WindowPlace.h"
#include "gui/shell/WindowTitle.h"

namespace perilymph::gui {

MainWindow::MainWindow(session::Scenario scenario, std::optional<std::filesystem::path> record,
                       std::shared_ptr<CochleaStore> cochleae)
    : top_(new TopBar(this)),
      insert_(new InsertPage(std::move(scenario), std::move(record), std::move(cochleae), this)),
      notice_(new Notice(this)),
      navigation_(new Navigation(*insert_, *notice_, this)),
      sheets_(new Sheets(*insert_, *navigation_, this)),
      pages_(new PageStack(*insert_, this)),
      ending_(*insert_, *notice_)
{
  setObjectName(QStringLiteral("mainWindow"));
  setFont(typeface(13));
  setStyleSheet(windowStyle());
  setMinimumSize(preferredMinimumSize);
  resize(preferredWindowSize);
  setFocusPolicy(Qt::ClickFocus);  // no stop of Tab, which would show no ring
  layOut();
  connectInsertion();
  navigation_->sendCtOf(
      [this](const session::Scenario& shown) { return pages_->ct().placedCt(shown); });
  addInsertKeys(keys_, *insert_);
  addWindowKeys(keys_, *this, *insert_);
  sheets_->help().listKeys(keys_);
  showSubject();
  top_->showPreparing();
  top_->moveToTabEnd();
  setFocus();  // Space belongs to the insertion, not to the first button
}

MainWindow::~MainWindow() = default;

void MainWindow::layOut()
{
  auto* line = new QFrame(this);
  line->setObjectName(QStringLiteral("line"));
  line->setFixedHeight(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(top_);
  column->addWidget(line);
  column->addWidget(notice_);
  column->addWidget(pages_, 1);
  top_->setPage(page());
}

void MainWindow::connectInsertion()
{
  connect(&insert_->frames(), &FrameLoop::firstFrameShown, this, &MainWindow::firstFrameShown);
  connect(insert_, &InsertPage::recordingChanged, this, &MainWindow::recordingChanged);
  connect(insert_, &InsertPage::subjectChanged, this, &MainWindow::showSubject);
  connect(insert_, &InsertPage::stateShown, this, [this] {
    top_->showInsertion(control(), insert_->error());
    if (control().isMoving()) notice_->dropOffer();
    sheets_->showState();
  });
  connect(insert_, &InsertPage::noted, notice_, &Notice::say);
  new StopTriggers(*insert_, this);
  connect(top_, &TopBar::stopAsked, insert_, &InsertPage::stopDevice);
  connect(insert_, &InsertPage::devicesAsked, sheets_, &Sheets::toggleDevices);
  connect(insert_, &InsertPage::replayOpened, this, [this] {
    showPage(Page::insert);
    top_->showReplay();
  });
  connect(pages_, &PageStack::setupChosen, this,
          qOverload<const Setup&, SetupOrigin::Kind, AfterLoading>(&MainWindow::load));
  connect(pages_, &PageStack::replayAsked, this, &MainWindow::replay);
  connect(pages_, &PageStack::pageAsked, this, &MainWindow::showPage);
  connect(pages_, &PageStack::refused, notice_, &Notice::say);
  connect(top_, &TopBar::pageChosen, this, &MainWindow::showPage);
  connect(top_, &TopBar::keysAsked, &sheets_->help(), &Help::toggleKeys);
  connect(top_, &TopBar::settingsAsked, sheets_, &Sheets::toggleSettings);
  top_->setMenu(new MainMenu(*this, top_));
  connect(sheets_, &Sheets::settingChosen, this, &MainWindow::reopenAsked);
}

void MainWindow::load(session::Scenario scenario, AfterLoading then)
{
  load({std::move(scenario), {}}, SetupOrigin::Kind::preset, then);
}

void MainWindow::load(const Setup& setup, SetupOrigin::Kind kind, AfterLoading then)
{
  ending_.askBefore(tr("End it and continue"), [this, setup, kind, then] {
    insert_->load(setup, kind, then);
    showPage(Page::insert);
  });
}

void MainWindow::showPage(Page page)
{
  top_->setPage(page);
  // the tab of the recordings reads them again
  if (page == pages_->page() && page != Page::sessions) return;
  pages_->showPage(page);
  top_->moveToTabEnd();  // behind what the page has just made
  showSubject();
  if (page != Page::start && page != Page::sessions) setFocus();
}

void MainWindow::showSubject()
{
  const ReplayControl& replay = insert_->replay();
  setWindowTitle(windowTitleOf(*insert_));
  if (page() != Page::insert) return top_->showNobody();  // the page is about no patient
  if (replay.isOpen()) return top_->showSubject(replay.playback().scenario(), {});
  top_->showSubject(control().scenario(), setup().isModified() ? setup().changedText() : QString());
}

void MainWindow::takePicture() { notice_->say(keepPicture(*this)); }

void MainWindow::leave()
{
  if (insert_->cancelBuilding() || sheets_->help().leaveGuide() || insert_->leavePanel()) return;
  if (sheets_->leave()) return;
  if (page() == Page::insert && insert_->rest()) return;
  if (notice_->isVisible()) return notice_->hide();
  if (pages_->cancel()) return;
  const bool isElsewhere = focusWidget() != nullptr && focusWidget() != this;
  if (isElsewhere && page() != Page::start) return setFocus();
  if (isFullScreen()) setWindowState(windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::keyPressEvent(QKeyEvent* event)
{
  if (isTyped(*event) && (takesText(focusWidget()) || areLettersOff(*event))) {
    event->ignore();
    return;
  }
  const bool isForSheet = event->key() == Qt::Key_Escape && sheets_->wantsEscape();
  if (page() == Page::insert && !isForSheet && insert_->takeReplayKey(*event)) return;
  if (!keys_.take(*event)) QWidget::keyPressEvent(event);
}

void MainWindow::keyReleaseEvent(QKeyEvent* event)
{
  if (!event->isAutoRepeat()) insert_->held().release(event->key());
}

void MainWindow::wheelEvent(QWheelEvent* event)
{
  if (page() != Page::insert) return QWidget::wheelEvent(event);
  insert_->turnWheel(event->angleDelta().y() / 120.0,
                     (event->modifiers() & Qt::ControlModifier) != 0);
  event->accept();
}

void MainWindow::replay(const std::filesystem::path& file)
{
  ending_.askBefore(tr("End it and replay"), [this, file] { insert_->openReplay(file); });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  insert_->stopDevice();  // whatever the answer is
  // The end of a desktop session does not wait for an answer.
  if (!qApp->isSavingSession() && ending_.isNeeded()) {
    event->ignore();
    return ending_.askBefore(tr("End it and close"), [this] { close(); });
  }
  insert_->end();
  QWidget::closeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  sheets_->place();
}

}  // namespace perilymph::gui
