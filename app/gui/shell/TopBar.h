#pragma once

// The bar at the top: the pages, whose ear this is, and whether the hand answers.

#include <QWidget>
#include <utility>
#include <vector>

class QLabel;
class QPushButton;

namespace perilymph::gui {

/// The pages of the window, in the order of their buttons.
enum class Page { start, insert, compare, validate, sessions };

/// How the device's light shines. Every state has its word beside the color.
enum class DeviceState { off, steady, warning, alarm };

/// A dot and a few words about the hand.
class DeviceLight : public QWidget {
  Q_OBJECT
public:
  explicit DeviceLight(QWidget* parent);

  void show(DeviceState light, const QString& label);
  const QString& text() const { return text_; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  DeviceState light_ = DeviceState::off;
  QString text_;
};

/// Name, pages, patient and device.
class TopBar : public QWidget {
  Q_OBJECT
public:
  explicit TopBar(QWidget* parent);

  /// Marks the page that is shown.
  void setPage(Page page);
  void setPatient(const QString& patient);
  /// A word beside the patient, while a preset is no longer what it says.
  void setModified(bool isModified, const QString& tip);
  void setDevice(DeviceState light, const QString& label, const QString& tip);

Q_SIGNALS:
  void pageChosen(perilymph::gui::Page page);
  void keysAsked();
  void settingsAsked();

private:
  QPushButton* addPage(Page page, const QString& text, const char* name);

  std::vector<std::pair<Page, QPushButton*>> pages_;
  QLabel* patient_;
  QLabel* modified_;
  DeviceLight* device_;
};

}  // namespace perilymph::gui
