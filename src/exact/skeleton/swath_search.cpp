#include "exact/skeleton/swath_search.h"

#include <algorithm>

#include "exact/skeleton/sorted_lists.h"
#include "scene/random_numbers.h"

namespace viewcover::exact {
namespace {

std::size_t hash(const Touch& touch) {
  std::uint64_t h = 0;
  for (const std::size_t point : touch.points) h = mixed(h + point);
  h = mixed(h + touch.points.size());
  for (const std::size_t edge : touch.edges) h = mixed(h + edge);
  return h;
}

Vector3<BigInteger> direction(const LineComponents& line) { return {line[0], line[1], line[2]}; }

}  // namespace

void SwathSearch::run() {
  if (cells_.empty()) return;
  cells_.visit_extremal(
      [&](const Approximation<6, double>& line) { return features_.may_be_pinned(line); },
      [&](StabbingLine line) { add(std::move(line)); });
  add_lines_through_points();
  add_lines_in_planes();
  bool any_changed = true;
  while (any_changed) {
    any_changed = false;
    for (auto& [key, group] : groups_) {
      if (!group.is_changed) continue;
      any_changed = true;
      update(key, group);
    }
  }
}

/// Of the nodes, those that two points pin.
void SwathSearch::add_lines_through_points() {
  const auto& points = features_.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      add(arithmetic_.line(line_through(points[i].x, points[j].x)));
    }
  }
}

/// Of the nodes, those that a point, a plane and an edge pin, where the plane is that of two edges
/// through the point or of a face that the point is in: the form has a double point there, inside
/// a face of dimension 3 of the free cells.
void SwathSearch::add_lines_in_planes() {
  const auto add_all = [&](const FeaturePoint& point, const Vector3<BigInteger>& normal) {
    const BigInteger offset = dot(normal, point.x.x);
    for (const FeatureEdge& edge : features_.edges()) {
      const BigInteger at_a = point.x.w * dot(normal, edge.a.x) - offset * edge.a.w,
                       at_b = point.x.w * dot(normal, edge.b.x) - offset * edge.b.w;
      // An end in the plane need not be a vertex.
      if (sign(at_a) * sign(at_b) > 0 || (sign(at_a) == 0 && sign(at_b) == 0)) continue;
      BigPoint meeting;
      for (std::size_t k = 0; k < 3; ++k) meeting.x[k] = at_a * edge.b.x[k] - at_b * edge.a.x[k];
      meeting.w = at_a * edge.b.w - at_b * edge.a.w;
      add(arithmetic_.line(line_through(point.x, meeting)));
    }
  };
  for (const FeaturePoint& point : features_.points()) {
    for (const EdgePair& pair : point.pairs) {
      add_all(point, cross(direction(features_.edges()[pair.first].components()),
                           direction(features_.edges()[pair.second].components())));
    }
    for (const FeatureFace& face : features_.faces()) {
      if (face.plane.side(point.x) == 0) add_all(point, face.plane.normal);
    }
  }
}

bool SwathSearch::is_limit(StabbingLine line) {
  if (features_.direct(line)) return cells_.is_limit(line);
  if (cells_.is_limit(line)) return true;
  line.reverse();
  return cells_.is_limit(line);
}

/// True if the line is a node that was not known.
bool SwathSearch::add(StabbingLine line) {
  if (line.approximate.size == 0) return false;  // through one point twice
  std::optional<Touch> touch = features_.touch(line);
  if (!touch || !features_.is_pinned(*touch)) return false;
  const std::size_t h = hash(*touch);
  const auto [first, last] = node_by_touch_.equal_range(h);
  for (auto at = first; at != last; ++at) {
    const Node& node = nodes_[at->second];
    if (node.touch == *touch && arithmetic_.are_equal(node.line, line)) return false;
  }
  if (!is_limit(line)) return false;
  const bool both_ways = !features_.direct(line);
  node_by_touch_.emplace(h, nodes_.size());
  std::vector<std::size_t> closed = features_.closed_edges(*touch);
  nodes_.push_back({std::move(line), std::move(*touch), std::move(closed), both_ways});
  register_node(nodes_.size() - 1);
  return true;
}

std::optional<SwathSearch::Key> SwathSearch::key_of(std::size_t e, std::size_t f, std::size_t g,
                                                    const Node& node) const {
  const bool ef = features_.are_coplanar(e, f), eg = features_.are_coplanar(e, g),
             fg = features_.are_coplanar(f, g);
  if (!ef && !eg && !fg) return Key{Kind::kRegulus, {e, f, g}};
  // With two coplanar pairs, lines near touch all three only through a common point.
  if (ef + eg + fg != 1) return std::nullopt;
  if (eg) std::swap(f, g);
  if (fg) {
    std::swap(e, g);
    std::swap(e, f);
  }
  // The line is in the plane of e and f, unless it only meets their common point.
  for (const std::size_t p : node.touch.points) {
    const auto& through = features_.points()[p].edges;
    if (!contains(through, e) || !contains(through, f)) continue;
    const Touch::PinnedPlane plane = {p, e, f};
    const auto& planes = node.touch.planes;
    if (std::find(planes.begin(), planes.end(), plane) == planes.end()) return std::nullopt;
  }
  return Key{Kind::kPlaneAndEdge, {e, f, g}};
}

std::vector<SwathSearch::Key> SwathSearch::keys(const Node& node) const {
  std::vector<Key> result;
  const auto& closed = node.closed_edges;
  for (const std::size_t p : node.touch.points) {
    for (const std::size_t edge : closed) {
      if (!contains(features_.points()[p].edges, edge)) {
        result.push_back({Kind::kPointAndEdge, {p, edge, 0}});
      }
    }
  }
  for (const Touch::PinnedPlane& plane : node.touch.planes) {
    result.push_back({Kind::kPointAndPlane, plane});
  }
  for (std::size_t i = 0; i < closed.size(); ++i) {
    for (std::size_t j = i + 1; j < closed.size(); ++j) {
      for (std::size_t k = j + 1; k < closed.size(); ++k) {
        if (auto key = key_of(closed[i], closed[j], closed[k], node)) result.push_back(*key);
      }
    }
  }
  return result;
}

void SwathSearch::register_node(std::size_t number) {
  const Node& node = nodes_[number];
  for (const Key& key : keys(node)) {
    Group& group = groups_[key];
    group.entries.push_back({number, 1, place_of(node.line, key)});
    if (node.both_ways && key.kind == Kind::kPointAndPlane) {
      group.entries.push_back({number, -1, Surd(0)});
    }
    group.is_changed = true;
  }
}

/// Where a line meets the edge that parametrizes a swath.
Surd SwathSearch::place_of(const StabbingLine& line, const Key& key) const {
  if (key.kind == Kind::kPointAndPlane) return Surd(0);
  const std::size_t number = key.features[key.kind == Kind::kPointAndEdge ? 1 : 0];
  const FeatureEdge& edge = features_.edges()[number];
  return place_on(line, edge.a, edge.b);
}

void SwathSearch::sort(const Key& key, Group& group) const {
  if (key.kind != Kind::kPointAndPlane) {
    std::sort(group.entries.begin(), group.entries.end(),
              [](const Entry& a, const Entry& b) { return a.place < b.place; });
    return;
  }
  // By direction: lines from region to element fill at most a half-plane. The one line in both
  // planes bounds it on either side.
  const auto& edges = features_.edges();
  const auto normal = cross(direction(edges[key.features[1]].components()),
                            direction(edges[key.features[2]].components()));
  const auto turn = [&](const Entry& a, const Entry& b) {
    const auto x = direction(nodes_[a.node].line.a), y = direction(nodes_[b.node].line.a);
    return a.way * b.way * exact::sign(dot(normal, cross(x, y)));
  };
  const auto middle =
      std::partition(group.entries.begin(), group.entries.end(),
                     [&](const Entry& entry) { return !nodes_[entry.node].both_ways; });
  std::sort(group.entries.begin(), middle,
            [&](const Entry& a, const Entry& b) { return turn(a, b) > 0; });
  if (middle == group.entries.begin() || middle == group.entries.end()) return;
  std::rotate(group.entries.begin(), middle, group.entries.end() - 1);
  if (turn(group.entries.front(), group.entries[1]) < 0) {
    std::swap(group.entries.front(), group.entries.back());
  }
}

void SwathSearch::update(const Key& key, Group& group) {
  group.is_changed = false;
  sort(key, group);
  const std::vector<Entry> entries = group.entries;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    const Entry &from = entries[i - 1], &to = entries[i];
    const std::pair pair(from.node, to.node);
    if (group.swaths.count(pair) != 0) continue;
    bool found_node = false;
    auto found = swath(key, group, from, to, found_node);
    if (!found_node) group.swaths.emplace(pair, std::move(found));
  }
}

bool SwathSearch::touches(const Touch& touch, const Key& key) const {
  switch (key.kind) {
    case Kind::kPointAndEdge:
      return contains(touch.points, key.features[0]) && contains(touch.edges, key.features[1]);
    case Kind::kPointAndPlane:
      return std::find(touch.planes.begin(), touch.planes.end(), key.features) !=
             touch.planes.end();
    default:
      return std::all_of(key.features.begin(), key.features.end(),
                         [&](std::size_t edge) { return contains(touch.edges, edge); });
  }
}

/// What the lines between two consecutive nodes touch, if they are a swath. Without an answer if
/// that shows a new node.
std::optional<SwathSearch::Swath> SwathSearch::swath(const Key& key, Group& group,
                                                     const Entry& from, const Entry& to,
                                                     bool& found_node) {
  if (key.kind == Kind::kRegulus) {
    if (group.regulus == nullptr) {
      const auto& edges = features_.edges();
      group.regulus = std::make_unique<Regulus>(arithmetic_, edges[key.features[0]],
                                                edges[key.features[1]], edges[key.features[2]]);
    }
    const StabbingLine line = group.regulus->at(arithmetic_, between(from.place, to.place));
    auto touch = touch_between(key, line, from, to, found_node);
    if (!touch) return std::nullopt;
    found_node = add_zeros_in_regulus(group, from, to);
    return Swath{std::move(*touch), 1};
  }
  const StabbingLine first = nodes_[from.node].line, second = nodes_[to.node].line;
  const bool reverse_first = nodes_[from.node].both_ways,
             reverse_second = nodes_[to.node].both_ways;
  for (const int way : {1, -1}) {
    if (way < 0 && !reverse_first && !reverse_second) break;
    if (key.kind == Kind::kPointAndPlane && way != from.way * to.way) continue;
    StabbingLine a = first, b = second;
    if (way < 0) (reverse_first ? a : b).reverse();
    auto touch = touch_between(key, mean(a, b), from, to, found_node);
    if (found_node) return std::nullopt;
    if (!touch) continue;
    found_node = add_zeros_in_pencil(key, a, b);
    return Swath{std::move(*touch), way};
  }
  return std::nullopt;
}

/// What a line of a swath's pencil or regulus touches, if it lies between two entries and tells
/// that the lines between are a swath.
std::optional<Touch> SwathSearch::touch_between(const Key& key, const StabbingLine& line,
                                                const Entry& from, const Entry& to,
                                                bool& found_node) {
  if (line.approximate.size == 0) return std::nullopt;
  std::optional<Touch> touch = features_.touch(line);
  if (!touch) return std::nullopt;
  if (features_.is_pinned(*touch)) {
    found_node = add(line);
    return std::nullopt;
  }
  if (!touches(*touch, key) || !is_limit(line)) return std::nullopt;
  if (key.kind == Kind::kPointAndEdge || key.kind == Kind::kPlaneAndEdge) {
    // Lines whose places are between may run the other way, outside the shaft.
    const Surd place = place_of(line, key);
    if (!(from.place < place && place < to.place)) return std::nullopt;
  }
  return touch;
}

std::vector<SwathSearch::Arc> SwathSearch::arcs() const {
  std::vector<Arc> result;
  for (const auto& [key, group] : groups_) {
    for (std::size_t i = 1; i < group.entries.size(); ++i) {
      const std::pair pair(group.entries[i - 1].node, group.entries[i].node);
      const auto place = group.swaths.find(pair);
      if (place == group.swaths.end() || !place->second) continue;
      const auto [from, to] = std::minmax(pair.first, pair.second);
      result.push_back({from, to, place->second->touch, place->second->way});
    }
  }
  // A swath with more generators than needed belongs to several groups.
  std::sort(result.begin(), result.end(), [](const Arc& a, const Arc& b) {
    return std::tie(a.from, a.to, a.way, a.touch.points, a.touch.edges) <
           std::tie(b.from, b.to, b.way, b.touch.points, b.touch.edges);
  });
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace viewcover::exact
