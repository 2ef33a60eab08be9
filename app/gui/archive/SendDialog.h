// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Results into the study of the patient's CT.

#include <QDialog>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "gui/archive/ArchiveWork.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace perilymph::gui {

class CheckBox;
class Selector;

/// Something that can be sent: what the user calls it, and how it is written for a CT. It is written
/// in another thread, with an error for a CT of another series than that of the result.
struct SentPart {
  QString name;
  std::function<Result<void>(const std::filesystem::path& ct, const std::filesystem::path& file)>
      write;
};

/// Form for the archive, the CT unless it is known, and what is to be sent. Each object is written
/// into a temporary folder, sent into the study of the CT, and removed.
///
/// Cancel and Esc end the sending. The dialog closes when it has ended; where the archive has a part, or
/// may have it, the dialog states it and stays open. A second time they close it at once.
class SendDialog : public QDialog {
  Q_OBJECT
public:
  /// @param ct  Folder of the patient's CT, where it is known.
  SendDialog(std::vector<SentPart> parts, std::optional<std::filesystem::path> ct, QWidget* parent);

  /// The folder of the CT, from which the objects take patient and study.
  void setCt(const std::filesystem::path& ct);
  void reject() override;
  void done(int result) override;

private:
  void layOut();
  void send();
  void showState();
  /// Takes the height of its texts.
  void fit();
  void showMessage(const QString& sentence, bool isError = false);

  ArchiveWork work_;
  std::vector<SentPart> parts_;
  std::optional<std::filesystem::path> ct_;
  bool isOpen_;               ///< The CT was known when the dialog opened.
  bool isCanceling_ = false;  ///< The sending was asked to end.
  std::vector<archive::Server> servers_;
  Selector* server_;
  std::vector<CheckBox*> boxes_;
  QLabel *ctText_, *status_;
  QPushButton *choose_, *send_, *close_;
  QProgressBar* progress_;
};

}  // namespace perilymph::gui
