// Pictures without OpenGL: the mesh's points go into the picture, the faces into order, where the plan has one, and
// into lists of the tiles that they cover, and threads draw tile after tile, each in its own cache.
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_invoke.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "light/light_data.h"
#include "render/fragment_values.h"
#include "render/make_renderer.h"
#include "render/native/kernels.h"
#include "render/native/renderers.h"
#include "render/native/tile_light_data.h"
#include "render/native/tile_worker.h"
#include "render/scene_sorter.h"
#include "sort/face_order.h"

namespace havs {
namespace {

/// (Tile, face) pairs that are kept at once, 4 bytes each: many more than faces only where faces cover many tiles.
constexpr std::size_t kMostPairs = std::size_t{1} << 25;

constexpr double kLeastDistance = 0.25;  // of the plane that depths are relative to, in radii

static_assert(sizeof(std::array<Index, 3>) == sizeof(std::uint32_t[3]));
static_assert(sizeof(Tetrahedron) == sizeof(std::uint32_t[4]));

class NativeRenderer final : public Renderer {
 public:
  NativeRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages, const Progress& progress)
      : prepared_(prepared), plan_(plan) {
    const InstructionSet& instructions = instructionSet(plan.instructionSet);
    if (!plan.lookup.shader.empty()) {
      const ScopedStage timer(stages, "table");
      shader_.emplace(prepared, plan, instructions, progress);
      setting_.shader = &*shader_;
    }
    if (plan.sort.empty()) {
      order_.faces.resize(plan.gathering == Gathering::sum ? prepared.mesh.tetrahedra.size() : prepared.faces.size());
      std::iota(order_.faces.begin(), order_.faces.end(), Index{0});
    } else {
      sorter_ = makeSceneSorter(prepared, plan.sort, PartOrder::itsOwn);
    }
    if (plan.gathering == Gathering::composite) {
      setKBuffer(instructions.kernels());
    } else {
      setGathering(instructions.kernels());
    }
    if (plan.light.lit) light_.emplace(prepared, plan.light, stages);
    prepareMesh();
  }

  Drawing draw(const View& view, StageTimes& stages, const Progress& progress) override {
    mesh_.parallelRays = view.orthographic;
    // Before the eye, and where the mesh is: differences of depths keep their digits also for a distant eye.
    const double eyeDepth = view.depth(view.eye);
    mesh_.fixedDepth = view.orthographic ? 0 : std::max(0.0, eyeDepth + kLeastDistance);
    mesh_.fixedDistance = view.orthographic ? 1 : mesh_.fixedDepth - eyeDepth;
    mesh_.width = view.width;
    mesh_.height = view.height;
    if (light_) {
      tileLight_ = tileLight(plan_.light, light_->rowsFor(view, stages), light_->lightsFor(view), view);
      setting_.light = &tileLight_;
    }
    const TileGrid grid = tileGrid(view.width, view.height, plan_.tileWidth);
    {
      const ScopedStage timer(stages, "order");
      tbb::parallel_invoke(
          [&] {
            if (sorter_) sorter_->sort(viewPoint(view), order_);
          },
          [&] {
            placePoints(view);
            if (mesh_.cells != nullptr) {
              bins_.findTilesOfCells(mesh_, points_.size(), prepared_.mesh.tetrahedra.size(), grid);
            } else {
              bins_.findTiles(mesh_, points_.size(), prepared_.faces, grid);
            }
          });
    }
    bool late = false;
    Drawing drawing = drawInOrder(view, grid, stages, progress, late);
    if (late && sorter_) {
      bool better = false;
      {
        const ScopedStage timer(stages, "order");
        better = sorter_->refine(viewPoint(view), order_);
      }
      if (better) drawing = drawInOrder(view, grid, stages, progress, late);
    }
    return drawing;
  }

  void setLayers(const RayLayers* layers) override { setting_.layers = layers; }

 private:
  /// With the sides of faces that the fill rule sees.
  static ViewPoint viewPoint(const View& view) {
    ViewPoint point = viewPointOf(view);
    point.sideInPicture = [&view](const Vec3& a, const Vec3& b, const Vec3& c) { return sideOfEye(a, b, c, view); };
    return point;
  }

  Drawing drawInOrder(const View& view, const TileGrid& grid, StageTimes& stages, const Progress& progress,
                      bool& late) {
    Drawing drawing;
    drawing.image.width = view.width;
    drawing.image.height = view.height;
    drawing.image.rgba.resize(4 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
    for (std::size_t i = 0; i < drawing.image.rgba.size(); ++i) drawing.image.rgba[i] = setting_.start[i % 4];
    if (plan_.certificate) drawing.certificate.emplace().count.assign(drawing.image.rgba.size() / 4, 0);
    {
      const ScopedStage timer(stages, "upload");
      bins_.count(order_.faces);
    }
    const ScopedStage timer(stages, "draw");
    late = drawTiles(view, grid, drawing, progress);
    finish(drawing.image);
    drawing.cycles = order_.cycles;
    drawing.tiles = grid.count();
    return drawing;
  }

  void setKBuffer(const KernelSet& kernels) {
    setting_.kernel = kernels.tileKernel(plan_.k, plan_.lookup.carries);
    // With early termination, which fragments a pixel still looks at depends on k: a smaller one may be done before it
    // meets the fragment that shows it to be wrong.
    if (plan_.speculate && plan_.k > 1 && !(plan_.earlyTermination > 0))
      setting_.ordered = kernels.orderedTileKernel(plan_.lookup.carries);
    setting_.k = plan_.k;
    setting_.attributes = numbersOf(plan_.lookup.carries);
    setting_.certificate = plan_.certificate;
    setting_.compositeLate = plan_.compositeLate;
    // Of cell data in any order: of faces in one place, as at an edge that a ray goes through, it knows best.
    setting_.orderIsBelieved = plan_.cellData || sortMethod(plan_.sort).isBelieved;
    if (plan_.earlyTermination > 0) setting_.terminalOpacity = static_cast<float>(plan_.earlyTermination);
  }

  void setGathering(const KernelSet& kernels) {
    setting_.adds = plan_.gathering == Gathering::sum;
    setting_.kernel =
        setting_.adds ? kernels.segmentsOfCells : kernels.extremeKernel(plan_.gathering == Gathering::greatest);
    setting_.start = plan_.start;
    setting_.certificate = plan_.certificate;
    if (!setting_.adds) return;
    mesh_.cells = reinterpret_cast<const std::uint32_t(*)[4]>(prepared_.mesh.tetrahedra.data());
    if (!prepared_.facts().cellData) return;
    ofCells_.assign(prepared_.scalars.begin(), prepared_.scalars.end());
    mesh_.ofCells = ofCells_.data();
  }

  void finish(Image& image) const {
    if (plan_.finish == nullptr) {  // light may make a colour brighter than any picture holds
      parallelFor(0, image.rgba.size(), 1 << 16, [&](std::size_t i) { image.rgba[i] = std::min(image.rgba[i], 1.0f); });
      return;
    }
    parallelFor(0, image.rgba.size() / 4, 4096,
                [&](std::size_t pixel) { plan_.finish(prepared_.curve, &image.rgba[4 * pixel]); });
  }

  void prepareMesh() {
    mesh_.faces = reinterpret_cast<const std::uint32_t(*)[3]>(prepared_.faces.vertices.data());
    mesh_.cellData = prepared_.facts().cellData;
    mesh_.isosurfaces = plan_.isosurfaces;
    if (plan_.lookup.carries == Payload::color) {
      if (mesh_.cellData) {
        colorsBehind_ = colorsBehindFaces(prepared_);
        mesh_.colors = reinterpret_cast<const float(*)[4]>(colorsBehind_.data());
      } else {
        colors_ = colorsOfPoints(prepared_);
        mesh_.colors = reinterpret_cast<const float(*)[4]>(colors_.data());
      }
    } else if (mesh_.cellData && mesh_.cells == nullptr) {
      behind_ = scalarsBehindFaces(prepared_);
      mesh_.behind = reinterpret_cast<const float(*)[2]>(behind_.data());
    }
  }

  void placePoints(const View& view) {
    points_.resize(prepared_.points.size());
    const std::vector<ScreenPoint> placed = screenPoints(prepared_.points, view);
    parallelFor(0, points_.size(), 8192, [&](std::size_t i) {
      static_cast<ScreenPoint&>(points_[i]) = placed[i];
      const bool before = placed[i].w > 0;  // what lies behind the eye has no place
      points_[i].column = before ? placed[i].x / placed[i].w : 0;
      points_[i].row = before ? placed[i].y / placed[i].w : 0;
      points_[i].scalar = mesh_.cellData ? 0.0 : prepared_.scalars[i];
    });
    mesh_.points = points_.data();
  }

  /// Returns whether fragments came late.
  bool drawTiles(const View& view, const TileGrid& grid, Drawing& drawing, const Progress&) {
    tbb::enumerable_thread_specific<TileWorker> workers([&] { return TileWorker(mesh_, view, grid, setting_); });
    for (std::size_t first = 0; first < grid.count();) {
      const std::size_t last = bins_.fill(first, kMostPairs);
      parallelFor(first, last, 1, [&](std::size_t tile) { workers.local().draw(tile, bins_.facesOf(tile), drawing); });
      first = last;
    }
    std::uint64_t fragments = 0, late = 0;
    for (const TileWorker& worker : workers) {
      fragments += worker.fragments();
      late += worker.lateFragments();
    }
    if (drawing.certificate) {
      drawing.certificate->fragments = fragments;
      for (const std::uint32_t ofPixel : drawing.certificate->count) {
        drawing.certificate->misordered += ofPixel;
        drawing.certificate->pixels += ofPixel > 0 ? 1 : 0;
      }
    }
    return late > 0;
  }

  const PreparedScene& prepared_;
  RenderPlan plan_;
  std::unique_ptr<FaceSorter> sorter_;
  std::optional<SegmentShader> shader_;
  TileSetting setting_;
  RasterMesh mesh_{};
  std::vector<RasterPoint> points_;
  std::vector<std::array<float, 2>> behind_;  // cell data
  std::vector<float> ofCells_;                // cell data, Gathering::sum
  std::vector<ColorAndExtinction> colors_;    // Payload::color
  std::vector<std::array<ColorAndExtinction, 2>> colorsBehind_;
  std::optional<LightData> light_;  // Payload::lit
  TileLight tileLight_{};
  FaceOrder order_;
  FaceBins bins_;
};

}  // namespace

std::unique_ptr<Renderer> makeNativeRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                             const Progress& progress) {
  return std::make_unique<NativeRenderer>(prepared, plan, stages, progress);
}

}  // namespace havs
