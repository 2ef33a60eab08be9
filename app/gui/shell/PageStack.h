// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pages of the window, one of which is visible.

#include <QStackedWidget>
#include <filesystem>

#include "gui/pages/insert/InsertPage.h"

namespace perilymph::gui {

class ComparePage;
class CtPage;
class PlanPage;
class SessionsPage;
class StartPage;
class StudiesPage;
class ValidatePage;

/// The pages, in the order of their buttons.
enum class Page { start, ct, plan, insert, compare, validate, sessions, studies };

/// Makes the pages and connects them, as they do not know each other.
class PageStack : public QStackedWidget {
  Q_OBJECT
public:
  /// @param insert  The insertion page; it is shown first.
  PageStack(InsertPage& insert, QWidget* parent);

  Page page() const { return static_cast<Page>(currentIndex()); }
  /// Shows a page. An insertion that is no longer visible is paused.
  void showPage(Page page);
  /// Cancels what the visible page computes in the background. False if there was nothing.
  bool cancel();
  /// Shows a message on the page of recordings.
  void showSessionsError(const QString& sentence);
  CtPage& ct() { return *ct_; }
  PlanPage& plan() { return *plan_; }
  StudiesPage& studies() { return *studies_; }
  /// Shows a study's result on its page.
  void openStudy(const std::filesystem::path& file);

Q_SIGNALS:
  /// Another setup was chosen for the insertion page.
  void setupChosen(const perilymph::gui::Setup& setup, perilymph::gui::SetupOrigin::Kind kind,
                   perilymph::gui::InsertPage::AfterLoading then);
  void replayAsked(const std::filesystem::path& file);
  /// A page asks for another one.
  void pageAsked(perilymph::gui::Page page);
  /// A dropped file cannot be used.
  void refused(const QString& sentence);

private:
  void connectPages();
  void showInsertionInCt();
  void connectStart();
  void connectRecordings();
  void openPatient(const std::filesystem::path& file);

  InsertPage& insert_;
  StartPage* start_;
  CtPage* ct_;
  PlanPage* plan_;
  ComparePage* compare_;
  ValidatePage* validate_;
  SessionsPage* sessions_;
  StudiesPage* studies_;
};

}  // namespace perilymph::gui
