#pragma once

// The first screen: three ways to begin, for three people.

#include <QPushButton>
#include <QWidget>

#include "gui/setup/Setup.h"
#include "perilymph/anatomy/Patient.h"

class QLabel;
class QStackedWidget;

namespace perilymph::gui {

class PatientForm;

/// A way to begin: a picture, a title and what comes of it. Pressed like a button.
class StartCard : public QPushButton {
  Q_OBJECT
public:
  /// @param picture  A shipped one; cut to the card's width about its middle.
  StartCard(const char* name, const QString& title, const QString& sentence,
            const std::string& picture, QWidget* parent);
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  QString title_, sentence_;
  QPixmap picture_;
};

/// Asks what to begin with. A patient's numbers are asked for in place.
class StartPage : public QWidget {
  Q_OBJECT
public:
  explicit StartPage(QWidget* parent);

  /// Back to the three cards.
  void showCards();
  /// Says in place why what was asked for cannot be shown.
  void showError(const QString& sentence);

Q_SIGNALS:
  /// What to begin with.
  /// @param isWatched  The insertion starts by itself.
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
