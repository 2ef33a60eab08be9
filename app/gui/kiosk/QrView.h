// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A text as a QR code, which a phone reads from the screen.

#include <QImage>
#include <QWidget>

namespace perilymph::gui {

/// The QR code of a text. Other letters than ASCII are encoded in UTF-8, which some readers take for
/// another encoding. It has error correction L (7 %), because a screen is neither torn nor soiled, and
/// one pixel per module, black on white, in the quiet zone of four modules that ISO/IEC 18004 requires.
///
/// @return Null if the text is empty or longer than a QR code can hold (2,953 bytes).
QImage qrCode(const QString& text);

/// Shows a QR code as large as fits in whole pixels of the display per module.
class QrView : public QWidget {
  Q_OBJECT
public:
  explicit QrView(QWidget* parent);

  void setText(const QString& text);
  const QString& text() const { return text_; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  QString text_;
  QImage code_;
};

}  // namespace perilymph::gui
