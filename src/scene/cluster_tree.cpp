#include "scene/cluster_tree.h"

#include <algorithm>
#include <numeric>

namespace viewcover {
namespace {

/// Something to put into the tree: a surface, or a whole group of them.
struct Item {
  Box box;
  std::uint32_t index;
};

double surface_area(const Box& box) {
  const Point size = box.sizes();
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

/// Splits items where the surface area heuristic is least over all three axes (sweep over sorted
/// centres); returns how many go to the first half. Requires at least 2 items.
std::size_t split(std::span<Item> items) {
  const std::size_t n = items.size();
  double best_cost = INFINITY;
  std::size_t best_count = n / 2;
  int best_axis = 0;
  const auto sort_along = [&](int axis) {
    std::sort(items.begin(), items.end(), [axis](const Item& a, const Item& b) {
      const double ca = a.box.min()[axis] + a.box.max()[axis];
      const double cb = b.box.min()[axis] + b.box.max()[axis];
      return ca != cb ? ca < cb : a.index < b.index;
    });
  };
  std::vector<double> right_cost(n);
  for (int axis = 0; axis < 3; ++axis) {
    sort_along(axis);
    Box box;
    for (std::size_t i = n; i-- > 1;) {
      box.extend(items[i].box);
      right_cost[i] = surface_area(box) * static_cast<double>(n - i);
    }
    box.setEmpty();
    for (std::size_t i = 1; i < n; ++i) {
      box.extend(items[i - 1].box);
      const double cost = surface_area(box) * static_cast<double>(i) + right_cost[i];
      if (cost < best_cost) {
        best_cost = cost;
        best_count = i;
        best_axis = axis;
      }
    }
  }
  if (best_axis != 2) sort_along(best_axis);
  return best_count;
}

}  // namespace

ClusterTree::ClusterTree(const Scene& scene) : places_(scene.surfaces.size()) {
  std::vector<std::vector<Item>> by_group(scene.groups.size());
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    by_group[scene.surfaces[i].group.value].push_back(
        {bounding_box(scene.surfaces[i].polygon), static_cast<std::uint32_t>(i)});
  }
  std::vector<Item> groups;
  for (std::size_t g = 0; g < by_group.size(); ++g) {
    if (by_group[g].empty()) continue;
    Box box;
    for (const Item& item : by_group[g]) box.extend(item.box);
    groups.push_back({box, static_cast<std::uint32_t>(g)});
  }
  nodes_.reserve(2 * scene.surfaces.size());
  leaf_order_.reserve(scene.surfaces.size());

  // Builds the subtree over `items`, whose leaves are made by `leaf`.
  const auto build = [this](const auto& self, std::span<Item> items, const auto& leaf) -> void {
    if (items.size() == 1) {
      leaf(items[0]);
      return;
    }
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    const std::size_t first_half = split(items);
    const std::size_t first = leaf_order_.size();
    self(self, items.first(first_half), leaf);
    nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
    self(self, items.subspan(first_half), leaf);
    nodes_[node].first = static_cast<std::uint32_t>(first);
    nodes_[node].count = static_cast<std::uint32_t>(leaf_order_.size() - first);
    nodes_[node].box = nodes_[node + 1].box.merged(nodes_[nodes_[node].right].box);
  };
  const auto surface_leaf = [this](const Item& item) {
    places_[item.index] = OccluderId(leaf_order_.size());
    nodes_.push_back({item.box, static_cast<std::uint32_t>(leaf_order_.size()), 1, 0});
    leaf_order_.emplace_back(item.index);
  };
  const auto group_leaf = [&](const Item& group) {
    build(build, by_group[group.index], surface_leaf);
  };
  if (!groups.empty()) build(build, groups, group_leaf);
}

}  // namespace viewcover
