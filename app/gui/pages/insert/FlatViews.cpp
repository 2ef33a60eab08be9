// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/FlatViews.h"

#include <algorithm>

#include "gui/pages/insert/Pane.h"
#include "gui/run/SnapshotDifference.h"
#include "gui/text/ChartLabels.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/PlotView.h"
#include "gui/widgets/Theme.h"
#include "perilymph/charts/ContactDistances.h"

namespace perilymph::gui {

struct FlatViews::Scene {
  Scene(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& design)
      : array(scala, design),
        style(chartStyle(shownColorScheme())),
        unrolled(scala, style),
        section(scala, style)
  {
  }
  charts::ArrayInScala array;
  charts::ChartStyle style;
  charts::UnrolledScala unrolled;
  charts::TipSection section;
};

FlatViews::FlatViews(QWidget* parent) : QObject(parent)
{
  addView(PaneRole::unrolled, QStringLiteral("unrolledPane"), tr("Unrolled scala tympani"),
          tr("angle from round window; width, mm"),
          tr("The scala tympani seen along the modiolar axis and unrolled. Bars: normal wall force "
             "per millimeter of array; rings: forces from floor and roof. Red: where the cochlear "
             "partition is torn, and the array above it."),
          [](const Scene& scene, double width, double height) {
            return scene.unrolled.draw(scene.array, width, height);
          });
  sectionPane_ = addView(
      PaneRole::section, QStringLiteral("sectionPane"), tr("Section at the tip"), QString(),
      tr("Half-plane through the modiolar axis at the tip, to scale; the angle is measured from "
         "the round window. The arrow shows the normal wall force on the last millimeter of array. "
         "Where the wall is compliant, the array extends past its outline."),
      [](const Scene& scene, double width, double height) {
        return scene.section.draw(scene.array, width, height);
      });
  addView(PaneRole::distances, QStringLiteral("distancesPane"), tr("Contacts"),
          tr("distance to modiolus, mm"),
          tr("Distance from the center line of the array at each contact (1 at the tip) to the "
             "inner wall, toward the modiolar axis."),
          [](const Scene& scene, double width, double height) {
            return charts::drawContactDistances(charts::contactDistances(scene.array), width,
                                                height, scene.style);
          });
}

Pane* FlatViews::addView(PaneRole role, const QString& name, const QString& title,
                         const QString& note, const QString& tip, Draw draw)
{
  auto* const parent = qobject_cast<QWidget*>(this->parent());
  auto* const plot = new PlotView(
      [this, draw = std::move(draw)](double width, double height) {
        return scene_ ? draw(*scene_, width, height) : figures::Drawing{};
      },
      parent);
  auto* const pane = new Pane(title, note, plot, parent);
  pane->setObjectName(name);
  pane->setTip(tip);
  views_.push_back({role, plot, pane});
  return pane;
}

std::vector<std::pair<PaneRole, Pane*>> FlatViews::panes() const
{
  std::vector<std::pair<PaneRole, Pane*>> panes;
  for (const View& view : views_) panes.emplace_back(view.role, view.pane);
  return panes;
}

FlatViews::~FlatViews() = default;

void FlatViews::setScene(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array)
{
  scene_ = std::make_unique<Scene>(scala, array);
  isShown_ = false;
}

void FlatViews::releaseScene() { scene_.reset(); }

void FlatViews::show(const haptics::Snapshot& now)
{
  const bool isSeen = std::any_of(views_.begin(), views_.end(),
                                  [](const View& view) { return view.plot->isVisible(); });
  if (!scene_ || !isSeen || (isShown_ && lookAlike(now, shown_))) return;
  shown_ = now;
  isShown_ = true;
  scene_->array.follow(now);
  for (const View& view : views_) view.plot->refresh();
  const QString angle = numberText(charts::TipSection::angle_deg(scene_->array), 0);
  const auto& nodes = scene_->array.nodes();
  sectionPane_->setNote(!nodes.empty() && nodes.back().isAbove
                            ? tr("at %1°, tip in the scala vestibuli").arg(angle)
                            : tr("at %1°").arg(angle));
}

}  // namespace perilymph::gui
