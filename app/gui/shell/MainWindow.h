#pragma once

// The workstation's window: the frame around its pages. Pages know nothing of each other; what one
// asks of another comes through here.

#include <QWidget>
#include <filesystem>
#include <optional>

#include "gui/pages/insert/InsertPage.h"
#include "gui/shell/KeyActions.h"
#include "gui/shell/PageStack.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

class ComparePage;
class Notice;
class SessionsPage;
class Sheets;
class StartPage;
class TopBar;
class ValidatePage;

class MainWindow : public QWidget {
  Q_OBJECT
public:
  using AfterLoading = InsertPage::AfterLoading;

  MainWindow(session::Scenario scenario, std::optional<std::filesystem::path> record);
  ~MainWindow() override;

  /// Builds the cochlea and prepares the insertion; then frames begin to run.
  Result<Done> open() { return insert_->open(); }

  /// Shows another scenario on the page of the insertion.
  void load(session::Scenario scenario, AfterLoading then);
  void load(const Setup& setup, SetupOrigin::Kind kind, AfterLoading then);
  /// Goes on with the setup of a window before this one, whose scenario is this one's.
  void resume(const SetupOrigin& origin, const Setup& now) { insert_->resume(origin, now); }

  /// Shows another page. An insertion that moves is paused: nobody would see where it goes.
  void showPage(Page page);
  Page page() const { return pages_->page(); }

  /// Says something over the foot of the window.
  Notice& notice() { return *notice_; }
  /// Says on the page of the insertion what went wrong; stays until the next reset.
  void showError(const QString& sentence) { insert_->showError(sentence); }

  InsertPage& insertion() { return *insert_; }
  const InsertionControl& control() const { return insert_->control(); }
  const SetupHistory& setup() const { return insert_->setup(); }
  OperationView& view() { return insert_->view(); }
  InsertionViews& views() { return insert_->views(); }
  Sheets& sheets() { return *sheets_; }

  /// Keeps a picture of the window, and says where.
  void takePicture();
  /// Esc: leaves what lies on the page, or lets go of the array.
  void leave();

Q_SIGNALS:
  /// The first frame with the cochlea in it is on the display.
  void firstFrameShown();
  /// Another insertion is being recorded: control().recording().
  void recordingChanged();
  /// A window made anew would show what was chosen in the settings.
  void anewAsked();

protected:
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void layOut();
  void connectInsertion();
  void connectPages();
  void showSubject();

  TopBar* top_;
  InsertPage* insert_;
  Sheets* sheets_;
  Notice* notice_;
  StartPage* start_;
  ValidatePage* validate_;
  ComparePage* compare_;
  SessionsPage* sessions_;
  PageStack* pages_;
  KeyActions keys_;
};

}  // namespace perilymph::gui
