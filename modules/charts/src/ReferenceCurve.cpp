#include "perilymph/charts/ReferenceCurve.h"

#include <sstream>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::charts {

Result<ReferenceCurve> loadReference(const std::filesystem::path& file)
{
  Result<TomlReader> reader = TomlReader::open(file);
  if (!reader) return reader.error();

  ReferenceCurve curve;
  curve.label = reader->text("label");
  curve.source = reader->text("source");
  for (TomlReader& table : reader->tables("point")) {
    ReferencePoint point;
    point.travel_mm = table.number("travel_mm", {0.0, 60.0});
    point.mean_N = table.number("mean_N", {-5.0, 5.0});
    point.sd_N = table.number("sd_N", {0.0, 5.0});
    table.text("source");
    if (!curve.points.empty() && point.travel_mm <= curve.points.back().travel_mm) {
      std::ostringstream sentence;
      sentence << "travel_mm is " << point.travel_mm << ", not above the point before it ("
               << curve.points.back().travel_mm << "). Put the points in the order of travel.";
      table.refuse("travel_mm", sentence.str());
    }
    curve.points.push_back(point);
    if (const Result<Done> finished = table.finish(); !finished) return finished.error();
  }
  if (curve.points.empty())
    reader->refuse("label", "There is no [[point]]; a reference needs at least one.");
  if (const Result<Done> finished = reader->finish(); !finished) return finished.error();
  return curve;
}

Result<ReferenceCurve> publishedExperiment()
{
  return loadReference(resource("resources/reference/todd-naghdy-experiment.toml"));
}

}  // namespace perilymph::charts
