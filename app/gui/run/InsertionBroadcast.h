// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sends the insertion that is shown to programs that speak OpenIGTLink.

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gui/run/Background.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/broadcast/Broadcast.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// A server that is off until listen(). Fifty times a second, or as often as the event loop comes
/// around, it sends the snapshot that is shown. It only sends. UI thread only.
class InsertionBroadcast : public QObject {
  Q_OBJECT
public:
  /// What is shown now.
  struct Shown {
    const haptics::Snapshot& now;                          ///< Used before the next event.
    const electrode::ArrayDesign& array;                   ///< Likewise.
    std::shared_ptr<const anatomy::ScalaTympani> anatomy;  ///< Not null.
    /// The CT in which this cochlea was measured, if it is open.
    std::optional<broadcast::PlacedCt> ct = std::nullopt;
  };
  /// Empty while nothing is shown.
  using Source = std::function<std::optional<Shown>()>;

  InsertionBroadcast(Source source, QObject* parent);
  ~InsertionBroadcast() override;

  /// Listens at an endpoint instead of the previous one. The error is one sentence; then it does
  /// not listen. Emits changed().
  ///
  /// @param coordinates  In those of the patient, nothing is sent while the CT is not open.
  Result<void> listen(const broadcast::Endpoint& endpoint,
                      broadcast::Coordinates coordinates = broadcast::Coordinates::cochlea);
  /// Disconnects all clients and listens no longer.
  void close();

  /// Where it listens; empty if it does not.
  const std::optional<broadcast::Endpoint>& endpoint() const noexcept { return endpoint_; }
  /// Number of connected clients.
  int clients() const noexcept { return clients_; }
  broadcast::Coordinates coordinates() const noexcept { return coordinates_; }
  /// Coordinates of the patient are to be sent, and are not known.
  bool isWaitingForCt() const noexcept { return isWaitingForCt_; }

Q_SIGNALS:
  /// It listens, or does not, or has another number of clients, or another state of the CT.
  void changed();
  /// A client was disconnected by its own fault: one sentence. Emitted by the server's thread.
  void clientRefused(const QString& sentence);

private:
  void end();
  void send();
  void publish(const Shown& shown);
  void sendCt(const std::optional<broadcast::PlacedCt>& ct);
  void clear();

  Source source_;
  QTimer timer_;
  std::unique_ptr<broadcast::Broadcast> server_;  ///< Null while it does not listen.
  std::optional<broadcast::Endpoint> endpoint_;
  broadcast::Coordinates coordinates_ = broadcast::Coordinates::cochlea;
  bool isWaitingForCt_ = false;
  bool isPlaced_ = false;  ///< The CT of what is shown was handed to the server.
  std::shared_ptr<const anatomy::ScalaTympani> sent_;  ///< The cochlea whose wall is sent.
  std::optional<broadcast::Placement> sentPlacement_;  ///< In which the wall is sent.
  std::optional<broadcast::PlacedCt> sentCt_;          ///< The CT that is sent, or being packed.
  Background packing_;
  int clients_ = 0;
};

class InsertionControl;

/// The insertion; empty before the first one.
std::optional<InsertionBroadcast::Shown> shownBy(const InsertionControl& control);

/// "127.0.0.1:18944", "[::1]:18944".
std::string textOf(const broadcast::Endpoint& endpoint);

}  // namespace perilymph::gui
