// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a patient's measures mean: duct length, turns, and how far an array reaches.

#include <QTimer>
#include <QWidget>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gui/run/Background.h"
#include "gui/run/CochleaStore.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/electrode/ArrayDesign.h"

class QGridLayout;
class QLabel;

namespace perilymph::gui {

/// Rows of measures with their uncertainty, computed in the background from the cochlea that the
/// mechanics use.
class DerivedMeasures : public QWidget {
  Q_OBJECT
public:
  DerivedMeasures(std::shared_ptr<CochleaStore> cochleae, QWidget* parent);

  /// Shows the measures of a cochlea and an array as soon as they are computed.
  void show(const anatomy::Cochlea& cochlea, const electrode::ArrayDesign& array);
  /// Shows a sentence in place of measures.
  void showNone(const QString& sentence);

private:
  void showMessage(const QString& sentence);
  void compute();
  void showContent(const Result<CochleaMeasures>& content);

  std::shared_ptr<CochleaStore> cochleae_;
  anatomy::Cochlea cochlea_;
  electrode::ArrayDesign array_;
  std::string shown_;  ///< The inputs of the shown measures, or of those being computed.
  std::vector<std::pair<QLabel*, QLabel*>> rows_;  ///< Name and value.
  QLabel* note_;
  QTimer delay_;
  Background background_;
};

}  // namespace perilymph::gui
