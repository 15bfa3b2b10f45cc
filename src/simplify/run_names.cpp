// SPDX-License-Identifier: MIT
#include "simplify/run_names.hpp"

namespace convexact {

const char* name_of(Engine engine) { return name_in(kEngineNames, engine); }
const char* name_of(CostMeasure measure) { return name_in(kCostMeasureNames, measure); }
const char* name_of(StopReason reason) { return name_in(kStopReasonNames, reason); }
const char* name_of(VerifyLevel level) { return name_in(kVerifyLevelNames, level); }
const char* name_of(Precision precision) { return name_in(kPrecisionNames, precision); }

}  // namespace convexact
