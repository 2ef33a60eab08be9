// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The question before a patient that exists gets other measures.

#include <QWidget>
#include <array>
#include <functional>

#include "gui/setup/PatientLibrary.h"
#include "perilymph/anatomy/Patient.h"

class QLabel;

namespace perilymph::gui {

/// Compares the saved measures of an ear with new ones, each difference with its 95 % interval, and asks:
/// a new version, or another code. Hidden while nothing is asked.
class VersionQuestion : public QWidget {
  Q_OBJECT
public:
  explicit VersionQuestion(QWidget* parent);

  /// @param then  Called if a new version is wanted.
  void ask(const SavedPatient& saved, const anatomy::Patient& measured, std::function<void()> then);
  /// Takes the question back.
  void drop();

Q_SIGNALS:
  /// Another code is wanted.
  void otherCodeWanted();

private:
  QLabel* title_;
  std::array<std::array<QLabel*, 3>, 4> cells_{};  ///< Saved, new, difference of A, B, H, CDL.
  std::function<void()> then_;
};

}  // namespace perilymph::gui
