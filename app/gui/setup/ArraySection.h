#pragma once

// The array in the panel: which, how it is inserted, how it rubs, and how it is computed.

#include <vector>

#include "gui/setup/Catalog.h"
#include "gui/setup/Section.h"
#include "gui/setup/Setup.h"

class QLabel;

namespace perilymph::gui {

class NumberField;
class Selector;

/// Shows the array and the technique of a setup and asks for changes of them.
class ArraySection : public Section {
  Q_OBJECT
public:
  explicit ArraySection(QWidget* parent);

  void show(const Setup& setup);
  /// Sends off what is typed. A sentence where something typed cannot be.
  QString commit();

Q_SIGNALS:
  void changeAsked(const perilymph::gui::SetupChange& change);

private:
  void addArrays();
  void addMotion();
  void addContact();
  void addModel();
  void askNumber(NumberField* field, SetupField what, const char* key, const QString& caption);
  void showFriction(const session::Scenario& scenario);

  std::vector<CatalogArray> arrays_;
  std::vector<CatalogFriction> frictions_;
  Selector* array_;
  QLabel* summary_;
  Selector* technique_;
  NumberField* speed_;
  NumberField* stop_;
  Selector* friction_;
  QLabel* coefficients_;
  Selector* opening_;
  Selector* model_;
  NumberField* nodes_;
};

}  // namespace perilymph::gui
