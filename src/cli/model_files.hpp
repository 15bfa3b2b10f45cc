// SPDX-License-Identifier: MIT
// model_files.hpp - outputs of decompose that are models for simulators: their conditions, and the
// paths of the files of the parts.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "cli/part_files.hpp"
#include "convexact/decompose.hpp"
#include "oracle/written_parts.hpp"

namespace convexact::cli {

/// @throws Error InvalidArgument if some output is a model and the numbers are not those of
///               binary32, or parts may stay flat; if it names the files of parts, and the outputs
///               do not have exactly one folder.
void require_model_options(const std::vector<std::string>& outputs, Precision precision,
                           FlatParts flat);

/// @param path     One of the outputs: MJCF, URDF or USD, by parts_output_of().
/// @param outputs  Outputs that require_model_options() accepts.
/// @throws Error   As write_mjcf(), write_urdf() and proven_parts_usd().
[[nodiscard]] std::string model_bytes(const std::string& path,
                                      const std::vector<std::string>& outputs,
                                      std::span<const WrittenPart> parts);

}  // namespace convexact::cli
