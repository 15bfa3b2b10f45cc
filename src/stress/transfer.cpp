// SPDX-License-Identifier: MIT
// Answers and findings as bytes. Both sides are the same program, so the layout is nobody's
// contract.
#include "stress/answer.hpp"
#include "stress/archive.hpp"

namespace convexact {
namespace {

template <class Value>
std::string written(const Value& value) {
  ArchiveWriter archive;
  archive(value);
  return std::move(archive.bytes);
}

template <class Value>
Value read(const std::string& bytes) {
  ArchiveReader archive(bytes);
  Value value;
  archive(value);
  if (!archive.is_at_end()) throw Error(ErrorCode::Malformed, "an answer is too long");
  return value;
}

}  // namespace

template <class Archive>
void fields(Archive& archive, Range& x) {
  archive(x.low, x.high);
}

template <class Archive>
void fields(Archive& archive, StoredBytes& x) {
  archive(x.form, x.precision, x.whole, x.refused, x.why, x.bytes, x.push, x.volume_ratio);
}

template <class Archive>
void fields(Archive& archive, EngineAnswer& x) {
  archive(x.engine, x.end, x.why, x.halfspaces, x.removed, x.costs, x.ties, x.lean_removed,
          x.lean_costs, x.lean_tied, x.left, x.input_volume, x.output_volume, x.claim, x.stored,
          x.seconds, x.memory);
}

template <class Archive>
void fields(Archive& archive, StressStored& x) {
  archive(x.form, x.precision, x.whole, x.outcome, x.violations, x.push, x.volume_ratio, x.why);
}

template <class Archive>
void fields(Archive& archive, StressRun& x) {
  archive(x.family, x.parameter, x.value, x.seed, x.engine, x.end, x.why, x.input, x.at_start,
          x.steps, x.compared, x.seconds, x.memory, x.volume_error, x.cost_error,
          x.first_difference, x.other_ties, x.regret, x.claim, x.stored, x.faults);
}

std::string to_bytes(const EngineAnswer& answer) { return written(answer); }
EngineAnswer answer_from_bytes(const std::string& bytes) { return read<EngineAnswer>(bytes); }
std::string to_bytes(const std::vector<StressRun>& runs) { return written(runs); }
std::vector<StressRun> runs_from_bytes(const std::string& bytes) {
  return read<std::vector<StressRun>>(bytes);
}

}  // namespace convexact
