// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The form of a new study.

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "gui/pages/studies/StudyRunWork.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

class CheckBox;
class Selector;
class StoredStudies;

/// Form of a new study: checks it while it is edited and shows what it will cost; also offers
/// the studies that were made before. It runs none.
class NewStudy : public QWidget {
  Q_OBJECT
public:
  explicit NewStudy(QWidget* parent);

  /// Reads patients and studies from the disk again.
  void refresh();
  /// While a study runs, none can be started.
  void setBusy(bool isBusy);
  /// Processors to be used.
  unsigned jobs() const;
  /// The study as entered; nothing if a field is no number.
  std::optional<StudyDraft> draft() const;

Q_SIGNALS:
  void startRequested(const perilymph::gui::StudyDraft& draft);
  /// A study of before: to be opened, or continued if it is not complete.
  void storedRequested(const perilymph::gui::StoredStudy& study);
  void leaveRequested();

private:
  struct Listed {
    CheckBox* box;
    std::string name;  ///< That of an array or a friction; path of a patient.
  };
  struct Limits {
    const char* key;
    double divisor;  ///< From the unit of the field to that of the key.
    QLineEdit *low, *high;
  };
  QWidget* addColumn(const QString& title, QVBoxLayout*& column);
  void addArrays(QVBoxLayout& column);
  void addCochleae(QVBoxLayout& column);
  void addHand(QVBoxLayout& column);
  void addRun(QVBoxLayout& column);
  void addLimits(QVBoxLayout& column, const char* key, const QString& name, double divisor,
                 const char* low, const char* high, const QString& tip);
  QLineEdit* field(const char* name, const QString& title, const char* value);
  CheckBox* box(std::vector<Listed>& list, const QString& text, const std::string& name,
                const QString& object, bool isChecked);
  /// "Study of 28.11.26", with a number if a study has that title.
  void proposeTitle();
  void listPatients();
  void edited();
  void check();
  void showMessage(const QString& sentence, bool canStart);
  void showState();

  StudyEstimateWork estimate_;
  QTimer waiting_;  ///< Until editing pauses.
  std::vector<Listed> arrays_, frictions_, patients_;
  std::vector<Limits> limits_;
  QVBoxLayout* patientRows_ = nullptr;
  QWidget* patientList_ = nullptr;
  QLineEdit *title_ = nullptr, *simulated_ = nullptr, *samples_ = nullptr, *seed_ = nullptr;
  CheckBox* mean_ = nullptr;
  Selector *resolution_ = nullptr, *cores_ = nullptr;
  StoredStudies* stored_ = nullptr;
  QLabel* note_ = nullptr;
  QPushButton* start_ = nullptr;
  bool isBusy_ = false, canStart_ = false;
  bool hasOwnTitle_ = false;  ///< Typed for the study that is being made.
};

}  // namespace perilymph::gui
