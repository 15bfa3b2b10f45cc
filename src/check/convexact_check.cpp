// SPDX-License-Identifier: MIT
// convexact-check reads a proof and proves a run of convexact, or its parts, again: from the proof
// alone, with GMP's numbers and nothing of convexact. A claim that is not proven is refused, with
// its line.
#include <iostream>
#include <optional>

#include "decomposition.hpp"
#include "partition.hpp"
#include "run.hpp"

namespace {

using namespace check;

// The facts that a proof of any kind proves, and that it is about a mesh file if one is given.
template <class AnyProof>
std::string prove(const std::string& bytes, const std::optional<std::string>& mesh) {
  AnyProof proof(bytes);
  std::string proven = proof.check();
  if (mesh) proven += proof.require_same(*mesh);
  return proven;
}
std::string prove_by_kind(const std::string& bytes, const std::optional<std::string>& mesh) {
  Words words(bytes);
  const bool is_proof = words.take_if("convexact-proof");
  if (is_proof && words.take_if("4")) return prove<DecompositionProof>(bytes, mesh);
  if (is_proof && words.take_if("6")) return prove<PartitionProof>(bytes, mesh);
  return prove<RunProof>(bytes, mesh);
}

// Prints a text and returns the exit code, which is 0 only if all of the text was written.
int say(const std::string& text) {
  if (std::cout << text << std::flush) return 0;
  std::cerr << "convexact-check: standard output cannot be written\n";
  return 5;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string usage =
      "usage: convexact-check PROOF [MESH]\n"
      "exit codes: 0 proven, 1 not proven, 2 wrong usage, 3 malformed, 5 cannot print, 6 memory\n";
  if (argc == 2 && argv[1] == std::string("--help")) return say(usage);
  if (argc < 2 || argc > 3 || argv[1][0] == '-' || argv[argc - 1][0] == '-') {
    std::cerr << usage;
    return 2;
  }
  check::end_if_memory_is_short();
  try {
    const std::string bytes = bytes_of_file(argv[1]);
    return say(
        prove_by_kind(bytes, argc == 3 ? std::optional<std::string>(argv[2]) : std::nullopt));
  } catch (const Failure& failure) {
    std::cerr << "convexact-check: " << failure.where << ": " << failure.what << "\n";
    return failure.exit_code;
  }
}
