#include "render/gl/lookup_textures.h"

namespace havs {

LookupTextures::LookupTextures(const PreparedScene& prepared, const RenderPlan& plan, const Progress& progress) {
  for (const ResourceData& resource : makeResources(prepared, plan, progress)) {
    for (const auto& [name, table] : resource.tables) {
      if (table.sizes.size() == 1) {
        addTexels(name, table);
      } else {
        addFiltered(name, table, plan.tableFormat);
      }
    }
    for (const auto& [name, number] : resource.numbers)
      std::visit([&, &uniform = uniforms_[name]](auto n) { uniform = n; }, number);
    rows_.insert(resource.rows.begin(), resource.rows.end());
  }
}

void LookupTextures::addTexels(const std::string& name, const ResourceTable& table) {
  buffers_.push_back(Buffer::of(name, table.values));
  samplers_.emplace(name, Texture::overBuffer(name, table.components == 1 ? GL_R32F : GL_RGBA32F, buffers_.back()));
}

void LookupTextures::addFiltered(const std::string& name, const ResourceTable& table, const TableFormat& format) {
  const auto& sizes = table.sizes;
  Texture texture = sizes.size() == 2 ? Texture::image2D(name, format.internalFormat, sizes[0], sizes[1])
                                      : Texture::image3D(name, format.internalFormat, sizes[0], sizes[1], sizes[2]);
  texture.upload(GL_RGBA, std::span<const float>(table.values));
  if (!format.filteredInShader) texture.filter(GL_LINEAR);
  // These put 0 on the middle of the first texel of each axis and 1 on the middle of the last.
  const glm::vec3 size(texture.width(), texture.height(), texture.depth());
  uniforms_["tableScale"] = (size - 1.0f) / size;
  uniforms_["tableBias"] = 0.5f / size;
  samplers_.emplace(name, std::move(texture));
}

void LookupTextures::bind(const Program& program) const {
  GLuint unit = 0;
  for (const auto& [name, texture] : samplers_) {
    texture.bind(unit);
    program.set(name.c_str(), static_cast<int>(unit++));
  }
  for (const auto& [name, value] : uniforms_)
    std::visit([&, &uniform = name](const auto& v) { program.set(uniform.c_str(), v); }, value);
  for (const auto& [name, row] : rows_) program.set(name.c_str(), std::span<const float>(row));
}

}  // namespace havs
