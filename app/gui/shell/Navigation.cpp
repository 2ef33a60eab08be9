// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/Navigation.h"

#include <QVariant>

#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/run/UserSettings.h"
#include "gui/text/DataText.h"
#include "gui/widgets/Notice.h"

namespace perilymph::gui {

namespace {

QString stateKey() { return QStringLiteral("openigtlink/server"); }
QString portKey() { return QStringLiteral("openigtlink/port"); }
QString coordinatesKey() { return QStringLiteral("openigtlink/coordinates"); }
QStringList stateText() { return {QStringLiteral("off"), QStringLiteral("on")}; }

}  // namespace

Navigation::Navigation(const InsertionController& insertion, Notice& notice, QObject* parent)
    : QObject(parent),
      insertion_(insertion),
      notice_(notice),
      broadcast_([this] { return shown(); }, nullptr)
{
  connect(&broadcast_, &InsertionBroadcast::changed, this, &Navigation::follow);
  connect(&broadcast_, &InsertionBroadcast::clientRefused, this, &Navigation::showMessage);
}

std::optional<InsertionBroadcast::Shown> Navigation::shown() const
{
  const ReplayPlayer& replay = insertion_.replay();
  const bool isReplay = replay.isOpen();
  auto shown = isReplay
                   ? InsertionBroadcast::Shown{replay.now(), replay.playback().scenario().array(),
                                               replay.playback().anatomy()}
                   : shownBy(insertion_.control());
  if (shown && ct_)
    shown->ct = ct_(isReplay ? replay.playback().scenario() : insertion_.control().scenario());
  return shown;
}

bool Navigation::listen(const broadcast::Endpoint& endpoint, broadcast::Coordinates coordinates)
{
  const Result<void> listening = broadcast_.listen(endpoint, coordinates);
  error_ = listening ? QString() : dataText(listening.error().message);
  follow();
  return isOn();
}

void Navigation::listenAsSet()
{
  const UserSettings settings;
  if (settings.word(stateKey(), stateText()) == stateText().first()) return;
  broadcast::Endpoint endpoint;
  endpoint.port = static_cast<std::uint16_t>(port());
  listen(endpoint, coordinates());
}

void Navigation::set(bool isOn, int port, broadcast::Coordinates coordinates)
{
  UserSettings settings;
  settings.setValue(portKey(), port);
  settings.setValue(coordinatesKey(), QString::fromLatin1(nameOf(coordinates)));
  error_.clear();
  if (isOn) {
    broadcast::Endpoint endpoint;
    endpoint.port = static_cast<std::uint16_t>(port);
    // A port that is taken is not tried again at the next start.
    isOn = listen(endpoint, coordinates);
  } else {
    broadcast_.close();
  }
  settings.setValue(stateKey(), stateText().at(isOn ? 1 : 0));
  settings.sync();
}

bool Navigation::isOpenToOthers() const
{
  if (!isOn()) return false;
  const std::string& address = broadcast_.endpoint()->address;
  return address.rfind("127.", 0) != 0 && address != "::1";
}

int Navigation::port() const
{
  if (broadcast_.endpoint()) return broadcast_.endpoint()->port;
  bool isNumber = false;
  const int kept = UserSettings().value(portKey()).toInt(&isNumber);
  const bool isValid = isNumber && kept >= minPort && kept <= maxPort;
  return isValid ? kept : broadcast::Endpoint().port;
}

broadcast::Coordinates Navigation::coordinates() const
{
  if (isOn()) return broadcast_.coordinates();
  const std::string kept = UserSettings().value(coordinatesKey()).toString().toStdString();
  return valueIn(broadcast::coordinateSystems, kept).value_or(broadcast::Coordinates::cochlea);
}

QString Navigation::status() const
{
  if (isError()) return error_;
  if (!isOn()) return tr("OpenIGTLink is off: no program can connect.");
  const QString place = QString::fromStdString(textOf(*broadcast_.endpoint()));
  const int clients = broadcast_.clients();
  QString status = clients == 0   ? tr("OpenIGTLink on %1, no client").arg(place)
                   : clients == 1 ? tr("OpenIGTLink on %1, 1 client").arg(place)
                                  : tr("OpenIGTLink on %1, %2 clients").arg(place).arg(clients);
  if (isOpenToOthers())
    status += QStringLiteral(". ") +
              tr("Whoever reaches it in the network receives the insertion and the CT, without a "
                 "password.");
  if (broadcast_.isWaitingForCt())
    status += QStringLiteral(". ") +
              tr("Nothing is sent: the coordinates of the patient are known while the CT of this "
                 "cochlea is open.");
  return status;
}

void Navigation::follow()
{
  Q_EMIT changed();
  // Not during an insertion: the notice takes a strip of the picture.
  if (isError() || !insertion_.control().isMoving()) showMessage(status());
}

void Navigation::showMessage(const QString& sentence)
{
  // A question keeps its place; the settings show the state at any time.
  if (notice_.isVisible() && notice_.sentence() != said_) return;
  notice_.showMessage(sentence);
  said_ = sentence;
}

}  // namespace perilymph::gui
