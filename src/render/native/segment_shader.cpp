#include "render/native/segment_shader.h"

#include <algorithm>
#include <deque>
#include <string>

#include "core/error.h"
#include "render/lookup_resources.h"
#include "render/native/kernels.h"
#include "render/native/lookup_data.h"
#include "render/native/table_layout.h"

namespace havs {
namespace {

LookupData::Uniform& addUniform(LookupData& data, const std::string& name) {
  if (data.count == LookupData::kMostUniforms)
    failRunning("a lookup reads more than " + std::to_string(LookupData::kMostUniforms) + " tables and numbers", name);
  LookupData::Uniform& uniform = data.uniforms[data.count++];
  uniform.key = nameKey(name.c_str());
  return uniform;
}

void addNumber(LookupData& data, const std::string& name, float number) { addUniform(data, name).number = number; }

void addTable(LookupData& data, const std::string& name, const LaidOutTable& table) {
  LookupData::Uniform& uniform = addUniform(data, name);
  uniform.values = table.values.get();
  uniform.channels = table.channels.get();
  std::copy(table.sizes.begin(), table.sizes.end(), uniform.size);
  std::copy(table.steps.begin(), table.steps.end(), uniform.step);
}

SegmentKernel kernelOf(const Lookup& lookup, const InstructionSet& instructions) {
  const NamedSegmentKernel* row = instructions.kernels().segmentKernels;
  while (row->shader != nullptr && lookup.shader != row->shader) ++row;
  if (row->shader == nullptr)
    failRunning("the lookup '" + lookup.name + "' names a shader that was not built", lookup.shader,
                "its file belongs into shaders/lookup");
  return row->kernel;
}

}  // namespace

struct SegmentShader::Data {
  std::deque<LaidOutTable> tables;  // that `lookup` points into
  LookupData lookup;
  SegmentKernel kernel;
};

SegmentShader::SegmentShader(const PreparedScene& prepared, const RenderPlan& plan, const InstructionSet& instructions,
                             const Progress& progress)
    : data_(std::make_unique<Data>()) {
  data_->kernel = kernelOf(plan.lookup, instructions);
  LookupData& lookup = data_->lookup;
  for (const ResourceData& resource : makeResources(prepared, plan, progress)) {
    for (const auto& [name, table] : resource.tables) addTable(lookup, name, data_->tables.emplace_back(layOut(table)));
    for (const auto& [name, number] : resource.numbers)
      addNumber(lookup, name, std::visit([](auto n) { return static_cast<float>(n); }, number));
    for (const auto& [name, row] : resource.rows)
      addTable(lookup, name, data_->tables.emplace_back(layOut({{static_cast<int>(row.size())}, 1, row})));
  }
  if (plan.lookup.carries == Payload::color)
    addNumber(lookup, "mostExtinction", static_cast<float>(prepared.curve.maximumKappa));
  lookup.lookupNumber = plan.lookup.number;
  lookup.cellData = plan.cellData;
  lookup.opaqueSurfaces = plan.opaqueSurfaces && plan.lookup.carries != Payload::color;
  lookup.isosurfaces = plan.isosurfaces;
  lookup.lit = plan.lookup.carries == Payload::lit;
}

SegmentShader::SegmentShader(SegmentShader&& other) noexcept = default;
SegmentShader::~SegmentShader() = default;

void SegmentShader::shade(SegmentQueue& queue) const { data_->kernel(data_->lookup, queue); }

}  // namespace havs
