// The k-buffer on OpenGL: clear the targets, draw every face in order through kbuffer.frag, flush what is left, read
// the colour back; tile by tile where a picture is larger than its targets may be.
#include <algorithm>
#include <functional>
#include <glm/gtc/type_ptr.hpp>

#include "gl/check.h"
#include "gl/program_cache.h"
#include "light/light_data.h"
#include "render/changes_k.h"
#include "render/gl/certificate_counter.h"
#include "render/gl/done_pixels.h"
#include "render/gl/drawing_steps.h"
#include "render/gl/kbuffer_targets.h"
#include "render/gl/layer_buffers.h"
#include "render/gl/lookup_textures.h"
#include "render/gl/mesh_buffers.h"
#include "render/gl/renderers.h"
#include "render/gl/stage_sum.h"
#include "render/gl/tile.h"
#include "render/make_renderer.h"
#include "render/scene_sorter.h"

namespace havs {

namespace {

/// The largest opacity that a pixel holds (kBelowOne of payload.glsl).
constexpr float kMostOpacity = 0.99999994f;
/// How often pixels that are done are looked for: each time costs as much as a fragment in every pixel.
constexpr std::size_t kMarksAFrame = 16;

class KBufferRenderer final : public Renderer, public ChangesK {
 public:
  KBufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages, const Progress& progress)
      : plan_(plan),
        mostExtinction_(static_cast<float>(prepared.curve.maximumKappa)),
        sorter_(makeSceneSorter(prepared, plan.sort, PartOrder::itsOwn)),
        insert_(programOf(programs_, plan, "insert")),
        flush_(programOf(programs_, plan, "flush")) {
    if (plan.flagsLate) lateFlag_.emplace("late flag", sizeof(std::uint32_t));
    {
      const ScopedStage timer(stages, "table");
      textures_.emplace(prepared, plan, progress);
    }
    if (plan.light.lit) light_.emplace(prepared, plan.light, stages);
    const ScopedStage timer(stages, "upload_mesh");
    mesh_.emplace(prepared, plan.lookup.carries);
    glFinish();
  }

  Drawing draw(const View& view, StageTimes& stages, const Progress&) override {
    makeTargets(std::min(plan_.tileWidth, view.width), std::min(plan_.tileHeight, view.height));
    if (light_) setLight(view, stages);
    FrameTimes times(stages);
    times.order.time([&] { sorter_->sort(viewPointOf(view), order_); });
    times.upload.time([&] { uploadLayers(); });
    Drawing drawing = drawInOrder(view, times);
    if (hasLate(drawing)) {
      bool better = false;
      times.order.time([&] { better = sorter_->refine(viewPointOf(view), order_); });
      if (better) drawing = drawInOrder(view, times);
    }
    return drawing;
  }

  void setLayers(const RayLayers* layers) override { toComposite_ = layers; }

  void changeK(const RenderPlan& plan) override {
    plan_ = plan;
    insert_ = programOf(programs_, plan_, "insert");
    flush_ = programOf(programs_, plan_, "flush");
    targets_.reset();
  }

 private:
  /// Of a frame, whatever it is drawn in. The last of them goes first, and is first in the report.
  struct FrameTimes {
    explicit FrameTimes(StageTimes& stages)
        : readback(stages, "readback"),
          flush(stages, "flush"),
          draw(stages, "draw"),
          upload(stages, "upload"),
          order(stages, "order") {}
    StageSum readback, flush, draw, upload, order;
  };

  Drawing drawInOrder(const View& view, FrameTimes& times) {
    times.upload.time([&] {
      mesh_->setOrder(order_);
      glFinish();
    });
    Drawing drawing;
    drawing.image = emptyPicture(view);
    if (plan_.certificate) drawing.certificate = emptyCertificate(view.width, view.height);
    if (lateFlag_) lateFlag_->clear();
    const std::vector<Tile> tiles = tilesOf(view, plan_);
    for (const Tile& tile : tiles) drawTile(view, tile, drawing, times);
    drawing.cycles = order_.cycles;
    drawing.tiles = tiles.size();
    return drawing;
  }

  void uploadLayers() {
    layers_.reset();
    if (toComposite_ != nullptr) layers_.emplace(*toComposite_);
  }

  bool hasLate(const Drawing& drawing) const {
    if (drawing.certificate) return drawing.certificate->misordered > 0;
    if (!lateFlag_) return false;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return lateFlag_->read<std::uint32_t>(1)[0] != 0;
  }

  void setLight(const View& view, StageTimes& stages) {
    const std::vector<float>& rows = light_->rowsFor(view, stages);
    if (light_->version() != lightVersion_) mesh_->setLight(rows, plan_.light.rowLength);
    lightVersion_ = light_->version();
    const LightPlan& plan = plan_.light;
    const Program& program = insert_;
    const Lighting& l = plan.lighting;
    program.set("lightCoefficients", glm::vec4(l.ambient, l.diffuse, l.specular, l.silhouettes));
    program.set("shininess", l.shininess);
    program.set("modulation", static_cast<float>(plan.modulation));
    program.set("viewRight", glm::vec3(view.right));
    program.set("viewUp", glm::vec3(view.up));
    const std::vector<ViewLight> lights = light_->lightsFor(view);
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const std::string at = "[" + std::to_string(i) + "]";
      program.set(("lightPlaces" + at).c_str(), glm::vec4(glm::vec3(lights[i].place), lights[i].atPlace ? 1.0f : 0.0f));
      program.set(("lightIntensities" + at).c_str(), static_cast<float>(lights[i].intensity));
    }
  }

  void makeTargets(int width, int height) {
    if (targets_ && targets_->width() == width && targets_->height() == height) return;
    targets_.reset();
    counter_.reset();
    targets_.emplace(plan_, width, height);
    if (plan_.marksDonePixels) done_.emplace(programOf(programs_, plan_, "done pixels"));
    if (plan_.certificate) counter_.emplace(width, height);
  }

  void drawTile(const View& view, const Tile& tile, Drawing& drawing, FrameTimes& times) {
    times.draw.time([&] {
      targets_->begin(tile);
      setUniforms(insert_, view, tile);
      if (counter_) counter_->begin(insert_, tile);
      if (lateFlag_) lateFlag_->bindBase(GL_SHADER_STORAGE_BUFFER, kLateFragmentsBinding);
      drawFaces();
      if (counter_) counter_->end();
      glFinish();
    });
    times.flush.time([&] {
      setUniforms(flush_, view, tile);
      emptyArray_.bind();
      glDrawArrays(GL_TRIANGLES, 0, 3);
      glFinish();
    });
    checkGl("drawing");
    times.readback.time([&] {
      targets_->readInto(drawing.image, tile);
      if (counter_) counter_->addTo(*drawing.certificate, tile, drawing.image.height);
    });
  }

  void drawFaces() const {
    const Program& insert = insert_;
    const std::size_t step = std::max<std::size_t>(1, order_.faces.size() / kMarksAFrame);
    std::size_t nextMark = step;
    if (done_) done_->begin();
    mesh_->drawInBatches([&](std::size_t first) {
      if (done_ && first >= nextMark) {
        done_->mark(terminalOpacity());
        insert.use();
        nextMark = first + step;
      }
      insert.set("firstFace", static_cast<int>(first));
    });
    if (done_) done_->end();
  }

  /// At which a pixel is done.
  float terminalOpacity() const {
    return plan_.earlyTermination > 0 ? std::min(static_cast<float>(plan_.earlyTermination), kMostOpacity)
                                      : kMostOpacity;
  }

  void setUniforms(const Program& program, const View& view, const Tile& tile) const {
    useForView(program, view, tile);
    program.set("firstBoundaryVertex", mesh_->firstBoundaryVertex());
    program.set("terminalOpacity", terminalOpacity());
    program.set("mostExtinction", mostExtinction_);
    textures_->bind(program);
    if (layers_) layers_->bind(program, tile);
  }

  RenderPlan plan_;
  float mostExtinction_;
  std::unique_ptr<FaceSorter> sorter_;
  FaceOrder order_;
  ProgramCache programs_;
  std::optional<Buffer> lateFlag_;  ///< whether any fragment came late
  std::reference_wrapper<const Program> insert_;
  std::reference_wrapper<const Program> flush_;
  VertexArray emptyArray_{"no vertices"};
  std::optional<LookupTextures> textures_;
  std::optional<MeshBuffers> mesh_;
  std::optional<LightData> light_;  ///< only where the plan is lit
  std::size_t lightVersion_ = 0;
  const RayLayers* toComposite_ = nullptr;
  std::optional<LayerBuffers> layers_;
  std::optional<KBufferTargets> targets_;
  std::optional<DonePixels> done_;             ///< only where the plan marks them
  std::optional<CertificateCounter> counter_;  ///< only where the plan asks for a certificate
};

}  // namespace

std::unique_ptr<Renderer> makeKBufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                              const Progress& progress) {
  return std::make_unique<KBufferRenderer>(prepared, plan, stages, progress);
}

}  // namespace havs
