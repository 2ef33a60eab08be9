#pragma once

// What was changed, in order, so that every change can be undone and done again.

#include <QObject>
#include <QUndoStack>

#include "gui/setup/Setup.h"

namespace perilymph::gui {

/// Holds the setup that the window is about. Consecutive changes of one field count as one.
class SetupHistory : public QObject {
  Q_OBJECT
public:
  explicit SetupHistory(QObject* parent);

  /// Begins anew; nothing is left to be undone.
  void begin(Setup setup, SetupOrigin::Kind kind);

  /// Goes on where another history was; nothing is left to be undone.
  void resume(const SetupOrigin& origin, Setup now);

  const Setup& now() const { return now_; }
  const SetupOrigin& origin() const { return origin_; }
  /// It is a preset's, but no longer as the preset says.
  bool isModified() const;
  /// What was changed, in words: "array, speed"; empty where nothing was.
  QString changedText() const;

  /// Makes a change, or says why it cannot be made.
  void change(const SetupChange& change);
  /// Back to the origin, as one change more.
  void restore();
  /// The next change stands for itself: what was tried since the last one is not to be lost in it.
  void seal() { ++epoch_; }

  void undo();
  void redo();
  /// Goes to where the scenario was this one, backwards or forwards; where none was, to the origin.
  void goTo(const std::string& scenarioText);
  const QUndoStack& stack() const { return stack_; }

Q_SIGNALS:
  /// The setup is another one: by a change, its undoing or its doing again.
  void setupChanged();
  /// A change could not be made; the setup is as before.
  void refused(const QString& sentence);

private:
  friend class SetupCommand;
  void push(Setup after, SetupField field, const QString& label);

  QUndoStack stack_;
  SetupOrigin origin_;
  Setup now_;
  int epoch_ = 0;
};

}  // namespace perilymph::gui
