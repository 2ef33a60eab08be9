#include "ChartColumn.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "Theme.h"

namespace perilymph::gui {

ChartColumn::ChartColumn(QWidget* parent) : QWidget(parent)
{
  setFixedWidth(chartColumnWidth);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, 2 * spacing);
  column->setSpacing(spacing);
  travelView_ = addChart(*column, tr("Force over travel"), tr("axial, N"), 5);
  column->addSpacing(spacing);
  timeView_ = addChart(*column, tr("Force components"), tr("last 5 s, mN"), 3);

  overTravel_.setScale(devicePixelRatioF());
  components_.setScale(devicePixelRatioF());
  overTravel_.attachTo(*travelView_->renderWindow());
  components_.attachTo(*timeView_->renderWindow());
}

ChartColumn::~ChartColumn() = default;

QVTKOpenGLNativeWidget* ChartColumn::addChart(QVBoxLayout& column, const QString& title,
                                              const QString& note, int stretch)
{
  auto* titleLabel = new QLabel(title, this);
  titleLabel->setFont(typeface(13, QFont::DemiBold));
  auto* noteLabel = new QLabel(note, this);
  noteLabel->setFont(typeface(11));
  noteLabel->setProperty("quiet", true);
  auto* row = new QHBoxLayout;
  row->addWidget(titleLabel);
  row->addStretch();
  row->addWidget(noteLabel);
  column.addLayout(row);
  if (travelTitle_ == nullptr) travelTitle_ = titleLabel;

  auto* view = new QVTKOpenGLNativeWidget(this);
  view->setFocusPolicy(Qt::NoFocus);
  view->setAttribute(Qt::WA_TransparentForMouseEvents);
  view->setAttribute(Qt::WA_AcceptTouchEvents, false);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  view->setRenderWindow(window);
  if (window->GetInteractor() != nullptr) window->GetInteractor()->SetInteractorStyle(nullptr);
  column.addWidget(view, stretch);
  return view;
}

void ChartColumn::setExperiment(const Result<charts::ReferenceCurve>& experiment)
{
  if (!experiment) {
    travelTitle_->setToolTip(QString::fromStdString(experiment.error().message));
    return;
  }
  overTravel_.setReference(experiment->points, experiment->label);
  travelTitle_->setToolTip(QString::fromStdString(experiment->source));
}

void ChartColumn::setExperimentVisible(bool isVisible)
{
  overTravel_.setVisible(charts::ChartLayer::reference, isVisible);
}

void ChartColumn::setGhost(std::vector<std::pair<Length, Force>> curve, const QString& name)
{
  overTravel_.setGhost(std::move(curve), tr("ghost: %1").arg(name).toStdString());
}

void ChartColumn::begin(const anatomy::Entry& entry)
{
  entry_ = entry;
  overTravel_.clear();
  components_.clear();
}

void ChartColumn::append(const haptics::TickOutput& now)
{
  overTravel_.append(Length::fromSi(now.travel), Force::fromSi(now.axialForce));
  const auto along = [&now](const Eigen::Vector3d& axis_W) {
    return Force::fromSi(now.force_W[0] * axis_W.x() + now.force_W[1] * axis_W.y() +
                         now.force_W[2] * axis_W.z());
  };
  components_.append(
      Duration::fromSi(now.time),
      {Force::fromSi(now.axialForce), along(entry_.outward_W), along(entry_.vertical_W)});
}

bool ChartColumn::renderIfDirty()
{
  if (!travelView_->isValid() || !timeView_->isValid()) return false;
  const bool travelChanged = overTravel_.update();
  const bool timeChanged = components_.update();
  if (travelChanged) travelView_->renderWindow()->Render();
  if (timeChanged) timeView_->renderWindow()->Render();
  return travelChanged || timeChanged;
}

}  // namespace perilymph::gui
