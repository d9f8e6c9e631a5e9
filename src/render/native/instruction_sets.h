#pragma once
// The table of instruction sets that the native device's kernels are compiled for.
#include <span>
#include <string>

namespace havs {

struct KernelSet;

/// One row of the table (`--simd`).
struct InstructionSet {
  std::string name;
  std::string description;
  int lanes = 1;
  bool (*available)() = nullptr;  ///< this processor has it
  /// The kernels (render/native/kernels.h) compiled for it.
  const KernelSet& (*kernels)() = nullptr;
};
/// Narrow first: scalar (any processor), and on x86-64 sse4.1, avx2, avx512.
std::span<const InstructionSet> instructionSets();
/// The last row that this processor has.
const InstructionSet& widestInstructionSet();
/// The row of a name, the widest for an empty one. Throws Error{input} for an unknown name, naming the nearest, and
/// Error{running} for one that this processor lacks.
const InstructionSet& instructionSet(const std::string& name);
/// "16 lanes (avx512)"
std::string describe(const InstructionSet& set);

}  // namespace havs
