// SPDX-License-Identifier: MIT
// Whether the parts of a decomposition lie within a distance of the input's solid.
#include <fmt/format.h>

#include <algorithm>

#include "convexact/reach.hpp"
#include "number/text.hpp"
#include "oracle/parts/judge.hpp"
#include "parts/part_volumes.hpp"
#include "task/parallel.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

struct Found {
  std::size_t part;
  PartReach reach;
};

const char* what_of(const Surface& surface) {
  return surface.is_closed ? "the input's solid" : "the input's surface";
}

// What is known of the parts that are not proven to be within.
class ReachJudge {
 public:
  explicit ReachJudge(PartsTrial& trial)
      : trial_(trial),
        surface_(trial.verdict.surface),
        parts_(trial.verdict.hulls),
        squared_(trial.request.distance->squared(trial.squared_diameter)) {
    if (surface_.is_closed) winding_.emplace(surface_);
  }

  void judge() {
    if (squared_ > 0) ask(squared_);
    if (squared_ == 0) return judge_at_zero();
    if (!beyond_.empty()) return violated();
    if (undecided_.empty() || excess() == Rational(0)) return holds();
    undecided();
  }

 private:
  // Any point outside refutes. A small distance finds one that is easily seen; if there is none,
  // the volume outside is the evidence.
  void judge_at_zero() {
    const std::optional<Rational> volume = excess();
    if (volume == Rational(0)) return holds();
    ask(trial_.squared_diameter / Rational(1 << 20));
    if (!beyond_.empty()) return violated();
    if (!volume) return undecided();
    trial_.violated(WithinSolid, fmt::format("the parts have a volume of {} outside of {}",
                                             to_decimal(*volume, 3), what_of(surface_)));
  }

  void ask(const Rational& squared) {
    const Watch watch = trial_.watch("reach");
    std::vector<BoundingBox> boxes;
    for (const ConvexPart& part : parts_) boxes.push_back(part.box);
    ReachLimit limit(surface_, winding_ ? &*winding_ : nullptr, squared, boxes);
    const std::vector<bool> allowed = limit.allows_each(parts_, jobs_of(trial_.request), watch);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (allowed[k]) continue;
      watch.ask();
      PartReach reach = limit(parts_[k], watch);
      if (reach.reach == Reach::Beyond)
        beyond_.push_back({k, std::move(reach)});
      else if (reach.reach == Reach::Undecided)
        undecided_.push_back({k, std::move(reach)});
    }
  }

  std::optional<Rational> excess() const {
    if (!surface_.is_closed) return {};
    return exact_excess(surface_, parts_, StageWatch{.stop = trial_.log.watch().stop},
                        jobs_of(trial_.request));
  }

  std::string limit_text() const { return describe_distance(*trial_.request.distance); }

  void holds() {
    trial_.holds(WithinSolid, fmt::format("no point of a part is farther than {} from {}",
                                          limit_text(), what_of(surface_)));
  }

  Witness witness_of(const Found& found) const {
    Witness witness;
    witness.parts = {found.part};
    if (const auto& far = found.reach.witness) {
      witness.point = far->point;
      witness.nearest = far->nearest;
      witness.squared_distance = far->squared;
    }
    return witness;
  }

  void violated() {
    const Found& worst =
        *std::max_element(beyond_.begin(), beyond_.end(), [](const Found& a, const Found& b) {
          return a.reach.witness->squared < b.reach.witness->squared;
        });
    trial_.violated(
        WithinSolid,
        fmt::format("{} of {} {} farther than {}; a point of {} is {} away from {}", beyond_.size(),
                    counted(parts_.size(), "part", "parts"),
                    beyond_.size() == 1 ? "reaches" : "reach", limit_text(),
                    trial_.part_text(worst.part),
                    trial_.distance_text(worst.reach.witness->squared), what_of(surface_)),
        witness_of(worst));
  }

  void undecided() {
    if (undecided_.empty()) {
      return trial_.undecided(WithinSolid,
                              fmt::format("whether no point is outside of {} is not decided: the "
                                          "parts may reach beyond it by less than 0.1% of the "
                                          "diameter",
                                          what_of(surface_)),
                              {});
    }
    const Found& first = undecided_.front();
    trial_.undecided(
        WithinSolid,
        fmt::format("whether {} is within {} is not decided: some point of it may be {} away",
                    trial_.part_text(first.part), limit_text(),
                    trial_.distance_text(first.reach.bracket->high)),
        witness_of(first));
  }

  PartsTrial& trial_;
  const Surface& surface_;
  const std::vector<ConvexPart>& parts_;
  const Rational squared_;
  std::optional<Winding> winding_;
  std::vector<Found> beyond_, undecided_;
};

}  // namespace

void judge_reach(PartsTrial& trial) {
  constexpr const char* kStage = "reach";
  if (!trial.asks(WithinSolid)) return trial.log.skip(kStage, "not requested");
  if (trial.verdict.surface.triangles.empty()) {
    trial.not_applicable(WithinSolid, "the input has no faces");
    return trial.log.skip(kStage, "the input has no faces");
  }
  if (trial.verdict.hulls.empty()) {
    trial.not_applicable(WithinSolid, "there is no part");
    return trial.log.skip(kStage, "there is no part");
  }
  if (trial.squared_diameter == 0) {
    trial.not_applicable(WithinSolid, "the input is a point");
    return trial.log.skip(kStage, "the input is a point");
  }
  trial.log.run(kStage, [&] { ReachJudge(trial).judge(); });
}

}  // namespace convexact::oracle
