// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/MainWindow.h"

#include <QApplication>
#include <QFrame>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "gui/pages/insert/FrameLoop.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/shell/FileDrop.h"
#include "gui/shell/Help.h"
#include "gui/shell/InsertKeys.h"
#include "gui/shell/MainMenu.h"
#include "gui/shell/Navigation.h"
#include "gui/shell/OverlayStack.h"
#include "gui/shell/PageLinks.h"
#include "gui/shell/StopTriggers.h"
#include "gui/shell/TopBar.h"
#include "gui/shell/TypedKeys.h"
#include "gui/shell/WindowKeys.h"
#include "gui/shell/WindowPicture.h"
#include "gui/shell/WindowPlace.h"
#include "gui/shell/WindowTitle.h"
#include "gui/widgets/Notice.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

MainWindow::MainWindow(session::Scenario scenario, std::optional<std::filesystem::path> record,
                       std::shared_ptr<CochleaStore> cochleae, const PageList& pages)
    : insertion_(std::make_unique<InsertionController>(std::move(scenario), std::move(record),
                                                       std::move(cochleae))),
      top_(new TopBar(this)),
      notice_(new Notice(this)),
      navigation_(new Navigation(*insertion_, *notice_, this)),
      pages_(new PageStack(pages, *insertion_, this)),
      insert_(pages_->find<InsertPage>()),
      sheets_(new OverlayStack(*insertion_, *insert_, *navigation_, this)),
      ending_(*pages_, *notice_)
{
  setObjectName(QStringLiteral("mainWindow"));
  setFont(typeface(13));
  setStyleSheet(windowStyle());
  setMinimumSize(preferredMinimumSize);
  resize(preferredWindowSize);
  setFocusPolicy(Qt::ClickFocus);  // no stop of Tab, which would show no ring
  layOut();
  linkPages(*this);
  new FileDrop(*pages_, this);
  connect(top_, &TopBar::pageChosen, this, qOverload<const QString&>(&MainWindow::showPage));
  connectInsertion();
  addInsertKeys(keys_, *insertion_, *insert_);
  addWindowKeys(keys_, *this, *insert_);
  sheets_->help().listKeys(keys_);
  showSubject();
  top_->showPreparing();
  top_->moveToTabEnd();
  setFocus();  // Space belongs to the insertion, not to the first button
}

MainWindow::~MainWindow()
{
  delete navigation_;  // both show the insertion to their end
  delete pages_;
}

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
  top_->setPages(pages_->all());
  top_->setPage(pages_->current());
}

void MainWindow::connectInsertion()
{
  connect(&insert_->frames(), &FrameLoop::firstFrameShown, this, &MainWindow::firstFrameShown);
  connect(insertion_.get(), &InsertionController::prepared, this, &MainWindow::recordingChanged);
  connect(insertion_.get(), &InsertionController::subjectChanged, this, &MainWindow::showSubject);
  connect(insert_, &InsertPage::stateShown, this, [this] {
    top_->showInsertion(*insertion_);
    if (control().isMoving()) notice_->dropOffer();
    ending_.clearIfDone();
    sheets_->showState();
  });
  new StopTriggers(*insertion_, this);
  connect(top_, &TopBar::stopRequested, insertion_.get(), &InsertionController::stopDevice);
  connect(insertion_.get(), &InsertionController::replayOpened, this, [this] {
    showPage(*insert_);
    top_->showReplay();
  });
  connect(top_, &TopBar::keysRequested, &sheets_->help(), &Help::toggleKeys);
  connect(top_, &TopBar::settingsRequested, sheets_, &OverlayStack::toggleSettings);
  top_->setMenu(new MainMenu(*this, top_));
  connect(sheets_, &OverlayStack::settingChosen, this, [this] {
    // of an insertion the recording stays
    const auto& all = pages_->all();
    const auto lost = std::ranges::find_if(all, [this](const Page* page) {
      return page != insert_ && page->unfinished().has_value();
    });
    if (lost == all.end()) return Q_EMIT reopenRequested();
    endWork(**lost, tr("Change it anyway"), [this] { Q_EMIT reopenRequested(); });
  });
}

void MainWindow::load(const InsertionRequest& request)
{
  ending_.askBefore(
      tr("End it and continue"),
      [this, request] {
        insertion_->load(request);
        showPage(*insert_);
      },
      insert_);
}

void MainWindow::showPage(const QString& id)
{
  Page& page = pages_->page(id);
  top_->setPage(page);
  if (&page == &pages_->current()) return page.onChosenAgain();
  pages_->show(page);
  top_->moveToTabEnd();  // behind what the page has just made
  showSubject();
  if (page.focus() == Page::Focus::window) setFocus();
}

void MainWindow::openOnPage(const QString& id, const std::filesystem::path& file)
{
  showPage(id);
  if (!file.empty()) pages_->page(id).open(file);
}

void MainWindow::openFile(const std::filesystem::path& file)
{
  const Page* page = pages_->pageFor(file);
  openOnPage(page != nullptr ? page->id() : QStringLiteral("ct"), file);
}

void MainWindow::showSubject()
{
  setWindowTitle(windowTitleOf(pages_->current(), *insertion_));
  if (!pages_->current().showsInsertion()) return top_->showNobody();
  if (const auto* other = insertion_->shownInstead()) return top_->showSubject(*other, {});
  top_->showSubject(control().scenario(), setup().isModified() ? setup().changedText() : QString());
}

OperationView& MainWindow::view() { return *views().operation(); }

void MainWindow::takePicture() { notice_->showMessage(keepPicture(*this)); }

void MainWindow::leave()
{
  if (insertion_->cancelOpening()) return;
  if (insertion_->setup().cancel() || sheets_->help().leaveGuide() || insert_->leavePanel()) return;
  if (sheets_->leave()) return;
  if (insert_->isShown() && insertion_->rest()) return;
  if (notice_->isVisible()) return notice_->hide();
  if (pages_->current().cancel()) return;
  const bool isElsewhere = focusWidget() != nullptr && focusWidget() != this;
  if (isElsewhere && pages_->current().focus() != Page::Focus::page) return setFocus();
  if (isFullScreen()) setWindowState(windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::keyPressEvent(QKeyEvent* event)
{
  if (isTyped(*event) && (takesText(focusWidget()) || areLettersOff(*event))) {
    event->ignore();
    return;
  }
  const bool isForSheet = event->key() == Qt::Key_Escape && sheets_->wantsEscape();
  if (!isForSheet && pages_->current().takeKey(*event)) return;
  if (!keys_.take(*event)) QWidget::keyPressEvent(event);
}

void MainWindow::keyReleaseEvent(QKeyEvent* event)
{
  if (!event->isAutoRepeat()) insertion_->held().release(event->key());
}

void MainWindow::replay(const std::filesystem::path& file)
{
  ending_.askBefore(
      tr("End it and replay"), [this, file] { insertion_->openReplay(file); }, insert_);
}

void MainWindow::endWork(Page& page, const QString& action, const std::function<void()>& act)
{
  ending_.askBefore(action, act, &page);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  insertion_->stopDevice();  // whatever the answer is
  // The end of a desktop session does not wait for an answer.
  if (!qApp->isSavingSession() && ending_.isNeeded()) {
    event->ignore();
    return ending_.askBefore(tr("Close anyway"), [this] { close(); });
  }
  insertion_->safety().end();
  QWidget::closeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  sheets_->place();
}

}  // namespace perilymph::gui
