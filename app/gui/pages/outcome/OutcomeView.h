// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What was found, in two views: the contacts in the CT, and the plan beside the outcome.

#include <QStringList>
#include <QWidget>
#include <array>
#include <memory>

#include "gui/pages/ct/CtStudy.h"
#include "gui/pages/outcome/PlannedEar.h"
#include "perilymph/charts/UnrolledScala.h"
#include "perilymph/outcome/FoundArray.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class AngleRing;
class DrawingView;
class FoundContacts;
class PlanBeside;
class PlaneView;
class PlotView;

/// Draws a study and the array found in it.
class OutcomeView : public QWidget {
  Q_OBJECT
public:
  OutcomeView(CtStudy& study, QWidget* parent);
  ~OutcomeView() override;

  /// Shows what was found beside a plan; nothing yet if it is null.
  /// @param planDoubt  Why the plan is no prediction, a sentence; empty if it is one.
  /// @param doubts     What else is doubtful about the outcome, a sentence each.
  void show(const std::shared_ptr<const outcome::FoundArray>& found, const PlannedEar& planned,
            const QString& planDoubt, const QStringList& doubts);
  /// Grays values that are found again at the moment.
  void setStale(bool isStale);
  /// The cochlear view with its contacts as a picture.
  QImage picture() const;
  /// The unrolled scala as a drawing on paper.
  figures::Drawing unrolledOnPaper(double width, double height) const;
  void showPlanBeside(bool isShown);

Q_SIGNALS:
  /// A person moved a contact to a point of P [mm].
  void contactMoved(int number, const Eigen::Vector3d& point_P);

private:
  QWidget* addContacts();
  QWidget* addBeside();
  figures::Drawing unrolled(figures::ColorScheme scheme, double width, double height) const;

  CtStudy& study_;
  std::shared_ptr<const outcome::FoundArray> found_;
  PlannedEar planned_;
  std::array<PlaneView*, 3> planes_{};
  QStackedWidget* stages_;
  QPushButton *contactsStage_, *besideStage_;
  QLabel *head_, *flags_, *besideNote_, *besideDoubt_;
  PlotView* unrolled_;
  FoundContacts* table_;
  PlanBeside* beside_;
  AngleRing* ring_;
  DrawingView* forces_;
};

}  // namespace perilymph::gui
