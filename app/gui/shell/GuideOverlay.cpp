// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/GuideOverlay.h"

#include <QAbstractTextDocumentLayout>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QShortcut>
#include <QStackedWidget>
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
    setFrameShape(QFrame::NoFrame);
    setFont(typeface(13));
    document()->setDocumentMargin(2 * spacing);
    QPalette inks = palette();
    inks.setColor(QPalette::Link, shownTheme().accent);
    inks.setColor(QPalette::LinkVisited, shownTheme().accent);
    setPalette(inks);
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

  /// Scrolls to a part, and marks its first line.
  void showPart(const GuideHit& part)
  {
    setExtraSelections({});
    // of a numbered list, which is no heading
    const QRegularExpression question("^\\d+\\. " + QRegularExpression::escape(part.heading));
    int place = 0;
    for (QTextBlock block = document()->begin(); block.isValid() && !part.heading.isEmpty();
         block = block.next()) {
      const QString text = block.text().simplified();
      const bool isHeading =
          block.blockFormat().headingLevel() > 0 || QTextCursor(block).currentTable() != nullptr;
      if (isHeading ? text != part.heading : !text.contains(question)) continue;
      if (++place < part.place) continue;
      setTextCursor(QTextCursor(block));
      QTextEdit::ExtraSelection mark;
      mark.cursor = textCursor();
      mark.cursor.select(QTextCursor::BlockUnderCursor);
      QColor soft = shownTheme().accent;
      soft.setAlphaF(0.3F);
      mark.format.setBackground(soft);
      setExtraSelections({mark});
      const QRectF box = document()->documentLayout()->blockBoundingRect(block);
      verticalScrollBar()->setValue(static_cast<int>(box.top()) - spacing);
      return;
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

GuideOverlay::GuideOverlay(QWidget* parent)
    : QFrame(parent),
      words_(new QLineEdit(this)),
      sheets_(new QStackedWidget(this)),
      page_(new GuideBrowser(this)),
      found_(new GuideBrowser(this))
{
  setObjectName(QStringLiteral("guide"));
  page_->setObjectName(QStringLiteral("guidePage"));
  page_->setAccessibleName(tr("User guide"));
  found_->setObjectName(QStringLiteral("guideHits"));
  found_->setAccessibleName(tr("Found in the user guide"));
  found_->setOpenLinks(false);
  for (GuideBrowser* sheet : {page_, found_}) sheets_->addWidget(sheet);

  auto* title = new QLabel(tr("User guide"), this);
  title->setFont(typeface(15, QFont::DemiBold));
  auto* back = new QPushButton(tr("Back"), this);
  back->setObjectName(QStringLiteral("guideBackButton"));
  auto* shut = new QPushButton(tr("Close"), this);
  shut->setObjectName(QStringLiteral("guideCloseButton"));
  shut->setToolTip(tr("Close (Esc)"));
  words_->setObjectName(QStringLiteral("guideWords"));
  words_->setPlaceholderText(tr("Search the guide (Ctrl+F)"));
  words_->setAccessibleName(tr("Words to search in the user guide"));
  words_->setClearButtonEnabled(true);
  words_->setFont(typeface(13));
  words_->setFixedHeight(sized(28));
  auto* head = new QHBoxLayout;
  head->addWidget(title);
  head->addSpacing(2 * spacing);
  head->addWidget(words_, 1);
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
  column->addWidget(sheets_, 1);

  connect(words_, &QLineEdit::textChanged, this, &GuideOverlay::search);
  connect(words_, &QLineEdit::returnPressed, this, [this] { openHit(0); });
  connect(found_, &QTextBrowser::anchorClicked, this,
          [this](const QUrl& hit) { openHit(hit.toString().toUInt()); });
  auto* find =
      new QShortcut(QKeySequence::Find, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
  connect(find, &QShortcut::activated, this, [this] {
    words_->setFocus();
    words_->selectAll();
    search(words_->text());
  });
  back->setEnabled(false);
  connect(back, &QPushButton::clicked, page_, [this] {
    sheets_->setCurrentWidget(page_);
    page_->backward();
  });
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
  words_->clear();
  words_->setEnabled(!folder.empty());
  page_->setFocus();
}

void GuideOverlay::search(const QString& words)
{
  hits_.clear();
  sheets_->setCurrentWidget(words.trimmed().isEmpty() ? page_ : found_);
  if (sheets_->currentWidget() == page_) return;
  if (!search_)
    if (auto read = GuideSearch::read(guideStart(guideFolder()))) search_ = *std::move(read);
  if (search_) hits_ = search_->find(words);
  QString list;
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    const GuideHit& hit = hits_[i];
    const bool hasHeading = !hit.heading.isEmpty() && hit.heading != hit.title;
    const QString name = hasHeading ? hit.heading : hit.title;
    list += QStringLiteral("<p><a href='%1'>%2</a>%3<br>%4</p>")
                .arg(QString::number(i), name.toHtmlEscaped(),
                     hasHeading ? " · " + hit.title.toHtmlEscaped() : QString(), hit.excerpt);
  }
  if (hits_.empty())
    list = "<p>" +
           tr("No page has \"%1\". Try one word, such as \"depth\" or \"device\".")
               .arg(words.trimmed().toHtmlEscaped()) +
           "</p>";
  found_->setHtml(list);
  found_->formatPage();
}

void GuideOverlay::openHit(std::size_t number)
{
  if (number >= hits_.size()) return;
  const GuideHit hit = hits_[number];
  sheets_->setCurrentWidget(page_);
  page_->setSource(QUrl::fromLocalFile(hit.page));
  page_->showPart(hit);
  page_->setFocus();
}

}  // namespace perilymph::gui
