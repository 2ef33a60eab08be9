// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/InsertKeys.h"

#include <QCoreApplication>
#include <array>
#include <utility>

#include "gui/pages/insert/InsertPage.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/scene/OperationView.h"
#include "gui/scene/SceneLabels.h"
#include "gui/shell/KeyActions.h"

namespace perilymph::gui {

namespace {

using visualization::CameraPreset;

constexpr double turn_deg = 5.0;       // per press of A, D, W, X
constexpr double moveFraction = 0.03;  // per press of Shift and an arrow, of the picture's height
constexpr double magnify = 1.1;        // per press of + or −

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

void addInsertionSection(KeyActions& keys, InsertionController& insertion, InsertPage& page)
{
  const auto section = KeySection::insertion;
  keys.add({section,
            {Qt::Key_Space},
            tr("start or pause; hold the array (mouse and keyboard)"),
            onPage(page, [&insertion](int) { insertion.pressSpace(); })});
  keys.add({section,
            {Qt::Key_Down, Qt::Key_Up},
            tr("advance or withdraw the held array"),
            onPage(page, [&insertion](int which) {
              insertion.held().press(which == 0 ? Qt::Key_Down : Qt::Key_Up);
            })});
  keys.add(Gesture{section, tr("Wheel"), tr("advance (down) or withdraw (up) the held array")});
  keys.add({section, {Qt::Key_Backspace}, tr("withdraw"), onPage(page, [&insertion](int) {
              insertion.withdraw();
            })});
  keys.add({section,
            {with(Qt::ControlModifier, Qt::Key_R)},
            tr("reset: new insertion and recording"),
            onPage(page, [&insertion](int) { insertion.reset(); })});
  keys.add({section,
            {with(Qt::ControlModifier, Qt::Key_Z),
             with(Qt::ControlModifier | Qt::ShiftModifier, Qt::Key_Z)},
            tr("undo or redo a setup change"),
            onPage(page,
                   [&insertion](int which) { which == 0 ? insertion.undo() : insertion.redo(); })});
  keys.add({section, {Qt::Key_S}, tr("withdraw the stylet"), onPage(page, [&insertion](int) {
              insertion.control().pullStylet();
            })});
}

void addPictureSection(KeyActions& keys, InsertPage& page)
{
  const auto section = KeySection::picture;
  static constexpr std::array views{CameraPreset::surgeon, CameraPreset::microscope,
                                    CameraPreset::overview, CameraPreset::section};
  keys.add({section,
            {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4},
            tr("surgeon’s view, through the opening, overview, basal-turn section"),
            onPage(page, [&page](int which) {
              page.views().operation()->glideTo(views[std::size_t(which)]);
            })});
  keys.add({section, {Qt::Key_F}, tr("follow the tip"), onPage(page, [&page](int) {
              page.views().operation()->glideTo(CameraPreset::followTip);
            })});
  keys.add({section, {Qt::Key_C}, tr("bone and landmarks on or off"), onPage(page, [&page](int) {
              page.toggleLandmarks();
            })});
  keys.add({section,
            {Qt::Key_PageUp, Qt::Key_PageDown},
            tr("move the cut of the bone"),
            onPage(page,
                   [&page](int which) {
                     page.views().operation()->moveCut(which == 0 ? cutOfKey_mm : -cutOfKey_mm);
                   }),
            true});
  keys.add({section, {Qt::Key_V}, tr("turn the cut to the viewer"), onPage(page, [&page](int) {
              page.views().operation()->faceCut();
            })});
  keys.add({section,
            {Qt::Key_G},
            tr("stereo: off, anaglyph, side by side, interlaced"),
            onPage(page, [&page](int) { page.views().nextStereo(); })});
  static constexpr std::array<std::pair<double, double>, 4> turns{
      {{-turn_deg, 0.0}, {turn_deg, 0.0}, {0.0, -turn_deg}, {0.0, turn_deg}}};
  keys.add({section,
            {Qt::Key_A, Qt::Key_D, Qt::Key_W, Qt::Key_X},
            tr("rotate the model"),
            onPage(page,
                   [&page](int which) {
                     const auto [azimuth_deg, elevation_deg] = turns[std::size_t(which)];
                     page.views().operation()->turnModel(azimuth_deg, elevation_deg, 0.0);
                   }),
            true});
  static constexpr std::array<std::pair<double, double>, 4> moves{
      {{-moveFraction, 0.0}, {moveFraction, 0.0}, {0.0, moveFraction}, {0.0, -moveFraction}}};
  keys.add({section,
            {with(Qt::ShiftModifier, Qt::Key_Left), with(Qt::ShiftModifier, Qt::Key_Right),
             with(Qt::ShiftModifier, Qt::Key_Up), with(Qt::ShiftModifier, Qt::Key_Down)},
            tr("pan"),
            onPage(page,
                   [&page](int which) {
                     const auto [right, up] = moves[std::size_t(which)];
                     page.views().operation()->moveModel(right, up);
                   }),
            true});
  keys.add({section,
            {Qt::Key_Plus, Qt::Key_Minus, Qt::Key_Equal},
            tr("zoom"),
            onPage(page,
                   [&page](int which) {
                     page.views().operation()->zoom(which == 1 ? 1.0 / magnify : magnify);
                   }),
            true});
  keys.add(Gesture{section, tr("Drag; Shift+drag"), tr("rotate the model; pan")});
  keys.add(Gesture{section, tr("Wheel, Ctrl+wheel"), tr("zoom")});
}

void addReplaySection(KeyActions& keys)
{
  // They have priority while a recording is open: ReplayControl::takeKey().
  const auto section = KeySection::replay;
  keys.add(Gesture{section, tr("Space; Esc"), tr("play or pause; back to the insertion")});
  keys.add(Gesture{section, tr("Left, Right; with Shift"), tr("step by 1 ms; by 100 ms")});
  keys.add(Gesture{section, tr("Home, End"), tr("go to start, to end")});
  keys.add(Gesture{section, tr(",  ."), tr("slower, faster")});
}

}  // namespace

std::function<bool(int)> onPage(InsertPage& page, std::function<void(int)> act)
{
  return [&page, act = std::move(act)](int which) {
    if (!page.isShown()) return false;
    act(which);
    return true;
  };
}

void addInsertKeys(KeyActions& keys, InsertionController& insertion, InsertPage& page)
{
  addInsertionSection(keys, insertion, page);
  addPictureSection(keys, page);
  addReplaySection(keys);
}

}  // namespace perilymph::gui
