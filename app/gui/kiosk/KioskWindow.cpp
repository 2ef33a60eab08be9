#include "gui/kiosk/KioskWindow.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/kiosk/BoardView.h"
#include "gui/kiosk/PushPad.h"
#include "gui/parts/Theme.h"
#include "gui/scene/OperationView.h"

namespace perilymph::gui {

namespace {

constexpr int frameInterval_ms = 16;
constexpr int buttonHeight_px = 96;  // twice what a finger needs
constexpr int headHeight_px = 112;

}  // namespace

KioskWindow::KioskWindow(session::Scenario scenario, std::filesystem::path board, KioskClock clock)
    : control_(std::move(scenario), std::nullopt),
      clock_(std::move(clock)),
      board_(std::move(board)),
      inVivo_(analysis::shippedReference("in-vivo")),
      title_(new QLabel(this)),
      sentence_(new QLabel(this)),
      view_(new OperationView(this)),
      boardView_(new BoardView(this)),
      foot_(new QStackedWidget(this))
{
  control_.keepNothing();
  setObjectName(QStringLiteral("kioskWindow"));
  setWindowTitle(tr("Perilymph"));
  setFont(typeface(16));
  setStyleSheet(windowStyle());
  setMinimumSize(1024, 720);
  resize(1280, 800);
  setFocusPolicy(Qt::StrongFocus);
  setContextMenuPolicy(Qt::PreventContextMenu);
  layOut();
  boardView_->setSource(peakSource(inVivo_));
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(frameInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &KioskWindow::onFrame);
  connect(view_, &QOpenGLWidget::frameSwapped, this, &KioskWindow::onPresented);
  qApp->installEventFilter(this);
}

KioskWindow::~KioskWindow() = default;

QPushButton* KioskWindow::addButton(const QString& text, const char* name, QWidget* parent)
{
  auto* button = new QPushButton(text, parent);
  button->setObjectName(QLatin1String(name));
  button->setFont(typeface(22, QFont::Medium));
  button->setFixedHeight(buttonHeight_px);
  button->setMinimumWidth(2 * buttonHeight_px);
  button->setFocusPolicy(Qt::NoFocus);
  return button;
}

QWidget* KioskWindow::addInvitation()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  auto* invite = addButton(tr("Touch anywhere to try it yourself"), "inviteButton", page);
  invite->setProperty("primary", true);
  invite->setFont(typeface(28, QFont::DemiBold));
  row->addWidget(invite, 1);
  return page;
}

QWidget* KioskWindow::addTurnFoot()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  row->setSpacing(2 * spacing);
  pull_ = addButton(tr("Hold to pull back"), "pullButton", page);
  pad_ = new PushPad(page);
  handle_ = addButton(tr("Use the handle"), "handleButton", page);
  auto* again = addButton(tr("Start over"), "startOverButton", page);
  row->addWidget(pull_);
  row->addWidget(pad_, 1);
  row->addWidget(handle_);
  row->addWidget(again);
  handle_->hide();
  connect(again, &QPushButton::clicked, this, [this] { beginTurn(control_.hand()); });
  connect(handle_, &QPushButton::clicked, this, &KioskWindow::chooseHandle);
  return page;
}

QWidget* KioskWindow::addResultFoot()
{
  auto* page = new QWidget(foot_);
  auto* row = new QHBoxLayout(page);
  row->setSpacing(2 * spacing);
  auto* leave = addButton(tr("Done"), "doneButton", page);
  auto* again = addButton(tr("Try again"), "againButton", page);
  again->setProperty("primary", true);
  row->addWidget(leave);
  row->addWidget(again, 1);
  connect(again, &QPushButton::clicked, this, [this] { beginTurn(control_.hand()); });
  connect(leave, &QPushButton::clicked, this, &KioskWindow::beginAttract);
  return page;
}

void KioskWindow::layOut()
{
  title_->setObjectName(QStringLiteral("kioskTitle"));
  title_->setFont(typeface(34, QFont::Light));
  sentence_->setObjectName(QStringLiteral("kioskSentence"));
  sentence_->setFont(typeface(20));
  sentence_->setProperty("quiet", true);
  sentence_->setWordWrap(true);
  auto* head = new QWidget(this);
  head->setFixedHeight(headHeight_px);
  auto* label = new QVBoxLayout(head);
  label->setContentsMargins(4 * spacing, 2 * spacing, 4 * spacing, spacing);
  label->setSpacing(4);
  label->addWidget(title_);
  label->addWidget(sentence_);
  label->addStretch();

  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  middle->addWidget(view_, 1);
  middle->addWidget(boardView_);

  foot_->addWidget(addInvitation());
  foot_->addWidget(addTurnFoot());
  foot_->addWidget(addResultFoot());
  foot_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* quiet =
      new QLabel(tr("A simulation for research and training; not a medical device."), this);
  quiet->setFont(typeface(13));
  quiet->setProperty("quiet", true);
  quiet->setAlignment(Qt::AlignCenter);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, spacing);
  column->setSpacing(0);
  column->addWidget(head);
  column->addLayout(middle, 1);
  column->addWidget(foot_);
  column->addWidget(quiet);
}

bool KioskWindow::eventFilter(QObject* target, QEvent* event)
{
  auto* widget = qobject_cast<QWidget*>(target);
  if (widget == nullptr || widget->window() != this) return QWidget::eventFilter(target, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TouchBegin:
    case QEvent::Wheel:
      touchedAt_s_ = now_s();
      if (stage_ != KioskStage::attract) return false;
      if (event->type() != QEvent::Wheel) beginTurn(InputSource::pointer);
      return true;
    case QEvent::MouseMove:
      touchedAt_s_ = now_s();
      return false;
    case QEvent::KeyPress:
      return takeKey(static_cast<QKeyEvent*>(event));
    case QEvent::WindowDeactivate:
      letGo();
      return false;
    default:
      return false;
  }
}

bool KioskWindow::takeKey(QKeyEvent* event)
{
  touchedAt_s_ = now_s();
  const auto both = Qt::ControlModifier | Qt::AltModifier;
  if (event->key() == Qt::Key_Q && (event->modifiers() & both) == both) {
    Q_EMIT ended();
    return true;
  }
  if (event->isAutoRepeat()) return true;
  if (stage_ == KioskStage::attract) {
    beginTurn(InputSource::pointer);
  } else if (event->key() == Qt::Key_Escape) {
    beginAttract();
  } else if (stage_ == KioskStage::result) {
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return) beginTurn(control_.hand());
  } else if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Down) {
    pushedByKey_ = 1;
  } else if (event->key() == Qt::Key_Up) {
    pushedByKey_ = -1;
  }
  return true;
}

void KioskWindow::keyReleaseEvent(QKeyEvent* event)
{
  if (!event->isAutoRepeat()) pushedByKey_ = 0;
}

void KioskWindow::closeEvent(QCloseEvent* event)
{
  // a visitor's Alt+F4 closes nothing
  event->ignore();
}

}  // namespace perilymph::gui
