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

Result<void> InsertionBroadcast::listen(const broadcast::Endpoint& endpoint,
                                        broadcast::Coordinates coordinates)
{
  end();
  coordinates_ = coordinates;
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
  sentPlacement_.reset();
  sentCt_.reset();
  packing_.cancel();
  clients_ = 0;
  isWaitingForCt_ = isPlaced_ = false;
}

void InsertionBroadcast::sendCt(const std::optional<broadcast::PlacedCt>& ct)
{
  sentCt_ = ct;
  packing_.cancel();
  isPlaced_ = false;
  server_->show(broadcast::PackedImage());
  server_->show(std::optional<broadcast::Placement>());
  if (!ct) return;
  // From what is sent to the patient: the identity if that is in the patient's coordinates already.
  // It comes with the CT: no array is over the CT of another patient meanwhile.
  const auto toPatient = coordinates_ == broadcast::Coordinates::patient
                             ? broadcast::Placement()
                             : broadcast::placementOf(*ct);
  // The only error is memory that is short; then there is no image.
  packing_.run(
      "The CT",
      [ct, coordinates = coordinates_](const std::stop_token&) {
        return broadcast::packImage(*ct, coordinates);
      },
      [this, toPatient](Result<broadcast::PackedImage> image) {
        server_->show(toPatient);
        if (image) server_->show(*std::move(image));
        isPlaced_ = true;
      });
}

/// The patient's coordinates are not known: nothing but that is sent.
void InsertionBroadcast::clear()
{
  server_->clear();  // each time, for clients that connect later or miss a frame
  if (isWaitingForCt_) return;
  isWaitingForCt_ = true;
  sent_.reset();
  sentPlacement_.reset();
  sentCt_.reset();
  packing_.cancel();
  Q_EMIT changed();
}

void InsertionBroadcast::publish(const Shown& shown)
{
  std::optional<broadcast::Placement> placement;
  if (coordinates_ == broadcast::Coordinates::patient) {
    if (!shown.ct) return clear();
    placement = broadcast::placementOf(*shown.ct);
    if (std::exchange(isWaitingForCt_, false)) Q_EMIT changed();
  }
  if (shown.ct != sentCt_) sendCt(shown.ct);
  if (shown.anatomy != sent_ || placement != sentPlacement_) {
    server_->show(broadcast::wallsOf(*shown.anatomy), placement);
    sent_ = shown.anatomy;
    sentPlacement_ = placement;
  }
  auto frame = broadcast::broadcastFrame(shown.now, shown.array);
  frame.patient = placement;
  frame.isPlaced = isPlaced_;
  server_->publish(frame);
}

void InsertionBroadcast::send()
{
  if (const auto shown = source_()) publish(*shown);
  const int clients = static_cast<int>(server_->figures().clients);
  if (clients == clients_) return;
  clients_ = clients;
  Q_EMIT changed();
}

}  // namespace perilymph::gui
