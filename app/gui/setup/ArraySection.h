// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The array section of the panel: array, technique, friction and model.

#include <vector>

#include "gui/setup/Catalog.h"
#include "gui/setup/Section.h"
#include "gui/setup/Setup.h"

class QLabel;

namespace perilymph::gui {

class NumberField;
class Selector;

/// Shows the array and the technique of a setup and requests changes.
class ArraySection : public Section {
  Q_OBJECT
public:
  explicit ArraySection(QWidget* parent);

  void show(const Setup& setup);
  /// Commits edited values. An error message if a value is invalid.
  QString commit();
  void setChangeable(bool isChangeable);
  /// Shows the timing of the haptic loop among the settings for experts.
  void setTiming(const QString& text);
  /// A folded section of its own: model, nodes, timing.
  Section* expert() { return expert_; }

Q_SIGNALS:
  void changeRequested(const perilymph::gui::SetupChange& change);

private:
  void addArrays();
  void addMotion();
  void addContact();
  void addModel();
  void askNumber(NumberField* field, SetupField what, const char* key, const QString& caption);
  void showFriction(const session::Scenario& scenario);

  Section* expert_;
  std::vector<CatalogArray> arrays_;
  std::vector<CatalogFriction> frictions_;
  Selector* array_;
  QLabel* summary_;
  QLabel* stopNote_;
  QLabel* timing_;
  Selector* technique_;
  NumberField* speed_;
  NumberField* stop_;
  Selector* friction_;
  QLabel* coefficients_;
  Selector* opening_;
  QLabel* approach_;  ///< Where it is not along the axis of the opening.
  Selector* model_;
  NumberField* nodes_;
};

}  // namespace perilymph::gui
