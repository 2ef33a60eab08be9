#pragma once

// SIGTERM, SIGINT and SIGHUP as events of the window, so that it can end as if it were closed.

#include <QObject>

class QSocketNotifier;

namespace perilymph::gui {

/// While it lives, the first of these signals is told by received(); a second one has its default
/// action and ends the program at once. A signal that the caller had ignored (nohup) stays so.
/// One object at a time; after QCoreApplication, whose events it needs.
class TerminationSignals : public QObject {
  Q_OBJECT
public:
  explicit TerminationSignals(QObject* parent);
  ~TerminationSignals() override;

Q_SIGNALS:
  void received(int signal);

private:
  void read();

  QSocketNotifier* notifier_ = nullptr;
};

}  // namespace perilymph::gui
