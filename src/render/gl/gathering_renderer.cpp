// Modes without an order on OpenGL: every face as it lies in memory, and blending that adds the measures of segments
// (gather.frag) or keeps the greatest or least scalar (extreme.frag).
#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "core/parallel.h"
#include "gl/check.h"
#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "render/gl/cell_buffers.h"
#include "render/gl/drawing_steps.h"
#include "render/gl/lookup_textures.h"
#include "render/gl/mesh_buffers.h"
#include "render/gl/renderers.h"
#include "render/gl/stage_sum.h"
#include "render/gl/tile.h"

namespace havs {
namespace {

GLenum blendEquation(Gathering gathering) {
  switch (gathering) {
    case Gathering::greatest:
      return GL_MAX;
    case Gathering::least:
      return GL_MIN;
    default:
      return GL_FUNC_ADD;
  }
}

class GatheringRenderer final : public Renderer {
 public:
  GatheringRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages, const Progress& progress)
      : plan_(plan), curve_(prepared.curve), program_(programOf(programs_, plan, "gather")) {
    if (sums()) {
      const ScopedStage timer(stages, "table");
      textures_.emplace(prepared, plan, progress);
    }
    const ScopedStage timer(stages, "upload_mesh");
    if (sums()) {
      cells_.emplace(prepared);
    } else {
      faces_.emplace(prepared);
      FaceOrder order;
      order.faces.resize(prepared.faces.size());
      for (std::size_t f = 0; f < order.faces.size(); ++f) order.faces[f] = static_cast<Index>(f);
      faces_->setOrder(order);
    }
    glFinish();
  }

  Drawing draw(const View& view, StageTimes& stages, const Progress&) override {
    makeTarget(std::min(plan_.tileWidth, view.width), std::min(plan_.tileHeight, view.height));
    Drawing drawing;
    drawing.image = emptyPicture(view);
    const std::vector<Tile> tiles = tilesOf(view, plan_);
    drawing.tiles = tiles.size();
    {
      StageSum drawTime(stages, "draw"), readTime(stages, "readback");
      for (const Tile& tile : tiles) {
        drawTime.time([&] { drawTile(view, tile); });
        readTime.time([&] { readTile(*framebuffer_, tile, drawing.image); });
      }
    }
    const ScopedStage timer(stages, "flush");
    auto& rgba = drawing.image.rgba;
    parallelFor(0, rgba.size() / 4, 4096, [&](std::size_t pixel) { plan_.finish(curve_, &rgba[4 * pixel]); });
    return drawing;
  }

 private:
  bool sums() const { return plan_.gathering == Gathering::sum; }

  void makeTarget(int width, int height) {
    if (target_ && target_->width() == width && target_->height() == height) return;
    framebuffer_.reset();
    target_ = Texture::image2D("sums", GL_RGBA32F, width, height);
    framebuffer_.emplace("sums", Framebuffer::Targets{*target_});
  }

  void drawTile(const View& view, const Tile& tile) const {
    framebuffer_->bind();
    glViewport(0, 0, tile.width, tile.height);
    for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE}) glDisable(capability);
    framebuffer_->clear(0, plan_.start);
    useForView(program_, view, tile);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBlendEquation(blendEquation(plan_.gathering));
    if (sums()) {
      program_.set("toView", glm::mat3(glm::dmat3(view.right, view.up, view.forward)));
      program_.set("eye", view.orthographic ? glm::vec4(-view.forward, 0) : glm::vec4(view.eye, 1));
      textures_->bind(program_);
      cells_->bind(program_);
      cells_->draw();
    } else {
      program_.set("firstBoundaryVertex", faces_->firstBoundaryVertex());
      faces_->drawInBatches([&](std::size_t first) { program_.set("firstFace", static_cast<int>(first)); });
    }
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glFinish();
    checkGl("drawing");
  }

  RenderPlan plan_;
  const ExtinctionCurve& curve_;
  ProgramCache programs_;
  const Program& program_;
  std::optional<LookupTextures> textures_;
  std::optional<CellBuffers> cells_;  ///< Gathering::sum
  std::optional<MeshBuffers> faces_;  ///< the others
  std::optional<Texture> target_;
  std::optional<Framebuffer> framebuffer_;
};

}  // namespace

std::unique_ptr<Renderer> makeGatheringRenderer(const PreparedScene& prepared, const RenderPlan& plan,
                                                StageTimes& stages, const Progress& progress) {
  return std::make_unique<GatheringRenderer>(prepared, plan, stages, progress);
}

}  // namespace havs
