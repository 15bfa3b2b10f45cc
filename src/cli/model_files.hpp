// SPDX-License-Identifier: MIT
// model_files.hpp - parts as models for simulators: what a model says beside the shapes, which
// outputs are models, and their bytes.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "cli/parser.hpp"
#include "cli/part_files.hpp"
#include "convexact/decompose.hpp"
#include "convexact/error.hpp"
#include "io/json_document.hpp"
#include "wire/decompose_report.hpp"
#include "wire/model_body.hpp"
#include "wire/written_parts.hpp"

namespace convexact::cli {

/// What models say of the body; no number of a shape depends on it.
struct ModelOptions {
  std::string name;  ///< Of the body; empty: that of the file.
  UpAxis up = UpAxis::Z;
  Rational scale = 1;       ///< Meters for each unit of the file.
  Rational density = 1000;  ///< In kilograms for each cubic meter.
};

/// Adds --name, --up, --scale and --density.
void add_model_options(Command& command, ModelOptions& model);

/// Whether it names the files of the parts, in a folder.
[[nodiscard]] bool names_files(PartsOutput kind);
/// Whether it is a model for simulators.
[[nodiscard]] bool is_model(PartsOutput kind);
/// Whether it holds binary32 numbers: simulators round to these, and GLB has nothing else.
[[nodiscard]] bool is_binary32(PartsOutput kind);

/// The name of a model's file up to its extension.
[[nodiscard]] std::string model_name(const std::string& path, PartsOutput kind);

/// @throws Error InvalidArgument unless parts for models are solids in binary32, in one folder.
void require_sensible_models(const std::vector<std::string>& outputs,
                             const DecomposeRequest& request);

/// The body of all parts, and what to say of it.
struct ModelOfParts {
  ModelBody body;
  Json mass;            ///< For density 1, exactly; with density, scale and kilograms. Null: none.
  std::string summary;  ///< The same as a line; empty: none.
  std::vector<std::string> notes;
};

/// The mass is that of the solids of all objects together; of an open surface that of the union of
/// its parts, with a note. Notes also tell of parts that MuJoCo refuses, if one of the outputs is
/// for it. @throws Error Stopped.
[[nodiscard]] ModelOfParts model_of(std::span<const DecomposedObject> objects,
                                    std::span<const WrittenPart> parts,
                                    const std::vector<std::string>& outputs,
                                    const ModelOptions& options, const Watch& watch);

/// Of one of the outputs, which is a model.
/// @throws Error Unrepresentable if a model cannot hold a name; Internal if a proof fails.
[[nodiscard]] std::string model_bytes(const std::string& path,
                                      const std::vector<std::string>& outputs, ModelBody body,
                                      std::span<const WrittenPart> parts, const std::string& input);

}  // namespace convexact::cli
