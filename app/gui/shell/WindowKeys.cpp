// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/WindowKeys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QStringList>
#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "gui/pages/insert/InsertPage.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/shell/Help.h"
#include "gui/shell/InsertKeys.h"
#include "gui/shell/KeyActions.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/OverlayStack.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

std::function<bool(int)> always(std::function<void(int)> act)
{
  return [act = std::move(act)](int which) {
    act(which);
    return true;
  };
}

/// Keys with Alt are the window's, whatever has the focus: tables and lists would take Alt+Home as
/// Home.
class AltKeys : public QObject {
public:
  AltKeys(const KeyActions& keys, QWidget& window) : QObject(&window), keys_(keys), window_(window)
  {
  }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (event->type() != QEvent::KeyPress) return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool isWithAltAlone = (key.modifiers() & ~Qt::KeypadModifier) == Qt::AltModifier;
    const auto* widget = qobject_cast<const QWidget*>(watched);
    return isWithAltAlone && widget != nullptr && widget->window() == &window_ && keys_.take(key);
  }

private:
  const KeyActions& keys_;
  QWidget& window_;
};

/// Alt+Home and Alt+1 to Alt+9, in the order of the pages.
void addPageKeys(KeyActions& keys, MainWindow& window)
{
  const std::vector<Page*>& pages = window.pages().all();
  keys.add({KeySection::window,
            {with(Qt::AltModifier, Qt::Key_Home)},
            pages.front()->name(),
            always([&window, &pages](int) { window.showPage(*pages.front()); })});
  QVector<QKeySequence> digits;
  QStringList names;
  for (std::size_t i = 1; i < std::min(pages.size(), std::size_t(10)); ++i) {
    digits.push_back(with(Qt::AltModifier, Qt::Key(Qt::Key_0 + int(i))));
    names.push_back(pages[i]->name());
  }
  keys.add(
      {KeySection::window, digits, names.join(QLatin1String(", ")),
       always([&window, &pages](int which) { window.showPage(*pages[std::size_t(which) + 1]); })});
}

}  // namespace

void addWindowKeys(KeyActions& keys, MainWindow& window, InsertPage& page)
{
  const auto section = KeySection::window;
  keys.add({section, {Qt::Key_L}, tr("cycle one, two or four views"), onPage(page, [&page](int) {
              page.views().nextArrangement();
            })});
  static constexpr std::array layouts{PaneLayout::one, PaneLayout::two, PaneLayout::four};
  keys.add({section,
            {with(Qt::ControlModifier, Qt::Key_1), with(Qt::ControlModifier, Qt::Key_2),
             with(Qt::ControlModifier, Qt::Key_4)},
            tr("one, two, four views"),
            onPage(page, [&page](int which) {
              page.views().setArrangement(layouts[std::size_t(which)]);
            })});
  keys.add(Gesture{section, tr("Double click"), tr("maximize a view; restore")});
  const auto ct = KeySection::ct;
  keys.add(Gesture{ct, tr("Click; drag a landmark"), tr("move the crosshair; move the landmark")});
  keys.add(Gesture{ct, tr("Wheel, Up, Down; Ctrl+wheel, +, -"), tr("layers; zoom")});
  keys.add(Gesture{ct, tr("Right drag; middle or Shift+drag"), tr("brightness and contrast; pan")});
  keys.add(Gesture{ct, tr("D, A, N; Return; Esc"),
                   tr("distance, angle, note; next point at the crosshair; end the tool")});
  keys.add(Gesture{ct, tr("Del; Ctrl+Z, Ctrl+Shift+Z; K"),
                   tr("remove the chosen markup; undo, redo; keep a key image for the report")});
  keys.add(Gesture{ct, tr("Bone: drag the handle of the line, Shift+arrow keys; Home"),
                   tr("turn the line of approach; along the axis of the opening")});
  addPageKeys(keys, window);
  qApp->installEventFilter(new AltKeys(keys, window));
  keys.add({section,
            {Qt::Key_H},
            tr("devices: list and connection quality"),
            onPage(page, [&window](int) { window.sheets().toggleDevices(); })});
  keys.add({section, {Qt::Key_B}, tr("hide or show the panel"), onPage(page, [&page](int) {
              page.togglePanel();
            })});
  keys.add({section, {Qt::Key_Return, Qt::Key_Enter}, tr("leave the field"), [&page](int) {
              return page.leavePanel();
            }});
  keys.add(
      {section, {with(Qt::ControlModifier, Qt::Key_Comma)}, tr("settings"), always([&window](int) {
         window.sheets().toggleSettings();
       })});
  keys.add({section, {with(Qt::ControlModifier, Qt::Key_Q)}, tr("quit"), always([&window](int) {
              window.close();
            })});
  keys.add({section, {Qt::Key_F11}, tr("full screen on or off"), always([&window](int) {
              window.setWindowState(window.windowState() ^ Qt::WindowFullScreen);
            })});
  keys.add({section,
            {with(Qt::ControlModifier | Qt::ShiftModifier, Qt::Key_S)},
            tr("save a screenshot"),
            always([&window](int) { window.takePicture(); })});
  keys.add({section,
            {Qt::Key_F1, Qt::Key_Question},
            tr("keyboard and mouse reference"),
            always([&window](int) { window.sheets().help().toggleKeys(); })});
  keys.add(
      {section, {with(Qt::ShiftModifier, Qt::Key_F1)}, tr("user guide"), always([&window](int) {
         window.sheets().help().toggleGuide();
       })});
  keys.add({section,
            {Qt::Key_Escape},
            tr("remove the force of a device; close the open panel; release the array"),
            always([&window](int) { window.leave(); })});
  keys.add(Gesture{section, tr("Tab"), tr("next button or field")});
}

}  // namespace perilymph::gui
