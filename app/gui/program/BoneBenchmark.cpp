// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/BoneBenchmark.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <QTimer>
#include <cstdio>
#include <memory>

#include "gui/pages/ct/CtPage.h"
#include "gui/pages/ct/SurfaceView.h"
#include "gui/pages/insert/FrameMeter.h"
#include "gui/shell/MainWindow.h"

namespace perilymph::gui {

namespace {

constexpr int turnedFrames = 150, step_px = 4;

/// Drags the picture on for the next frame when the last one is on the display.
class BoneFrames : public QObject {
public:
  explicit BoneFrames(MainWindow& window)
      : QObject(&window), view_(*window.findChild<SurfaceView*>())
  {
    connect(&view_, &PlainVtkWidget::presented, this, [this] {
      if (!isWaiting_) return;
      isWaiting_ = false;
      meter_.present(FrameMeter::Clock::now());
      QTimer::singleShot(0, this, &BoneFrames::next);
    });
    Q_EMIT view_.maximizeRequested();
    QTimer::singleShot(1000, this, [this] {
      send(QEvent::MouseButtonPress, Qt::LeftButton);
      next();
    });
  }

private:
  void send(QEvent::Type type, Qt::MouseButton button)
  {
    QMouseEvent event(type, place_, button, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view_, &event);
  }

  void next()
  {
    if (frame_++ == turnedFrames) {
      std::printf("%zu triangles of bone in %d x %d, turning: %s\n",
                  view_.scene()->bone().triangles(), view_.width(), view_.height(),
                  meter_.report().c_str());
      std::fflush(stdout);
      return QCoreApplication::exit(0);
    }
    isWaiting_ = true;
    meter_.begin(FrameMeter::Clock::now());
    place_ += QPointF(step_px, frame_ % 2 == 0 ? 1 : 0);
    send(QEvent::MouseMove, Qt::NoButton);
  }

  SurfaceView& view_;
  FrameMeter meter_;
  QPointF place_{200.0, 200.0};
  int frame_ = 0;
  bool isWaiting_ = false;
};

}  // namespace

void measureBoneFrames(MainWindow& window, const std::filesystem::path& ct)
{
  constexpr int interval_ms = 50, longest_ms = 300'000;  // for the CT to be read and measured
  CtPage& page = *window.pages().find<CtPage>();
  window.openOnPage(page.id(), ct);
  auto* poll = new QTimer(&window);
  const auto polls = std::make_shared<int>(0);
  QObject::connect(poll, &QTimer::timeout, &window, [poll, polls, &window, &page] {
    const bool isMade = page.bone().inAnatomy() != nullptr;
    const bool hasFailed = *polls > 10 && !page.isBusy() && !page.bone().isBusy();
    if (!isMade && !hasFailed && ++*polls < longest_ms / interval_ms) return;
    poll->stop();
    if (isMade) {
      new BoneFrames(window);
      return;
    }
    std::fprintf(stderr, "No cochlea was measured in this CT; its frames were not measured.\n");
    QCoreApplication::exit(1);
  });
  poll->start(interval_ms);
}

}  // namespace perilymph::gui
