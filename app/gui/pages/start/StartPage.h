// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The start page with three ways to begin.

#include <QPushButton>
#include <QWidget>

#include "gui/setup/Setup.h"
#include "perilymph/anatomy/Patient.h"

class QLabel;
class QStackedWidget;

namespace perilymph::gui {

class PatientForm;

/// A large button with a picture, a title and a description.
class StartCard : public QPushButton {
  Q_OBJECT
public:
  /// @param picture  A shipped picture, cropped to the card's width about its center.
  StartCard(const char* name, const QString& title, const QString& sentence,
            const std::string& picture, QWidget* parent);
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  QString title_, sentence_;
  QPixmap picture_;
};

/// Selection of the first setup. The patient form is shown in place.
class StartPage : public QWidget {
  Q_OBJECT
public:
  explicit StartPage(QWidget* parent);

  /// Shows the three cards again.
  void showCards();
  /// Shows why the selection failed.
  void showError(const QString& sentence);

Q_SIGNALS:
  /// The user selected a setup.
  /// @param isWatched  The insertion starts automatically.
  void setupChosen(const perilymph::gui::Setup& setup, perilymph::gui::SetupOrigin::Kind kind,
                   bool isWatched);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QWidget* cards();
  void beginPatient(const anatomy::Patient& patient);
  void beginShipped(const std::string& name, bool isWatched);

  QStackedWidget* stages_;
  StartCard* patient_ = nullptr;
  StartCard* mean_ = nullptr;
  StartCard* demonstration_ = nullptr;
  PatientForm* form_ = nullptr;
  QLabel* error_ = nullptr;
};

}  // namespace perilymph::gui
