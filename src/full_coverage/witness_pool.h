#pragma once

#include <span>
#include <vector>

#include "full_coverage/witnesses.h"
#include "viewpoints/column_bits.h"
#include "viewpoints/viewpoint.h"

namespace viewcover {

/// Viewpoints to choose from, the witnesses that each sees, and which it sees of some elements: of
/// those that have no witness.
class WitnessPool {
 public:
  WitnessPool(const RegionViews& views, const Witnesses& witnesses)
      : views_(views), witnesses_(witnesses) {}

  /// Names the elements, by column; before the first look.
  void set_elements(std::vector<std::size_t> columns) { elements_ = std::move(columns); }

  /// False if it is here already.
  bool add(const Viewpoint& viewpoint);
  /// Looks at what is new: viewpoints or witnesses. In parallel. Cost: a microsecond a pair.
  void look();
  /// Keeps those that are named, ascending.
  void keep(std::span<const std::size_t> rows);

  std::size_t size() const { return viewpoints_.size(); }
  const Viewpoint& operator[](std::size_t index) const { return viewpoints_[index]; }
  /// #viewpoints x #witnesses, as of the last look.
  BitRows rows() const;
  /// The elements named, as columns of the visibility matrix.
  std::span<const std::size_t> elements() const { return elements_; }
  bool sees_element(std::size_t viewpoint, std::size_t column) const {
    return has_column(seen_elements_[viewpoint], column);
  }

 private:
  const RegionViews& views_;
  const Witnesses& witnesses_;
  std::vector<std::size_t> elements_;
  std::vector<Viewpoint> viewpoints_;
  std::vector<std::vector<BitRows::Word>> seen_;
  std::vector<std::vector<BitRows::Word>> seen_elements_;  ///< empty until looked at
  std::vector<std::size_t> looked_;                        ///< by viewpoint: witnesses looked at
};

}  // namespace viewcover
