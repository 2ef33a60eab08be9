// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ViewMenu.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

using visualization::CameraPreset;
using visualization::Quality;
using visualization::Stereo;

void addHeading(QMenu& menu, const QString& title)
{
  QAction* heading = menu.addAction(title);
  heading->setEnabled(false);
  heading->setFont(typeface(11, QFont::DemiBold));
}

/// A heading, and an exclusive group of the entries below it.
QActionGroup* section(QMenu& menu, const QString& title)
{
  addHeading(menu, title);
  return new QActionGroup(&menu);
}

void check(const std::vector<QAction*>& choices, std::size_t chosen)
{
  for (std::size_t i = 0; i < choices.size(); ++i) choices[i]->setChecked(i == chosen);
}

}  // namespace

ViewMenu::ViewMenu(QWidget* parent) : QToolButton(parent)
{
  setObjectName(QStringLiteral("viewButton"));
  setText(tr("View ▾"));
  setFont(typeface(12));
  setFocusPolicy(Qt::NoFocus);
  setPopupMode(QToolButton::InstantPopup);
  setToolTip(tr("Camera, layout, stereo and rendering quality"));
  setAccessibleName(tr("View"));

  auto* menu = new QMenu(this);
  menu->setToolTipsVisible(true);
  QActionGroup* group = section(*menu, tr("CAMERA"));
  const struct {
    CameraPreset preset;
    QString text, key;
    const char* name;
  } presets[] = {
      {CameraPreset::surgeon, tr("Surgeon’s view, rotated 110°"), tr("1"), "viewSurgeon"},
      {CameraPreset::microscope, tr("Through the opening"), tr("2"), "viewMicroscope"},
      {CameraPreset::overview, tr("Overview"), tr("3"), "viewOverview"},
      {CameraPreset::section, tr("Basal-turn section"), tr("4"), "viewSection"},
      {CameraPreset::followTip, tr("Follow the tip"), tr("F"), "viewFollowTip"}};
  for (const auto& one : presets) {
    presets_.push_back(addChoice(*menu, *group, one.text, one.key, one.name));
    connect(presets_.back(), &QAction::triggered, this,
            [this, preset = one.preset] { Q_EMIT presetChosen(preset); });
  }

  menu->addSeparator();
  group = section(*menu, tr("VIEWS"));
  const struct {
    PaneLayout layout;
    QString text, key;
    const char* name;
  } layouts[] = {{PaneLayout::one, tr("One"), tr("Ctrl+1"), "layoutOne"},
                 {PaneLayout::two, tr("Two: picture and charts"), tr("Ctrl+2"), "layoutTwo"},
                 {PaneLayout::four, tr("Four"), tr("Ctrl+4"), "layoutFour"}};
  for (const auto& one : layouts) {
    layouts_.push_back(addChoice(*menu, *group, one.text, one.key, one.name));
    connect(layouts_.back(), &QAction::triggered, this,
            [this, layout = one.layout] { Q_EMIT arrangementChosen(layout); });
  }

  menu->addSeparator();
  group = section(*menu, tr("STEREO (G)"));
  const struct {
    Stereo stereo;
    QString text;
    const char* name;
  } stereos[] = {{Stereo::off, tr("Off"), "stereoOff"},
                 {Stereo::anaglyph, tr("Anaglyph, red and cyan"), "stereoAnaglyph"},
                 {Stereo::sideBySide, tr("Side by side"), "stereoSideBySide"},
                 {Stereo::interlaced, tr("Interlaced"), "stereoInterlaced"},
                 {Stereo::quadBuffered, tr("Quad-buffered"), "stereoQuadBuffered"}};
  for (const auto& one : stereos) {
    stereos_.push_back(addChoice(*menu, *group, one.text, QString(), one.name));
    connect(stereos_.back(), &QAction::triggered, this,
            [this, stereo = one.stereo] { Q_EMIT stereoChosen(stereo); });
  }

  menu->addSeparator();
  group = section(*menu, tr("RENDERING"));
  const struct {
    QualityChoice quality;
    QString text;
    const char* name;
  } qualities[] = {{std::nullopt, tr("Automatic"), "qualityAuto"},
                   {Quality::fast, tr("Fast"), "qualityFast"},
                   {Quality::software, tr("Balanced"), "qualityBalanced"},
                   {Quality::gpu, tr("Full"), "qualityFull"}};
  for (const auto& one : qualities) {
    qualities_.push_back(addChoice(*menu, *group, one.text, QString(), one.name));
    connect(qualities_.back(), &QAction::triggered, this,
            [this, quality = one.quality] { Q_EMIT qualityChosen(quality); });
  }
  addSound(*menu);
  connect(menu, &QMenu::aboutToShow, this, &ViewMenu::opened);
  setMenu(menu);
}

void ViewMenu::addSound(QMenu& menu)
{
  menu.addSeparator();
  addHeading(menu, tr("SOUND"));
  sound_ = menu.addAction(QString());
  sound_->setObjectName(QStringLiteral("soundOfForce"));
  sound_->setCheckable(true);
  connect(sound_, &QAction::triggered, this, &ViewMenu::soundChosen);
  offerSound(tr("searching for an audio device"));
}

void ViewMenu::offerSound(const QString& error)
{
  sound_->setEnabled(error.isEmpty());
  if (!error.isEmpty()) sound_->setChecked(false);
  sound_->setText(error.isEmpty() ? tr("Force sound: one octave per 100 mN")
                                  : tr("Force sound: %1").arg(error));
  sound_->setToolTip(error.isEmpty() ? tr("Plays a tone while the insertion force is 5 mN or more: "
                                          "220 Hz at zero force, one octave higher per 100 mN.")
                                     : error);
}

QAction* ViewMenu::addChoice(QMenu& menu, QActionGroup& group, const QString& text,
                             const QString& key, const char* name)
{
  // The key is only displayed; the window itself handles it.
  QAction* action = menu.addAction(key.isEmpty() ? text : text + QLatin1Char('\t') + key);
  action->setObjectName(QLatin1String(name));
  action->setCheckable(true);
  group.addAction(action);
  return action;
}

void ViewMenu::setPreset(CameraPreset preset)
{
  constexpr CameraPreset order[] = {CameraPreset::surgeon, CameraPreset::microscope,
                                    CameraPreset::overview, CameraPreset::section,
                                    CameraPreset::followTip};
  for (std::size_t i = 0; i < presets_.size(); ++i)
    if (order[i] == preset) check(presets_, i);
}

void ViewMenu::setArrangement(PaneLayout layout)
{
  check(layouts_, static_cast<std::size_t>(layout));
}

void ViewMenu::setStereo(Stereo stereo) { check(stereos_, static_cast<std::size_t>(stereo)); }

void ViewMenu::setQuality(QualityChoice quality)
{
  check(qualities_, quality ? 1 + static_cast<std::size_t>(*quality) : 0);
}

void ViewMenu::offerQuadBuffered(const QString& error)
{
  QAction* action = stereos_.back();
  action->setEnabled(error.isEmpty());
  action->setText(error.isEmpty() ? tr("Quad-buffered, separate window")
                                  : tr("Quad-buffered: %1").arg(error));
  action->setToolTip(
      error.isEmpty()
          ? tr("Stereo view through the left and right buffers of the display; Esc closes it.")
          : error);
}

}  // namespace perilymph::gui
