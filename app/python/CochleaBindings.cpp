// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "Bindings.h"
#include "NumberArrays.h"
#include "ObjectText.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/anatomy/ImportedScala.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/session/Csv.h"

namespace perilymph::python {

namespace {

using anatomy::ScalaTympani;

BuiltCochlea built(const anatomy::Cochlea& cochlea)
{
  auto scala =
      valueOf(withoutLock([&] { return anatomy::buildAnatomy(cochlea, cochlea.patient.label); }));
  BuiltCochlea one;
  one.cochlea = cochlea;
  one.scala = std::move(scala);
  return one;
}

BuiltCochlea fromPatient(const anatomy::Patient& patient)
{
  anatomy::Cochlea cochlea;
  cochlea.patient = patient;
  cochlea.source = sourceScaledBy(measuresOf(patient));
  return built(cochlea);
}

BuiltCochlea fromName(const std::string& name)
{
  const auto source = anatomy::anatomySourceNamed(name);
  if (!source) {
    std::string known;
    for (const std::string& each : anatomy::anatomySourceNames())
      known += (known.empty() ? "'" : ", '") + each + "'";
    throw EngineError("There is no anatomy '" + name + "'; there are " + known + ". Name one.");
  }
  anatomy::Cochlea cochlea;
  cochlea.source = *source;
  cochlea.patient.label = name;
  return built(cochlea);
}

BuiltCochlea fromScenario(const session::Scenario& scenario)
{
  BuiltCochlea one = built(scenario.parameters().cochlea);
  one.isOfScenario = true;
  return one;
}

NumberArray anglesOf(const py::object& given, const ScalaTympani& scala)
{
  return numbersOf(given, "angle_deg", "deg", 0.0, inDegrees(scala.lastAngle()));
}

py::array axis(const BuiltCochlea& one, const py::object& angle_deg)
{
  return mappedPoints(anglesOf(angle_deg, *one.scala),
                      [&](double angle) { return one.scala->center_W(degrees(angle).si()); });
}

/// Points of the wall at angles and directions of one shape.
py::array pairedWall(const BuiltCochlea& one, const NumberArray& angles, const NumberArray& around)
{
  std::size_t i = 0;
  return mappedPoints(angles, [&](double angle) {
    return one.scala->wall_W(degrees(angle).si(), degrees(around.values[i++]).si());
  });
}

py::array wall(const BuiltCochlea& one, const py::object& angle_deg, const py::object& around_deg,
               bool paired)
{
  if (paired) {
    const py::object pair =
        py::module_::import("numpy").attr("broadcast_arrays")(angle_deg, around_deg);
    return pairedWall(one, anglesOf(pair[py::int_(0)], *one.scala),
                      numbersOf(pair[py::int_(1)], "around_deg", "deg", -360.0, 360.0));
  }
  const NumberArray angles = anglesOf(angle_deg, *one.scala);
  const NumberArray around = numbersOf(around_deg, "around_deg", "deg", -360.0, 360.0);
  if (around.values.size() != 0 && angles.values.size() > maxValues / around.values.size())
    throw EngineError("angle_deg and around_deg ask for more than " + std::to_string(maxValues) +
                      " points. Divide them.");
  std::vector<double> values = withoutLock([&] {
    std::vector<double> found;
    found.reserve(3 * angles.values.size() * around.values.size());
    for (const double angle : angles.values)
      for (const double direction : around.values) {
        const Eigen::Vector3d point =
            one.scala->wall_W(degrees(angle).si(), degrees(direction).si());
        for (int k = 0; k < 3; ++k) found.push_back(point[k] * 1e3);
      }
    return found;
  });
  std::vector<py::ssize_t> shape = angles.shape;
  shape.insert(shape.end(), around.shape.begin(), around.shape.end());
  shape.push_back(3);
  return arrayOf(std::move(values), std::move(shape));
}

py::array membrane(const BuiltCochlea& one, const py::object& angle_deg, double across)
{
  numberOf(across, "across", "of the width", 0.0, 1.0);
  return mappedPoints(anglesOf(angle_deg, *one.scala), [&](double angle) {
    return one.scala->membrane_W(degrees(angle).si(), across);
  });
}

py::dict sections(const BuiltCochlea& one, double max_step_deg)
{
  numberOf(max_step_deg, "max_step_deg", "deg", 0.1, 90.0);
  const auto rows =
      withoutLock([&] { return analysis::sectionRows(*one.scala, degrees(max_step_deg)); });
  py::dict columns;
  for (auto& [name, values] : analysis::sectionColumns(rows))
    columns[name] = arrayOf(std::move(values));
  return columns;
}

py::dict opening(const BuiltCochlea& one)
{
  const anatomy::Entry entry = one.scala->entry();
  py::dict found;
  found["origin_mm"] = vectorOf(entry.origin_W, 1e3);
  found["out"] = vectorOf(entry.out_W, 1.0);
  found["outward"] = vectorOf(entry.outward_W, 1.0);
  found["vertical"] = vectorOf(entry.vertical_W, 1.0);
  return found;
}

/// Place of a point in the duct: of the turns at its angle, and the lead-in, the one in which its
/// signed distance to the wall is the largest. A point in the lumen is in one turn only.
struct LumenPlace {
  double distance = std::numeric_limits<double>::quiet_NaN();
  double angle = std::numeric_limits<double>::quiet_NaN();
  Eigen::Vector3d normal_W = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

LumenPlace placeIn(const ScalaTympani& scala, const Eigen::Vector3d& point_W)
{
  constexpr double anywhere = 1.0;  // [m]: however far the wall is
  const anatomy::Entry entry = scala.entry();
  // in front of the opening only the inside of a later turn is a place in the lumen
  const bool isInFront = (entry.origin_W - point_W).dot(entry.out_W) < 0.0;
  LumenPlace place;
  const auto look = [&](anatomy::LumenTrack track) {
    anatomy::WallPoint wall;
    scala.nearestWall({&point_W, 1}, {&anywhere, 1}, {&track, 1}, {&wall, 1});
    if (!wall.isNear || wall.distance <= place.distance) return;
    if (isInFront && wall.distance < 0.0) return;
    place = {wall.distance, track.inLeadIn ? 0.0 : track.angle, wall.normal_W};
  };
  const double r = std::hypot(point_W.x(), point_W.y());
  if (!(r > 0.0)) return place;  // on the modiolar axis no angle is defined
  const double theta = std::atan2(point_W.y(), point_W.x());
  const double last = scala.lastAngle().si();
  for (double angle = theta < 0.0 ? theta + 2.0 * pi : theta; angle <= last; angle += 2.0 * pi)
    look({false, angle, {point_W.x() / r, point_W.y() / r}});
  if (point_W.x() > 0.0 && point_W.y() < 0.0) look(scala.startTrack());
  return place;
}

py::dict distance(const BuiltCochlea& one, const py::object& points_mm)
{
  const PointArray given = pointsOf(points_mm, "points_mm");
  std::vector<double> distances, angles, normals;
  withoutLock([&] {
    for (const Eigen::Vector3d& point : given.points) {
      const LumenPlace place = placeIn(*one.scala, point);
      distances.push_back(place.distance * 1e3);
      angles.push_back(inDegrees(radians(place.angle)));
      for (int k = 0; k < 3; ++k) normals.push_back(place.normal_W[k]);
    }
    return true;
  });
  std::vector<py::ssize_t> normalShape = given.shape;
  normalShape.push_back(3);
  py::dict found;
  found["distance_mm"] = arrayOf(std::move(distances), given.shape);
  found["angle_deg"] = arrayOf(std::move(angles), given.shape);
  found["normal"] = arrayOf(std::move(normals), std::move(normalShape));
  return found;
}

/// Measures, taken once. They are kept with the lock.
const std::vector<analysis::Measure>& measuresOf(const BuiltCochlea& one)
{
  if (one.kept->measures.empty()) {
    auto all = withoutLock([&] { return analysis::measure(*one.scala, one.cochlea); });
    if (one.kept->measures.empty()) one.kept->measures = std::move(all);
  }
  return one.kept->measures;
}

py::dict measures(const BuiltCochlea& one)
{
  py::dict found;
  for (const analysis::Measure& each : measuresOf(one)) found[each.key.c_str()] = each.value;
  return found;
}

py::dict measureErrors(const BuiltCochlea& one)
{
  const std::vector<analysis::Measure>& all = measuresOf(one);
  if (!one.kept->errors)
    one.kept->errors = valueOf(withoutLock([&] { return analysis::errorBands(one.cochlea, all); }));
  py::dict found;
  const std::vector<double>& errors = *one.kept->errors;
  for (std::size_t i = 0; i < errors.size(); ++i) found[all[i].key.c_str()] = errors[i];
  return found;
}

/// Points [mm] and triangles of a surface as given.
anatomy::Surface surfaceOf(const py::object& vertices_mm, const py::object& faces)
{
  anatomy::Surface surface;
  for (const Eigen::Vector3d& point : pointsOf(vertices_mm, "vertices_mm").points)
    surface.points.push_back({point.x(), point.y(), point.z()});
  const NumberArray corners =
      numbersOf(faces, "faces", "(indices of vertices)", 0.0,
                static_cast<double>(std::max<std::size_t>(surface.points.size(), 1)) - 1.0);
  if (corners.shape.size() != 2 || corners.shape[1] != 3)
    throw EngineError("faces has no shape (m, 3). Give three indices of vertices for each.");
  for (std::size_t i = 0; i < corners.values.size(); i += 3) {
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = static_cast<int>(corners.values[i + k]);
      if (triangle[k] != corners.values[i + k])
        throw EngineError("faces holds " + session::shortestDecimal(corners.values[i + k]) +
                          ", which is no index. Give whole numbers.");
    }
    surface.triangles.push_back(triangle);
  }
  return surface;
}

BuiltCochlea fromSurface(const py::object& vertices_mm, const py::object& faces,
                         const std::string& label)
{
  const anatomy::Surface surface = surfaceOf(vertices_mm, faces);
  const anatomy::ImportedScala scala =
      valueOf(withoutLock([&] { return anatomy::importScala(surface); }));
  for (const anatomy::ImportDoubt& doubt : scala.doubts)
    if (PyErr_WarnEx(PyExc_UserWarning, std::string(textOf(doubt.sentence)).c_str(), 1) != 0)
      throw py::error_already_set();
  anatomy::Patient patient;
  patient.label = label;
  patient.side = scala.side;
  patient.basalTurn = anatomy::BasalTurn{scala.a, scala.b, scala.h};
  valueOf(anatomy::checkPatient(patient));
  return fromPatient(patient);
}

py::dict surface(const BuiltCochlea& one, int triangles)
{
  numberOf(triangles, "triangles", "(whole numbers)", 200, 1e6);
  const anatomy::Surface wall =
      withoutLock([&] { return anatomy::wallSurface(*one.scala, triangles); });
  std::vector<double> vertices;
  vertices.reserve(3 * wall.points.size());
  for (const auto& point : wall.points)
    for (const double value : point) vertices.push_back(value * 1e3);
  std::vector<std::int64_t> faces;
  faces.reserve(3 * wall.triangles.size());
  for (const auto& triangle : wall.triangles)
    faces.insert(faces.end(), triangle.begin(), triangle.end());
  py::dict found;
  found["vertices_mm"] =
      arrayOf(std::move(vertices), {static_cast<py::ssize_t>(wall.points.size()), 3});
  found["faces"] = arrayOf(std::move(faces), {static_cast<py::ssize_t>(wall.triangles.size()), 3});
  return found;
}

}  // namespace

void defineCochlea(py::module_& module)
{
  module.def("anatomies", &anatomy::anatomySourceNames,
             "Names of the anatomies that need no patient: 'published', 'mean', 'clark'.");
  py::class_<BuiltCochlea> kind(
      module, "Cochlea",
      "The scala tympani of one cochlea. Points are in mm in its frame: z along the modiolus "
      "toward "
      "the apex, angle zero at the center of the round window on the x axis, right ear (a left one "
      "is mirrored). Angles are in degrees from the round window, full turns included.");
  kind.def(
          py::init(&fromPatient), py::arg("patient"),
          "Builds a patient's cochlea: the mean anatomy scaled by A, B and H, or the published one "
          "by three lengths. Takes some tenths of a second.")
      .def_static("named", &fromName, py::arg("anatomy"),
                  "Builds an anatomy by its name (see anatomies()).")
      .def_static("of_scenario", &fromScenario, py::arg("scenario"),
                  "Builds the cochlea of a scenario.")
      .def_static(
          "from_surface", &fromSurface, py::arg("vertices_mm"), py::arg("faces"), py::kw_only(),
          py::arg("label") = "imported",
          "Builds the cochlea of a segmented scala tympani: its wall as vertices (n, 3) [mm] and "
          "faces (m, 3), indices of their corners, in any frame; corners may repeat, as in STL. "
          "The axis, the round window, the side, A, B and H are found in it, and the mean anatomy "
          "is scaled by these, as 'perilymph-cli anatomy --import' measures them; the surface's "
          "own sections are not kept. H comes out 0.2 mm too low where the apex reaches the axis, "
          "as in "
          "the mean anatomy. A surface that raises doubts warns; one that cannot be a "
          "scala tympani is refused. Takes about a second.")
      .def_property_readonly(
          "anatomy", [](const BuiltCochlea& one) { return nameOf(one.cochlea.source); },
          "Name of the anatomy that was scaled.")
      .def_property_readonly(
          "patient", [](const BuiltCochlea& one) { return one.cochlea.patient; },
          "The patient it was built from.")
      .def_property_readonly(
          "last_angle_deg",
          [](const BuiltCochlea& one) { return inDegrees(one.scala->lastAngle()); },
          "Angle of the apex [deg].")
      .def_property_readonly(
          "measured_angle_deg",
          [](const BuiltCochlea& one) { return inDegrees(one.scala->measuredAngle()); },
          "Angle at which measured sections end and extrapolation begins [deg].")
      .def_property_readonly(
          "lead_in_mm", [](const BuiltCochlea& one) { return inMillimeters(one.scala->leadIn()); },
          "Straight length before the round window [mm]. An insertion has that of its scenario in "
          "place of it, unless the cochlea is one of_scenario().")
      .def_property_readonly(
          "_scenario_lead_in_mm",
          [](const BuiltCochlea& one) -> std::optional<double> {
            if (!one.isOfScenario) return std::nullopt;
            return inMillimeters(one.cochlea.leadIn);
          },
          "That of its scenario; None of any other cochlea.")
      .def("axis", &axis, py::arg("angle_deg"),
           "Centers of the sections at angles of shape (...): points (..., 3) [mm].")
      .def("wall", &wall, py::arg("angle_deg"), py::arg("around_deg"), py::kw_only(),
           py::arg("paired") = false,
           "Points of the wall at angles (...) and directions around the section (---), 0 outward, "
           "90 toward the apex [deg]: points (..., ---, 3) [mm]. paired: the angles and directions "
           "are broadcast against each other, as NumPy does: points (..., 3).")
      .def("membrane", &membrane, py::arg("angle_deg"), py::arg("across") = 0.5,
           "Points of the basilar membrane at angles (...), across from 0 (inner edge) to 1 (outer "
           "edge): points (..., 3) [mm].")
      .def("sections", &sections, py::arg("max_step_deg") = 5.0,
           "Sections at equal angles to the apex, as columns of shape (n,): angle, radii, heights, "
           "area, lengths along walls, center and organ of Corti, frequencies; units in the names.")
      .def("opening", &opening,
           "The opening: 'origin_mm' (3,), and the unit vectors (3,) 'out' of the cochlea, "
           "'outward' "
           "to the outer wall and 'vertical'.")
      .def("distance", &distance, py::arg("points_mm"),
           "The lumen at points (..., 3) [mm]: 'distance_mm' (...) to the wall, negative outside; "
           "'angle_deg' (...); 'normal' (..., 3), from the wall into the lumen. NaN where there is "
           "no wall: outside of the opening and on the modiolar axis.")
      .def("measures", &measures,
           "Clinical measures by name with unit: 'A_mm', 'B_mm', ..., as 'perilymph-cli anatomy' "
           "prints them.")
      .def("measure_errors", &measureErrors,
           "Half width of the 95 % interval of each measure by the errors of A, B and H, SD 0.1 mm "
           "where "
           "the patient states none, and for the duct length by the choice of its formula; not by "
           "the error of "
           "the model. Empty without a patient's measures.")
      .def("surface", &surface, py::arg("triangles") = 20000,
           "The wall as triangles, open at the opening: 'vertices_mm' (n, 3) [mm] and 'faces' "
           "(m, 3), indices of corners in the order that makes the normal point outward; m is at "
           "most `triangles`, 200 to 1,000,000.")
      .def(py::pickle(
          [](const BuiltCochlea& one) {
            return py::make_tuple(one.cochlea.patient, std::string(nameOf(one.cochlea.source)),
                                  one.cochlea.leadIn.si(), one.isOfScenario);
          },
          [](const py::tuple& state) {
            anatomy::Cochlea cochlea;
            cochlea.patient = state[0].cast<anatomy::Patient>();
            const auto source = anatomy::anatomySourceNamed(state[1].cast<std::string>());
            if (!source)
              throw EngineError("The pickled cochlea is of another version. Make it again.");
            cochlea.source = *source;
            cochlea.leadIn = Length::fromSi(state[2].cast<double>());
            BuiltCochlea one = built(cochlea);
            // one of a version that did not say so brought its lead-in along
            one.isOfScenario = state.size() < 4 || state[3].cast<bool>();
            return one;
          }))
      .def("__repr__",
           [](const BuiltCochlea& one) {
             std::string size;
             if (const auto& turn = one.cochlea.patient.basalTurn)
               size = ", A " + figures::fixed(inMillimeters(turn->a), 2) + " mm, B " +
                      figures::fixed(inMillimeters(turn->b), 2) + " mm";
             return textOf("<perilymph.Cochlea '" + one.cochlea.patient.label + "', " +
                           nameOf(one.cochlea.source) + size + ", to " +
                           figures::fixed(inDegrees(one.scala->lastAngle()), 0) + " deg>");
           })
      .def(
          "_repr_html_",
          [](const BuiltCochlea& one) {
            std::vector<std::pair<std::string, std::string>> rows{
                {"anatomy", nameOf(one.cochlea.source)}};
            for (const analysis::Measure& each : measuresOf(one))
              rows.emplace_back(each.key, figures::fixed(each.value, 2));
            return htmlTable(one.cochlea.patient.label, rows);
          },
          "A table of its measures for notebooks.");
  defineIdentity(kind, [](const BuiltCochlea& one) {
    return std::string(py::repr(py::make_tuple(py::cast(one.cochlea.patient).attr("__getstate__")(),
                                               std::string(nameOf(one.cochlea.source)),
                                               one.cochlea.leadIn.si(), one.isOfScenario)));
  });
}

}  // namespace perilymph::python
