// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ReplayBar.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QToolTip>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/InsertionEvents.h"
#include "perilymph/analysis/Reference.h"

namespace perilymph::gui {

namespace {

constexpr double knob_px = 6.0;
constexpr double markReach_px = 4.0;

QString speedText(double speed)
{
  return ReplayBar::tr("%1 ×").arg(numberText(speed, speed == 0.25 ? 2 : speed < 1.0 ? 1 : 0));
}

bool isAlarm(analysis::EventKind kind)
{
  using analysis::EventKind;
  switch (kind) {
    case EventKind::rupture:
    case EventKind::translocation:
    case EventKind::resistance:
    case EventKind::buckled:
    case EventKind::outOfOpening:
    case EventKind::foldedTip:
    case EventKind::jammed:
      return true;
    default:
      return false;
  }
}

}  // namespace

Scrubber::Scrubber(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("scrubber"));
  setAttribute(Qt::WA_NoSystemBackground);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(tr("Position in the replay"));
}

void Scrubber::setFractions(double here, double ready)
{
  if (here == here_ && ready == ready_) return;
  here_ = here;
  ready_ = ready;
  update();
}

void Scrubber::setMarks(std::vector<ReplayMark> marks)
{
  marks_ = std::move(marks);
  QStringList texts;
  for (const ReplayMark& mark : marks_) texts << mark.text;
  setAccessibleDescription(texts.join(QStringLiteral("; ")));
  update();
}

double Scrubber::xOf(double fraction) const
{
  return knob_px + fraction * (width() - 2.0 * knob_px);
}

const ReplayMark* Scrubber::markAt(double x) const
{
  const ReplayMark* nearest = nullptr;
  for (const ReplayMark& mark : marks_) {
    const double distance = std::abs(x - xOf(mark.fraction));
    if (distance <= markReach_px &&
        (nearest == nullptr || distance < std::abs(x - xOf(nearest->fraction))))
      nearest = &mark;
  }
  return nearest;
}

bool Scrubber::event(QEvent* event)
{
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QStringList texts;  // all that lie there: events may coincide
  for (const ReplayMark& mark : marks_)
    if (std::abs(help->pos().x() - xOf(mark.fraction)) <= markReach_px) texts << mark.text;
  if (texts.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(help->globalPos(), texts.join(QLatin1Char('\n')), this);
  return true;
}

void Scrubber::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double middle = height() / 2.0;
  const auto at = [&](double fraction) { return QPointF(xOf(fraction), middle); };
  const auto line = [&](double fraction, const QColor& color) {
    painter.setPen(QPen(color, 4.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(at(0.0), at(fraction));
  };
  line(1.0, shownTheme().line);
  line(ready_, shownTheme().line.lighter(170));
  if (here_ > 0.0) line(here_, shownTheme().ghost);
  for (const ReplayMark& mark : marks_) {
    const double half = mark.isAlarm ? 10.0 : 7.0;
    painter.setPen(QPen(mark.isAlarm ? shownTheme().alarm : shownTheme().text, 2.0));
    painter.drawLine(at(mark.fraction) - QPointF(0, half), at(mark.fraction) + QPointF(0, half));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(shownTheme().text);
  painter.drawEllipse(at(here_), knob_px, knob_px);
}

void Scrubber::mousePressEvent(QMouseEvent* event)
{
  const double way = width() - 2.0 * knob_px;
  const ReplayMark* const mark =
      event->type() == QEvent::MouseButtonPress ? markAt(event->pos().x()) : nullptr;
  Q_EMIT draggedTo(mark != nullptr ? mark->fraction
                                   : std::clamp((event->pos().x() - knob_px) / way, 0.0, 1.0));
  event->accept();
}

void Scrubber::mouseMoveEvent(QMouseEvent* event)
{
  if ((event->buttons() & Qt::LeftButton) != 0) mousePressEvent(event);
}

ReplayBar::ReplayBar(QWidget* parent)
    : QWidget(parent),
      play_(addButton(tr("Play"), "replayPlayButton", 88, tr("Play or pause (Space)"))),
      back_(addButton(tr("◂"), "replayBackButton", 32, tr("Back 1 ms (Left)"))),
      forth_(addButton(tr("▸"), "replayForthButton", 32, tr("Forward 1 ms (Right)"))),
      slower_(addButton(tr("−"), "replaySlowerButton", 32, tr("Slower (comma)"))),
      faster_(addButton(tr("+"), "replayFasterButton", 32, tr("Faster (period)"))),
      close_(addButton(tr("Close replay"), "replayCloseButton", 112,
                       tr("Back to the insertion (Esc)"))),
      speed_(new QLabel(this)),
      time_(new QLabel(this)),
      status_(new QLabel(this)),
      scrubber_(new Scrubber(this))
{
  setObjectName(QStringLiteral("replayBar"));
  setFixedHeight(shownLengths().bar);
  play_->setProperty("primary", true);
  back_->setAccessibleName(tr("Back 1 ms"));
  forth_->setAccessibleName(tr("Forward 1 ms"));
  slower_->setAccessibleName(tr("Slower"));
  faster_->setAccessibleName(tr("Faster"));
  speed_->setObjectName(QStringLiteral("replaySpeed"));
  speed_->setFont(typeface(13));
  speed_->setAlignment(Qt::AlignCenter);
  speed_->setFixedWidth(sized(52));
  time_->setObjectName(QStringLiteral("replayTime"));
  time_->setToolTip(
      tr("Recorded time since the first motion; after the insertion time it includes the rest"));
  time_->setFont(typeface(13));
  time_->setProperty("quiet", true);
  time_->setMinimumWidth(sized(188));
  status_->setObjectName(QStringLiteral("replayStatus"));
  status_->setFont(typeface(11));
  status_->setProperty("quiet", true);
  status_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  status_->setWordWrap(true);
  status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * spacing, 0, 2 * spacing, 0);
  row->setSpacing(spacing);
  row->addWidget(play_);
  row->addWidget(back_);
  row->addWidget(forth_);
  row->addWidget(slower_);
  row->addWidget(speed_);
  row->addWidget(faster_);
  row->addSpacing(spacing);
  row->addWidget(scrubber_, 5);
  row->addWidget(time_);
  row->addWidget(status_, 4);
  row->addWidget(close_);

  connect(play_, &QPushButton::clicked, this, &ReplayBar::playRequested);
  connect(back_, &QPushButton::clicked, this, [this] { Q_EMIT stepRequested(-1); });
  connect(forth_, &QPushButton::clicked, this, [this] { Q_EMIT stepRequested(1); });
  connect(slower_, &QPushButton::clicked, this, &ReplayBar::slowerRequested);
  connect(faster_, &QPushButton::clicked, this, &ReplayBar::fasterRequested);
  connect(close_, &QPushButton::clicked, this, &ReplayBar::closeRequested);
  connect(scrubber_, &Scrubber::draggedTo, this, &ReplayBar::draggedTo);
}

QPushButton* ReplayBar::addButton(const QString& text, const char* name, int width,
                                  const QString& tip)
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(QLatin1String(name));
  button->setFont(typeface(13, QFont::Medium));
  button->setFixedSize(sized(width), sized(28));
  if (width < 40) button->setStyleSheet(QStringLiteral("padding: 0;"));
  button->setFocusPolicy(Qt::NoFocus);
  button->setToolTip(tip);
  return button;
}

void ReplayBar::showPlace(const ReplayPlayer& replay)
{
  if (!replay.isOpen()) return;
  const double last = double(std::max<std::uint64_t>(replay.playback().ticks(), 2) - 1);
  play_->setText(replay.isPlaying() ? tr("Pause") : tr("Play"));
  speed_->setText(speedText(replay.speed()));
  scrubber_->setFractions(double(replay.place()) / last,
                          std::min(1.0, double(replay.ready()) / last));
  const double end_s = replay.playback().samples().back().output.time;
  time_->setText(
      tr("%1 of %2 s recorded").arg(numberText(replay.now().output.time, 3), numberText(end_s, 3)));
  const QString label = tr("replay · %1 · not a medical device").arg(replay.verdict());
  if (status_->text() == label) return;
  status_->setText(label);
  status_->setToolTip(label);
  status_->setProperty("error", replay.isError());
  status_->style()->unpolish(status_);
  status_->style()->polish(status_);
}

void ReplayBar::showEvents(const ReplayPlayer& replay)
{
  const session::Playback& playback = replay.playback();
  const auto felt = analysis::forceFeltBySurgeons();
  analysis::EventFinder finder(playback.scenario().array(), felt ? felt->si() : 0.0);
  for (const session::Playback::Sample& sample : playback.samples())
    finder.add(sample.place, sample.output, sample.peak);
  const double last = double(std::max<std::uint64_t>(playback.ticks(), 2) - 1);
  std::vector<ReplayMark> marks;
  for (const analysis::InsertionEvent& event : finder.events())
    marks.push_back(
        {double(event.place) / last,
         tr("%1 s, %2 mm, %3 mN: %4")
             .arg(numberText(event.time, 2), numberText(inMillimeters(meters(event.depth)), 1),
                  numberText(inMillinewtons(newtons(event.force)), 0), dataText(textOf(event))),
         isAlarm(event.kind)});
  scrubber_->setMarks(std::move(marks));
}

}  // namespace perilymph::gui
