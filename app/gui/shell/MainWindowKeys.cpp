// What the keys of the main window do, and what the sheet of keys says of them.

#include <QDateTime>
#include <QDir>
#include <QPixmap>
#include <QStandardPaths>
#include <array>

#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/devices/DevicePage.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/pages/validate/ValidatePage.h"
#include "gui/parts/Notice.h"
#include "gui/scene/OperationView.h"
#include "gui/shell/GuideSheet.h"
#include "gui/shell/KeyList.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/SettingsSheet.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

using visualization::CameraPreset;

constexpr double turn_deg = 5.0;       // per press of A, D, W, X
constexpr double moveFraction = 0.03;  // per press of Shift and an arrow, of the picture's height
constexpr double magnify = 1.1;        // per press of + or −

}  // namespace

std::function<bool(int)> MainWindow::onInsertion(std::function<void(int)> act)
{
  return [this, act = std::move(act)](int which) {
    if (page_ != Page::insert) return false;
    act(which);
    return true;
  };
}

std::function<bool(int)> MainWindow::onAnyPage(std::function<void(int)> act)
{
  return [act = std::move(act)](int which) {
    act(which);
    return true;
  };
}

void MainWindow::addKeys()
{
  addInsertionKeys();
  addPictureKeys();
  addReplayKeys();
  addWindowKeys();
}

void MainWindow::addInsertionKeys()
{
  const auto section = KeySection::insertion;
  keyActions_.add({section,
                   {Qt::Key_Space},
                   tr("start or pause; hold the array with mouse and keyboard"),
                   onInsertion([this](int) { pressSpace(); })});
  keyActions_.add({section,
                   {Qt::Key_Down, Qt::Key_Up},
                   tr("advance or withdraw the array while it is held"),
                   onInsertion([this](int which) {
                     if (control_.isHeld()) pressed_.insert(which == 0 ? Qt::Key_Down : Qt::Key_Up);
                   })});
  keyActions_.add(Gesture{section, tr("Wheel"), tr("the same")});
  keyActions_.add(
      {section, {Qt::Key_Backspace}, tr("withdraw"), onInsertion([this](int) { withdraw(); })});
  keyActions_.add({section,
                   {with(Qt::ControlModifier, Qt::Key_R)},
                   tr("reset: a fresh insertion and recording"),
                   onInsertion([this](int) { reset(); })});
  keyActions_.add({section,
                   {with(Qt::ControlModifier, Qt::Key_Z),
                    with(Qt::ControlModifier | Qt::ShiftModifier, Qt::Key_Z)},
                   tr("undo and redo a change of the setup"),
                   onInsertion([this](int which) { which == 0 ? undo() : redo(); })});
  keyActions_.add({section, {Qt::Key_S}, tr("pull the stylet"), onInsertion([this](int) {
                     control_.pullStylet();
                   })});
}

void MainWindow::addPictureKeys()
{
  const auto section = KeySection::picture;
  static constexpr std::array views{CameraPreset::surgeon, CameraPreset::microscope,
                                    CameraPreset::overview, CameraPreset::section};
  keyActions_.add({section,
                   {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4},
                   tr("surgeon’s view, down the opening, overview, section"),
                   onInsertion([this](int which) { view_->glideTo(views[std::size_t(which)]); })});
  keyActions_.add({section, {Qt::Key_F}, tr("follow the tip"), onInsertion([this](int) {
                     view_->glideTo(CameraPreset::followTip);
                   })});
  keyActions_.add({section,
                   {Qt::Key_G},
                   tr("stereo: off, anaglyph, side by side, interlaced"),
                   onInsertion([this](int) { views_->nextStereo(); })});
  static constexpr std::array<std::pair<double, double>, 4> turns{
      {{-turn_deg, 0.0}, {turn_deg, 0.0}, {0.0, -turn_deg}, {0.0, turn_deg}}};
  keyActions_.add({section,
                   {Qt::Key_A, Qt::Key_D, Qt::Key_W, Qt::Key_X},
                   tr("turn the model"),
                   onInsertion([this](int which) {
                     const auto [azimuth_deg, elevation_deg] = turns[std::size_t(which)];
                     view_->turnModel(azimuth_deg, elevation_deg, 0.0);
                   }),
                   true});
  static constexpr std::array<std::pair<double, double>, 4> moves{
      {{-moveFraction, 0.0}, {moveFraction, 0.0}, {0.0, moveFraction}, {0.0, -moveFraction}}};
  keyActions_.add({section,
                   {with(Qt::ShiftModifier, Qt::Key_Left), with(Qt::ShiftModifier, Qt::Key_Right),
                    with(Qt::ShiftModifier, Qt::Key_Up), with(Qt::ShiftModifier, Qt::Key_Down)},
                   tr("move the model"),
                   onInsertion([this](int which) {
                     const auto [right, up] = moves[std::size_t(which)];
                     view_->moveModel(right, up);
                   }),
                   true});
  keyActions_.add(
      {section,
       {Qt::Key_Plus, Qt::Key_Minus, Qt::Key_Equal},
       tr("magnify"),
       onInsertion([this](int which) { view_->zoom(which == 1 ? 1.0 / magnify : magnify); }),
       true});
  keyActions_.add(Gesture{section, tr("Drag; Shift+drag"), tr("turn the model; move it")});
  keyActions_.add(Gesture{section, tr("Wheel, Ctrl+wheel"), tr("magnify")});
}

void MainWindow::addReplayKeys()
{
  // They act before all others while a recording is open: keyOfReplay().
  const auto section = KeySection::replay;
  keyActions_.add(Gesture{section, tr("Space; Esc"), tr("play or pause; back to the insertion")});
  keyActions_.add(Gesture{section, tr("Left, Right; with Shift"), tr("step by 1 tick; by 100")});
  keyActions_.add(Gesture{section, tr("Home, End"), tr("to the beginning, to the end")});
  keyActions_.add(Gesture{section, tr(",  ."), tr("slower, faster")});
}

void MainWindow::addWindowKeys()
{
  const auto section = KeySection::window;
  keyActions_.add(
      {section, {Qt::Key_L}, tr("one, two or four views in turn"), onInsertion([this](int) {
         views_->nextArrangement();
       })});
  static constexpr std::array layouts{PaneLayout::one, PaneLayout::two, PaneLayout::four};
  keyActions_.add(
      {section,
       {with(Qt::ControlModifier, Qt::Key_1), with(Qt::ControlModifier, Qt::Key_2),
        with(Qt::ControlModifier, Qt::Key_4)},
       tr("one, two, four views"),
       onInsertion([this](int which) { views_->setArrangement(layouts[std::size_t(which)]); })});
  keyActions_.add(Gesture{section, tr("Double click"), tr("enlarge a view, and back")});
  keyActions_.add({section,
                   {with(Qt::AltModifier, Qt::Key_Home)},
                   tr("begin anew: the first screen"),
                   onAnyPage([this](int) { showPage(Page::start); })});
  static constexpr std::array pages{Page::insert, Page::compare, Page::validate, Page::sessions};
  keyActions_.add({section,
                   {with(Qt::AltModifier, Qt::Key_1), with(Qt::AltModifier, Qt::Key_2),
                    with(Qt::AltModifier, Qt::Key_3), with(Qt::AltModifier, Qt::Key_4)},
                   tr("insert, compare, validate, sessions"),
                   onAnyPage([this](int which) { showPage(pages[std::size_t(which)]); })});
  keyActions_.add({section,
                   {Qt::Key_H},
                   tr("devices: which there are, and how the hand is doing"),
                   onInsertion([this](int) { toggleDevices(); })});
  keyActions_.add({section, {Qt::Key_B}, tr("hide or show the panel"), onInsertion([this](int) {
                     side_->setCollapsed(!side_->isCollapsed());
                   })});
  keyActions_.add(
      {section, {Qt::Key_Return, Qt::Key_Enter}, tr("out of the panel’s fields"), [this](int) {
         return leavePanel();
       }});
  keyActions_.add(
      {section, {with(Qt::ControlModifier, Qt::Key_Comma)}, tr("settings"), onAnyPage([this](int) {
         toggleSettings();
       })});
  keyActions_.add({section, {Qt::Key_F11}, tr("full screen, and back"), onAnyPage([this](int) {
                     setWindowState(windowState() ^ Qt::WindowFullScreen);
                   })});
  keyActions_.add({section,
                   {with(Qt::ControlModifier | Qt::ShiftModifier, Qt::Key_S)},
                   tr("keep a picture of the window"),
                   onAnyPage([this](int) { takePicture(); })});
  keyActions_.add({section, {Qt::Key_F1, Qt::Key_Question}, tr("this list"), onAnyPage([this](int) {
                     toggleKeyList();
                   })});
  keyActions_.add(
      {section, {with(Qt::ShiftModifier, Qt::Key_F1)}, tr("user guide"), onAnyPage([this](int) {
         toggleGuide();
       })});
  keyActions_.add({section,
                   {Qt::Key_Escape},
                   tr("leave what lies on the page; let go of the array"),
                   onAnyPage([this](int) { leave(); })});
  keyActions_.add(Gesture{section, tr("Tab"), tr("to the next button or field")});
}

void MainWindow::pressSpace()
{
  if (control_.hand() == InputSource::pointer) {
    if (!control_.isRunning()) start();
    hold(true);
  } else if (control_.isMoving()) {
    pause();
  } else {
    start();
  }
}

bool MainWindow::leavePanel()
{
  if (page_ != Page::insert || !side_->isAncestorOf(focusWidget())) return false;
  setFocus();
  return true;
}

void MainWindow::leave()
{
  if (modelBuilder_.isBusy()) return cancelBuilding();
  if (guide_->isVisible()) return toggleGuide();
  if (leavePanel()) return;
  if (keys_->isVisible()) return toggleKeyList();
  if (settings_->isVisible()) return toggleSettings();
  if (devices_->isVisible()) return toggleDevices();
  if (page_ == Page::insert && (control_.isMoving() || control_.isHeld())) return pause();
  if (notice_->isVisible()) return notice_->hide();
  if (page_ == Page::validate) validation_->cancel();
  if (page_ == Page::compare) comparison_->cancel();
  const bool isElsewhere = focusWidget() != nullptr && focusWidget() != this;
  if (isElsewhere && page_ != Page::start) return setFocus();
  if (isFullScreen()) setWindowState(windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::toggleSettings()
{
  settings_->setVisible(!settings_->isVisible());
  if (!settings_->isVisible()) return setFocus();
  settings_->adjustSize();
  settings_->move(rect().center() - settings_->rect().center());
  settings_->raise();
}

void MainWindow::toggleKeyList()
{
  keys_->adjustSize();
  keys_->move(rect().center() - keys_->rect().center());
  keys_->setVisible(!keys_->isVisible());
  keys_->raise();
}

void MainWindow::toggleGuide()
{
  keys_->hide();
  if (guide_->isHidden()) return guide_->open();
  guide_->hide();
  setFocus();
}

void MainWindow::takePicture()
{
  const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  QDir().mkpath(pictures);  // what cannot be made is said when the file is written
  const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
  QString file = QStringLiteral("%1/perilymph-%2.png").arg(pictures, name);
  for (int number = 2; QFile::exists(file); ++number)
    file = QStringLiteral("%1/perilymph-%2-%3.png").arg(pictures, name).arg(number);
  const QPixmap picture = grab();
  const Result<Done> written =
      writeWhole(file.toStdString(), [&picture](const std::filesystem::path& place) {
        return picture.save(QString::fromStdString(place.string()), "PNG");
      });
  notice_->say(written ? tr("The picture is kept: %1").arg(file)
                       : QString::fromStdString(written.error().message));
}

}  // namespace perilymph::gui
