// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The window as a server for navigation programs: its setting, and its state as text.

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "gui/run/InsertionBroadcast.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

class InsertionController;
class Notice;

/// Sends the insertion, or its replay. Off until the command line or the setting asks
/// for it. The setting listens on this machine only.
class Navigation : public QObject {
  Q_OBJECT
public:
  static constexpr int minPort = 1024, maxPort = 65535;

  /// @param notice  Shows every change of the state, unless it shows something else.
  Navigation(const InsertionController& insertion, Notice& notice, QObject* parent);

  InsertionBroadcast& broadcast() { return broadcast_; }

  /// The CT in which the cochlea of a scenario was measured; empty if none is open.
  using CtSource =
      std::function<std::optional<broadcast::PlacedCt>(const session::Scenario& scenario)>;
  /// Sends the CT of what is shown, too. None is sent before.
  void sendCtOf(CtSource source) { ct_ = std::move(source); }

  /// Listens at an endpoint until the program ends. False if it cannot: status() says why.
  bool listen(const broadcast::Endpoint& endpoint,
              broadcast::Coordinates coordinates = broadcast::Coordinates::cochlea);
  /// Listens if the setting is on.
  void listenAsSet();

  /// Keeps the setting and applies it at once.
  void set(bool isOn, int port, broadcast::Coordinates coordinates);
  bool isOn() const { return broadcast_.endpoint().has_value(); }
  /// It listens at an address that other computers may reach.
  bool isOpenToOthers() const;
  /// Where it listens, or would.
  int port() const;
  /// In which it sends, or would.
  broadcast::Coordinates coordinates() const;

  /// The state, or why it is off, in one sentence.
  QString status() const;
  bool isError() const { return !error_.isEmpty(); }

Q_SIGNALS:
  void changed();

private:
  void follow();
  void showMessage(const QString& sentence);

  std::optional<InsertionBroadcast::Shown> shown() const;

  const InsertionController& insertion_;
  Notice& notice_;
  CtSource ct_;
  QString said_;   ///< The last sentence of the notice that came from here.
  QString error_;  ///< Before the broadcast, which emits signals when it ends.
  InsertionBroadcast broadcast_;
};

}  // namespace perilymph::gui
