#pragma once

// The application object: where exceptions of events end, and where text becomes plain.
// plain.

#include <QApplication>
#include <functional>

namespace perilymph::gui {

class Application : public QApplication {
  Q_OBJECT
public:
  Application(int& argc, char** argv);

  /// Told what an event threw: the window shows it in place.
  void onException(std::function<void(const QString&)> tell) { tell_ = std::move(tell); }

  bool notify(QObject* receiver, QEvent* event) override;

private:
  std::function<void(const QString&)> tell_;
};

/// What QApplication must find when it is made: the surface VTK draws on, pixels as they are.
void prepareQt();

}  // namespace perilymph::gui
