// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A large number, readable from two meters.

#include <QFont>
#include <QWidget>
#include <initializer_list>

namespace perilymph::gui {

/// A number with its unit and a caption below it. Digits have equal widths, so that the text does
/// not move when the number changes.
class ReadOut : public QWidget {
  Q_OBJECT
public:
  /// Format of a read-out.
  struct Form {
    int size_px = 46;  ///< Size of the number.
    QString widest;    ///< The longest number that space is reserved for: "-00.0".
    QString unit;      ///< Text behind the number.
    Qt::Alignment side = Qt::AlignLeft;
  };

  ReadOut(Form form, QWidget* parent);

  /// Draws a smaller number without caption, for low views.
  void setCompact(bool isCompact);
  /// Size of the number [px, before textScale()].
  void setNumberSize(int size_px);
  void setNumber(const QString& number);
  void setCaption(const QString& caption);
  const QString& number() const { return number_; }
  const QString& caption() const { return caption_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  void setSize(int size_px);
  void fit();
  QString shownCaption() const { return isCompact_ ? QString() : caption_; }
  int numberWidth(const QString& number) const;
  int cellWidth(QChar character) const;

  Form form_;
  QFont numberFont_, unitFont_, captionFont_;
  int digitWidth_ = 0;
  bool isCompact_ = false;
  QString number_, caption_;
};

/// Width that read-outs need in a row, with the gaps between them [px].
int widthOf(std::initializer_list<const ReadOut*> row);

}  // namespace perilymph::gui
