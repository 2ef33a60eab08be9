// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the surgeon knows about an insertion: a short form of which only the array must be stated.

#include <QWidget>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/outcome/Surgery.h"

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace perilymph::gui {

class Section;
class Selector;

/// Fields for an outcome::Surgery. Empty ones are not known; an error is shown while it is typed.
class SurgeryForm : public QWidget {
  Q_OBJECT
public:
  explicit SurgeryForm(QWidget* parent);

  /// The answers; a field that cannot be read counts as empty.
  outcome::Surgery surgery() const;
  void setSurgery(const outcome::Surgery& surgery);
  /// Whether something is answered besides the array.
  bool hasAnswers() const;
  /// The day of the CT: "2026-11-20"; empty where it is not known or cannot be read.
  std::string ctDay() const;
  /// Shows the day that the CT or a saved outcome states; empty for none.
  void setCtDay(const std::string& day);
  /// Proposes an array where the user has chosen none.
  void proposeArray(const std::string& array);
  /// Why an answer cannot be kept, one sentence; empty if all can.
  QString error() const;

Q_SIGNALS:
  void changed();

private:
  /// A field and the answer that it holds.
  struct Field {
    QString name;
    QLineEdit* edit;
    std::function<void(outcome::Surgery&, double)> set;
    std::function<QString(const outcome::Surgery&)> text;
    bool isWhole;
  };

  QWidget* addRow(QVBoxLayout& column, const QString& name, QWidget* field,
                  const QString& unit = {});
  void addNumber(QVBoxLayout& column, const char* object, const QString& name, const QString& unit,
                 std::optional<Length> outcome::Surgery::*value);
  void addNumber(QVBoxLayout& column, const char* object, const QString& name, const QString& unit,
                 std::optional<double> outcome::Surgery::*value);
  void addNumber(QVBoxLayout& column, const char* object, const QString& name,
                 std::optional<int> outcome::Surgery::*value);
  QLineEdit* addEdit(QVBoxLayout& column, const char* object, const QString& name,
                     const QString& unit);
  void addUsual(QVBoxLayout& column);
  void addOthers();
  /// Reads the array that is chosen, for the checks of answers.
  void readDesign();
  void showError();

  Section* more_;
  Selector *array_, *stopReason_, *markReached_, *opening_, *tool_;
  QLineEdit *ctDay_ = nullptr, *lubricant_ = nullptr, *lot_ = nullptr;
  std::vector<Field> numbers_;
  std::optional<electrode::ArrayDesign> design_;
  std::string designOf_;  ///< Name of the array that was read.
  QLabel* error_;
  bool isArrayChosen_ = false, isShowing_ = false;
};

}  // namespace perilymph::gui
