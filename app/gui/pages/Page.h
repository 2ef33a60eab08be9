// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the window needs of a page. A page is a class derived from it and one line in
// shell/PageList.cpp: its button, its keys, dropped files, Esc and closing follow.

#include <QWidget>
#include <filesystem>
#include <optional>

#include "gui/setup/InsertionRequest.h"
#include "gui/widgets/Icon.h"

namespace perilymph::gui {

class Page : public QWidget {
  Q_OBJECT
public:
  /// @param id    Identifies the page in requests, and names its objects: `ct` is the page `ctPage`
  ///              with the button `ctPageButton`.
  /// @param name  Text of its button and in the list of keys, translated.
  /// @param icon  Of its button.
  Page(const char* id, QString name, Icon icon, QWidget* parent);

  const QString& id() const { return id_; }
  const QString& name() const { return name_; }
  Icon icon() const { return icon_; }

  /// It works in the background.
  virtual bool isBusy() const { return false; }
  /// Esc on this page: ends what it works on. False if there was nothing to end.
  virtual bool cancel() { return false; }

  /// Which files may be dropped; those that a page always accepts may also be named on the command line.
  enum class Acceptance { none, whileShown, always };
  virtual Acceptance accepts(const std::filesystem::path& file) const;
  /// Opens a file or folder that was dropped, or that another page requested to be opened here. A
  /// page that is not shown may request it: pageRequested(id()).
  virtual void open(const std::filesystem::path& file);

  /// The page was shown in place of another one.
  virtual void onShown() {}
  /// Its button was pressed while it was shown.
  virtual void onChosenAgain() {}
  /// Another page will be shown.
  virtual void onHidden() {}
  /// Handles a key before those of the window. False if it is not handled.
  virtual bool takeKey(const QKeyEvent& event);

  /// Where the keyboard focus is: in the window, so that single letters are commands; in a widget of
  /// the page when it is shown, until Esc; always in a widget of the page.
  enum class Focus { window, pageUntilEscape, page };
  virtual Focus focus() const { return Focus::window; }
  /// It shows the insertion and its patient: a device remains active when its button is pressed.
  virtual bool showsInsertion() const { return false; }

  /// Work that would be lost: why the user is asked first, and the button that continues it.
  struct Unfinished {
    QString sentence, keepText;
  };
  virtual std::optional<Unfinished> unfinished() const { return std::nullopt; }
  virtual void endUnfinished() {}

Q_SIGNALS:
  void insertionRequested(const perilymph::gui::InsertionRequest& request);
  void replayRequested(const std::filesystem::path& recording);
  /// Another page is requested, and a file to be opened there unless it is empty.
  void pageRequested(const QString& id, const std::filesystem::path& file = {});
  /// A message that needs no answer; an empty one shows nothing.
  void noted(const QString& sentence);

private:
  QString id_, name_;
  Icon icon_;
};

}  // namespace perilymph::gui
