// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The question before a patient that exists gets other measures.

#include <QStringList>
#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "gui/setup/PatientLibrary.h"
#include "perilymph/anatomy/Patient.h"

class QLabel;
class QPushButton;

namespace perilymph::gui {

/// Says what speaks against a code, compares the saved measures of the ear with new ones, each difference
/// with its 95 % interval, and asks: save under this code, or another code. Hidden while nothing is asked.
class VersionQuestion : public QWidget {
  Q_OBJECT
public:
  /// @param place  Begin of the object names of its parts; with one it is narrow: saved and new measures
  ///               stand without their intervals, and the buttons below each other.
  explicit VersionQuestion(QWidget* parent, const QString& place = {});

  /// @param saved   The ear with other measures, if there is one.
  /// @param doubts  What else speaks against the code, a sentence each.
  /// @param then    Called if the code is wanted.
  void ask(const std::optional<SavedPatient>& saved, const anatomy::Patient& measured,
           const QStringList& doubts, std::function<void()> then);
  /// Takes the question back.
  void drop();

Q_SIGNALS:
  /// Another code is wanted.
  void otherCodeWanted();

private:
  void compare(const SavedPatient& saved, const anatomy::Patient& measured);

  bool isNarrow_;
  QLabel *title_, *doubts_;
  QWidget* table_;
  QPushButton* accept_;
  std::array<std::array<QLabel*, 3>, 4> cells_{};  ///< Saved, new, difference of A, B, H, CDL.
  std::function<void()> then_;
};

}  // namespace perilymph::gui
