// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/MarkGuide.h"

#include <QLabel>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include "gui/pages/ct/CtText.h"
#include "gui/setup/LandmarkDrawing.h"
#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Population.h"

namespace perilymph::gui {

namespace {

constexpr int drawingHeight_px = 190;

LandmarkDrawing::Point pointOf(ct::Mark mark)
{
  using Point = LandmarkDrawing::Point;
  switch (mark) {
    case ct::Mark::roundWindow:
      return Point::roundWindow;
    case ct::Mark::farWall:
      return Point::farWall;
    case ct::Mark::nearB:
      return Point::nearB;
    case ct::Mark::farB:
      return Point::farB;
    case ct::Mark::floor:
      return Point::floor;
    case ct::Mark::apex:
      return Point::apex;
    case ct::Mark::modiolus:
      return Point::modiolus;
  }
  return Point::none;
}

}  // namespace

MarkGuide::MarkGuide(const CtStudy& study, QWidget* parent)
    : QWidget(parent),
      study_(study),
      name_(new QLabel(this)),
      text_(new QLabel(this)),
      drawing_(new LandmarkDrawing(this))
{
  setObjectName(QStringLiteral("markGuide"));
  name_->setFont(typeface(13, QFont::DemiBold));
  text_->setFont(typeface(12));
  text_->setWordWrap(true);
  drawing_->setFixedHeight(drawingHeight_px);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  for (QWidget* each : {static_cast<QWidget*>(name_), static_cast<QWidget*>(drawing_),
                        static_cast<QWidget*>(text_)})
    column->addWidget(each);
  hide();
}

void MarkGuide::showMark(const std::optional<ct::Mark>& mark)
{
  setVisible(mark.has_value());
  if (!mark) return;
  anatomy::BasalTurn turn{anatomy::spreadOfA().mean, anatomy::spreadOfB().mean, std::nullopt};
  auto side = anatomy::Side::right;
  if (const auto& measures = study_.measures()) {
    turn = {millimeters(measures->a.value), millimeters(measures->b.value), std::nullopt};
    side = measures->side;
  }
  drawing_->show(turn, side);
  drawing_->showPoint(pointOf(*mark));
  name_->setText(markName(*mark));
  text_->setText(markGuide(*mark));
  // below the buttons, often outside a low panel; its place is known after the layout
  QTimer::singleShot(0, this, [this] {
    for (QWidget* above = parentWidget(); above != nullptr; above = above->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(above)) return area->ensureWidgetVisible(this);
  });
}

}  // namespace perilymph::gui
