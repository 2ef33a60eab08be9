// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/InsertionBroadcast.h"

#include <stop_token>
#include <utility>

#include "gui/run/InsertionControl.h"

namespace perilymph::gui {

namespace {

constexpr int interval_ms = 20;  // 50 Hz, as trackers send

}  // namespace

std::string textOf(const broadcast::Endpoint& endpoint)
{
  const bool isSix = endpoint.address.find(':') != std::string::npos;
  return (isSix ? "[" + endpoint.address + "]" : endpoint.address) + ":" +
         std::to_string(endpoint.port);
}

std::optional<InsertionBroadcast::Shown> shownBy(const InsertionControl& control)
{
  auto anatomy = control.sharedAnatomy();
  if (!anatomy) return std::nullopt;
  return InsertionBroadcast::Shown{control.now(), control.scenario().array(), std::move(anatomy)};
}

InsertionBroadcast::InsertionBroadcast(Source source, QObject* parent)
    : QObject(parent), source_(std::move(source)), packing_(nullptr)
{
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(interval_ms);
  connect(&timer_, &QTimer::timeout, this, &InsertionBroadcast::send);
}

InsertionBroadcast::~InsertionBroadcast() = default;

Result<void> InsertionBroadcast::listen(const broadcast::Endpoint& endpoint)
{
  end();
  auto server = broadcast::Broadcast::start(endpoint, [this](const std::string& sentence) {
    Q_EMIT clientRefused(QString::fromStdString(sentence));
  });
  if (!server) {
    Q_EMIT changed();
    return server.error();
  }
  server_ = *std::move(server);
  endpoint_ = endpoint;
  endpoint_->port = server_->port();
  timer_.start();
  Q_EMIT changed();
  return {};
}

void InsertionBroadcast::close()
{
  if (!server_) return;
  end();
  Q_EMIT changed();
}

void InsertionBroadcast::end()
{
  timer_.stop();
  server_.reset();
  endpoint_.reset();
  sent_.reset();
  sentCt_.reset();
  packing_.cancel();
  clients_ = 0;
}

void InsertionBroadcast::sendCt(const std::optional<broadcast::PlacedCt>& ct)
{
  sentCt_ = ct;
  packing_.cancel();
  server_->show(broadcast::PackedImage());
  if (!ct) return;
  // The only error is memory that is short; then no image answers the request.
  packing_.run(
      "The CT", [ct](const std::stop_token&) { return broadcast::packImage(*ct); },
      [this](Result<broadcast::PackedImage> image) {
        if (image) server_->show(*std::move(image));
      });
}

void InsertionBroadcast::send()
{
  if (const auto shown = source_()) {
    if (shown->anatomy != sent_) {
      server_->show(anatomy::wallSurface(*shown->anatomy, broadcast::maxSurfaceTriangles));
      sent_ = shown->anatomy;
    }
    if (shown->ct != sentCt_) sendCt(shown->ct);
    server_->publish(broadcast::broadcastFrame(shown->now, shown->array));
  }
  const int clients = static_cast<int>(server_->figures().clients);
  if (clients == clients_) return;
  clients_ = clients;
  Q_EMIT changed();
}

}  // namespace perilymph::gui
