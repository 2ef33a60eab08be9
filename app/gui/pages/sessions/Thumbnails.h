// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Thumbnails of recordings, painted once in a separate thread and stored beside them.

#include <QHash>
#include <QObject>
#include <QPixmap>
#include <QSet>
#include <vector>

#include "gui/run/Background.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// Returns available thumbnails at once and paints others in the background. The latest requests
/// are painted first, because the user may have scrolled; old requests are dropped until they are
/// made again.
class Thumbnails : public QObject {
  Q_OBJECT
public:
  static constexpr QSize size{72, 52};

  /// Maximum number of pending requests: about one screen of rows.
  static constexpr std::size_t maxRequests = 40;

  explicit Thumbnails(QObject* parent) : QObject(parent), background_(this) {}

  /// The thumbnail, or a blank one while it is being painted or if it cannot be.
  QPixmap find(const session::SessionSummary& summary);

Q_SIGNALS:
  void painted(const std::filesystem::path& file);

private:
  struct PendingRequest {
    session::SessionSummary summary;
    QString key;
  };
  void paintNext();

  QHash<QString, QPixmap> known_;
  QSet<QString> impossible_;
  std::vector<PendingRequest> wishes_;  ///< The last one is painted first.
  QString painting_;                    ///< Current work of the thread.
  Background background_;
};

}  // namespace perilymph::gui
