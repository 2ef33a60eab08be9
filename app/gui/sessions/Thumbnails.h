#pragma once

// Small pictures of recordings, painted once in a thread of their own and kept beside them.

#include <QHash>
#include <QObject>
#include <QPixmap>
#include <QSet>
#include <QThreadPool>
#include <atomic>
#include <memory>

#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// Answers at once with what it has; what it has not it paints meanwhile and says so.
class Thumbnails : public QObject {
  Q_OBJECT
public:
  static constexpr QSize size{72, 52};

  explicit Thumbnails(QObject* parent);
  ~Thumbnails() override;

  /// The picture, or a blank one while it is being painted or cannot be.
  QPixmap find(const session::SessionSummary& summary);

Q_SIGNALS:
  void painted();

private:
  void paint(const session::SessionSummary& summary, const QString& key);

  QHash<QString, QPixmap> known_;
  QSet<QString> asked_;
  QThreadPool thread_;  ///< One thread.
  std::shared_ptr<std::atomic<bool>> isEnding_;
};

}  // namespace perilymph::gui
