// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientTransfer.h"

#include <algorithm>
#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"

namespace perilymph::gui {

namespace {

constexpr int reportInterval_ms = 100;

}  // namespace

PatientTransfer::PatientTransfer(QObject* parent) : QObject(parent), background_(this)
{
  timer_.setInterval(reportInterval_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { Q_EMIT progressed(*percent_); });
}

void PatientTransfer::start(Copy copy)
{
  if (isBusy()) return;
  percent_ = std::make_shared<std::atomic<int>>(0);
  const auto work = [copy = std::move(copy), percent = percent_](const std::stop_token& stop) {
    const auto progress = [&](std::uintmax_t done, std::uintmax_t all) {
      *percent = static_cast<int>(100 * done / std::max<std::uintmax_t>(all, 1));
    };
    return copy(progress, stop);
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

void PatientTransfer::cancel() { background_.requestStop(); }

}  // namespace perilymph::gui
