// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One plane of the CT with crosshair, outlines and landmarks.

#include <QImage>
#include <QPointer>
#include <QWidget>
#include <cstddef>
#include <functional>
#include <optional>

#include "gui/pages/ct/CtStudy.h"

class QLineEdit;

namespace perilymph::gui {

/// Shows plane 0, 1 or 2 of a study and moves what is in it:
/// - left button: crosshair, or the landmark or the point of a markup under the mouse; a chosen landmark, or the next
///   point of a markup whose tool is chosen, is placed; a note is written where it was placed, and again by a double
///   click on its point;
/// - right button: brightness and contrast; middle button, or left with Shift: the picture;
/// - a contact of an implanted array is dragged, or moved by Shift and the arrow keys where it is chosen;
/// - wheel: through the layers; with Ctrl: zoom. Up and Down, + and - do the same.
class PlaneView : public QWidget {
  Q_OBJECT
public:
  PlaneView(CtStudy& study, std::size_t plane, QWidget* parent);

  /// The landmark that the next click places; none if empty.
  void setPlaced(std::optional<ct::Mark> mark);

  /// The structure to which clicks add points; none if empty.
  void setMarked(std::optional<ct::MarkupKind> structure);

  /// The place of a point in the widget [px].
  QPointF placeOf(const Eigen::Vector3d& point_P) const;
  /// The point of the plane under a place of the widget, in P [mm].
  Eigen::Vector3d pointAt(const QPointF& place) const;
  /// The landmark within reach of the mouse; empty without one.
  std::optional<ct::Mark> markAt(const QPointF& place) const;
  /// The point of a markup within reach of the mouse that is drawn in this plane; empty without one.
  std::optional<CtStudy::MarkupPoint> markupAt(const QPointF& place) const;
  /// Places the next point of the markup whose tool is chosen; for a note its text is typed there.
  void placeToolPoint(const Eigen::Vector3d& point_P);
  /// Asks for a line of text beside a place of the view, in place of another one that is being typed.
  ///
  /// @param then  Receives it when it is confirmed; it may be empty.
  void askText(const QString& name, const QString& text, const QPointF& place,
               std::function<void(const QString&)> then);
  /// Ends the typing of a text without it. False if none is typed.
  bool cancelText();

  /// The picture with its overlay at a size of its own, all of what the view shows in it, without crosshair.
  QImage pictureOf(const QSize& size_px, double ratio) const;

  /// The number of the contact within reach of the mouse; 0 without one.
  int contactAt(const QPointF& place) const;

  QSize minimumSizeHint() const override { return {160, 140}; }

Q_SIGNALS:
  /// The chosen landmark was placed.
  void markPlaced(perilymph::ct::Mark mark);
  /// A contact was moved to a point of P [mm].
  void contactMoved(int number, const Eigen::Vector3d& point_P);
  /// A double click.
  void maximizeRequested();
  /// The view was clicked, or it got the focus.
  void chosen();
  /// A markup cannot be kept: why, a sentence.
  void refused(const QString& sentence);

protected:
  /// A tool tip names the landmark under the mouse in full.
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  /// Return confirms a text that is typed.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  ct::ViewPlane plane() const { return study_.planes()[index_]; }
  void paintPlane(class QPainter& painter);
  void editText(std::size_t markup);
  /// The landmark or contact that is moved now.
  std::optional<Eigen::Vector3d> held_P() const;
  void paintLoupe(QPainter& painter, const Eigen::Vector3d& about_P);
  void nudgeContact(const Eigen::Vector2d& by_mm);
  void stepLayers(double layers);

  CtStudy& study_;
  std::size_t index_;
  std::optional<ct::Mark> placed_, dragged_;
  std::optional<ct::MarkupKind> marked_;
  std::optional<CtStudy::MarkupPoint> heldMarkup_;
  int heldContact_ = 0;
  bool isContactMoved_ = false;
  std::optional<QPointF> cursor_;  ///< Place of the mouse; empty outside the view.
  QPointer<QLineEdit> typed_;
  std::function<void(const QString&)> thenTyped_;
  QPointF mouse_;
  double wheelRest_ = 0.0;
};

}  // namespace perilymph::gui
