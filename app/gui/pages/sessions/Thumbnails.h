#pragma once

// Small pictures of recordings, painted once in a thread of their own and kept beside them.

#include <QHash>
#include <QObject>
#include <QPixmap>
#include <QSet>
#include <vector>

#include "gui/run/Background.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// Answers at once with what it has; what it has not it paints meanwhile and says so. Whoever
/// scrolls by wants what is seen now: the last ones asked for are painted first, and those that
/// many others were asked for since are forgotten until they are asked for again.
class Thumbnails : public QObject {
  Q_OBJECT
public:
  static constexpr QSize size{72, 52};

  /// More than this many wishes are no longer seen: of one screen's height of rows.
  static constexpr std::size_t maxRequests = 40;

  explicit Thumbnails(QObject* parent) : QObject(parent), background_(this) {}

  /// The picture, or a blank one while it is being painted or cannot be.
  QPixmap find(const session::SessionSummary& summary);

Q_SIGNALS:
  void painted(const std::filesystem::path& file);

private:
  struct Wish {
    session::SessionSummary summary;
    QString key;
  };
  void paintNext();

  QHash<QString, QPixmap> known_;
  QSet<QString> impossible_;
  std::vector<Wish> wishes_;  ///< The last one is painted first.
  QString painting_;          ///< What the thread is busy with.
  Background background_;
};

}  // namespace perilymph::gui
