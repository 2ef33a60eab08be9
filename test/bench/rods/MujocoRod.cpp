// SPDX-License-Identifier: BSD-3-Clause

// MuJoCo's chain of rigid links, with a sphere at each node and two hinges, across the chain, between
// neighbors. Its library has no concave wall: the function that it calls for a sphere and a box is
// replaced by the distance to the tube, which is exact, unlike that to a wall of boxes.

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

#include "RodTrial.h"
#include "perilymph/foundation/Units.h"

namespace {

using namespace perilymph;

// The model is in mm, g and s, so that the inertia of links is far above the least that MuJoCo computes
// with, 1e-15. Forces are then in uN.
constexpr double millimeter = 1e-3;   // [m]
constexpr double micronewton = 1e-6;  // [N]

/// Inertia of each hinge over EI dt^2 / h. That of a link is 5e-7 of it with 100 nodes: its springs, whose
/// force MuJoCo takes from the begin of a step, would need steps of 0.4 us. Forces at rest do not depend on
/// it; with more, contacts yield less, but with 70 and more the pressed tip vibrates as it slides.
constexpr double hingeInertia = 50.0;
/// Inertia of the joints that the hand moves [g, g.mm^2]: so much that the rod does not move them.
constexpr double handInertia = 1e6;
/// Time in which a contact is restored: the least that MuJoCo advises, over the time step.
constexpr double contactTime = 2.0;
/// Part of a contact's penetration that is restored; 0.9999 is the most, and with it the rod vibrates.
constexpr double contactImpedance = 0.999;
/// Stiffness of contacts along the wall over that along its normal.
constexpr double frictionImpedance = 10.0;

/// Links in a file, since nested elements of XML are limited to 100.
constexpr int linksOfAFile = 50;

/// Distance of a sphere from the tube whose radius, bend and lead are the user data of the wall.
/// data->userdata holds for each geometry whether it is in the bend.
int sphereInTube(const mjModel* model, const mjData* data, mjContact* contact, int sphere, int wall,
                 mjtNum margin)
{
  const mjtNum* tube = model->geom_user + model->nuser_geom * wall;
  const mjtNum bend = tube[1], lead = tube[2];
  const mjtNum* at = data->geom_xpos + 3 * sphere;
  mjtNum& isInBend = data->userdata[sphere];
  if (bend > 0.0 && at[2] < -lead) isInBend = 1.0;
  if (at[2] > 0.0) return 0;

  mjtNum out[3] = {at[0], at[1], 0.0};  // from the tube's axis
  if (isInBend > 0.0) {
    const mjtNum x = at[0] + bend, z = at[2] + lead, far = std::hypot(x, z);
    out[0] = x * (1.0 - bend / far);
    out[2] = z * (1.0 - bend / far);
  }
  const mjtNum off = mju_normalize3(out);
  const mjtNum distance = tube[0] - off - model->geom_size[3 * sphere];
  if (distance > margin || off < mjMINVAL) return 0;
  contact->dist = distance;
  mju_copy3(contact->pos, at);  // forces act on the center line, as those of the closed forms
  mju_copy3(contact->frame, out);
  mju_zero3(contact->frame + 3);
  return 1;
}

/// Text with all digits.
std::ostringstream writer()
{
  std::ostringstream text;
  text.precision(17);
  return text;
}

std::string nameOfFile(int firstNode) { return "from" + std::to_string(firstNode) + ".xml"; }

/// Links from a node on, each within the one before. That of the tip has no joints.
std::string links(const bench::RodTrial& trial, int first)
{
  const double h = trial.spacing() / millimeter;
  const double stiffness = trial.rod.bending / (micronewton * millimeter * millimeter) / h;
  const double inertia = hingeInertia * stiffness * bench::rodTimeStep * bench::rodTimeStep;
  const double section = pi * trial.rod.radius * trial.rod.radius;          // [m^2]
  const double mass = 1e3 * trial.rod.density * section * trial.spacing();  // [g]
  const double inertial = mass * h * h;  // [g.mm^2], of the order of a link's
  const int end = std::min(first + linksOfAFile, trial.nodes);
  std::ostringstream xml = writer();
  xml << "<mujocoinclude>";
  for (int i = first; i < end; ++i) {
    xml << "<body pos='0 0 " << -h << "'><inertial pos='0 0 0' mass='" << mass << "' diaginertia='";
    xml << inertial << ' ' << inertial << ' ' << inertial;
    xml << "'/><geom name='node" << i << "' type='sphere' size='" << trial.rod.radius / millimeter
        << "'/>";
    if (i + 1 == trial.nodes) continue;
    for (const char* axis : {"1 0 0", "0 1 0"})
      xml << "<joint axis='" << axis << "' stiffness='" << stiffness << "' damping='"
          << trial.rod.damping * stiffness << "' armature='" << inertia << "'/>";
  }
  if (end < trial.nodes) xml << "<include file='" << nameOfFile(end) << "'/>";
  for (int i = first; i < end; ++i) xml << "</body>";
  xml << "</mujocoinclude>";
  return xml.str();
}

/// All but the links behind node 0.
std::string world(const bench::RodTrial& trial)
{
  std::ostringstream xml = writer();
  xml << "<mujoco><compiler angle='radian'/><size nuser_geom='3' nuserdata='" << trial.nodes + 1
      << "' nconmax='" << trial.nodes << "' njmax='" << 3 * trial.nodes << "' nstack='4000000'/>"
      << "<statistic meaninertia='1'/><option timestep='" << bench::rodTimeStep
      << "' gravity='0 0 0' collision='predefined' cone='elliptic' solver='Newton' "
      << "jacobian='dense' impratio='" << frictionImpedance << "'/>";
  xml << "<worldbody><geom name='wall' type='box' size='1000 1000 1000' user='";
  xml << trial.tube.radius / millimeter << ' ' << trial.tube.bend / millimeter << ' '
      << trial.tube.lead / millimeter;
  xml << "'/><body pos='0 0 " << (trial.rod.length - trial.startInside) / millimeter << "'>"
      << "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>"
      << "<joint type='slide' axis='0 0 -1' armature='" << handInertia << "'/>"
      << "<joint axis='0 -1 0' armature='" << handInertia << "'/>"
      << "<geom name='node0' type='sphere' size='" << trial.rod.radius / millimeter << "'/>"
      << "<include file='" << nameOfFile(1) << "'/></body></worldbody><contact>";
  for (int i = 0; i < trial.nodes; ++i)
    xml << "<pair geom1='node" << i << "' geom2='wall' condim='" << (trial.friction > 0.0 ? 3 : 1)
        << "' friction='" << trial.friction << ' ' << trial.friction << "' solref='"
        << contactTime * bench::rodTimeStep << " 1' solimp='" << contactImpedance << ' '
        << contactImpedance << "'/>";
  xml << "</contact></mujoco>";
  return xml.str();
}

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

std::unique_ptr<mjModel, Free> modelOf(const bench::RodTrial& trial)
{
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const auto add = [&files](const std::string& name, const std::string& text) {
    mj_makeEmptyFileVFS(files.get(), name.c_str(), static_cast<int>(text.size()));
    std::memcpy(files->filedata[files->nfile - 1], text.data(), text.size());
  };
  add("rod.xml", world(trial));
  for (int i = 1; i < trial.nodes; i += linksOfAFile) add(nameOfFile(i), links(trial, i));
  std::array<char, 1000> error{};
  std::unique_ptr<mjModel, Free> model(
      mj_loadXML("rod.xml", files.get(), error.data(), static_cast<int>(error.size())));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(error.data());
  return model;
}

class MujocoRod {
public:
  explicit MujocoRod(const bench::RodTrial& trial) : trial_(trial)
  {
    mjCOLLISIONFUNC[mjGEOM_SPHERE][mjGEOM_BOX] = sphereInTube;
    mju_user_warning = [](const char*) {};  // what it warns of is a large error here
    model_ = modelOf(trial);
    data_.reset(mj_makeData(model_.get()));
    firstNode_ = mj_name2id(model_.get(), mjOBJ_GEOM, "node0");
  }

  void start()
  {
    mj_resetData(model_.get(), data_.get());
    at_ = {};
  }

  void tick(const bench::RodHandAt& hand)
  {
    data_->qpos[0] = at_.pushed / millimeter;
    data_->qpos[1] = at_.turned;
    data_->qvel[0] = hand.speed / millimeter;
    data_->qvel[1] = hand.turnRate;
    mj_step(model_.get(), data_.get());
    at_ = hand;
  }

  /// At rest the hand balances the wall.
  bench::RodForces forces() const
  {
    bench::RodForces forces;
    for (int i = 0; i < trial_.nodes; ++i) {
      const mjtNum* at = data_->geom_xpos + 3 * (firstNode_ + i);
      forces.loads.push_back({millimeter * Eigen::Vector3d(at[0], at[1], at[2]), 0.0});
    }
    for (int i = 0; i < data_->ncon; ++i) {
      const mjContact& contact = data_->contact[i];
      mjtNum along[6], onWall[3];  // in the frame of the contact, and in that of the tube
      mj_contactForce(model_.get(), data_.get(), i, along);
      mju_mulMatTVec(onWall, contact.frame, along, 3, 3);
      forces.push -= micronewton * onWall[2];
      forces.side += micronewton * onWall[0];
      forces.loads[static_cast<std::size_t>(contact.geom1 - firstNode_)].force =
          micronewton * along[0];
    }
    return forces;
  }

private:
  bench::RodTrial trial_;
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
  int firstNode_ = 0;
  bench::RodHandAt at_;
};

void rod(benchmark::State& state, bench::RodQuestion question, double maxPercent)
try {
  bench::rodBy<MujocoRod>(state, question, maxPercent);
} catch (const std::runtime_error& error) {
  state.SkipWithError(error.what());
}

BENCHMARK_CAPTURE(rod, tube, bench::RodQuestion::pressedTip, 0.2)
    ->Name("rod/mujoco/tube")
    ->Apply(bench::rodNodes);
BENCHMARK_CAPTURE(rod, torus, bench::RodQuestion::pushForce, 1.5)
    ->Name("rod/mujoco/torus")
    ->Apply(bench::rodNodes);
BENCHMARK_CAPTURE(rod, capstan, bench::RodQuestion::capstan, 5.0)
    ->Name("rod/mujoco/capstan")
    ->Apply(bench::rodNodes);

}  // namespace
