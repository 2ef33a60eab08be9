// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/FrameBenchmark.h"

#include <QCoreApplication>
#include <QScreen>
#include <QTimer>
#include <cstdio>
#include <memory>
#include <string>

#include "gui/pages/insert/FrameLoop.h"
#include "gui/shell/MainWindow.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr int pollInterval_ms = 20;

// Reverses before the ends, where the loop would finish the insertion.
constexpr double deepFraction = 0.9;
constexpr double shallowFraction = 0.1;

/// Frame statistics of one insertion.
struct WayIn {
  std::string report;
  double median_ms = 0.0;
};

class FrameBenchmark {
public:
  FrameBenchmark(MainWindow& window, std::optional<std::uint64_t> ticks)
      : window_(window), ticks_(ticks)
  {
    window_.insertPage().frames().restartMeter();
    window_.insertion().start();
  }

  /// False when the application should end.
  bool goesOn()
  {
    const haptics::Snapshot& now = window_.control().now();
    if (now.output.workflow == haptics::Workflow::fault) {
      std::fprintf(stderr,
                   "The demonstration ended with a fault; its frames were not measured to the "
                   "end.\n");
      status_ = 1;
      return false;
    }
    if (!ticks_) return !isFinished(now);
    if (isFinished(now)) {
      std::fprintf(
          stderr,
          "The array came to its end before it could turn round: the way of %.1f mm is too "
          "short, or the machine too slow, to measure on. Give a scenario with a longer "
          "one.\n",
          inMillimeters(window_.control().scenario().stopTravel()));
      status_ = 1;
      return false;
    }
    const double fraction = now.output.travel / window_.control().scenario().stopTravel().si();
    if (!isMeasuring_ && fraction >= shallowFraction) {  // the first insertion begins farther out
      isMeasuring_ = true;
      window_.insertPage().frames().restartMeter();
    }
    if (isGoingIn_ && fraction >= deepFraction) turnBack(now);
    if (!isGoingIn_ && fraction <= shallowFraction) goIn();
    return !isEnough_;
  }

  int end()
  {
    if (status_ != 0) return status_;
    if (!ticks_) std::printf("%s\n", window_.insertPage().frames().meter().report().c_str());
    const haptics::LoopStatistics loop = window_.insertion().safety().end();
    std::printf("ticks %llu, late by more than a period %llu (%.2f %%), %s real-time priority\n",
                static_cast<unsigned long long>(loop.ticks),
                static_cast<unsigned long long>(loop.lateTicks),
                loop.ticks > 0 ? 100.0 * double(loop.lateTicks) / double(loop.ticks) : 0.0,
                loop.hasRealTimePriority ? "with" : "without");
    std::fflush(stdout);
    return 0;
  }

private:
  bool isFinished(const haptics::Snapshot& now) const
  {
    return now.output.workflow == haptics::Workflow::finished;
  }

  void turnBack(const haptics::Snapshot& now)
  {
    isGoingIn_ = false;
    const WayIn way{window_.insertPage().frames().meter().report(),
                    window_.insertPage().frames().meter().quantile_ms(0.5)};
    isEnough_ = now.tick >= *ticks_ && first_;
    if (!first_ || isEnough_)
      std::printf("after %llu ticks: %s\n", static_cast<unsigned long long>(now.tick),
                  way.report.c_str());
    if (isEnough_)
      std::printf("median frame time %+.1f %% against the first\n",
                  100.0 * (way.median_ms / first_->median_ms - 1.0));
    std::fflush(stdout);
    if (!first_) first_ = way;
    window_.insertion().withdraw();
  }

  void goIn()
  {
    isGoingIn_ = true;
    window_.insertion().start();
    window_.insertPage().frames().restartMeter();
  }

  MainWindow& window_;
  std::optional<std::uint64_t> ticks_;
  bool isGoingIn_ = true, isMeasuring_ = false, isEnough_ = false;
  std::optional<WayIn> first_;
  int status_ = 0;
};

}  // namespace

void measureFrames(MainWindow& window, std::optional<std::uint64_t> ticks)
{
  window.setGeometry(window.screen()->availableGeometry());
  auto measurement = std::make_shared<FrameBenchmark>(window, ticks);
  auto* poll = new QTimer(&window);
  QObject::connect(poll, &QTimer::timeout, &window, [poll, measurement] {
    if (measurement->goesOn()) return;
    poll->stop();
    QCoreApplication::exit(measurement->end());
  });
  poll->start(pollInterval_ms);
}

}  // namespace perilymph::gui
