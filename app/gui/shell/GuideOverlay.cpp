// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/GuideOverlay.h"

#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextTable>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <utility>
#include <vector>

#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

constexpr int max_px = 920;  // longer lines are hard to read
constexpr double lineHeight_percent = 125.0;

}  // namespace

/// A browser whose pictures are at most as wide as the page, with links in the window's color and
/// space between paragraphs.
class GuideBrowser : public QTextBrowser {
public:
  explicit GuideBrowser(QWidget* parent) : QTextBrowser(parent)
  {
    connect(this, &QTextBrowser::sourceChanged, this, [this] { formatPage(); });
  }

  /// Formats the page: Markdown has neither colors nor margins.
  void formatPage()
  {
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
      QTextCursor cursor(block);
      QTextBlockFormat spaced = block.blockFormat();
      const bool isHeading = spaced.headingLevel() > 0;
      const bool isInTable = cursor.currentTable() != nullptr;
      spaced.setTopMargin(isInTable ? 3.0 : isHeading ? 2.5 * spacing : 0.5 * spacing);
      spaced.setBottomMargin(isInTable ? 3.0 : spacing);
      spaced.setLineHeight(lineHeight_percent, QTextBlockFormat::ProportionalHeight);
      cursor.setBlockFormat(spaced);
      std::vector<std::pair<int, int>> links;  // formatting them changes the fragments
      for (auto part = block.begin(); !part.atEnd(); ++part)
        if (const QTextFragment each = part.fragment(); each.charFormat().isAnchor())
          links.emplace_back(each.position(), each.position() + each.length());
      QTextCharFormat link;
      link.setForeground(shownTheme().accent);
      link.setFontUnderline(true);
      for (const auto& [from, to] : links) {
        cursor.setPosition(from);
        cursor.setPosition(to, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(link);
      }
    }
  }

  QVariant loadResource(int type, const QUrl& name) override
  {
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    const QImage image(source().resolved(name).toLocalFile());
    const int available = viewport()->width() - 6 * spacing;
    if (image.isNull() || image.width() <= available) return image;
    return image.scaledToWidth(std::max(available, 1), Qt::SmoothTransformation);
  }
};

std::filesystem::path guideFolder()
{
  std::error_code ignored;
  for (const std::filesystem::path& place :
       {resource("resources/guide"),
        resourceRoot().parent_path() / "doc" / "perilymph" / "resources" / "guide"})
    if (std::filesystem::exists(place / "README.md", ignored)) return place;
  return {};
}

std::filesystem::path guideStart(const std::filesystem::path& folder)
{
  const auto spoken = folder / QLocale().name().left(2).toStdString() / "README.md";
  std::error_code ignored;
  return std::filesystem::exists(spoken, ignored) ? spoken : folder / "README.md";
}

GuideOverlay::GuideOverlay(QWidget* parent) : QFrame(parent), page_(new GuideBrowser(this))
{
  setObjectName(QStringLiteral("guide"));
  page_->setObjectName(QStringLiteral("guidePage"));
  page_->setAccessibleName(tr("User guide"));
  page_->setFrameShape(QFrame::NoFrame);
  page_->setFont(typeface(13));
  page_->document()->setDocumentMargin(2 * spacing);
  QPalette inks = page_->palette();
  inks.setColor(QPalette::Link, shownTheme().accent);
  inks.setColor(QPalette::LinkVisited, shownTheme().accent);
  page_->setPalette(inks);

  auto* title = new QLabel(tr("User guide"), this);
  title->setFont(typeface(15, QFont::DemiBold));
  auto* back = new QPushButton(tr("Back"), this);
  back->setObjectName(QStringLiteral("guideBackButton"));
  auto* shut = new QPushButton(tr("Close"), this);
  shut->setObjectName(QStringLiteral("guideCloseButton"));
  shut->setToolTip(tr("Close (Esc)"));
  auto* head = new QHBoxLayout;
  head->addWidget(title, 1);
  for (QPushButton* button : {back, shut}) {
    button->setFont(typeface(13));
    button->setFixedHeight(sized(28));
    button->setFocusPolicy(Qt::TabFocus);
    head->addWidget(button);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, 2 * spacing, spacing, spacing);
  column->setSpacing(spacing);
  column->addLayout(head);
  column->addWidget(page_, 1);

  back->setEnabled(false);
  connect(back, &QPushButton::clicked, page_, &QTextBrowser::backward);
  connect(page_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(shut, &QPushButton::clicked, this, &GuideOverlay::closeRequested);
  hide();
}

void GuideOverlay::fit()
{
  const QWidget& around = *parentWidget();
  resize(std::min(max_px, around.width() - 4 * spacing), around.height() - 2 * shownLengths().bar);
  move((around.width() - width()) / 2, shownLengths().bar);
  layout()->activate();
}

void GuideOverlay::open()
{
  fit();
  show();
  raise();
  const std::filesystem::path folder = guideFolder();
  if (folder.empty()) {
    page_->setPlainText(
        tr("The user guide is not installed. It is in the folder resources/guide of the source."));
  } else {
    page_->setSource(QUrl::fromLocalFile(QString::fromStdString(guideStart(folder).string())));
    page_->clearHistory();
  }
  page_->setFocus();
}

}  // namespace perilymph::gui
