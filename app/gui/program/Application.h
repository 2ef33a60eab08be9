// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The application object: catches exceptions of event handlers, and makes texts plain.

#include <QApplication>
#include <functional>

namespace perilymph::gui {

class Application : public QApplication {
  Q_OBJECT
public:
  Application(int& argc, char** argv);

  /// Receives the message of an exception in an event handler, for display in the window.
  void onException(std::function<void(const QString&)> tell) { tell_ = std::move(tell); }

  bool notify(QObject* receiver, QEvent* event) override;

private:
  std::function<void(const QString&)> tell_;
};

/// Global settings required before QApplication is made: VTK's surface format, unscaled pixels.
void prepareQt();

}  // namespace perilymph::gui
