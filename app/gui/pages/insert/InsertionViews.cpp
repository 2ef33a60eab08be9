// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/InsertionViews.h"

#include "gui/pages/insert/FlatViews.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/ForceSound.h"
#include "gui/pages/insert/FrameMeter.h"
#include "gui/pages/insert/Pane.h"
#include "gui/pages/insert/ViewMenu.h"
#include "gui/run/ScenarioApproach.h"
#include "gui/run/UserSettings.h"
#include "gui/scene/OperationView.h"
#include "gui/scene/StereoWindow.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/text/ChartLabels.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr auto layoutKey = "insert/layout";
constexpr auto qualityKey = "insert/quality";

PaneLayout keptLayout()
{
  const QString word = UserSettings().value(QLatin1String(layoutKey)).toString();
  return word == QLatin1String("one")    ? PaneLayout::one
         : word == QLatin1String("four") ? PaneLayout::four
                                         : PaneLayout::two;
}

void keepLayout(PaneLayout layout)
{
  UserSettings().setValue(QLatin1String(layoutKey),
                          QLatin1String(layout == PaneLayout::one    ? "one"
                                        : layout == PaneLayout::four ? "four"
                                                                     : "two"));
}

QualityChoice keptQuality()
{
  return qualityNamed(UserSettings().value(QLatin1String(qualityKey)).toString().toStdString())
      .value_or(std::nullopt);
}

void keepQuality(QualityChoice choice)
{
  UserSettings().setValue(QLatin1String(qualityKey), QString::fromStdString(nameOf(choice)));
}

}  // namespace

InsertionViews::InsertionViews(QWidget* parent)
    : PaneArea(parent),
      operation_(new OperationView(this)),
      charts_(new ForceCharts(this)),
      flat_(new FlatViews(this)),
      menu_(new ViewMenu(operation_)),
      sound_(new ForceSound(this))
{
  add(PaneRole::picture, operation_);
  add(PaneRole::travel, charts_->overTravel());
  add(PaneRole::components, charts_->components());
  for (const auto& [role, pane] : flat_->panes()) add(role, pane);
  operation_->addFooterControl(menu_);
  setArrangement(keptLayout());
  connectParts();
}

InsertionViews::~InsertionViews() = default;

void InsertionViews::connectParts()
{
  auto panes = flat_->panes();
  panes.emplace_back(PaneRole::travel, charts_->overTravel());
  panes.emplace_back(PaneRole::components, charts_->components());
  for (const auto& [role, pane] : panes)
    connect(pane, &Pane::maximizeRequested, this, [this, asked = role] { toggleMaximized(asked); });
  connect(operation_, &OperationView::maximizeRequested, this,
          [this] { toggleMaximized(PaneRole::picture); });
  connect(this, &PaneArea::arrangementChanged, this, [this](PaneLayout layout) {
    keepLayout(layout);
    menu_->setArrangement(layout);
  });
  connect(operation_, &OperationView::presetChanged, menu_, &ViewMenu::setPreset);
  connect(menu_, &ViewMenu::presetChosen, this, &InsertionViews::lookFrom);
  connect(menu_, &ViewMenu::arrangementChosen, this, &PaneArea::setArrangement);
  connect(menu_, &ViewMenu::stereoChosen, this, &InsertionViews::setStereo);
  connect(menu_, &ViewMenu::qualityChosen, this, &InsertionViews::chooseQuality);
  connect(menu_, &ViewMenu::opened, sound_, &ForceSound::ask);
  connect(menu_, &ViewMenu::soundChosen, sound_, &ForceSound::setOn);
  connect(sound_, &ForceSound::known, menu_, &ViewMenu::offerSound);
  menu_->setArrangement(arrangement());
  menu_->setStereo(visualization::Stereo::off);
  menu_->setQuality(std::nullopt);
  offerQuadBuffered(tr("not supported by this display"));
}

void InsertionViews::lookFrom(visualization::CameraPreset preset) { operation_->glideTo(preset); }

void InsertionViews::setStereo(visualization::Stereo stereo)
{
  using visualization::Stereo;
  if (stereo == Stereo::quadBuffered && !hasQuadBuffers_) stereo = Stereo::off;
  operation_->setStereo(stereo);
  menu_->setStereo(stereo);
  closeTwin();
  if (hasOwnWindow(stereo)) openTwin();
}

void InsertionViews::nextStereo()
{
  using visualization::Stereo;
  const Stereo last = hasQuadBuffers_ ? Stereo::quadBuffered : Stereo::interlaced;
  const Stereo now = operation_->stereo();
  setStereo(now == last ? Stereo::off : static_cast<Stereo>(static_cast<int>(now) + 1));
}

void InsertionViews::offerQuadBuffered(const QString& error)
{
  hasQuadBuffers_ = error.isEmpty();
  menu_->offerQuadBuffered(error);
}

std::unique_ptr<visualization::InsertionScene> InsertionViews::madeScene() const
{
  auto scene = std::make_unique<visualization::InsertionScene>(
      *scala_, array_, side_, pilot_.quality(), sceneStyle(shownColorScheme()));
  scene->bone().setBone(bone());
  scene->setApproach(approach_);
  return scene;
}

std::shared_ptr<const visualization::BoneModel> InsertionViews::bone() const
{
  return patient_ && boneSource_ ? boneSource_(*patient_) : nullptr;
}

void InsertionViews::setBoneSource(BoneSource source)
{
  boneSource_ = std::move(source);
  refreshBone();
}

void InsertionViews::refreshBone()
{
  if (scala_ == nullptr) return;
  const auto shown = bone();
  const CochleaOrigin origin = !patient_                   ? CochleaOrigin::model
                               : isMeasuredInCt(*patient_) ? CochleaOrigin::ct
                                                           : CochleaOrigin::numbers;
  operation_->setBone(shown, boneNote(shown != nullptr, origin));
  if (twin_) twin_->scene().bone().setBone(shown);
}

void InsertionViews::openTwin()
{
  if (scala_ == nullptr || operation_->scene() == nullptr) return;
  if (!twin_) {
    twin_ = std::make_unique<StereoWindow>(operation_->stereo(), nullptr);
    // deferred, because it is emitted by its own event
    connect(
        twin_.get(), &StereoWindow::closed, this, [this] { setStereo(visualization::Stereo::off); },
        Qt::QueuedConnection);
  }
  auto scene = madeScene();
  scene->showPartsOf(*operation_->scene());
  scene->show(shown_);
  twin_->setScene(std::move(scene));
  operation_->setTwin(twin_.get());
}

void InsertionViews::closeTwin()
{
  operation_->setTwin(nullptr);
  twin_.reset();
}

void InsertionViews::drawBy(const std::string& renderer, std::optional<QualityChoice> asked)
{
  pilot_ = AdaptiveQuality(renderer);
  measures_ = true;
  pilot_.choose(asked ? *asked : keptQuality());
  menu_->setQuality(pilot_.choice());
  redraw();
}

void InsertionViews::chooseQuality(QualityChoice choice)
{
  pilot_.choose(choice);
  keepQuality(choice);
  menu_->setQuality(choice);
  redraw();
}

void InsertionViews::weigh(const FrameMeter& meter)
{
  if (pilot_.rest(operation_->isResting())) redraw();
  const bool isEnough = meter.frames() >= AdaptiveQuality::minFrames &&
                        meter.span_s() >= AdaptiveQuality::firstSecond_s;
  if (!measures_ || !isEnough) return;
  measures_ = false;  // once: sorting an hour of frame times would itself cost frames
  if (pilot_.weigh(meter.frames(), meter.span_s(), meter.quantile_ms(0.5))) redraw();
}

void InsertionViews::redraw()
{
  if (scala_ != nullptr) {
    operation_->replaceScene(madeScene());
    operation_->scene()->show(shown_);  // nothing moved
    if (twin_) openTwin();
  }
  Q_EMIT qualityChanged();
}

void InsertionViews::setScene(const anatomy::ScalaTympani& scala, const session::Scenario& scenario)
{
  scala_ = &scala;
  array_ = scenario.array();
  side_ = scenario.patient().side;
  approach_ = approachOf(scenario);
  patient_.reset();
  if (scenario.anatomy() == anatomy::AnatomySource::mean &&
      anatomy::isScaledBy(scenario.anatomy(), scenario.patient()))
    patient_ = scenario.patient();
  operation_->setScene(madeScene());
  refreshBone();
  flat_->setScene(scala, array_);
  if (twin_) openTwin();
}

void InsertionViews::releaseScene()
{
  scala_ = nullptr;
  shown_ = {};
  flat_->releaseScene();
}

void InsertionViews::showSlowly(const haptics::Snapshot& now)
{
  shown_ = now;
  flat_->show(now);
  if (now.output.workflow == haptics::Workflow::inserting)
    sound_->show(Force::fromSi(now.output.axialForce));
}

QSize InsertionViews::minimumSizeHint() const
{
  return {operation_->minimumSizeHint().width() + shownLengths().minChartColumn + 1, 400};
}

}  // namespace perilymph::gui
