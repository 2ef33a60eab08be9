// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bone of the CT that is looked at: of the whole volume, then around the measured cochlea.

#include <QObject>
#include <memory>
#include <optional>

#include "gui/pages/ct/CtStudy.h"
#include "gui/run/Background.h"
#include "perilymph/visualization/BoneLayer.h"

namespace perilymph::gui {

/// Follows a study and computes its bone in the background.
class CtBone : public QObject {
  Q_OBJECT
public:
  CtBone(CtStudy& study, QObject* parent);

  /// Bone in P [m]; null while there is none.
  const std::shared_ptr<const visualization::BoneModel>& model() const { return made_.inPatient; }
  /// The same in frame W of the cochlea that is built from the measures; null without measures.
  const std::shared_ptr<const visualization::BoneModel>& inAnatomy() const
  {
    return made_.inAnatomy;
  }
  /// Landmarks of the measured cochlea and contacts of the array in it, in P [m].
  visualization::SceneLandmarks landmarks() const;
  bool isBusy() const { return background_.isBusy(); }
  /// Waits for the bone that is computed.
  void finish() { background_.finish(); }

Q_SIGNALS:
  /// The bone is another one.
  void changed();

private:
  struct Made {
    std::shared_ptr<const visualization::BoneModel> inPatient, inAnatomy;
    visualization::SceneLandmarks landmarks;  ///< In P [m].
  };
  static Made make(const std::shared_ptr<const ct::CtVolume>& volume,
                   const std::shared_ptr<const ct::CochleaMeasures>& measures,
                   const std::stop_token& stop);
  void follow();

  CtStudy& study_;
  Background background_;
  // what was made, or is being made
  std::shared_ptr<const ct::CtVolume> volume_;
  std::shared_ptr<const ct::CochleaMeasures> measures_;
  Made made_;
};

}  // namespace perilymph::gui
