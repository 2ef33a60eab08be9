// SPDX-License-Identifier: BSD-3-Clause
#include "RestingPicture.h"

#include <GL/gl.h>
#include <vtkAOSDataArrayTemplate.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkTranslucentPass.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

namespace perilymph::visualization {
namespace {

constexpr int tile_px = 32;
constexpr int margin_px = 2;          // around a triangle: rounding
constexpr vtkIdType smallMesh = 400;  // triangles below which a mesh is drawn whole
constexpr double maxDrawn = 0.75;     // of the tiles; above it, a frame drawn whole costs less

vtkPolyData* meshOf(vtkActor& actor)
{
  vtkMapper* const mapper = actor.GetMapper();
  return mapper == nullptr || mapper->GetNumberOfInputConnections(0) == 0
             ? nullptr
             : vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
}

/// The last change of anything but the colors of points.
vtkMTimeType lastChange(vtkActor& actor)
{
  vtkMTimeType last = actor.GetMTime();
  const auto include = [&last](auto* part) {
    if (part != nullptr) last = std::max(last, part->GetMTime());
  };
  include(actor.GetMapper());
  if (vtkTexture* const texture = actor.GetTexture()) {
    include(texture);
    include(texture->GetInput());
  }
  vtkPolyData* const mesh = meshOf(actor);
  if (mesh == nullptr) return last;
  include(mesh->GetPoints());
  include(mesh->GetPolys());
  include(mesh->GetPointData()->GetNormals());
  include(mesh->GetPointData()->GetTCoords());
  return last;
}

/// Corners of the triangles of a mesh, three each; empty if it has other cells.
std::span<const vtkTypeInt64> cornersOf(vtkPolyData& mesh)
{
  using Corners = vtkAOSDataArrayTemplate<vtkTypeInt64>;
  auto* const corners = vtkArrayDownCast<Corners>(mesh.GetPolys()->GetConnectivityArray());
  if (corners == nullptr || corners->GetNumberOfValues() != 3 * mesh.GetPolys()->GetNumberOfCells())
    return {};
  return {corners->GetPointer(0), static_cast<std::size_t>(corners->GetNumberOfValues())};
}

/// Coordinates of the points of a mesh, three each; empty if they are no floats.
std::span<const float> placesOf(vtkPolyData& mesh)
{
  if (mesh.GetPoints() == nullptr) return {};
  auto* const places = vtkFloatArray::SafeDownCast(mesh.GetPoints()->GetData());
  if (places == nullptr) return {};
  return {places->GetPointer(0), static_cast<std::size_t>(places->GetNumberOfValues())};
}

}  // namespace

struct RestingPicture::Patch {
  std::vector<vtkIdType> corners;
  std::vector<TileRange> tiles;       ///< That each triangle may touch.
  std::vector<unsigned char> colors;  ///< Colors of the points in the kept picture; empty without.
  vtkMTimeType colorsSeen = 0;
  std::vector<std::size_t> recolored;  ///< Triangles whose colors are others than in the picture.
  std::vector<std::size_t> drawn;      ///< Triangles of the last frame.
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  std::unordered_map<vtkActor*, vtkSmartPointer<vtkActor>> actors;
};

vtkStandardNewMacro(RestingPicture)

    RestingPicture::RestingPicture() = default;
RestingPicture::~RestingPicture() = default;

bool RestingPicture::canKeep(const vtkRenderState& state)
{
  vtkRenderer& renderer = *state.GetRenderer();
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer.GetRenderWindow());
  if (window == nullptr || window->GetStereoRender() != 0 || window->GetMultiSamples() > 0 ||
      state.GetFrameBuffer() != nullptr || renderer.GetErase() == 0)
    return false;
  for (int i = 0; i < state.GetPropArrayCount(); ++i) {
    auto* const actor = vtkActor::SafeDownCast(state.GetPropArray()[i]);
    if (actor != nullptr && (actor->GetIsIdentity() == 0 || meshOf(*actor) == nullptr))
      return false;
  }
  return true;
}

RestingPicture::Look RestingPicture::lookOf(const vtkRenderState& state) const
{
  vtkRenderer& renderer = *state.GetRenderer();
  Look look;
  vtkCamera& camera = *renderer.GetActiveCamera();
  const double aspect = renderer.GetTiledAspectRatio();
  std::copy_n(camera.GetModelViewTransformMatrix()->GetData(), 16, look.camera.begin());
  std::copy_n(camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)->GetData(), 16,
              look.camera.begin() + 16);
  renderer.GetTiledSizeAndOrigin(&look.viewport[2], &look.viewport[3], &look.viewport[0],
                                 &look.viewport[1]);
  renderer.GetBackground(look.background.data());
  look.background[3] = renderer.GetBackgroundAlpha();
  for (int i = 0; i < state.GetPropArrayCount(); ++i) {
    auto* const actor = vtkActor::SafeDownCast(state.GetPropArray()[i]);
    if (actor != nullptr && !moving_.contains(actor))
      look.parts.emplace_back(actor, lastChange(*actor));
  }
  return look;
}

void RestingPicture::draw(vtkRenderer& renderer, std::vector<vtkProp*> props)
{
  vtkRenderState state(&renderer);
  state.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  opaque_->Render(&state);
  translucent_->Render(&state);
  NumberOfRenderedProps =
      opaque_->GetNumberOfRenderedProps() + translucent_->GetNumberOfRenderedProps();
}

void RestingPicture::Render(const vtkRenderState* state)
{
  vtkRenderer& renderer = *state->GetRenderer();
  const std::vector<vtkProp*> props(state->GetPropArray(),
                                    state->GetPropArray() + state->GetPropArrayCount());
  drawnFraction_ = 1.0;
  const bool mayKeep = mayKeep_ && canKeep(*state);
  Look look = mayKeep ? lookOf(*state) : Look{};
  if (!mayKeep || look != look_) {  // a picture is kept when the second frame looks like the first
    look_ = std::move(look);
    isKept_ = false;
    return draw(renderer, props);
  }

  auto& window = static_cast<vtkOpenGLRenderWindow&>(*renderer.GetRenderWindow());
  if (!isKept_) keep(*state, window);
  std::fill(tiles_.begin(), tiles_.end(), static_cast<unsigned char>(0));
  for (vtkProp* const prop : props) {
    auto* const actor = vtkActor::SafeDownCast(prop);
    if (actor == nullptr) continue;
    if (moving_.contains(actor))
      markMoving(*actor);
    else
      markRecolored(*actor);
  }
  const auto marked = std::count(tiles_.begin(), tiles_.end(), static_cast<unsigned char>(1));
  drawnFraction_ = static_cast<double>(marked) / static_cast<double>(tiles_.size());
  if (drawnFraction_ > maxDrawn) {
    drawnFraction_ = 1.0;
    markAll();
    openMarkedTiles(renderer, window);
    return draw(renderer, props);
  }
  copyPicture(window, true);
  openMarkedTiles(renderer, window);
  std::vector<vtkProp*> drawn;
  drawn.reserve(props.size());
  for (vtkProp* const prop : props)
    if (vtkProp* const part = patched(prop)) drawn.push_back(part);
  draw(renderer, std::move(drawn));
}

void RestingPicture::keep(const vtkRenderState& state, vtkOpenGLRenderWindow& window)
{
  columns_ = (look_.viewport[2] + tile_px - 1) / tile_px;
  rows_ = (look_.viewport[3] + tile_px - 1) / tile_px;
  tiles_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);

  std::vector<vtkProp*> resting;
  patches_.clear();
  for (int i = 0; i < state.GetPropArrayCount(); ++i) {
    vtkProp* const prop = state.GetPropArray()[i];
    auto* const actor = vtkActor::SafeDownCast(prop);
    if (actor != nullptr && moving_.contains(actor)) continue;
    resting.push_back(prop);
    if (actor != nullptr) planPatch(*actor);
  }
  draw(*state.GetRenderer(), std::move(resting));

  const int* const size = window.GetSize();
  if (!picture_) {
    picture_ = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    picture_->SetContext(&window);
    window.GetState()->PushFramebufferBindings();
    picture_->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, false, 0, 0);
    window.GetState()->PopFramebufferBindings();
  } else {
    picture_->Resize(size[0], size[1]);
  }
  copyPicture(window, false);
  isKept_ = true;
}

/// Copies the colors of the frame into the kept picture, or back.
void RestingPicture::copyPicture(vtkOpenGLRenderWindow& window, bool isRestored)
{
  const auto [left, bottom, width, height] = look_.viewport;
  vtkOpenGLState& state = *window.GetState();
  state.PushFramebufferBindings();
  if (isRestored)
    picture_->Bind(GL_READ_FRAMEBUFFER);
  else
    picture_->Bind(GL_DRAW_FRAMEBUFFER);
  state.vtkglBlitFramebuffer(left, bottom, left + width, bottom + height, left, bottom,
                             left + width, bottom + height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state.PopFramebufferBindings();
}

template <class Use>
void RestingPicture::forTilesOf(vtkActor& actor, Use use)
{
  vtkPolyData& mesh = *meshOf(actor);
  const std::span<const float> points = placesOf(mesh);
  // pixels of the viewport = m * point, in the rows of x, y and w
  const double* const matrix = look_.camera.data() + 16;
  std::array<float, 12> m{};
  for (std::size_t k = 0; k < 4; ++k) {
    m[8 + k] = static_cast<float>(matrix[12 + k]);
    m[k] = static_cast<float>(0.5 * look_.viewport[2] * (matrix[k] + matrix[12 + k]));
    m[4 + k] = static_cast<float>(0.5 * look_.viewport[3] * (matrix[4 + k] + matrix[12 + k]));
  }
  places_px_.resize(points.size() / 3);
  for (std::size_t i = 0; i < places_px_.size(); ++i) {
    const float* const p = points.data() + 3 * i;
    const auto row = [&](std::size_t k) {
      return m[k] * p[0] + m[k + 1] * p[1] + m[k + 2] * p[2] + m[k + 3];
    };
    const float w = row(8);
    places_px_[i] = {row(0) / w, row(4) / w};
  }
  const auto tileAt = [](float place_px, int beyond) {
    return static_cast<int>(std::clamp(std::floor(place_px / tile_px), -1.0F, float(beyond)));
  };
  const std::span<const vtkTypeInt64> corners = cornersOf(mesh);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const auto& a = places_px_[static_cast<std::size_t>(corners[i])];
    const auto& b = places_px_[static_cast<std::size_t>(corners[i + 1])];
    const auto& c = places_px_[static_cast<std::size_t>(corners[i + 2])];
    const auto [left, right] = std::minmax({a[0], b[0], c[0]});
    const auto [bottom, top] = std::minmax({a[1], b[1], c[1]});
    use(TileRange{std::max(0, tileAt(left - margin_px, columns_)),
                  std::max(0, tileAt(bottom - margin_px, rows_)),
                  std::min(columns_ - 1, tileAt(right + margin_px, columns_)),
                  std::min(rows_ - 1, tileAt(top + margin_px, rows_))});
  }
}

/// Prepares the parts of a resting mesh that later frames draw.
void RestingPicture::planPatch(vtkActor& actor)
{
  vtkPolyData& mesh = *meshOf(actor);
  auto* const mapper = vtkOpenGLPolyDataMapper::SafeDownCast(actor.GetMapper());
  // its points must be rounded as those of the whole mesh
  if (mapper == nullptr ||
      mapper->GetVBOShiftScaleMethod() != vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE)
    return;
  Patch& patch = patches_[mapper];
  if (patch.corners.empty()) {
    const auto corners = cornersOf(mesh);
    patch.corners.assign(corners.begin(), corners.end());
    forTilesOf(actor, [&patch](const TileRange& range) { patch.tiles.push_back(range); });
    if (auto* const colors = mesh.GetPointData()->GetScalars()) {
      const auto* const first = static_cast<const unsigned char*>(colors->GetVoidPointer(0));
      patch.colors.assign(first, first + colors->GetNumberOfValues());
      patch.colorsSeen = colors->GetMTime();
    }
    patch.mesh->ShallowCopy(&mesh);  // points, normals and colors are those of the mesh
    patch.mesh->SetPolys(vtkNew<vtkCellArray>());
    patch.mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    patch.mapper->SetScalarVisibility(mapper->GetScalarVisibility());
    patch.mapper->SetScalarMode(mapper->GetScalarMode());
    patch.mapper->SetColorMode(mapper->GetColorMode());
    patch.mapper->SetClippingPlanes(mapper->GetClippingPlanes());
    patch.mapper->SetInputData(patch.mesh);
  }
  auto one = vtkSmartPointer<vtkActor>::New();
  one->ShallowCopy(&actor);
  one->SetMapper(patch.mapper);
  patch.actors[&actor] = one;
}

void RestingPicture::mark(const TileRange& range)
{
  for (int row = range.bottom; row <= range.top; ++row)
    for (int column = range.left; column <= range.right; ++column)
      tiles_[static_cast<std::size_t>(row * columns_ + column)] = 1;
}

void RestingPicture::markAll()
{
  std::fill(tiles_.begin(), tiles_.end(), static_cast<unsigned char>(1));
}

bool RestingPicture::isMarked(const TileRange& range) const
{
  for (int row = range.bottom; row <= range.top; ++row)
    for (int column = range.left; column <= range.right; ++column)
      if (tiles_[static_cast<std::size_t>(row * columns_ + column)] != 0) return true;
  return false;
}

void RestingPicture::markMoving(vtkActor& actor)
{
  forTilesOf(actor, [this](const TileRange& range) { mark(range); });
}

void RestingPicture::markRecolored(vtkActor& actor)
{
  const auto found = patches_.find(actor.GetMapper());
  auto* const colors = meshOf(actor)->GetPointData()->GetScalars();
  if (found == patches_.end() || colors == nullptr) return;
  Patch& patch = found->second;
  if (colors->GetMTime() != patch.colorsSeen) {
    patch.colorsSeen = colors->GetMTime();
    patch.recolored.clear();
    const auto* const now = static_cast<const unsigned char*>(colors->GetVoidPointer(0));
    const auto isOther = [&](vtkIdType point) {
      return std::memcmp(now + 4 * point, patch.colors.data() + 4 * point, 4) != 0;
    };
    for (std::size_t i = 0; i < patch.tiles.size(); ++i)
      if (isOther(patch.corners[3 * i]) || isOther(patch.corners[3 * i + 1]) ||
          isOther(patch.corners[3 * i + 2]))
        patch.recolored.push_back(i);
  }
  for (const std::size_t triangle : patch.recolored) mark(patch.tiles[triangle]);
}

/// Clears the marked tiles, and closes the others by the nearest depth.
void RestingPicture::openMarkedTiles(vtkRenderer& renderer, vtkOpenGLRenderWindow& window)
{
  const auto [left, bottom, width, height] = look_.viewport;
  vtkOpenGLState& state = *window.GetState();
  state.vtkglDepthMask(GL_TRUE);
  state.vtkglClearDepth(0.0);
  state.vtkglClear(GL_DEPTH_BUFFER_BIT);
  state.vtkglClearDepth(1.0);
  double background[3];
  renderer.GetBackground(background);
  state.vtkglClearColor(static_cast<float>(background[0]), static_cast<float>(background[1]),
                        static_cast<float>(background[2]),
                        static_cast<float>(renderer.GetBackgroundAlpha()));
  // runs of tiles in a row, together with equal runs in the rows above it
  std::vector<unsigned char> open = tiles_;
  const auto at = [&](int row, int column) -> unsigned char& {
    return open[static_cast<std::size_t>(row * columns_ + column)];
  };
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      if (at(row, column) == 0) continue;
      int end = column;
      while (end < columns_ && at(row, end) != 0) ++end;
      int top = row;
      const auto isWhole = [&](int which) {
        for (int k = column; k < end; ++k)
          if (at(which, k) == 0) return false;
        return true;
      };
      while (top < rows_ && isWhole(top)) {
        for (int k = column; k < end; ++k) at(top, k) = 0;
        ++top;
      }
      state.vtkglScissor(left + column * tile_px, bottom + row * tile_px,
                         std::min(end * tile_px, width) - column * tile_px,
                         std::min(top * tile_px, height) - row * tile_px);
      state.vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
  state.vtkglScissor(left, bottom, width, height);
}

/// A resting part with the triangles that touch marked tiles only; null without one.
vtkProp* RestingPicture::patched(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  const auto found = actor == nullptr ? patches_.end() : patches_.find(actor->GetMapper());
  if (found == patches_.end()) return prop;
  Patch& patch = found->second;
  const auto part = patch.actors.find(actor);
  if (part == patch.actors.end() || static_cast<vtkIdType>(patch.tiles.size()) < smallMesh)
    return prop;
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < patch.tiles.size(); ++i)
    if (isMarked(patch.tiles[i])) drawn.push_back(i);
  if (drawn != patch.drawn || patch.mesh->GetNumberOfPolys() == 0) {
    patch.drawn = std::move(drawn);
    vtkNew<vtkCellArray> triangles;
    triangles->AllocateExact(static_cast<vtkIdType>(patch.drawn.size()),
                             static_cast<vtkIdType>(3 * patch.drawn.size()));
    for (const std::size_t i : patch.drawn)
      triangles->InsertNextCell(3, patch.corners.data() + 3 * i);
    patch.mesh->SetPolys(triangles);
  }
  if (patch.drawn.empty()) return nullptr;
  // the colors are those of the mesh, which does not tell its copy of their change
  patch.mesh->Modified();
  return part->second;
}

void RestingPicture::ReleaseGraphicsResources(vtkWindow* window)
{
  isKept_ = false;
  opaque_->ReleaseGraphicsResources(window);
  translucent_->ReleaseGraphicsResources(window);
  for (auto& [mapper, patch] : patches_) {
    patch.mapper->ReleaseGraphicsResources(window);
    for (auto& [actor, copy] : patch.actors) copy->ReleaseGraphicsResources(window);
  }
  patches_.clear();
  if (picture_) picture_->ReleaseGraphicsResources(window);
  picture_ = nullptr;
}

}  // namespace perilymph::visualization
