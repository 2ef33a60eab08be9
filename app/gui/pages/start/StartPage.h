// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The start page: three ways to begin, and recent work.

#include <QPushButton>
#include <filesystem>
#include <memory>
#include <optional>

#include "gui/pages/Page.h"
#include "gui/setup/CtRequest.h"
#include "gui/setup/PatientLibrary.h"
#include "perilymph/anatomy/Patient.h"

class QLabel;
class QStackedWidget;

namespace perilymph::gui {

class InsertionControl;
class PatientForm;
class PatientPicker;
class RecentWork;
struct HistoryEntry;
class SetupHistory;

/// A large button with a picture, a title and a description.
class StartCard : public QPushButton {
  Q_OBJECT
public:
  /// A rendering has the ground of the theme, a CT is gray in both.
  enum class Ground { ofTheme, own };

  /// @param picture  A file in resources/start, which resources/pictures/make-start makes.
  StartCard(const char* name, const QString& title, const QString& sentence,
            const std::string& picture, Ground ground, QWidget* parent);
  QSize sizeHint() const override;
  /// Height that its text needs at a width [px].
  int textHeight(int width_px) const;
  void setHeights(int picture_px, int text_px);

protected:
  void paintEvent(QPaintEvent*) override;

private:
  int titleHeight(int width_px) const;

  int pictureHeight_px_;
  QString title_, sentence_;
  QPixmap picture_;
};

/// Selection of the first setup. The patient form and the saved patients are shown in place.
class StartPage : public Page {
  Q_OBJECT
public:
  /// @param control  The insertion that the page offers to continue, and its setup.
  StartPage(const InsertionControl& control, const SetupHistory& setup, QWidget* parent);

  /// Shows the three cards again, and recent work.
  void onShown() override { showCards(); }
  /// Leaves the form or the list for the cards.
  bool cancel() override;
  Focus focus() const override { return Focus::page; }
  /// Requests to be shown with the list of saved patients.
  void showPatients();
  /// Requests to be shown with an empty form.
  void showNewPatient();
  /// Shows why the selection failed.
  void showError(const QString& sentence);

Q_SIGNALS:
  void ctRequested(const perilymph::gui::CtRequest& request);
  /// An outcome in the record of a patient's file is to be shown.
  void outcomeRequested(const std::filesystem::path& patient, std::size_t place);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  QWidget* cards();
  QWidget* centered(QWidget* content);
  void showCards();
  void addKey(QWidget& page, Qt::Key key, StartCard& card);
  void savePatient(const anatomy::Patient& patient);
  void openPatient(const SavedPatient& patient);
  void openEntry(const HistoryEntry& entry);
  void beginPatient(const anatomy::Patient& patient);
  void beginShipped(const std::string& name, AfterLoading then);

  const InsertionControl& control_;
  const SetupHistory& setup_;
  QStackedWidget* stages_;
  StartCard* patient_ = nullptr;
  StartCard* mean_ = nullptr;
  StartCard* demonstration_ = nullptr;
  PatientForm* form_ = nullptr;
  PatientPicker* picker_ = nullptr;
  RecentWork* recent_ = nullptr;
  QLabel* error_ = nullptr;
};

}  // namespace perilymph::gui
