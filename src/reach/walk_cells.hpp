// SPDX-License-Identifier: MIT
// walk_cells.hpp - the order in which the cells that a part meets are visited.
#pragma once
#include <algorithm>
#include <vector>

#include "reach/met_cell.hpp"
#include "reach/reach_cells.hpp"

namespace convexact {

/// What a visit to a cell says about those below it.
enum class Below { Visit, Skip, Stop };

/// Visits cells that a part may meet and that are not fine, from the root on. The cell whose center
/// is farthest from the surface comes first, wherever it is: in a cell along a face, a point that
/// refutes is found late, if at all.
template <class Visit>
class CellOrder {
 public:
  CellOrder(ReachCells& cells, const NearPart& part, Visit visit, std::size_t most_waiting)
      : cells_(cells), part_(part), visit_(std::move(visit)), most_waiting_(most_waiting) {}

  void run() {
    MetCell root{cells_.root(), {}};
    for (std::uint32_t k = 0; k < part_.planes(); ++k) root.planes.push_back(k);
    if (cells_.label(root.place) != ReachCells::Label::Open) return;
    push(std::move(root));
    while (!waiting_.empty() && !is_stopped_) {
      std::pop_heap(waiting_.begin(), waiting_.end(), comes_later);
      const MetCell met = std::move(waiting_.back().met);
      waiting_.pop_back();
      visit(met);
    }
  }

 private:
  struct Waiting {
    double distance;
    std::size_t number;
    MetCell met;
  };
  static bool comes_later(const Waiting& a, const Waiting& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.number > b.number);
  }

  void push(MetCell met) {
    waiting_.push_back({cells_.distance(met.place.cell).low, pushed_++, std::move(met)});
    std::push_heap(waiting_.begin(), waiting_.end(), comes_later);
  }

  // Where too many wait, depth comes first: what waits takes more memory than a cell.
  void visit(const MetCell& met) {
    const Below below = visit_(met);
    is_stopped_ = is_stopped_ || below == Below::Stop;
    if (below != Below::Visit) return;
    MetCell half;
    for (const CellPlace& at : cells_.children(met.place)) {
      if (!met.may_meet(part_, at, half)) continue;
      if (cells_.label(at) != ReachCells::Label::Open) continue;
      if (waiting_.size() < most_waiting_) {
        push(half);
      } else {
        visit(half);
        if (is_stopped_) return;
      }
    }
  }

  ReachCells& cells_;
  const NearPart& part_;
  Visit visit_;
  std::size_t most_waiting_;
  std::vector<Waiting> waiting_;  // a heap
  std::size_t pushed_ = 0;
  bool is_stopped_ = false;
};

/// Of as many cells it is kept that they wait.
inline constexpr std::size_t kMostWaiting = std::size_t{1} << 16;

/// @param visit  Takes a MetCell, returns a Below.
template <class Visit>
void walk_cells(ReachCells& cells, const NearPart& part, Visit visit,
                std::size_t most_waiting = kMostWaiting) {
  CellOrder<Visit>(cells, part, std::move(visit), most_waiting).run();
}

}  // namespace convexact
