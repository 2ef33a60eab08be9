// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One array of a plan in the patient's cochlea, or up to four of them side by side.

#include <QWidget>
#include <array>
#include <memory>

#include "gui/pages/plan/PlanShapeWork.h"
#include "gui/scene/BoneNote.h"
#include "perilymph/charts/UnrolledScala.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QStackedWidget;

namespace perilymph::gui {

class AngleRing;
class ContactTable;
class DrawingView;
class PlanScene;
class PlotView;

/// Linked 3D pictures; beside them the unrolled scala, the angle ring and the contacts of one array,
/// or the force bands of several and what they differ by.
class PlanView : public QWidget {
  Q_OBJECT
public:
  static constexpr std::size_t maxArrays = 4;

  explicit PlanView(QWidget* parent);
  ~PlanView() override;

  /// @param arrays  Indices into the plan's arrays; at most maxArrays.
  void show(const PlanWork::SharedPlan& plan, std::vector<std::size_t> arrays, std::string madeUtc);
  /// Ends the computation of the pictures.
  void cancel() { work_.cancel(); }
  /// Pictures that show their array.
  std::size_t shownScenes() const;
  /// Where bone of patients is.
  void setBoneSource(BoneSource source) { boneSource_ = std::move(source); }
  /// Shows the bone as it is now.
  void refreshBone();
  PlanScene& scene(std::size_t place) { return *panes_[place].scene; }

Q_SIGNALS:
  void failed(const QString& sentence);

private:
  struct Pane {
    QWidget* frame;
    QLabel* title;
    PlanScene* scene;
  };
  struct Unrolled;
  Pane addPane();
  QWidget* addDetails();
  QWidget* addForces();
  void saveContacts();
  void arrange(std::size_t count);
  void showShape(std::size_t place, const PlanShapeWork::Shape& shape);

  BoneSource boneSource_;
  PlanShapeWork work_;
  PlanWork::SharedPlan plan_;
  std::vector<std::size_t> arrays_;
  std::string madeUtc_;  ///< When the plan was made.
  std::unique_ptr<Unrolled> unrolled_;
  QCheckBox* showsBone_;
  QGridLayout* grid_;
  std::array<Pane, maxArrays> panes_{};
  PlotView* unrolledView_;
  QStackedWidget* aside_;
  AngleRing* ring_;
  ContactTable* contacts_;
  QLabel* facts_;
  DrawingView* forces_;
  QLabel* differences_;
};

}  // namespace perilymph::gui
