// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/StudyBenchmark.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "gui/pages/insert/FrameMeter.h"
#include "gui/pages/studies/StudiesPage.h"
#include "gui/pages/studies/StudyPlot.h"
#include "gui/scene/PlainVtkWidget.h"
#include "gui/shell/MainWindow.h"
#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

constexpr int measuredFrames = 300;
constexpr int patience_ms = 60'000;  // for the study to be read

/// Changes the filter for the next frame when the last one is on the display.
class StudyFrames : public QObject {
public:
  explicit StudyFrames(MainWindow& window)
      : QObject(&window),
        page_(*window.pages().find<StudiesPage>()),
        view_(*page_.findChild<PlainVtkWidget*>())
  {
    connect(&view_, &PlainVtkWidget::presented, this, [this] {
      if (!isWaiting_) return;
      isWaiting_ = false;
      meter_.present(FrameMeter::Clock::now());
      QTimer::singleShot(0, this, &StudyFrames::next);
    });
    const auto& sizes = page_.columns()->quantity("A_mm")->values;
    const auto [low, high] = std::minmax_element(sizes.begin(), sizes.end());
    low_ = *low;
    step_ = (*high - *low) / measuredFrames;
    next();
  }

private:
  void next()
  {
    if (frame_ == measuredFrames) {
      std::printf("%zu insertions of a study, filtered: %s\n", page_.columns()->size(),
                  meter_.report().c_str());
      std::fflush(stdout);
      return QCoreApplication::exit(0);
    }
    // all are shown at first, and all are filtered in every frame
    auto* limit = page_.findChild<QLineEdit*>(QStringLiteral("studyMinA"));
    isWaiting_ = true;
    meter_.begin(FrameMeter::Clock::now());
    limit->setText(numberText(low_ + step_ * 0.1 * frame_, 6));
    ++frame_;
  }

  StudiesPage& page_;
  PlainVtkWidget& view_;
  FrameMeter meter_;
  double low_ = 0.0, step_ = 0.0;  ///< [mm]
  int frame_ = 0;
  bool isWaiting_ = false;
};

}  // namespace

void measureStudyFrames(MainWindow& window, const std::filesystem::path& file)
{
  constexpr int pollInterval_ms = 20;
  StudiesPage& page = *window.pages().find<StudiesPage>();
  window.openOnPage(page.id(), file);
  auto* poll = new QTimer(&window);
  const auto polls = std::make_shared<int>(0);
  QObject::connect(poll, &QTimer::timeout, &window, [poll, polls, &window, &page] {
    if (page.isBusy() && ++*polls < patience_ms / pollInterval_ms) return;
    poll->stop();
    if (page.columns() != nullptr) {
      new StudyFrames(window);
      return;
    }
    std::fprintf(stderr, "The study could not be opened; its frames were not measured.\n");
    QCoreApplication::exit(1);
  });
  poll->start(pollInterval_ms);
}

}  // namespace perilymph::gui
