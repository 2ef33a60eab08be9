#include "perilymph/anatomy/MeanScala.h"

#include "MeanOutlines.h"
#include "OutlineTables.h"

namespace perilymph::anatomy {

Result<std::shared_ptr<const ScalaTympani>> buildMean(Length leadIn)
{
  const auto sections = loadMeasuredSections();
  if (!sections) return sections.error();
  const MeanOutlines mean(*sections);
  const double last = MeanOutlines::lastAngle();
  const OutlineSource source = [&](double angle) {
    return OutlineAtAngle{mean.outline(angle), mean.organOfCorti(angle),
                          membraneWidth(angle, last) * MeanOutlines::capShare(angle)};
  };
  return std::make_shared<const ScalaTympani>(tablesFrom(source, "mean", last, leadIn.si()));
}

}  // namespace perilymph::anatomy
