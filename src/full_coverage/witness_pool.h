#pragma once

#include <span>
#include <vector>

#include "full_coverage/witnesses.h"
#include "viewpoints/viewpoint.h"

namespace viewcover {

/// Viewpoints to choose from and the witnesses that each sees.
class WitnessPool {
 public:
  explicit WitnessPool(const Witnesses& witnesses) : witnesses_(witnesses) {}

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

 private:
  const Witnesses& witnesses_;
  std::vector<Viewpoint> viewpoints_;
  std::vector<std::vector<BitRows::Word>> seen_;
  std::vector<std::size_t> looked_;  ///< by viewpoint: witnesses looked at
};

}  // namespace viewcover
