#include "gui/pages/insert/FlatViews.h"

#include <algorithm>
#include <iterator>

#include "gui/pages/insert/Pane.h"
#include "gui/pages/insert/PlotView.h"
#include "gui/parts/ChartLabels.h"
#include "gui/parts/Numbers.h"
#include "perilymph/charts/ContactDistances.h"

namespace perilymph::gui {

struct FlatViews::Scene {
  Scene(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& design)
      : array(scala, design), style(chartStyle()), unrolled(scala, style), section(scala, style)
  {
  }
  charts::ArrayInScala array;
  charts::ChartStyle style;
  charts::UnrolledScala unrolled;
  charts::TipSection section;
};

FlatViews::FlatViews(QWidget* parent) : QObject(parent)
{
  unrolledView_ = new PlotView(
      [this](double width, double height) {
        return scene_ ? scene_->unrolled.draw(scene_->array, width, height) : figures::Drawing{};
      },
      parent);
  sectionView_ = new PlotView(
      [this](double width, double height) {
        return scene_ ? scene_->section.draw(scene_->array, width, height) : figures::Drawing{};
      },
      parent);
  distancesView_ = new PlotView(
      [this](double width, double height) {
        return scene_ ? charts::drawContactDistances(charts::contactDistances(scene_->array), width,
                                                     height, scene_->style)
                      : figures::Drawing{};
      },
      parent);
  unrolledPane_ = new Pane(tr("Unrolled scala tympani"), tr("angle from round window; width, mm"),
                           unrolledView_, parent);
  unrolledPane_->setObjectName(QStringLiteral("unrolledPane"));
  unrolledPane_->setTip(
      tr("The scala seen along the modiolus and rolled out. Bars: normal force of the wall on each "
         "millimeter of array; rings: forces of floor and roof."));
  sectionPane_ = new Pane(tr("Section at the tip"), QString(), sectionView_, parent);
  sectionPane_->setObjectName(QStringLiteral("sectionPane"));
  sectionPane_->setTip(tr(
      "The half-plane through the modiolar axis at the tip, to scale; its angle counts from the "
      "round window. The arrow is the wall’s "
      "normal force on the last millimeter of array. Where the wall yields, the array reaches past "
      "its line."));
  distancesPane_ = new Pane(tr("Contacts"), tr("to modiolus, mm"), distancesView_, parent);
  distancesPane_->setObjectName(QStringLiteral("distancesPane"));
  distancesPane_->setTip(tr(
      "From the center line of the array at each contact, 1 at the tip, to the inner wall on the "
      "way to the modiolar axis."));
}

FlatViews::~FlatViews() = default;

void FlatViews::setScene(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array)
{
  scene_ = std::make_unique<Scene>(scala, array);
}

void FlatViews::forgetScene() { scene_.reset(); }

void FlatViews::show(const haptics::Snapshot& now)
{
  PlotView* const views[] = {unrolledView_, sectionView_, distancesView_};
  const bool isSeen = std::any_of(std::begin(views), std::end(views),
                                  [](PlotView* view) { return view->isVisible(); });
  if (!scene_ || !isSeen) return;
  scene_->array.follow(now);
  for (PlotView* view : views) view->refresh();
  sectionPane_->setNote(
      tr("at %1°").arg(numberText(charts::TipSection::angle_deg(scene_->array), 0)));
}

}  // namespace perilymph::gui
