// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ForceCharts.h"

#include <vtkRenderWindow.h>

#include <QEvent>
#include <algorithm>

#include "gui/pages/insert/Pane.h"
#include "gui/scene/PlainVtkWidget.h"
#include "gui/text/ChartLabels.h"
#include "gui/text/DataText.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/InsertionEvents.h"
#include "perilymph/figures/Strings.h"

namespace perilymph::gui {

ForceCharts::ForceCharts(QWidget* parent)
    : QObject(parent),
      overTravel_(chartStyle(shownColorScheme())),
      components_(chartStyle(shownColorScheme())),
      travelView_(chartView(parent)),
      timeView_(chartView(parent))
{
  travelPane_ =
      new Pane(tr("Insertion force over travel"), tr("insertion force, mN"), travelView_, parent);
  travelPane_->setObjectName(QStringLiteral("travelPane"));
  timePane_ = new Pane(tr("Force components"), tr("last 5 s, mN"), timeView_, parent);
  timePane_->setObjectName(QStringLiteral("componentsPane"));

  overTravel_.setScale(parent->devicePixelRatioF() * textScale());
  components_.setScale(parent->devicePixelRatioF() * textScale());
  overTravel_.attachTo(*travelView_->renderWindow());
  components_.attachTo(*timeView_->renderWindow());
}

ForceCharts::~ForceCharts() = default;

PlainVtkWidget* ForceCharts::chartView(QWidget* parent)
{
  auto* view = new PlainVtkWidget(parent);
  view->setAttribute(Qt::WA_TransparentForMouseEvents);
  view->installEventFilter(this);
  return view;
}

bool ForceCharts::eventFilter(QObject* watched, QEvent* event)
{
  // hidden charts missed updates; resized ones show an old picture
  if (event->type() == QEvent::Show || event->type() == QEvent::Resize)
    (watched == travelView_ ? travelIsDirty_ : timeIsDirty_) = true;
  return QObject::eventFilter(watched, event);
}

void ForceCharts::setExperiment(const Result<charts::ReferenceCurve>& experiment)
{
  if (!experiment) return travelPane_->setTip(dataText(experiment.error().message));
  overTravel_.setReference(experiment->points, referenceName(experiment->label).toStdString());
  travelPane_->setTip(QString::fromStdString(experiment->source));
}

void ForceCharts::setExperimentVisible(bool isVisible)
{
  isExperimentVisible_ = isVisible;
  showExperiment();
}

void ForceCharts::setComparable(bool isComparable)
{
  isComparable_ = isComparable;
  showExperiment();
}

void ForceCharts::showExperiment()
{
  overTravel_.setVisible(charts::ChartLayer::reference, isExperimentVisible_ && isComparable_);
}

void ForceCharts::setGhost(const std::optional<ReferenceInsertion>& reference)
{
  ghost_ = reference;
  if (reference)
    overTravel_.setGhost(reference->curve, reference->name.toStdString());
  else
    overTravel_.setGhost({}, {});
}

void ForceCharts::setPlan(const std::optional<PlannedForce>& plan) { plan_ = plan; }

bool ForceCharts::showPlanIn(const session::Scenario& scenario)
{
  std::vector<charts::ExpectedForce> points;
  if (plan_ && plan_->isFor(scenario))
    for (const PlannedForce::Point& each : plan_->points) {
      const double travel_mm = each.depth_mm - inMillimeters(scenario.startInside());
      if (travel_mm >= 0.0)
        points.push_back({travel_mm, each.low_mN, each.median_mN, each.high_mN});
    }
  const bool isShown = !points.empty();
  overTravel_.setExpected(std::move(points), isShown ? plan_->label.toStdString() : std::string());
  return isShown;
}

void ForceCharts::showRibsOf(const session::Scenario& scenario)
{
  std::vector<Length> ribs = scenario.array().ribsFromTip;
  std::ranges::sort(ribs);
  const std::string name = chartStyle(shownColorScheme()).strings.rib;
  std::vector<std::pair<double, std::string>> marks;
  for (std::size_t i = 0; i < ribs.size(); ++i) {
    const Length travel = ribs[i] - scenario.startInside();
    if (travel.si() >= 0.0 && travel <= scenario.stopTravel() + analysis::ribReach())
      marks.emplace_back(inMillimeters(travel), figures::filled(name, {std::to_string(i + 1)}));
  }
  overTravel_.setTravelMarks(std::move(marks));
}

void ForceCharts::begin(const anatomy::Entry& entry)
{
  entry_ = entry;
  peak_N_ = 0.0;
  overTravel_.clear();
  components_.clear();
}

void ForceCharts::append(const haptics::TickOutput& now, const haptics::PeakForce& peak)
{
  if (peak.force > peak_N_) {
    peak_N_ = peak.force;
    overTravel_.append(Length::fromSi(peak.travel), Force::fromSi(peak.force));
  }
  overTravel_.append(Length::fromSi(now.travel), Force::fromSi(now.axialForce));
  const auto along = [&now](const Eigen::Vector3d& axis_W) {
    return Force::fromSi(now.force_W[0] * axis_W.x() + now.force_W[1] * axis_W.y() +
                         now.force_W[2] * axis_W.z());
  };
  components_.append(
      Duration::fromSi(now.time),
      {Force::fromSi(now.axialForce), along(entry_.outward_W), along(entry_.vertical_W)});
}

void ForceCharts::showRecorded(const analysis::ForceProfile& profile)
{
  overTravel_.clear();
  std::vector<analysis::CurvePoint> curve = profile.curve;
  const auto before = [](const analysis::CurvePoint& one, const analysis::CurvePoint& other) {
    return one.travel < other.travel;
  };
  curve.insert(std::upper_bound(curve.begin(), curve.end(), profile.peak, before), profile.peak);
  for (const analysis::CurvePoint& point : curve)
    overTravel_.append(meters(point.travel), newtons(point.force));
}

bool ForceCharts::renderNext()
{
  const auto render = [](PlainVtkWidget& view, auto& chart, bool& isDirty) {
    if (!view.isVisible() || !view.isValid()) return false;
    if (!chart.update() && !isDirty) return false;
    isDirty = false;
    view.renderWindow()->Render();
    return true;
  };
  const auto renderTime = [&] { return render(*timeView_, components_, timeIsDirty_); };
  const bool isTimeRendered = isTimeNext_ && renderTime();
  if (!isTimeRendered && render(*travelView_, overTravel_, travelIsDirty_)) {
    isTimeNext_ = true;
    return true;
  }
  isTimeNext_ = false;
  return isTimeRendered || renderTime();
}

}  // namespace perilymph::gui
