// SPDX-License-Identifier: MIT
// run_names.hpp - what a run is asked for and how it ends, by name.
#pragma once
#include "convexact/number.hpp"
#include "convexact/run.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kEngineNames = name_table<Engine>(
    {{Engine::Exact, "exact"}, {Engine::Filtered, "filtered"}, {Engine::Float, "float"}});
const char* name_of(Engine engine);

inline constexpr auto kVerifyLevelNames = name_table<VerifyLevel>(
    {{VerifyLevel::None, "none"}, {VerifyLevel::Local, "local"}, {VerifyLevel::Full, "full"}});

const char* name_of(VerifyLevel level);

inline constexpr auto kPrecisionNames =
    name_table<Precision>({{Precision::Binary64, "binary64"}, {Precision::Binary32, "binary32"}});

const char* name_of(Precision precision);

inline constexpr auto kCostMeasureNames =
    name_table<CostMeasure>({{CostMeasure::Volume, "volume"},
                             {CostMeasure::Area, "area"},
                             {CostMeasure::MeanWidth, "mean-width"}});
const char* name_of(CostMeasure measure);

inline constexpr auto kTieProofNames =
    name_table<TieProof>({{TieProof::EqualRationals, "rational"},
                          {TieProof::Congruent, "congruent"},
                          {TieProof::SquareClasses, "square-classes"},
                          {TieProof::NormalForm, "normal-form"},
                          {TieProof::AngleBasis, "angle-basis"},
                          {TieProof::Undecided, "undecided"}});
inline const char* name_of(TieProof proof) { return name_in(kTieProofNames, proof); }

inline constexpr auto kStopReasonNames =
    name_table<StopReason>({{StopReason::Reached, "reached"},
                            {StopReason::GrowthLimit, "growth-limit"},
                            {StopReason::AllUnbounded, "all-unbounded"},
                            {StopReason::AllKeptOrUnbounded, "all-kept-or-unbounded"}});
const char* name_of(StopReason reason);

inline constexpr auto kInnerStopNames =
    name_table<InnerStop>({{InnerStop::Reached, "reached"}, {InnerStop::LossLimit, "loss-limit"}});
inline const char* name_of(InnerStop reason) { return name_in(kInnerStopNames, reason); }

}  // namespace convexact
