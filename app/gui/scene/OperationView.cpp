// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/OperationView.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "gui/scene/Banner.h"
#include "gui/scene/ForceLabel.h"
#include "gui/scene/PhaseLine.h"
#include "gui/scene/PictureLabel.h"
#include "gui/scene/ReadOutTips.h"
#include "gui/scene/SceneLabels.h"
#include "gui/scene/StereoWindow.h"
#include "gui/scene/ViewNames.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/ReadOut.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

using visualization::CameraPreset;

// Height of the view's own text below the scale bars: two labels and the phase line.
constexpr int footHeight_px = 100;
constexpr int lowFootHeight_px = 56;     // without the phase line
constexpr double usualLetter_px = 12.0;  // of a scene's own texts
// Of the view's height; the rest is the picture's. With more, texts yield (Texts), at last the picture's share.
constexpr double textShare = 0.6, lowTextShare = 0.7;
constexpr int number_px = 46;  // of the three read-outs above, and what yields to a narrow view
constexpr int compactNumber_px = 28;
constexpr std::array numbers_px{number_px, 34, 28, 24, 20, 17};
constexpr qint64 restTime_ms = 1000;
constexpr QSize scales_px(270, 85);  // of the scene’s legend of forces
constexpr int narrowNote_px = 220;   // a narrower note has many lines
constexpr qint64 boneRest_ms = 250;  // without motion the bone is shown in full

}  // namespace

OperationView::OperationView(QWidget* parent)
    : PlainVtkWidget(parent),
      labels_(new SceneLabels(*this)),
      travel_(new ReadOut({number_px, QStringLiteral("00.0"), tr("mm"), Qt::AlignLeft}, this)),
      angle_(new ReadOut({number_px, QStringLiteral("000"), QStringLiteral("°"), Qt::AlignLeft},
                         this)),
      force_(new ReadOut({number_px, QStringLiteral("-000"), tr("mN"), Qt::AlignRight}, this)),
      forceLabel_(new ForceLabel(this)),
      speed_(new ReadOut({20, QStringLiteral("-00.0"), tr("mm/s"), Qt::AlignRight}, this)),
      banner_(new Banner(this)),
      hint_(pictureLabel(this, "hintLabel")),
      magnification_(elidedPictureLabel(this, "magnificationLabel")),
      viewName_(elidedPictureLabel(this, "viewLabel")),
      phase_(new PhaseLine(this))
{
  setObjectName(QStringLiteral("operationView"));
  addReadOuts();
  sinceMotion_.start();
  showNumbers({}, {}, millimeters(1));
}

OperationView::~OperationView() = default;

void OperationView::addReadOuts()
{
  travel_->setObjectName(QStringLiteral("travelReadOut"));
  angle_->setObjectName(QStringLiteral("angleReadOut"));
  force_->setObjectName(QStringLiteral("forceReadOut"));
  speed_->setObjectName(QStringLiteral("speedReadOut"));
  tips().set();
  hint_->setVisible(false);
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);

  auto* numbers = new QHBoxLayout;
  numbers->setSpacing(0);
  numbers->addWidget(travel_, 0, Qt::AlignTop);
  numbers->addSpacing(spacing);
  numbers->addWidget(angle_, 0, Qt::AlignTop);
  numbers->addStretch();
  numbers->addWidget(force_, 0, Qt::AlignTop);

  foot_ = new QHBoxLayout;
  foot_->addWidget(magnification_);
  foot_->addStretch();
  foot_->addWidget(viewName_);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, spacing, 2 * spacing, spacing);
  column->setSpacing(spacing);
  column->addLayout(numbers);
  column->addWidget(forceLabel_, 0, Qt::AlignRight);
  column->addWidget(speed_, 0, Qt::AlignRight);
  column->addWidget(banner_);
  column->addStretch();
  column->addLayout(foot_);
  column->addWidget(phase_);
}

void OperationView::captionReadOuts()
{
  travel_->setCaption(tr("advanced · insertion depth %1 mm").arg(depth_mm_));
  angle_->setCaption(tr("angular insertion depth · tip %1°").arg(tip_deg_));
  force_->setCaption(tr("insertion force"));
  const auto fits = [this] { return widthOf({travel_, angle_, force_}) <= width(); };
  if (!fits()) angle_->setCaption(tr("angular insertion depth"));
  if (!fits()) captionShortly();
  // at once: the caption is as wide as its number
  if (travel_->width() < travel_->sizeHint().width()) layout()->activate();
}

void OperationView::captionShortly()
{
  travel_->setCaption(tr("depth %1 mm").arg(depth_mm_));
  angle_->setCaption(tr("angular depth"));
  force_->setCaption(tr("force"));
}

/// Height of what lies below the scale bars, at a text of 100 %: the scene scales it.
int OperationView::footMargin() const
{
  if (visitorLetter_px_ > 0) {
    // its scene scales it with its own type, too
    const int foot = phase_->sizeHint().height() + 3 * spacing;
    return qRound(foot * usualLetter_px / visitorLetter_px_ / textScale());
  }
  const bool isLow = texts_ == Texts::low;
  // gaps and the line of phases do not shrink with the text
  const int more = isLow ? 0 : std::max(0, 60 - sized(60));
  return (isLow ? lowFootHeight_px : footHeight_px) + qRound((hintLift_ + more) / textScale());
}

/// The scene between the read-outs above and the texts below.
void OperationView::fitScene()
{
  if (!scene_) return;
  scene_->setScaleBarMargin(footMargin());
  const double across = std::max(1, width()), down = std::max(1, height());
  int above = spacing;
  for (const QWidget* part : std::initializer_list<const QWidget*>{travel_, forceLabel_, speed_})
    if (!part->isHidden()) above = std::max(above, part->geometry().bottom() + spacing);
  const double below = footMargin() * textScale() *
                       (visitorLetter_px_ > 0 ? visitorLetter_px_ / usualLetter_px : 1.0);
  // a view that is hardly higher than its texts is free as a whole
  const bool isRoomy = above + below <= lowTextShare * down;
  scene_->setFreeArea({spacing / across, isRoomy ? below / down : 0.0, 1.0 - spacing / across,
                       isRoomy ? 1.0 - above / down : 1.0});
  isDirty_ = true;
}

ReadOutTips OperationView::tips() const
{
  return {travel_, angle_, force_, forceLabel_, speed_, magnification_, viewName_, phase_};
}

void OperationView::addFooterControl(QWidget* control) { foot_->addWidget(control); }

void OperationView::setScene(std::unique_ptr<visualization::InsertionScene> scene)
{
  take(std::move(scene));
  scene_->lookFrom(CameraPreset::surgeon);
  describeView();
}

void OperationView::replaceScene(std::unique_ptr<visualization::InsertionScene> scene)
{
  if (!scene_) return setScene(std::move(scene));
  scene->showPartsOf(*scene_);
  scene->keepViewOf(*scene_);
  take(std::move(scene));
  describeView();
}

void OperationView::take(std::unique_ptr<visualization::InsertionScene> scene)
{
  if (scene_) renderWindow()->RemoveRenderer(&scene_->renderer());
  scene_ = std::move(scene);
  scene_->setScale(devicePixelRatioF() * textScale());
  scene_->attachTo(*renderWindow());
  fitScene();
  scene_->setStereo(hasOwnWindow(stereo_) ? visualization::Stereo::off : stereo_);
  isDirty_ = true;
}

void OperationView::setStereo(visualization::Stereo stereo)
{
  stereo_ = stereo;
  if (!scene_) return;
  scene_->setStereo(hasOwnWindow(stereo_) ? visualization::Stereo::off : stereo_);
  describeView();
  isDirty_ = true;
}

void OperationView::showArray(const haptics::Snapshot& now)
{
  if (!scene_) return;
  scene_->show(now);
  if (twin_ != nullptr) twin_->scene().show(now);
  sinceMotion_.restart();
  isDirty_ = true;
}

void OperationView::showGhost(const electrode::ArrayDesign& array,
                              std::span<const Eigen::Vector3d> nodes_W)
{
  if (!scene_) return;
  scene_->showGhost(array, nodes_W);
  if (twin_ != nullptr) twin_->scene().showGhost(array, nodes_W);
  isDirty_ = true;
}

void OperationView::showNumbers(const haptics::TickOutput& now, Angle angularDepth,
                                Length stopTravel)
{
  phase_->setPhase(analysis::phaseOf(now, stopTravel));
  if (visitorLetter_px_ > 0) return;
  travel_->setNumber(numberText(inMillimeters(Length::fromSi(now.travel)), 1));
  depth_mm_ = numberText(inMillimeters(Length::fromSi(now.depth)), 1);
  tip_deg_ = numberText(inDegrees(Angle::fromSi(now.angularDepth)), 0);
  captionReadOuts();
  angle_->setNumber(numberText(inDegrees(angularDepth), 0));
  force_->setNumber(numberText(inMillinewtons(Force::fromSi(now.axialForce)), 0));
  forceLabel_->show(now);
  speed_->setNumber(numberText(inMillimetersPerSecond(Speed::fromSi(now.speed)), 1));
}

void OperationView::setForVisitors(int size_px)
{
  visitorLetter_px_ = size_px;
  for (QWidget* part : std::initializer_list<QWidget*>{travel_, angle_, force_, forceLabel_, speed_,
                                                       magnification_, viewName_})
    part->hide();
  phase_->setForVisitors(size_px);
  fitReadOuts();
  placeHint();
}

void OperationView::retranslate()
{
  if (scene_) describeView();
  phase_->update();
}

void OperationView::setPartial(bool isPartial) { phase_->setPartial(isPartial); }

void OperationView::setPartVisible(visualization::Part part, bool isVisible)
{
  if (!scene_) return;
  scene_->setVisible(part, isVisible);
  if (twin_ != nullptr) twin_->scene().setVisible(part, isVisible);
  isDirty_ = true;
}

void OperationView::setBone(std::shared_ptr<const visualization::BoneModel> bone,
                            const QString& note)
{
  boneNote_ = note;
  if (!scene_) return;
  scene_->bone().setBone(std::move(bone));
  isDirty_ = true;
}

void OperationView::placeBoneNote()
{
  // beside the interpretation of the force where there is room, else below
  const int left = 2 * spacing, beside = forceLabel_->x() - left - spacing;
  const bool isBeside = beside >= sized(narrowNote_px);
  const QWidget& above = isBeside              ? static_cast<QWidget&>(*travel_)
                         : speed_->isVisible() ? static_cast<QWidget&>(*speed_)
                                               : static_cast<QWidget&>(*forceLabel_);
  labels_->setNote(boneNote_, {left, above.geometry().bottom() + spacing},
                   isBeside ? beside : width() - 2 * left);
}

void OperationView::moveCut(double by_mm)
{
  if (!scene_ || !scene_->bone().isVisible()) return;
  scene_->bone().moveCut(by_mm);
  if (twin_ != nullptr) twin_->scene().bone().moveCut(by_mm);
  sinceMotion_.restart();
  isDirty_ = true;
}

void OperationView::faceCut()
{
  if (!scene_ || !scene_->bone().isVisible()) return;
  scene_->bone().faceCut();
  if (twin_ != nullptr) twin_->scene().bone().faceCut();
  isDirty_ = true;
}

void OperationView::glideTo(CameraPreset preset)
{
  if (!scene_) return;
  scene_->glideTo(preset);
  describeView();
  sinceMotion_.restart();
  isDirty_ = true;
}

void OperationView::turnModel(double azimuth_deg, double elevation_deg, double roll_deg)
{
  if (!scene_) return;
  scene_->rotateModel(azimuth_deg, elevation_deg, roll_deg);
  sinceMotion_.restart();
  isDirty_ = true;
}

void OperationView::moveModel(double right, double up)
{
  if (!scene_) return;
  scene_->moveModel(right * pictureHeight_mm(), up * pictureHeight_mm());
  sinceMotion_.restart();
  isDirty_ = true;
}

void OperationView::zoom(double factor)
{
  if (!scene_) return;
  scene_->zoom(factor);
  describeView();
  sinceMotion_.restart();
  isDirty_ = true;
}

void OperationView::stepCamera(double seconds)
{
  if (scene_ && scene_->bone().isVisible()) {
    const bool wasMoving = scene_->bone().isMoving();
    scene_->bone().setMoving(sinceMotion_.elapsed() < boneRest_ms);
    if (wasMoving != scene_->bone().isMoving()) isDirty_ = true;
  }
  if (!scene_ || !scene_->stepCamera(seconds)) return;
  describeView();
  sinceMotion_.restart();
  isDirty_ = true;
}

void OperationView::describeView()
{
  describedMagnification_ = scene_->magnification();
  magnification_->setText(tr("Microscope × %1").arg(numberText(scene_->magnification(), 1)));
  const QString eyes = nameOf(stereo_);
  const QString name = nameOf(scene_->preset());
  viewName_->setText(eyes.isEmpty() ? name : tr("%1 · %2").arg(name, eyes));
  placeHint();
  Q_EMIT presetChanged(scene_->preset());
}

double OperationView::pictureHeight_mm() const
{
  return 2.0 * scene_->renderer().GetActiveCamera()->GetParallelScale();
}

void OperationView::setBanner(const QString& sentence) { banner_->setSentence(sentence); }

void OperationView::setHint(const QString& hint)
{
  if (hint_->text() == hint) return;
  hint_->setText(hint);
  placeHint();
}

void OperationView::fitReadOuts()
{
  if (visitorLetter_px_ > 0) {
    layout()->activate();
    return;
  }
  captionShortly();
  for (const Texts texts : {Texts::whole, Texts::compact, Texts::low}) {
    showTexts(texts);
    if (heightOf(texts) <= textShare * height()) break;
  }
  layout()->activate();
}

void OperationView::showTexts(Texts texts)
{
  texts_ = texts;
  const bool isWhole = texts == Texts::whole;
  for (ReadOut* readOut : {travel_, angle_, force_}) readOut->setCompact(texts == Texts::low);
  for (const int size : numbers_px) {
    if (!isWhole && size > compactNumber_px) continue;
    for (ReadOut* readOut : {travel_, angle_, force_}) readOut->setNumberSize(size);
    if (widthOf({travel_, angle_, force_}) <= width()) break;
  }
  speed_->setVisible(isWhole);
  phase_->setVisible(texts != Texts::low);
}

/// The height that the read-outs above and the texts below the picture take.
int OperationView::heightOf(Texts texts) const
{
  int above = spacing;
  for (const QWidget* part : std::initializer_list<const QWidget*>{travel_, forceLabel_})
    above += part->sizeHint().height() + spacing;
  if (texts == Texts::whole) above += speed_->sizeHint().height() + spacing;
  return above + qRound(footMargin() * textScale());
}

void OperationView::placeHint()
{
  if (visitorLetter_px_ > 0) {
    fitScene();
    return;
  }
  const bool isSeen = !hint_->text().isEmpty();
  constexpr int padding = 2 * 6;  // of the style sheet
  const int caption = QFontMetrics(hint_->font()).horizontalAdvance(hint_->text()) + padding + 1;
  const auto spaceBeside = [this] {
    layout()->activate();
    const int left = magnification_->geometry().right() + spacing;
    const QWidget* next =
        viewName_->isHidden() ? foot_->itemAt(foot_->count() - 1)->widget() : viewName_;
    return QRect(left, foot_->geometry().top(), next->x() - spacing - left,
                 foot_->geometry().height());
  };
  hint_->setVisible(isSeen);
  viewName_->setVisible(true);
  QRect beside = spaceBeside();
  if (isSeen && caption > beside.width()) {  // the hint is more important than the view's name
    viewName_->setVisible(false);
    beside = spaceBeside();
  }
  int lift = 0;
  if (caption <= beside.width()) {
    const int left =
        std::clamp((width() - caption) / 2, beside.left(), beside.right() - caption + 1);
    const int height = magnification_->sizeHint().height();
    hint_->setGeometry(left, beside.center().y() - height / 2, caption, height);
  } else if (isSeen) {
    viewName_->setVisible(true);
    const int widest = std::min(caption, foot_->geometry().width());
    const int height = hint_->heightForWidth(widest);
    hint_->setGeometry((width() - widest) / 2, beside.top() - height - spacing, widest, height);
    lift = height + spacing;
  }
  hintLift_ = lift;
  fitScene();
}

bool OperationView::isResting() const { return sinceMotion_.elapsed() > restTime_ms; }

bool OperationView::renderIfDirty()
{
  if (!isDirty_ || !scene_ || !isValid()) return false;
  isDirty_ = false;
  renderWindow()->Render();
  // since then it framed the ear in another window
  if (scene_->magnification() != describedMagnification_) describeView();
  if (twin_ != nullptr) twin_->renderAs(*scene_);
  if (scene_->bone().isVisible()) placeBoneNote();
  // the scales lie above the foot, at the left
  const int foot = qRound(textScale() * footMargin());
  labels_->follow(&scene_->bone(), {QRectF(0.0, height() - foot - sized(scales_px.height()),
                                           sized(scales_px.width()), sized(scales_px.height()))});
  return true;
}

void OperationView::resizeEvent(QResizeEvent* event)
{
  PlainVtkWidget::resizeEvent(event);
  fitReadOuts();
  if (!depth_mm_.isEmpty()) captionReadOuts();
  placeHint();
  isDirty_ = true;
}

bool OperationView::event(QEvent* event)
{
  if (event->type() == QEvent::ToolTip) {
    const auto& help = static_cast<const QHelpEvent&>(*event);
    if (tips().show(*this, help.pos(), help.globalPos())) return true;
  }
  return PlainVtkWidget::event(event);
}

void OperationView::mousePressEvent(QMouseEvent* event)
{
  mouse_ = event->pos();
  isCutHeld_ = event->button() == Qt::LeftButton && scene_ && scene_->bone().isVisible() &&
               (labels_->isHandleAt(mouse_) || (event->modifiers() & Qt::ControlModifier) != 0);
  event->accept();
}

void OperationView::mouseMoveEvent(QMouseEvent* event)
{
  const QPoint moved = event->pos() - mouse_;
  mouse_ = event->pos();
  const double right = double(moved.x()) / height();
  const double down = double(moved.y()) / height();
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (isCutHeld_)
    moveCut(labels_->cutMotion_mm(moved));
  else if ((event->buttons() & Qt::MiddleButton) != 0 ||
           ((event->buttons() & Qt::LeftButton) != 0 && isShift))
    moveModel(right, -down);
  else if ((event->buttons() & Qt::LeftButton) != 0)
    turnModel(right * turnPerHeight_deg, down * turnPerHeight_deg, 0.0);
  else if ((event->buttons() & Qt::RightButton) != 0)
    zoom(std::exp(-2.0 * down));
  event->accept();
}

void OperationView::mouseReleaseEvent(QMouseEvent* event)
{
  isCutHeld_ = false;
  event->accept();
}

void OperationView::mouseDoubleClickEvent(QMouseEvent* event)
{
  event->accept();
  if (event->button() == Qt::LeftButton) Q_EMIT maximizeRequested();
}

}  // namespace perilymph::gui
