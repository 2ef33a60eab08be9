#pragma once

// What a page is for, while there is nothing on it.

#include <QWidget>

class QLabel;

namespace perilymph::gui {

/// A title and a quiet sentence in the middle of a page.
class EmptyPage : public QWidget {
  Q_OBJECT
public:
  EmptyPage(const QString& title, const QString& sentence, QWidget* parent);

  void say(const QString& title, const QString& sentence);

private:
  QLabel* title_;
  QLabel* sentence_;
};

}  // namespace perilymph::gui
