// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The parts that panels beside a page's view are made of: headings, buttons, a scrolled column.

#include <QString>

class QProgressBar;
class QPushButton;
class QScrollArea;
class QWidget;

namespace perilymph::gui {

class WrappedLabel;

/// The heading of a panel's section: small and quiet.
WrappedLabel* panelHeading(const QString& text, QWidget* parent);

/// A button of a panel or a row of verbs, 28 px high. It takes the focus by Tab only.
///
/// @param name  Its object name.
QPushButton* panelButton(const QString& text, const char* name, QWidget* parent);

/// A panelButton() that is as wide as its row gives it: its text does not widen the panel.
QPushButton* rowButton(const QString& text, const char* name, QWidget* parent);

/// Draws a button as what most users press next, or as any other.
void setPrimary(QPushButton& button, bool isPrimary);

/// A bar of work whose duration is unknown, 6 px high.
QProgressBar* endlessBar(int width_px, QWidget* parent);

/// A frameless area in which the content is as wide as the area and scrolls vertically. It takes no
/// focus, but follows that of its fields.
QScrollArea* verticalScroll(QWidget* content, QWidget* parent);

}  // namespace perilymph::gui
