// SPDX-License-Identifier: BSD-3-Clause
#include "gui/archive/ServersSection.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <utility>

#include "gui/text/DataText.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Placeholder.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/archive/OwnAddresses.h"

namespace perilymph::gui {

namespace {

constexpr int field_px = 26, caption_px = 150;

QWidget* captioned(const QString& caption, QWidget* field, QWidget* parent)
{
  auto* line = new QWidget(parent);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing);
  auto* label = new WrappedLabel(caption, line);
  label->setFont(typeface(13));
  label->setFixedWidth(sized(caption_px));
  label->setBuddy(field);
  row->addWidget(label);
  row->addWidget(field, 1);
  return line;
}

QString plain(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

ServersSection::ServersSection(QWidget* parent)
    : QWidget(parent),
      work_(this),
      list_(new Selector("archiveList", tr("Archives"), this)),
      get_(new Choice(tr("C-GET, without a port of this machine"), this)),
      move_(new Choice(tr("C-MOVE, to a port of this machine"), this)),
      tls_(new CheckBox(tr("Encrypted (TLS)"), this)),
      tlsFiles_(new QWidget(this)),
      add_(rowButton(tr("Add"), "archiveAddButton", this)),
      remove_(rowButton(tr("Remove"), "archiveRemoveButton", this)),
      save_(rowButton(tr("Save"), "archiveSaveButton", this)),
      test_(rowButton(tr("Test"), "archiveTestButton", this)),
      status_(new WrappedLabel({}, this))
{
  layOut();
  connect(list_, &Selector::chosen, this, [this] { choose(list_->currentIndex()); });
  connect(add_, &QPushButton::clicked, this, [this] {
    choose(-1);
    name_->setFocus();
  });
  connect(remove_, &QPushButton::clicked, this, &ServersSection::remove);
  connect(save_, &QPushButton::clicked, this, &ServersSection::save);
  connect(test_, &QPushButton::clicked, this, &ServersSection::test);
  for (QAbstractButton* button :
       {static_cast<QAbstractButton*>(get_), static_cast<QAbstractButton*>(move_),
        static_cast<QAbstractButton*>(tls_)})
    connect(button, &QAbstractButton::toggled, this, &ServersSection::showKinds);
  connect(&work_, &ArchiveWork::answered, this, [this] {
    showMessage(tr("%1 answers.").arg(name_->text()) + QLatin1Char('\n') + forAdministrator());
    test_->setEnabled(true);
  });
  connect(&work_, &ArchiveWork::failed, this, [this](const QString& sentence) {
    test_->setEnabled(true);
    if (!sentence.isEmpty()) showMessage(sentence + QLatin1Char('\n') + forAdministrator(), true);
  });
  refresh();
}

void ServersSection::layOut()
{
  auto* heading = new WrappedLabel(tr("DICOM archives (PACS)"), this);
  heading->setFont(typeface(13, QFont::DemiBold));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing / 2);
  column->addWidget(heading);
  auto* top = new QHBoxLayout;
  top->setSpacing(spacing);
  top->addWidget(list_, 2);
  top->addWidget(add_, 1);
  top->addWidget(remove_, 1);
  column->addLayout(top);
  name_ = addLine("archiveName", tr("Name"), tr("as you call it"));
  aeTitle_ = addLine("archiveAeTitle", tr("AE title"), tr("of the archive"));
  host_ = addLine("archiveHost", tr("Host"), tr("name or IPv4 address"));
  port_ = addLine("archivePort", tr("Port"), QStringLiteral("104"));
  ownAeTitle_ = addLine("archiveOwnAeTitle", tr("Own AE title"), {});
  get_->setObjectName(QStringLiteral("archiveGet"));
  move_->setObjectName(QStringLiteral("archiveMove"));
  for (Choice* choice : {get_, move_}) {
    choice->setFocusPolicy(Qt::TabFocus);
    column->addWidget(choice);
  }
  ownPort_ = addLine("archiveOwnPort", tr("Own port"), QStringLiteral("11112"));
  tls_->setObjectName(QStringLiteral("archiveTls"));
  tls_->setFont(typeface(13));
  column->addWidget(tls_);
  auto* files = new QVBoxLayout(tlsFiles_);
  files->setContentsMargins(0, 0, 0, 0);
  files->setSpacing(spacing / 2);
  authority_ = addFile("archiveAuthority", tr("Authority (PEM)"));
  certificate_ = addFile("archiveCertificate", tr("Own certificate (PEM)"));
  key_ = addFile("archiveKey", tr("Own key (PEM)"));
  column->addWidget(tlsFiles_);
  auto* verbs = new QHBoxLayout;
  verbs->setSpacing(spacing);
  verbs->addWidget(save_);
  verbs->addWidget(test_);
  column->addLayout(verbs);
  status_->setObjectName(QStringLiteral("archiveServerStatus"));
  status_->setFont(typeface(12));
  status_->setTextFormat(Qt::PlainText);
  status_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(status_);
}

QLineEdit* ServersSection::addLine(const char* name, const QString& caption, const QString& hint)
{
  auto* field = new QLineEdit(this);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(caption);
  field->setFont(typeface(13));
  field->setFixedHeight(sized(field_px));
  field->setMaxLength(100);
  if (!hint.isEmpty()) markPlaceholder(*field, hint);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(captioned(caption, field, this));
  return field;
}

QLineEdit* ServersSection::addFile(const char* name, const QString& caption)
{
  auto* both = new QWidget(tlsFiles_);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  auto* field = new QLineEdit(both);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(caption);
  field->setFont(typeface(13));
  field->setFixedHeight(sized(field_px));
  field->setMaxLength(1000);
  auto* pick = new QPushButton(QStringLiteral("…"), both);
  pick->setAccessibleName(tr("Choose the file: %1").arg(caption));
  pick->setToolTip(tr("Choose the file"));
  pick->setFont(typeface(13));
  pick->setFixedSize(sized(30), sized(field_px));
  pick->setFocusPolicy(Qt::TabFocus);
  row->addWidget(field, 1);
  row->addWidget(pick);
  connect(pick, &QPushButton::clicked, this, [this, field, caption] {
    const QString file = QFileDialog::getOpenFileName(this, caption, {},
                                                      tr("PEM (*.pem *.crt *.key);;All files (*)"));
    if (!file.isEmpty()) field->setText(file);
  });
  static_cast<QVBoxLayout*>(tlsFiles_->layout())->addWidget(captioned(caption, both, tlsFiles_));
  return field;
}

void ServersSection::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  refresh();
}

void ServersSection::refresh()
{
  const auto read = archive::readServers();
  servers_ = read ? *read : std::vector<archive::Server>{};
  list_->clear();
  for (const archive::Server& each : servers_) list_->addChoice(plain(each.name), plain(each.name));
  choose(servers_.empty() ? -1 : 0);
  if (!read) showMessage(dataText(read.error().message), true);
  for (QWidget* each : {static_cast<QWidget*>(save_), static_cast<QWidget*>(add_)})
    each->setEnabled(bool(read));  // a file that is not understood is not written over
}

void ServersSection::focusFirst()
{
  (servers_.empty() ? static_cast<QWidget*>(name_) : list_)->setFocus();
}

void ServersSection::choose(int index)
{
  work_.cancel();
  shown_ = index;
  list_->setVisible(!servers_.empty());
  if (index >= 0)
    list_->setCurrentIndex(index);
  else
    list_->setCurrentIndex(-1);
  remove_->setEnabled(index >= 0);
  showServer(index >= 0 ? servers_[std::size_t(index)] : archive::Server());
  showMessage({});
}

void ServersSection::showServer(const archive::Server& server)
{
  name_->setText(plain(server.name));
  aeTitle_->setText(plain(server.aeTitle));
  host_->setText(plain(server.host));
  port_->setText(QString::number(server.port));
  ownAeTitle_->setText(plain(server.ownAeTitle));
  ownPort_->setText(QString::number(server.ownPort));
  (server.retrieval == archive::Retrieval::move ? move_ : get_)->setChecked(true);
  tls_->setChecked(server.tls.has_value());
  const archive::TlsFiles files = server.tls.value_or(archive::TlsFiles{});
  authority_->setText(plain(files.authority.string()));
  certificate_->setText(plain(files.certificate.string()));
  key_->setText(plain(files.key.string()));
  showKinds();
}

archive::Server ServersSection::typed() const
{
  const auto text = [](const QLineEdit* field) { return field->text().trimmed().toStdString(); };
  archive::Server server;
  server.name = text(name_);
  server.aeTitle = text(aeTitle_);
  server.host = text(host_);
  server.port = port_->text().trimmed().toInt();  // 0 is no port
  server.ownAeTitle = text(ownAeTitle_);
  server.ownPort = ownPort_->text().trimmed().toInt();
  server.retrieval = move_->isChecked() ? archive::Retrieval::move : archive::Retrieval::get;
  if (tls_->isChecked())
    server.tls = archive::TlsFiles{text(authority_), text(certificate_), text(key_)};
  return server;
}

void ServersSection::write(std::vector<archive::Server> servers, const std::string& chosen,
                           const QString& sentence)
{
  if (const auto written = archive::writeServers(servers); !written)
    return showMessage(dataText(written.error().message), true);
  Q_EMIT changed();
  refresh();
  for (std::size_t i = 0; i < servers_.size(); ++i)
    if (servers_[i].name == chosen) choose(int(i));
  showMessage(sentence);
}

void ServersSection::save()
{
  const archive::Server server = typed();
  if (const auto checked = archive::checkServer(server); !checked)
    return showMessage(dataText(checked.error().message), true);
  std::vector<archive::Server> servers = servers_;
  if (shown_ >= 0)
    servers[std::size_t(shown_)] = server;
  else
    servers.push_back(server);
  write(std::move(servers), server.name, tr("Saved. Test it."));
}

void ServersSection::remove()
{
  if (shown_ < 0) return;
  std::vector<archive::Server> servers = servers_;
  const QString name = plain(servers[std::size_t(shown_)].name);
  servers.erase(servers.begin() + shown_);
  write(std::move(servers), {}, tr("%1 was removed.").arg(name));
}

void ServersSection::test()
{
  const archive::Server server = typed();
  if (const auto checked = archive::checkServer(server); !checked)
    return showMessage(dataText(checked.error().message), true);
  showMessage(tr("Asking %1…").arg(plain(server.name)));
  test_->setEnabled(false);
  work_.echo(server);
}

QString ServersSection::forAdministrator() const
{
  const archive::Server server = typed();
  QStringList addresses;
  for (const std::string& each : archive::ownAddresses()) addresses << plain(each);
  const QString address = addresses.isEmpty() ? tr("not known") : addresses.join(tr(" or "));
  if (server.retrieval == archive::Retrieval::move)
    return tr("The administrator of the archive has to enter: AE title %1, address %2, port %3, "
              "and "
              "allow it to query, to move to this port and to store. The firewall must let the "
              "archive in at this port.")
        .arg(plain(server.ownAeTitle), address)
        .arg(server.ownPort);
  return tr("The administrator of the archive has to enter: AE title %1, address %2, and allow it "
            "to query, to get (C-GET) and to store. No port is needed.")
      .arg(plain(server.ownAeTitle), address);
}

void ServersSection::showKinds()
{
  ownPort_->parentWidget()->setVisible(move_->isChecked());
  tlsFiles_->setVisible(tls_->isChecked());
}

void ServersSection::showMessage(const QString& sentence, bool isError)
{
  showSentence(*status_, sentence, isError);
  status_->setVisible(!sentence.isEmpty());
}

}  // namespace perilymph::gui
