#pragma once

// The bar at the top: whose ear this is, and whether the hand answers.

#include <QWidget>

class QLabel;
class QPushButton;

namespace perilymph::gui {

/// How the device's light shines. Every state has its word beside the color.
enum class Light { off, steady, warning, alarm };

/// A dot and a few words about the hand.
class DeviceLight : public QWidget {
  Q_OBJECT
public:
  explicit DeviceLight(QWidget* parent);

  void show(Light light, const QString& words);
  const QString& words() const { return words_; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  Light light_ = Light::off;
  QString words_;
};

/// Name, page, patient and device.
class TopBar : public QWidget {
  Q_OBJECT
public:
  explicit TopBar(QWidget* parent);

  void setPatient(const QString& patient);
  void setDevice(Light light, const QString& words, const QString& tip);

Q_SIGNALS:
  void keysAsked();

private:
  QLabel* patient_;
  DeviceLight* device_;
};

}  // namespace perilymph::gui
