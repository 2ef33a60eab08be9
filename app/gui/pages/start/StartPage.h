// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The start page: three ways to begin, and recent work.

#include <QPushButton>
#include <QWidget>
#include <filesystem>
#include <memory>
#include <optional>

#include "gui/setup/Setup.h"
#include "perilymph/anatomy/Patient.h"

class QLabel;
class QStackedWidget;

namespace perilymph::gui {

class CochleaStore;
class PatientForm;
class PatientPicker;
class RecentWork;
struct HistoryEntry;
struct SavedPatient;

/// A large button with a picture, a title and a description.
class StartCard : public QPushButton {
  Q_OBJECT
public:
  /// @param picture  A shipped picture, cropped to the card's width about its center.
  StartCard(const char* name, const QString& title, const QString& sentence,
            const std::string& picture, QWidget* parent);
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
class StartPage : public QWidget {
  Q_OBJECT
public:
  StartPage(std::shared_ptr<CochleaStore> cochleae, QWidget* parent);

  /// Work that the page offers to continue.
  struct Current {
    QString title;  ///< Title of the setup on the insertion page; empty if it was not used yet.
    std::optional<std::filesystem::path> beingRecorded;
  };
  /// Shows the three cards again, and recent work.
  void showCards(const Current& current);
  /// Shows the list of saved patients.
  void showPatients();
  /// Shows an empty form.
  void showNewPatient();
  /// Shows why the selection failed.
  void showError(const QString& sentence);

Q_SIGNALS:
  /// The user selected a setup.
  /// @param isWatched  The insertion starts automatically.
  void setupChosen(const perilymph::gui::Setup& setup, perilymph::gui::SetupOrigin::Kind kind,
                   bool isWatched);
  /// The user wants to continue with the insertion page, to replay a recording, or to see all.
  void continueAsked();
  void replayAsked(const std::filesystem::path& recording);
  void allRecordingsAsked();
  /// The user wants to open a CT again, or a plan.
  void scansAsked();
  void planAsked(const std::filesystem::path& folder);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QWidget* cards();
  QWidget* centered(QWidget* content);
  void showCards() { showCards(current_); }
  void addKey(QWidget& page, Qt::Key key, StartCard& card);
  void savePatient(const anatomy::Patient& patient);
  void openPatient(const SavedPatient& patient);
  void openEntry(const HistoryEntry& entry);
  void beginPatient(const anatomy::Patient& patient);
  void beginShipped(const std::string& name, bool isWatched);

  QStackedWidget* stages_;
  StartCard* patient_ = nullptr;
  StartCard* mean_ = nullptr;
  StartCard* demonstration_ = nullptr;
  PatientForm* form_ = nullptr;
  PatientPicker* picker_ = nullptr;
  RecentWork* recent_ = nullptr;
  Current current_;
  QLabel* error_ = nullptr;
};

}  // namespace perilymph::gui
