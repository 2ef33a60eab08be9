// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of landmarks and numbers of contacts over a 3D view, and the handles of cut and approach.

#include <QLabel>
#include <QWidget>
#include <optional>
#include <vector>

#include "perilymph/visualization/BoneLayer.h"

namespace perilymph::gui {

/// How far a key moves the cut [mm].
inline constexpr double cutOfKey_mm = 0.25;

/// A label over a picture: its text, the point that it names and its place [px].
struct PlacedLabel {
  QString text;
  QPointF at;
  QRectF place;  ///< Null without room for it.
};

/// Places the labels of anchors: landmarks first, then contacts, of which those at the ends and every
/// fifth come first.
///
/// @param ratio  Device pixels per pixel.
/// @param taken  Where no label may be; points that lie there are covered and have none.
std::vector<PlacedLabel> placedLabels(const std::vector<visualization::SceneAnchor>& anchors,
                                      double ratio, const QRectF& pane, const QFont& font,
                                      const std::vector<QRectF>& taken);

/// Covers a view and lets the mouse through; the view passes on what drags the handle.
class SceneLabels : public QWidget {
  Q_OBJECT
public:
  explicit SceneLabels(QWidget& view);

  /// Shows what a layer has in the last picture; nothing if null.
  /// @param taken               Where no label may be, beside the widgets of the view.
  /// @param isApproachTurnable  Whether the line of approach has a handle.
  void follow(const visualization::BoneLayer* layer, std::vector<QRectF> taken = {},
              bool isApproachTurnable = false);
  /// A sentence in the picture; hidden if empty.
  /// @param place   Its upper left corner.
  /// @param widest  It has more lines rather than a greater width [px].
  void setNote(const QString& note, const QPoint& place, int widest);
  QString note() const { return note_->text(); }
  const std::vector<PlacedLabel>& labels() const { return labels_; }

  /// Whether the handle is at a place.
  bool isHandleAt(const QPointF& place) const;
  /// Motion of the cut that belongs to a motion of the mouse [mm].
  double cutMotion_mm(const QPointF& moved) const;
  /// The handle's center; empty while there is none.
  std::optional<QPointF> handle() const;
  /// The handle of the line of approach; empty while there is none.
  struct TurnHandle {
    QPointF at;
    double toViewer_mm;  ///< In front of the line's inner end.
  };
  const std::optional<TurnHandle>& approachHandle() const { return approachHandle_; }
  bool isApproachHandleAt(const QPointF& place) const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent*) override;

private:
  void placeNote();

  QWidget& view_;
  QLabel* note_;
  QPoint notePlace_;
  int widestNote_px_ = 0;
  std::vector<PlacedLabel> labels_;
  std::optional<visualization::CutHandle> handle_;
  std::optional<TurnHandle> approachHandle_;
};

}  // namespace perilymph::gui
