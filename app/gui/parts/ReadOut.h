#pragma once

// A big number that can be read from two meters.

#include <QFont>
#include <QWidget>

namespace perilymph::gui {

/// A number with its unit, and below it what it is. Digits have equal widths, so that nothing
/// trembles while the number runs.
class ReadOut : public QWidget {
  Q_OBJECT
public:
  /// How a read-out is set.
  struct Form {
    int size_px = 46;  ///< Size of the number.
    QString widest;    ///< The longest number it keeps room for: "-00.0".
    QString unit;      ///< As it stands behind the number.
    Qt::Alignment side = Qt::AlignLeft;
  };

  ReadOut(Form form, QWidget* parent);

  void setNumber(const QString& number);
  void setCaption(const QString& caption);
  const QString& number() const { return number_; }
  const QString& caption() const { return caption_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  int numberWidth(const QString& number) const;
  int cellWidth(QChar character) const;

  Form form_;
  QFont numberFont_, unitFont_, captionFont_;
  int digitWidth_ = 0;
  QString number_, caption_;
};

}  // namespace perilymph::gui
