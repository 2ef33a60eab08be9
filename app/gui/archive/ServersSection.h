// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The DICOM archives in the settings.

#include <QWidget>
#include <vector>

#include "gui/archive/ArchiveWork.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace perilymph::gui {

class CheckBox;
class Choice;
class Selector;

/// A list of archives, and the fields of one. Save writes servers.toml; Test queries the archive as it
/// is typed. Nothing is asked or listened to otherwise.
class ServersSection : public QWidget {
  Q_OBJECT
public:
  explicit ServersSection(QWidget* parent);
  /// Reads the file again.
  void refresh();
  /// Takes the focus to the list, or to the first field.
  void focusFirst();

Q_SIGNALS:
  /// The file was written.
  void changed();

protected:
  void showEvent(QShowEvent* event) override;

private:
  QLineEdit* addLine(const char* name, const QString& caption, const QString& hint);
  QLineEdit* addFile(const char* name, const QString& caption);
  void layOut();
  void choose(int index);
  void showServer(const archive::Server& server);
  archive::Server typed() const;
  void save();
  void remove();
  void test();
  void write(std::vector<archive::Server> servers, const std::string& chosen,
             const QString& sentence);
  void showKinds();
  void showMessage(const QString& sentence, bool isError = false);
  /// What the administrator of the archive has to enter.
  QString forAdministrator() const;

  ArchiveWork work_;
  std::vector<archive::Server> servers_;
  int shown_ = -1;  ///< Its place in servers_; -1 for one that is not saved yet.
  Selector* list_;
  QLineEdit *name_, *aeTitle_, *host_, *port_, *ownAeTitle_, *ownPort_;
  Choice *get_, *move_;
  CheckBox* tls_;
  QLineEdit *authority_, *certificate_, *key_;
  QWidget* tlsFiles_;
  QPushButton *add_, *remove_, *save_, *test_;
  QLabel* status_;
};

}  // namespace perilymph::gui
