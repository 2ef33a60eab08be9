// SPDX-License-Identifier: BSD-3-Clause
#include "gui/archive/SendDialog.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <system_error>

#include "gui/text/DataText.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/archive/Send.h"
#include "perilymph/foundation/Unfinished.h"

namespace perilymph::gui {

namespace {

constexpr int width_px = 480;

WrappedLabel* quietText(const QString& text, QWidget* parent)
{
  auto* label = new WrappedLabel(text, parent);
  label->setFont(typeface(12));
  label->setTextFormat(Qt::PlainText);
  label->setProperty("quiet", true);
  return label;
}

/// Writes and sends one part after the other. What was stored before an error is said with it.
///
/// @return  After a cancellation before anything was given to the archive, an error without a sentence.
Result<Sentence> sendAll(const archive::Server& server, const std::vector<SentPart>& parts,
                         const std::filesystem::path& ct, archive::Exchange exchange)
{
  std::error_code failure;
  const auto folder =
      UnfinishedFolder::create(std::filesystem::temp_directory_path(failure) / "perilymph-send");
  if (failure || !folder)
    return Error{"No temporary folder can be made for what is sent. Check the space on the disk."};
  std::string numbers;
  std::size_t stored = 0, given = 0;
  Sentence warning;
  exchange.onStore = [&given] { ++given; };
  const auto sendOne = [&](const SentPart& part) -> Result<void> {
    const std::filesystem::path file = folder->path() / (std::to_string(stored) + ".dcm");
    if (const auto written = part.write(ct, file); !written) return written;
    if (exchange.stop.stop_requested()) return Error{"The sending was canceled."};
    const auto sent = archive::sendObject(server, file, exchange);
    if (!sent) return sent.error();
    numbers += (numbers.empty() ? "" : ", ") + sent->seriesNumber;
    if (!sent->warning.empty()) warning = sent->warning;
    return {};
  };
  for (const SentPart& part : parts) {
    const auto done = exchange.stop.stop_requested()
                          ? Result<void>(Error{"The sending was canceled."})
                          : sendOne(part);
    if (!done) {
      if (exchange.stop.stop_requested() && given == 0) return Error{std::string()};
      if (stored == 0) return done.error();
      return Error{"%1 of %2 objects were stored, as series %3. Then: %4", stored, parts.size(),
                   numbers, done.error().message};
    }
    ++stored;
    if (exchange.onProgress)
      exchange.onProgress(static_cast<double>(stored) / static_cast<double>(parts.size()));
  }
  if (!warning.empty())
    return Sentence{"Stored in the study of the CT, as series %1. %2", numbers, warning};
  return Sentence{"Stored in the study of the CT, as series %1.", numbers};
}

}  // namespace

SendDialog::SendDialog(std::vector<SentPart> parts, std::optional<std::filesystem::path> ct,
                       QWidget* parent)
    : QDialog(parent),
      work_(this),
      parts_(std::move(parts)),
      ct_(std::move(ct)),
      isOpen_(ct_.has_value()),
      server_(new Selector("sendServer", tr("Archive"), this)),
      ctText_(quietText({}, this)),
      status_(quietText({}, this)),
      choose_(panelButton(tr("Folder of the CT…"), "sendCtButton", this)),
      send_(panelButton(tr("Send"), "sendButton", this)),
      close_(panelButton(tr("Close"), "sendCloseButton", this)),
      progress_(new QProgressBar(this))
{
  setObjectName(QStringLiteral("sendDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Send to the archive"));
  setFixedWidth(sized(width_px));
  layOut();
  const auto read = archive::readServers();
  if (read) servers_ = *read;
  for (const archive::Server& each : servers_)
    server_->addChoice(QString::fromStdString(each.name), QString::fromStdString(each.name));
  server_->setVisible(!servers_.empty());
  connect(choose_, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(
        this, tr("Folder of the patient’s CT; the objects take name and number from it"),
        documentsFolder());
    if (!folder.isEmpty()) setCt(folder.toStdString());
  });
  connect(send_, &QPushButton::clicked, this, &SendDialog::send);
  connect(close_, &QPushButton::clicked, this, &SendDialog::reject);
  connect(&work_, &ArchiveWork::progressed, this,
          [this](double fraction) { progress_->setValue(int(1000.0 * fraction)); });
  connect(&work_, &ArchiveWork::done, this, [this](const QString& sentence) {
    showMessage(sentence);
    showState();
    send_->setEnabled(false);  // once; the box of another part allows it again
  });
  connect(&work_, &ArchiveWork::failed, this, [this](const QString& sentence) {
    if (sentence.isEmpty()) return done(Rejected);  // canceled, and the archive has nothing
    showMessage(sentence, true);
    showState();
  });
  if (!read)
    showMessage(dataText(read.error().message), true);
  else if (servers_.empty())
    showMessage(tr("No archive is entered yet: see Settings, DICOM archives."), true);
  showState();
  QTimer::singleShot(0, this, &SendDialog::fit);  // once it has its style
}

void SendDialog::layOut()
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * spacing, 2 * spacing, 3 * spacing, 2 * spacing);
  column->setSpacing(spacing);
  column->addWidget(server_);
  for (const SentPart& part : parts_) {
    auto* box = new CheckBox(part.name, this);
    box->setObjectName(QStringLiteral("sendPart%1").arg(boxes_.size()));
    box->setFont(typeface(13));
    box->setChecked(true);
    connect(box, &QAbstractButton::toggled, this, &SendDialog::showState);
    column->addWidget(box);
    boxes_.push_back(box);
  }
  column->addWidget(ctText_);
  column->addWidget(choose_, 0, Qt::AlignLeft);
  column->addWidget(quietText(
      tr("What is sent names the patient, as the CT does. It goes into the study of that CT "
         "and into no other; the archive must have it under the same patient number and "
         "birth date. Results are for research and training, not a diagnosis."),
      this));
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  progress_->setRange(0, 1000);
  column->addWidget(progress_);
  status_->setObjectName(QStringLiteral("sendStatus"));
  column->addWidget(status_);
  column->addStretch();
  auto* verbs = new QHBoxLayout;
  verbs->setSpacing(spacing);
  verbs->addStretch();
  verbs->addWidget(send_);
  verbs->addWidget(close_);
  column->addLayout(verbs);
  setPrimary(*send_, true);
  send_->setDefault(true);
}

void SendDialog::setCt(const std::filesystem::path& ct)
{
  ct_ = ct;
  showState();
}

void SendDialog::reject()
{
  if (!work_.isBusy() || isCanceling_) return QDialog::reject();
  isCanceling_ = true;
  showMessage(tr("Canceling…"));
  work_.requestStop();
}

void SendDialog::done(int result)
{
  const QSignalBlocker quiet(work_);
  work_.cancel();
  QDialog::done(result);
}

void SendDialog::send()
{
  const int index = server_->currentIndex();
  if (index < 0 || index >= int(servers_.size()) || !ct_) return;
  std::vector<SentPart> chosen;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (boxes_[i]->isChecked()) chosen.push_back(parts_[i]);
  isCanceling_ = false;
  showMessage(tr("Sending…"));
  progress_->setValue(0);
  work_.run([server = servers_[std::size_t(index)], chosen,
             ct = *ct_](const archive::Exchange& exchange) {
    return sendAll(server, chosen, ct, exchange);
  });
  showState();
}

void SendDialog::showState()
{
  const bool isBusy = work_.isBusy();
  const bool isAny = std::ranges::any_of(boxes_, &CheckBox::isChecked);
  ctText_->setText(!ct_      ? tr("The CT that this was made from is not open. Choose its folder.")
                   : isOpen_ ? tr("The CT is the one that is open on the page CT.")
                             : tr("CT: %1").arg(QString::fromStdString(ct_->filename().string())));
  choose_->setVisible(!isOpen_);
  choose_->setEnabled(!isBusy);
  progress_->setVisible(isBusy);
  for (CheckBox* box : boxes_) box->setEnabled(!isBusy);
  server_->setEnabled(!isBusy);
  send_->setEnabled(!isBusy && isAny && ct_ && !servers_.empty());
  close_->setText(isBusy ? tr("Cancel") : tr("Close"));
  fit();
}

void SendDialog::fit()
{
  layout()->activate();
  const int width = sized(width_px);
  resize(width, std::max(layout()->heightForWidth(width), layout()->minimumSize().height()));
}

void SendDialog::showMessage(const QString& sentence, bool isError)
{
  showSentence(*status_, sentence, isError);
  status_->setVisible(!sentence.isEmpty());
  fit();
}

}  // namespace perilymph::gui
