// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The main window: the frame that connects its pages, which do not know each other.

#include <QWidget>
#include <filesystem>
#include <optional>

#include "gui/pages/insert/InsertPage.h"
#include "gui/shell/EndingQuestion.h"
#include "gui/shell/KeyActions.h"
#include "gui/shell/PageStack.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

class Navigation;
class Notice;
class Sheets;
class TopBar;

class MainWindow : public QWidget {
  Q_OBJECT
public:
  using AfterLoading = InsertPage::AfterLoading;

  /// @param cochleae  Those built by an earlier window are used again.
  MainWindow(session::Scenario scenario, std::optional<std::filesystem::path> record,
             std::shared_ptr<CochleaStore> cochleae = std::make_shared<CochleaStore>());
  ~MainWindow() override;

  /// Builds the cochlea and prepares the insertion; then frames begin.
  Result<Done> open() { return insert_->open(); }

  /// Shows another scenario on the insertion page.
  void load(session::Scenario scenario, AfterLoading then);
  void load(const Setup& setup, SetupOrigin::Kind kind, AfterLoading then);

  /// Shows another page. A moving insertion is paused, because it is not visible.
  void showPage(Page page);
  Page page() const { return pages_->page(); }
  PageStack& pages() { return *pages_; }

  /// Replays a recording on the insertion page; asks first if that would end an insertion.
  void replay(const std::filesystem::path& file);

  /// The message strip below the top bar.
  Notice& notice() { return *notice_; }
  /// Shows an error on the insertion page until the next reset.
  void showError(const QString& sentence) { insert_->showError(sentence); }

  InsertPage& insertion() { return *insert_; }
  const InsertionControl& control() const { return insert_->control(); }
  const SetupHistory& setup() const { return insert_->setup(); }
  OperationView& view() { return insert_->view(); }
  InsertionViews& views() { return insert_->views(); }
  Sheets& sheets() { return *sheets_; }
  Navigation& navigation() { return *navigation_; }

  /// Saves a screenshot of the window and shows its path.
  void takePicture();
  /// Esc: closes an overlay, or releases the array.
  void leave();

Q_SIGNALS:
  /// The first frame with the cochlea is on the display.
  void firstFrameShown();
  /// Another insertion is being recorded: control().recording().
  void recordingChanged();
  /// A setting was changed that requires a new window.
  void reopenAsked();

protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void layOut();
  void connectInsertion();
  void showSubject();

  TopBar* top_;
  InsertPage* insert_;
  Notice* notice_;
  Navigation* navigation_;
  Sheets* sheets_;
  PageStack* pages_;
  KeyActions keys_;
  EndingQuestion ending_;
};

}  // namespace perilymph::gui
