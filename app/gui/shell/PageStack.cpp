// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/PageStack.h"

#include <filesystem>
#include <vector>

#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/pages/start/StartPage.h"
#include "gui/pages/validate/ValidatePage.h"

namespace perilymph::gui {

PageStack::PageStack(InsertPage& insert, QWidget* parent)
    : QStackedWidget(parent),
      insert_(insert),
      start_(new StartPage(this)),
      ct_(new CtPage(this)),
      compare_(new ComparePage(this)),
      validate_(new ValidatePage(this)),
      sessions_(new SessionsPage(this))
{
  // in the order of Page
  for (QWidget* page : {static_cast<QWidget*>(start_), static_cast<QWidget*>(ct_),
                        static_cast<QWidget*>(&insert_), static_cast<QWidget*>(compare_),
                        static_cast<QWidget*>(validate_), static_cast<QWidget*>(sessions_)})
    addWidget(page);
  setCurrentWidget(&insert_);
  connectPages();
}

void PageStack::connectPages()
{
  using AfterLoading = InsertPage::AfterLoading;
  connect(start_, &StartPage::setupChosen, this,
          [this](const Setup& setup, SetupOrigin::Kind kind, bool isWatched) {
            Q_EMIT setupChosen(setup, kind, isWatched ? AfterLoading::insert : AfterLoading::rest);
          });
  connect(ct_, &CtPage::setupChosen, this, [this](const Setup& setup) {
    Q_EMIT setupChosen(setup, SetupOrigin::Kind::own, AfterLoading::rest);
  });
  connect(sessions_, &SessionsPage::replayAsked, &insert_, &InsertPage::openReplay);
  connect(sessions_, &SessionsPage::ghostRead, &insert_, &InsertPage::setGhost);
  connect(sessions_, &SessionsPage::compareAsked, this,
          [this](const std::vector<std::filesystem::path>& files) {
            Q_EMIT pageAsked(Page::compare);
            compare_->compare(files);
          });
  connect(&insert_, &InsertPage::replayFailed, this, &PageStack::showSessionsError);
}

void PageStack::showPage(Page page)
{
  if (this->page() == Page::insert && page != Page::insert) insert_.leaveSight();
  setCurrentIndex(static_cast<int>(page));
  if (page == Page::start) start_->showCards();
  if (page == Page::ct) showInsertionInCt();
  if (page != Page::sessions) return;
  sessions_->refresh(insert_.control().recording(), insert_.control().isRunning());
  sessions_->setFocus();
}

void PageStack::showInsertionInCt()
{
  const InsertionControl& control = insert_.control();
  if (const auto scala = control.sharedAnatomy())
    ct_->showInsertion(control.scenario(), *scala, control.now());
}

bool PageStack::cancel()
{
  switch (page()) {
    case Page::ct:
      return ct_->cancel();
    case Page::compare:
      compare_->cancel();
      return false;
    case Page::validate:
      validate_->cancel();
      return false;
    default:
      return false;
  }
}

void PageStack::showSessionsError(const QString& sentence) { sessions_->say(sentence, true); }

}  // namespace perilymph::gui
