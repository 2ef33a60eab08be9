// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Converts SIGTERM, SIGINT and SIGHUP to events, so that the window can close regularly.

#include <QObject>

class QSocketNotifier;

namespace perilymph::gui {

/// During its lifetime the first of these signals emits received(); a second one has its default
/// action and ends the program at once. A signal ignored by the caller (nohup) remains ignored. At
/// most one object; requires QCoreApplication.
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
