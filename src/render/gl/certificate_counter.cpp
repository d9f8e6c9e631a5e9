#include "render/gl/certificate_counter.h"

namespace havs {
namespace {

std::size_t pixelsOf(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

Certificate emptyCertificate(int width, int height) {
  Certificate certificate;
  certificate.count.assign(pixelsOf(width, height), 0);
  return certificate;
}

CertificateCounter::CertificateCounter(int width, int height)
    : counts_("late fragments", pixelsOf(width, height) * sizeof(std::uint32_t)) {
  glCreateQueries(GL_SAMPLES_PASSED, 1, &query_);
}

CertificateCounter::~CertificateCounter() { glDeleteQueries(1, &query_); }

void CertificateCounter::begin(const Program& program, const Tile& tile) {
  counts_.clear();
  counts_.bindBase(GL_SHADER_STORAGE_BUFFER, kLateFragmentsBinding);
  program.set("pixelsPerRow", tile.width);
  glBeginQuery(GL_SAMPLES_PASSED, query_);
}

void CertificateCounter::end() { glEndQuery(GL_SAMPLES_PASSED); }

void CertificateCounter::addTo(Certificate& certificate, const Tile& tile, int pictureHeight) const {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  GLuint64 fragments = 0;
  glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &fragments);
  certificate.fragments += fragments;
  const auto counts = counts_.read<std::uint32_t>(pixelsOf(tile.width, tile.height));
  const std::size_t pictureWidth = certificate.count.size() / static_cast<std::size_t>(pictureHeight);
  auto count = counts.begin();
  for (int y = tile.y; y < tile.y + tile.height; ++y)
    for (int x = tile.x; x < tile.x + tile.width; ++x, ++count) {
      if (*count == 0) continue;
      certificate.misordered += *count;
      ++certificate.pixels;
      certificate.count[static_cast<std::size_t>(pictureHeight - 1 - y) * pictureWidth + static_cast<std::size_t>(x)] =
          *count;
    }
}

}  // namespace havs
