// The k-buffer without OpenGL: the mesh's points go into the picture, the faces into order and into lists of the tiles
// that they cover, and threads draw tile after tile, each in its own cache.
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_invoke.h>

#include <atomic>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "render/fragment_values.h"
#include "render/make_renderer.h"
#include "render/native/kernels.h"
#include "render/native/renderers.h"
#include "render/native/tile_worker.h"
#include "render/scene_sorter.h"

namespace havs {
namespace {

constexpr int kTileSide = 64;  // at most kLargestTileStamps stamps
/// (Tile, face) pairs that are kept at once, 4 bytes each: many more than faces only where faces cover many tiles.
constexpr std::size_t kMostPairs = std::size_t{1} << 25;

static_assert(sizeof(std::array<Index, 3>) == sizeof(std::uint32_t[3]));

class NativeKBufferRenderer final : public Renderer {
 public:
  NativeKBufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                        const Progress& progress)
      : prepared_(prepared), plan_(plan), sorter_(makeSceneSorter(prepared, plan.sort, PartOrder::itsOwn)) {
    const InstructionSet& instructions = instructionSet(plan.instructionSet);
    {
      const ScopedStage timer(stages, "table");
      shader_.emplace(prepared, plan, instructions, progress);
    }
    const KernelSet& kernels = instructions.kernels();
    setting_.kernel = kernels.tileKernel(plan.k, plan.lookup.carries);
    // With early termination, which fragments a pixel still looks at depends on k: a smaller one may be done before it
    // meets the fragment that shows it to be wrong.
    if (plan.speculate && plan.k > 1 && !(plan.earlyTermination > 0))
      setting_.ordered = kernels.orderedTileKernel(plan.lookup.carries);
    setting_.k = plan.k;
    setting_.attributes = plan.lookup.carries == Payload::color ? 4 : 1;
    setting_.certificate = plan.certificate;
    setting_.compositeLate = plan.compositeLate;
    if (plan.earlyTermination > 0) setting_.terminalOpacity = static_cast<float>(plan.earlyTermination);
    setting_.shader = &*shader_;
    prepareMesh();
  }

  Drawing draw(const View& view, StageTimes& stages, const Progress& progress) override {
    mesh_.width = view.width;
    mesh_.height = view.height;
    const TileGrid grid = tileGrid(view.width, view.height, plan_.tileWidth);
    {
      const ScopedStage timer(stages, "order");
      tbb::parallel_invoke([&] { sorter_->sort(viewPoint(view), order_); },
                           [&] {
                             placePoints(view);
                             bins_.findTiles(mesh_, points_.size(), prepared_.faces, grid);
                           });
    }
    bool late = false;
    Drawing drawing = drawInOrder(view, grid, stages, progress, late);
    if (late) {
      bool better = false;
      {
        const ScopedStage timer(stages, "order");
        better = sorter_->refine(viewPoint(view), order_);
      }
      if (better) drawing = drawInOrder(view, grid, stages, progress, late);
    }
    return drawing;
  }

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
    drawing.image.rgba.assign(4 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height), 0.0f);
    if (plan_.certificate) drawing.certificate.emplace().count.assign(drawing.image.rgba.size() / 4, 0);
    {
      const ScopedStage timer(stages, "upload");
      bins_.count(order_.faces);
    }
    const ScopedStage timer(stages, "draw");
    late = drawTiles(view, grid, drawing, progress);
    drawing.cycles = order_.cycles;
    drawing.tiles = grid.count();
    return drawing;
  }

  void prepareMesh() {
    mesh_.faces = reinterpret_cast<const std::uint32_t(*)[3]>(prepared_.faces.vertices.data());
    mesh_.cellData = prepared_.facts().cellData;
    if (plan_.lookup.carries == Payload::color) {
      if (mesh_.cellData) {
        colorsBehind_ = colorsBehindFaces(prepared_);
        mesh_.colors = reinterpret_cast<const float(*)[4]>(colorsBehind_.data());
      } else {
        colors_ = colorsOfPoints(prepared_);
        mesh_.colors = reinterpret_cast<const float(*)[4]>(colors_.data());
      }
    } else if (mesh_.cellData) {
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
  std::vector<ColorAndExtinction> colors_;    // Payload::color
  std::vector<std::array<ColorAndExtinction, 2>> colorsBehind_;
  FaceOrder order_;
  FaceBins bins_;
};

}  // namespace

void planNativeKBuffer(RenderPlan& plan, const Scene& scene, const Capabilities&) {
  if (scene.targetFormat != "32f")
    failInput("the native device keeps its k-buffer in 32-bit numbers", "--target-format",
              "leave it out, or draw on another device");
  plan.k = scene.k;
  plan.targetFormat = targetFormat(scene.targetFormat);
  const int attributes = plan.lookup.carries == Payload::color ? 4 : 1;
  plan.bytesPerPixel = 4 * (4 + 1 + 2 + plan.k * (2 + attributes)) + (plan.certificate ? 4 : 0);
  plan.tileWidth = plan.tileHeight = kTileSide;
}

std::unique_ptr<Renderer> makeNativeKBufferRenderer(const PreparedScene& prepared, const RenderPlan& plan,
                                                    StageTimes& stages, const Progress& progress) {
  return std::make_unique<NativeKBufferRenderer>(prepared, plan, stages, progress);
}

}  // namespace havs
