#include "InsertionViews.h"

#include "FlatViews.h"
#include "ForceCharts.h"
#include "OperationView.h"
#include "Pane.h"
#include "Settings.h"
#include "Theme.h"

namespace perilymph::gui {

namespace {

constexpr auto layoutKey = "insert/layout";

PaneLayout keptLayout()
{
  const QString word = Settings().value(QLatin1String(layoutKey)).toString();
  return word == QLatin1String("one")    ? PaneLayout::one
         : word == QLatin1String("four") ? PaneLayout::four
                                         : PaneLayout::two;
}

void keepLayout(PaneLayout layout)
{
  Settings().setValue(QLatin1String(layoutKey),
                      QLatin1String(layout == PaneLayout::one    ? "one"
                                    : layout == PaneLayout::four ? "four"
                                                                 : "two"));
}

}  // namespace

InsertionViews::InsertionViews(QWidget* parent)
    : PaneArea(parent),
      operation_(new OperationView(this)),
      charts_(new ForceCharts(this)),
      flat_(new FlatViews(this))
{
  add(PaneRole::picture, operation_);
  add(PaneRole::travel, charts_->overTravel());
  add(PaneRole::components, charts_->components());
  add(PaneRole::unrolled, flat_->unrolled());
  add(PaneRole::section, flat_->section());
  setArrangement(keptLayout());
  connectParts();
}

InsertionViews::~InsertionViews() = default;

void InsertionViews::connectParts()
{
  const std::pair<PaneRole, Pane*> panes[] = {{PaneRole::travel, charts_->overTravel()},
                                              {PaneRole::components, charts_->components()},
                                              {PaneRole::unrolled, flat_->unrolled()},
                                              {PaneRole::section, flat_->section()}};
  for (const auto& [role, pane] : panes)
    connect(pane, &Pane::maximizeAsked, this, [this, asked = role] { toggleMaximized(asked); });
  connect(operation_, &OperationView::maximizeAsked, this,
          [this] { toggleMaximized(PaneRole::picture); });
  connect(this, &PaneArea::arrangementChanged, this, &keepLayout);
}

void InsertionViews::setScene(const anatomy::ScalaTympani& scala, const session::Scenario& scenario)
{
  operation_->setScene(std::make_unique<visualization::InsertionScene>(scala, scenario.array,
                                                                       scenario.patient.side));
  flat_->setScene(scala, scenario.array);
}

void InsertionViews::forgetScene() { flat_->forgetScene(); }

void InsertionViews::showSlowly(const haptics::Snapshot& now) { flat_->show(now); }

QSize InsertionViews::minimumSizeHint() const
{
  return {operation_->minimumSizeHint().width() + chartColumnWidth + 1, 400};
}

}  // namespace perilymph::gui
