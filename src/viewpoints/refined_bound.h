#pragma once

#include <memory>
#include <span>
#include <vector>

#include "optim/cover_proof.h"
#include "viewpoints/cell_views.h"
#include "viewpoints/looks.h"
#include "viewpoints/pool_cover.h"

namespace viewcover {

/// A lower bound on the number of viewpoints and its certificate: cells that tile the regions, what
/// they see of some elements, and a proof that no fewer cells see all of these.
///
/// Every viewpoint lies in a cell and sees no more than it (viewpoints/region_views.h), so with an
/// exact backend no fewer viewpoints see everything (papers/viewpoints.md).
struct RefinedBound {
  std::size_t lower_bound = 0;
  std::vector<RegionAddress> cells;  ///< rows, ascending
  BitRows seen;                      ///< #cells x #columns; columns that were not asked are empty
  std::shared_ptr<const CoverProof> proof;  ///< of lower_bound, for the canonical matrix of `seen`
};

/// Raises the bound by splitting the cells that carry it.
///
/// The cells are the regions at first. Each round finds a smallest cover by cells and the prices of
/// its linear programme; cells of the cover, and others whose columns cost 1 together, are replaced
/// by their four children, each decided against the columns that its parent sees. A child sees no
/// more than its parent, so the bound never falls. Only columns that are named are looked at: any
/// set of columns gives a bound, and few of them decide it.
/// Not safe for concurrent use; decides in parallel.
class BoundRefinement {
 public:
  /// The views and limits must outlive the refinement. `effort`: for each smallest cover by cells.
  BoundRefinement(const CellViews& views, std::span<const std::uint32_t> columns,
                  SearchLimits& limits, std::uint64_t seed, const PoolCoverEffort& effort = {});

  /// Names further columns; those that were named before stay. Cost: a decision for each of them
  /// and each cell below a region that sees it.
  void ask(std::span<const std::uint32_t> columns);

  /// One round. False if the limits expired or no cell can be split. Errors: Interrupted.
  bool refine();

  std::size_t lower_bound() const { return bound_.lower_bound; }
  /// Cells there are.
  std::size_t size() const { return cells_.size(); }
  /// Where viewpoints may be that do as the last cover by cells: the middle of each of its cells.
  const std::vector<Look>& middles_of_cover() const { return middles_; }
  /// The best bound so far.
  const RefinedBound& bound() const { return bound_; }

 private:
  /// What each cell sees, and what others lend it.
  BitRows rows() const;
  void keep_proof(const BitRows& rows);
  void find_middles();
  std::vector<std::size_t> cells_to_split(const BitRows& rows) const;
  void split(std::span<const std::size_t> parents);

  const CellViews& views_;
  SearchLimits& limits_;
  std::uint64_t seed_;
  PoolCoverEffort effort_;
  std::vector<RegionCell> cells_;
  std::vector<std::vector<BitRows::Word>> seen_;            ///< by cell
  std::vector<std::pair<std::size_t, std::size_t>> lends_;  ///< by which rows grow
  std::vector<BitRows::Word> asked_;
  std::vector<std::size_t> cover_;  ///< cells of the last cover
  std::vector<double> prices_;
  std::vector<Look> middles_;
  RefinedBound bound_;
};

}  // namespace viewcover
