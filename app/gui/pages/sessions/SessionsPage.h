// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The library of recorded insertions: search, preview, replay, comparison, deletion.

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "gui/pages/Page.h"
#include "gui/pages/sessions/LibraryWork.h"
#include "gui/report/ReportSending.h"
#include "gui/run/InsertionControl.h"
#include "gui/run/ReferenceInsertion.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSortFilterProxyModel;
class QStackedWidget;
class QTableView;

namespace perilymph::gui {

class EmptyPage;
class SessionTable;
class SessionTasks;
class StatusLine;

/// The recordings in the folder of recordings.
class SessionsPage : public Page {
  Q_OBJECT
public:
  /// @param control  What is being recorded.
  SessionsPage(const InsertionControl& control, QWidget* parent,
               LibraryWork::Lister lister = session::listSessions);

  /// Reads the folder again.
  void onShown() override;
  /// Shows what the insertion does. To be called whenever it may do something else.
  void follow();
  void onChosenAgain() override { onShown(); }
  Focus focus() const override { return Focus::pageUntilEscape; }
  bool isBusy() const override { return work_.isBusy(); }
  /// Ends reading early.
  bool cancel() override;

  /// The selected readable recordings, in the order of the table.
  std::vector<session::SessionSummary> chosen() const;
  void showMessage(const QString& sentence, bool isError = false);
  void showError(const QString& sentence) { showMessage(sentence, true); }

  /// Writes the report of a recording in the background; the page shows the result.
  void saveReport(const std::filesystem::path& file, const ReportPlace& place);
  /// Where the CT of a series is, as far as it is open.
  void setCtPlaces(CtPlaces places) { ctPlaces_ = std::move(places); }

Q_SIGNALS:
  void compareRequested(const std::vector<std::filesystem::path>& files);
  void referenceRead(const perilymph::gui::ReferenceInsertion& reference);

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  QWidget* addTop();
  QWidget* addList();
  QWidget* addVerbs();
  QPushButton* addVerb(const QString& text, const char* name, const QString& tip);
  void showList(std::vector<session::SessionSummary> sessions, int all);
  void showFresh(std::vector<session::SessionSummary> sessions);
  void showChoice();
  /// The selected readable recording; empty unless exactly one is selected.
  std::optional<std::filesystem::path> oneChosen() const;
  void replayChosen();
  void reportChosen();
  void rename(const std::filesystem::path& file, const QString& name);
  /// Opens the editor of a recording's name with a text.
  void editName(const std::filesystem::path& file, const QString& name);
  void throwAway();
  void bringBack();
  void reread();

  const InsertionControl& control_;
  CtPlaces ctPlaces_;
  LibraryWork work_;
  SessionTasks* tasks_;
  SessionTable* table_;
  QSortFilterProxyModel* sorted_;
  Progress insertion_ = Progress::ready;  ///< What it does, as shown.
  /// Paths in the trash and previous paths of the last deleted recordings.
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> trashed_;

  QStackedWidget* stack_ = nullptr;
  EmptyPage* empty_ = nullptr;
  QTableView* list_ = nullptr;
  QLineEdit* search_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* count_ = nullptr;
  StatusLine* status_ = nullptr;
  QPushButton *replay_ = nullptr, *compare_ = nullptr, *ghost_ = nullptr, *report_ = nullptr,
              *send_ = nullptr, *rename_ = nullptr, *delete_ = nullptr, *undo_ = nullptr,
              *end_ = nullptr;
};

}  // namespace perilymph::gui
