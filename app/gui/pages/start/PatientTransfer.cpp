// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientTransfer.h"

#include <algorithm>
#include <utility>

#include "gui/parts/DataText.h"

namespace perilymph::gui {

namespace {

constexpr int reportInterval_ms = 100;

}  // namespace

struct PatientTransfer::State {
  std::atomic<bool> isEnded{false};
  std::atomic<int> percent{0};
};

PatientTransfer::PatientTransfer(QObject* parent) : QObject(parent), background_(this)
{
  timer_.setInterval(reportInterval_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { Q_EMIT progressed(state_->percent); });
}

void PatientTransfer::start(Copy copy)
{
  if (isBusy()) return;
  state_ = std::make_shared<State>();
  const auto work = [copy = std::move(copy), state = state_](const std::atomic<bool>& isCanceled) {
    return copy([&](std::uintmax_t done, std::uintmax_t all) {
      state->percent = static_cast<int>(100 * done / std::max<std::uintmax_t>(all, 1));
      return !isCanceled && !state->isEnded;
    });
  };
  background_.run("The copy", work, [this](const Result<std::filesystem::path>& place) {
    timer_.stop();
    if (place)
      Q_EMIT copied(QString::fromStdString(place->string()));
    else
      Q_EMIT failed(dataText(place.error().message));
  });
  timer_.start();
}

void PatientTransfer::cancel()
{
  if (isBusy()) state_->isEnded = true;
}

}  // namespace perilymph::gui
