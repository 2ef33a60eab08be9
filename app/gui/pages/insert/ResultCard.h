// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What an insertion came to, shown over the charts of the last seconds once it has ended.

#include "gui/report/ContactExport.h"
#include "gui/report/ReportContent.h"
#include "gui/widgets/Overlay.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace perilymph::gui {

/// Forces, depth and contacts beside the band of a plan, and what to do next. Hidden until an
/// insertion has ended; the user may close it.
class ResultCard : public Overlay {
  Q_OBJECT
public:
  /// Placed over `page`, whose size it follows.
  explicit ResultCard(QWidget* page);

  /// Stays hidden if the user has closed it.
  ///
  /// @param title  How the insertion ended: "Full depth".
  void show(const ReportContent& content, const QString& title);
  /// Hides it until the next insertion has ended.
  void clear();

Q_SIGNALS:
  void reportRequested();
  /// The report is to be sent to an archive.
  void sendRequested();
  void compareRequested();
  void againRequested();

protected:
  void place() override;

private:
  void saveContacts();
  void addRow(int row, const QString& name, const QString& value, const QString& plan,
              bool isOutside, const QString& clinics, const QString& clinicsDetail);

  QLabel* title_;
  QLabel* subject_;
  QWidget* rows_ = nullptr;
  bool isClosed_ = false;  ///< By the user.
  ContactSubject contactsOf_;
  Result<std::string> contacts_;  ///< Table of the contacts of the shown insertion.
  QPushButton* report_;
};

}  // namespace perilymph::gui
