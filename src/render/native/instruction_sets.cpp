#include "render/native/instruction_sets.h"

#include <vector>

#include "core/error.h"
#include "core/find_row.h"
#include "render/native/kernel_sets.h"

namespace havs {

std::span<const InstructionSet> instructionSets() {
  static const std::vector<InstructionSet> rows {
    {"scalar", "one lane, on any processor", 1, [] { return true; }, scalarKernels},
#if HAVS_HAS_sse41
        {"sse4.1", "four lanes", 4, [] { return __builtin_cpu_supports("sse4.1") != 0; }, sse41Kernels},
#endif
#if HAVS_HAS_avx2
        {"avx2", "eight lanes", 8, [] { return __builtin_cpu_supports("avx2") != 0; }, avx2Kernels},
#endif
#if HAVS_HAS_avx512
        {"avx512", "sixteen lanes", 16,
         [] {
           return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                  __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
         },
         avx512Kernels},
#endif
  };
  return rows;
}

const InstructionSet& widestInstructionSet() {
  const auto rows = instructionSets();
  std::size_t widest = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].available()) widest = i;
  return rows[widest];
}

const InstructionSet& instructionSet(const std::string& name) {
  if (name.empty()) return widestInstructionSet();
  const InstructionSet& row = findRow(instructionSets(), name, "instruction set", "--simd");
  if (!row.available())
    failRunning("this processor has no " + row.name, "--simd", "leave it out: the widest that it has is chosen");
  return row;
}

std::string describe(const InstructionSet& set) {
  return std::to_string(set.lanes) + (set.lanes == 1 ? " lane (" : " lanes (") + set.name + ")";
}

}  // namespace havs
