// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The dialog in which a user saves a report, and the dialog for a CT's folder behind it.

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QTest>
#include <QTimer>
#include <filesystem>

#include "WindowRig.h"

namespace perilymph::test {

/// What a user does in the dialogs.
struct SaveAnswer {
  std::filesystem::path folder;  ///< Where the report is saved, under the proposed name.
  int kind = 0;                  ///< 0: PDF, 1: DICOM with the code, 2: DICOM in the CT's study.
  std::filesystem::path ct = {};
};

inline void acceptPath(QFileDialog& dialog, const std::filesystem::path& path)
{
  dialog.findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString(path.string()));
  auto* buttons = dialog.findChild<QDialogButtonBox*>("buttonBox");
  for (QAbstractButton* each : buttons->buttons())
    if (buttons->buttonRole(each) == QDialogButtonBox::AcceptRole) each->click();
}

/// Presses a button and answers the dialogs that it opens.
///
/// @return  The file that was saved.
inline std::filesystem::path saveBy(WindowRig& rig, const char* button, const SaveAnswer& answer)
{
  std::filesystem::path file;
  QTimer poll;
  QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    if (dialog->acceptMode() == QFileDialog::AcceptOpen) return acceptPath(*dialog, answer.ct);
    if (!file.empty()) return;
    auto* kinds = dialog->findChild<QComboBox*>("fileTypeCombo");
    ASSERT_GT(kinds->count(), answer.kind);
    for (int i = 0; i < answer.kind; ++i) QTest::keyClick(kinds, Qt::Key_Down);
    const std::string proposed =
        dialog->findChild<QLineEdit*>("fileNameEdit")->text().toStdString();
    file = answer.folder / std::filesystem::path(proposed).filename();
    acceptPath(*dialog, file);
  });
  poll.start(10);
  rig.click(button);
  return file;
}

}  // namespace perilymph::test
