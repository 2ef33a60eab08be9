// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The main window: the frame that connects its pages, which do not know each other.

#include <QWidget>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "gui/pages/insert/InsertPage.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/shell/EndConfirmation.h"
#include "gui/shell/KeyActions.h"
#include "gui/shell/PageStack.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

class Navigation;
class Notice;
class OverlayStack;
class TopBar;

class MainWindow : public QWidget {
  Q_OBJECT
public:
  /// @param cochleae  Those built by an earlier window are used again.
  MainWindow(session::Scenario scenario, std::optional<std::filesystem::path> record,
             std::shared_ptr<CochleaStore> cochleae = std::make_shared<CochleaStore>(),
             const PageList& pages = standardPages());
  ~MainWindow() override;

  /// Builds the cochlea and prepares the insertion; then frames begin.
  Result<void> open() { return insertion_->open(); }

  /// Shows another setup on the insertion page, after a confirmation if that would end an insertion.
  void load(const InsertionRequest& request);

  /// Shows another page. A moving insertion is paused, because it is not visible.
  void showPage(const Page& page) { showPage(page.id()); }
  void showPage(const QString& id);
  /// Shows a page and opens a file there.
  /// Opens a recording, patient, plan, study or CT that was named when the program was started. What no other page
  /// knows is taken for a CT.
  void openFile(const std::filesystem::path& file);
  void openOnPage(const QString& id, const std::filesystem::path& file);
  /// The id of the visible page.
  const QString& page() const { return pages_->current().id(); }
  PageStack& pages() { return *pages_; }

  /// Does something that ends a page's work, after a question if that would be lost.
  /// @param action  Text of the button that does it.
  void endWork(Page& page, const QString& action, const std::function<void()>& act);
  /// Takes a question about work back that would not be lost any more.
  void takeQuestionBack() { ending_.clearIfDone(); }
  /// Replays a recording on the insertion page, after a confirmation if that would end an insertion.
  void replay(const std::filesystem::path& file);

  /// The message strip below the top bar.
  Notice& notice() { return *notice_; }
  /// Shows an error on the insertion page until the next reset.
  void showError(const QString& sentence) { insertion_->showError(sentence); }

  InsertionController& insertion() { return *insertion_; }
  const InsertionControl& control() const { return std::as_const(*insertion_).control(); }
  const SetupHistory& setup() const { return insertion_->history(); }
  InsertPage& insertPage() { return *insert_; }
  OperationView& view();
  InsertionViews& views() { return insert_->views(); }
  OverlayStack& sheets() { return *sheets_; }
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
  void reopenRequested();

protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void layOut();
  void connectInsertion();
  void showSubject();

  std::unique_ptr<InsertionController> insertion_;
  TopBar* top_;
  Notice* notice_;
  Navigation* navigation_;
  PageStack* pages_;
  InsertPage* insert_;  ///< One of the pages.
  OverlayStack* sheets_;
  KeyActions keys_;
  EndConfirmation ending_;
};

}  // namespace perilymph::gui
