// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/ReferenceInsertion.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstdint>
#include <stop_token>

namespace perilymph::gui {

namespace {

constexpr double shapeStep = 1e-4;  // [m] of depth; shapes between are interpolated

ReferenceShapes::Shape shapeOf(const haptics::Snapshot& now)
{
  ReferenceShapes::Shape shape;
  shape.depth = now.output.depth;
  for (std::uint32_t i = 0; i < now.nodes; ++i)
    shape.nodes_W.emplace_back(now.node_W[i][0], now.node_W[i][1], now.node_W[i][2]);
  return shape;
}

}  // namespace

std::vector<Eigen::Vector3d> ReferenceShapes::nodesAt(double depth) const
{
  const auto after =
      std::upper_bound(shapes.begin(), shapes.end(), depth,
                       [](double wanted, const Shape& shape) { return wanted < shape.depth; });
  if (shapes.empty()) return {};
  if (after == shapes.begin()) return shapes.front().nodes_W;
  if (after == shapes.end()) return shapes.back().nodes_W;
  const Shape& a = *(after - 1);
  const Shape& b = *after;
  const double fraction = (depth - a.depth) / (b.depth - a.depth);
  std::vector<Eigen::Vector3d> nodes_W;
  for (std::size_t i = 0; i < a.nodes_W.size(); ++i)
    nodes_W.push_back(a.nodes_W[i] + fraction * (b.nodes_W[i] - a.nodes_W[i]));
  return nodes_W;
}

Result<std::shared_ptr<const ReferenceShapes>> readShapes(const std::filesystem::path& file,
                                                          const std::stop_token& stop)
{
  const auto playback = session::Playback::open(file);
  if (!playback) return playback.error();
  const auto computed = (*playback)->compute(stop);
  if (!computed) return computed.error();
  auto read = std::make_shared<ReferenceShapes>();
  read->array = (*playback)->scenario().array();
  haptics::Snapshot now{};
  for (const session::Playback::Sample& sample : (*playback)->samples()) {
    if (!read->shapes.empty() && sample.output.depth < read->shapes.back().depth + shapeStep)
      continue;
    if (const auto done = (*playback)->show(sample.place, now); !done) return done.error();
    read->shapes.push_back(shapeOf(now));
    if (stop.stop_requested()) break;
  }
  return std::shared_ptr<const ReferenceShapes>(std::move(read));
}

QString differenceText(const ReferenceInsertion& reference, const session::ScenarioSubject& current)
{
  const auto tr = [](const char* text) {
    return QCoreApplication::translate("perilymph::gui", text);
  };
  QStringList differences;
  if (reference.subject.array != current.array)
    differences << tr("another array (%1)").arg(QString::fromStdString(reference.subject.array));
  if (reference.subject.cochlea != current.cochlea)
    differences
        << tr("another cochlea (%1)").arg(QString::fromStdString(reference.subject.patient));
  return differences.join(QStringLiteral(", "));
}

}  // namespace perilymph::gui
