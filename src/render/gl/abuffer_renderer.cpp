// The a-buffer on OpenGL (Carpenter 1984; lists of known length as in Maule et al. 2012): count the fragments of each
// pixel, give each pixel a list of that length, store all fragments in the lists, then sort and composite each list;
// the last two tile by tile, as many rows as fit into memory. Faces come in any order.
#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/memory_budget.h"
#include "gl/check.h"
#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "render/gl/abuffer_tiles.h"
#include "render/gl/drawing_steps.h"
#include "render/gl/layer_buffers.h"
#include "render/gl/lookup_textures.h"
#include "render/gl/mesh_buffers.h"
#include "render/gl/renderers.h"
#include "render/gl/stage_sum.h"

namespace havs {
namespace {

constexpr GLuint kEndsBinding = 3, kFragmentsUnit = 0;  // as in abuffer_lists.glsl, abuffer_sort.glsl
constexpr std::array kZero{0.0f, 0.0f, 0.0f, 0.0f};
constexpr float kMostCount = 1 << 24;  // beyond it, floats do not count by ones

/// Draws within a tile only, while it lives.
class Scissors {
 public:
  explicit Scissors(const Tile& area) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x, area.y, area.width, area.height);
  }
  Scissors(const Scissors&) = delete;
  Scissors& operator=(const Scissors&) = delete;
  ~Scissors() { glDisable(GL_SCISSOR_TEST); }
};

FaceOrder asNumbered(std::size_t faces) {
  FaceOrder order;
  order.faces.resize(faces);
  for (std::size_t f = 0; f < faces; ++f) order.faces[f] = static_cast<Index>(f);
  return order;
}

class ABufferRenderer final : public Renderer {
 public:
  ABufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages, const Progress& progress)
      : plan_(plan),
        count_(programOf(programs_, plan, "count")),
        store_(programOf(programs_, plan, "store")),
        resolve_(programOf(programs_, plan, "resolve")) {
    {
      const ScopedStage timer(stages, "table");
      textures_.emplace(prepared, plan, progress);
    }
    const ScopedStage timer(stages, "upload_mesh");
    mesh_.emplace(prepared);
    mesh_->setOrder(asNumbered(prepared.faces.size()));
    glFinish();
  }

  Drawing draw(const View& view, StageTimes& stages, const Progress&) override {
    layers_.reset();
    if (toComposite_ != nullptr) layers_.emplace(*toComposite_);
    Drawing drawing;
    drawing.image = emptyPicture(view);
    drawing.tiles = 0;
    if (plan_.certificate) drawing.certificate = certificateOf(view);
    makeTargets(std::min(plan_.tileWidth, view.width), std::min(plan_.tileHeight, view.height));
    StageSum drawTime(stages, "draw"), flushTime(stages, "flush"), readTime(stages, "readback");
    for (const Tile& part : tilesOf(view, plan_)) {
      std::vector<std::uint32_t> counts;
      drawTime.time([&] { counts = countFragments(view, part); });
      colorFramebuffer_->clear(0, kZero);
      for (const FragmentTile& tile : cutByFragments(counts, part.width, plan_.mostFragments, layers_.has_value())) {
        drawTime.time([&] { storeFragments(view, part, tile, listBegins(counts, part.width, tile.area)); });
        flushTime.time([&] { resolve(part, tile.area); });
        drawing.fragments += tile.fragments;
        ++drawing.tiles;
      }
      checkGl("drawing");
      readTime.time([&] { readTile(*colorFramebuffer_, part, drawing.image); });
    }
    refuseCutShort(drawing.image);
    if (drawing.certificate) drawing.certificate->fragments = drawing.fragments;
    drawing.fragmentBytes = fragments_ ? fragments_->bytes() : 0;
    return drawing;
  }

  void setLayers(const RayLayers* layers) override { toComposite_ = layers; }

 private:
  /// Pixels that abuffer_resolve.frag has marked.
  static void refuseCutShort(const Image& image) {
    for (std::size_t alpha = 3; alpha < image.rgba.size(); alpha += 4)
      if (image.rgba[alpha] < 0)
        failRunning("a pixel has more fragments than the loops of this OpenGL can sort", "--visibility abuffer",
                    "draw with --visibility kbuffer or cells");
  }

  /// None can come too late: a segment is drawn when all fragments of its pixel lie sorted.
  static Certificate certificateOf(const View& view) {
    Certificate certificate;
    certificate.count.assign(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height), 0);
    return certificate;
  }

  void makeTargets(int width, int height) {
    if (countTarget_ && countTarget_->width() == width && countTarget_->height() == height) return;
    countFramebuffer_.reset();
    colorFramebuffer_.reset();
    countTarget_ = Texture::image2D("fragment counts", GL_R32F, width, height);
    colorTarget_ = Texture::image2D("colour", GL_RGBA32F, width, height);
    countFramebuffer_.emplace("fragment counts", Framebuffer::Targets{*countTarget_});
    colorFramebuffer_.emplace("colour", Framebuffer::Targets{*colorTarget_});
    ends_.emplace("ends of lists",
                  sizeof(std::uint32_t) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }

  /// Of each pixel of `part`, rows from the bottom up.
  std::vector<std::uint32_t> countFragments(const View& view, const Tile& part) {
    countFramebuffer_->bind();
    glViewport(0, 0, part.width, part.height);
    for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST}) glDisable(capability);
    countFramebuffer_->clear(0, kZero);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    useForView(count_, view, part);
    mesh_->drawInBatches([](std::size_t) {});
    glDisable(GL_BLEND);
    return readCounts(part);
  }

  std::vector<std::uint32_t> readCounts(const Tile& part) const {
    const std::vector<float> whole = countFramebuffer_->readFloats(0, GL_RED);
    std::vector<std::uint32_t> counts;
    counts.reserve(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x) {
        const float count = whole[static_cast<std::size_t>(y) * static_cast<std::size_t>(countTarget_->width()) +
                                  static_cast<std::size_t>(x)];
        if (count >= kMostCount)
          failRunning("a pixel has 2^24 fragments or more", "", "draw with --visibility kbuffer or cells");
        counts.push_back(static_cast<std::uint32_t>(count));
      }
    return counts;
  }

  /// `begins`: of the tile's lists. Drawn with the viewport of all of `part`, so that the very pixels are covered that
  /// were counted.
  void storeFragments(const View& view, const Tile& part, const FragmentTile& tile,
                      const std::vector<std::uint32_t>& begins) {
    const auto afterLast = std::span(begins).subspan(1);
    ends_->upload(std::span(begins).first(begins.size() - 1));
    reserve(std::max<std::size_t>(1, tile.fragments));
    bindLists();
    countFramebuffer_->bind();
    glViewport(0, 0, part.width, part.height);
    const Scissors scissors(tile.area);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);  // else llvmpipe drops what opaque triangles hide
    useForView(store_, view, part);
    store_.set("firstBoundaryVertex", mesh_->firstBoundaryVertex());
    setTile(store_, tile.area);
    mesh_->drawInBatches([&](std::size_t first) { store_.set("firstFace", static_cast<int>(first)); });
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    const auto ends = ends_->read<std::uint32_t>(afterLast.size());
    if (!std::equal(ends.begin(), ends.end(), afterLast.begin()))
      failRunning("this OpenGL drew other fragments when they were stored than when they were counted", "",
                  "draw with --visibility kbuffer or cells");
  }

  void reserve(std::size_t fragments) {
    if (fragments_ && fragments_->bytes() >= fragments * kBytesPerFragment) return;
    needMemory(static_cast<double>(fragments) * kBytesPerFragment, "keeping all fragments of a tile", "",
               "draw with --visibility kbuffer or cells");
    fragmentsTexture_.reset();
    fragments_.reset();  // before the larger one is taken
    fragments_.emplace("fragments", fragments * kBytesPerFragment);
    fragmentsTexture_ = Texture::overBuffer("fragments", GL_RG32UI, *fragments_);
  }

  void bindLists() const {
    ends_->bindBase(GL_SHADER_STORAGE_BUFFER, kEndsBinding);
    glBindImageTexture(kFragmentsUnit, fragmentsTexture_->id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RG32UI);
  }

  static void setTile(const Program& program, const Tile& area) {
    program.set("tileCorner", glm::ivec2(area.x, area.y));
    program.set("tileWidth", area.width);
  }

  void resolve(const Tile& part, const Tile& area) {
    colorFramebuffer_->bind();
    const Scissors scissors(area);
    resolve_.use();
    setTile(resolve_, area);
    resolve_.set("terminalOpacity", static_cast<float>(plan_.earlyTermination));
    textures_->bind(resolve_);
    if (layers_) layers_->bind(resolve_, part);
    emptyArray_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
  }

  RenderPlan plan_;
  ProgramCache programs_;
  const Program& count_;
  const Program& store_;
  const Program& resolve_;
  VertexArray emptyArray_{"no vertices"};
  const RayLayers* toComposite_ = nullptr;
  std::optional<LayerBuffers> layers_;
  std::optional<LookupTextures> textures_;
  std::optional<MeshBuffers> mesh_;
  std::optional<Texture> countTarget_, colorTarget_;
  std::optional<Framebuffer> countFramebuffer_, colorFramebuffer_;
  std::optional<Buffer> ends_, fragments_;
  std::optional<Texture> fragmentsTexture_;
};

}  // namespace

std::unique_ptr<Renderer> makeABufferRenderer(const PreparedScene& prepared, const RenderPlan& plan, StageTimes& stages,
                                              const Progress& progress) {
  return std::make_unique<ABufferRenderer>(prepared, plan, stages, progress);
}

}  // namespace havs
