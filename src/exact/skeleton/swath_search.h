#pragma once

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact/skeleton/free_cells.h"
#include "exact/skeleton/regulus.h"
#include "exact/skeleton/shaft_features.h"

namespace viewcover::exact {

/// Finds the nodes of a skeleton and the swaths between them.
///
/// A swath is a part of a pencil or of a regulus on which lines touch the same. Which ones pass
/// through a node can be read off what it touches (`keys`); the nodes on each, in order, part it
/// into intervals. Along an interval nothing changes: where lines begin or cease to touch
/// something, the lines before, touching more in the limit, are pinned there, so that this is a
/// node. One line inside therefore decides whether all lines inside are limits of free lines. The
/// argument needs all nodes on the swath: between two that are known the others are searched,
/// exactly, among the zeros of the functionals that tell what is touched. An interval ends in a
/// node on either side, as a swath leaves every edge that it is parametrized by at the ends of that
/// edge.
class SwathSearch {
 public:
  struct Node {
    StabbingLine line;
    Touch touch;
    std::vector<std::size_t> closed_edges;
    bool both_ways;  ///< in both planes: lines near may run either way
  };
  struct Arc {
    std::size_t from, to;
    Touch touch;  ///< of the lines between
    int way;      ///< -1 on the other side of an end that lies in both planes

    friend bool operator==(const Arc&, const Arc&) = default;
  };

  SwathSearch(LineArithmetic& arithmetic, const ShaftFeatures& features, FreeCells& cells)
      : arithmetic_(arithmetic), features_(features), cells_(cells) {}

  void run();
  const std::vector<Node>& nodes() const { return nodes_; }
  std::vector<Arc> arcs() const;

 private:
  enum class Kind : std::size_t {
    kPointAndEdge,   ///< lines through a point to an edge
    kPointAndPlane,  ///< lines through a point in the plane of two edges through it
    kRegulus,        ///< lines that meet three edges, pairwise skew
    kPlaneAndEdge    ///< lines in the plane of two edges that meet a third
  };
  struct Key {
    Kind kind;
    std::array<std::size_t, 3> features;

    friend auto operator<=>(const Key&, const Key&) = default;
  };
  struct Entry {
    std::size_t node;
    int way;
    Surd place;
  };
  struct Swath {
    Touch touch;
    int way;
  };
  struct Group {
    std::vector<Entry> entries;  // in order
    std::map<std::pair<std::size_t, std::size_t>, std::optional<Swath>> swaths;
    std::unique_ptr<Regulus> regulus;
    bool is_changed = false;
  };

  void add_lines_through_points();
  void add_lines_in_planes();
  bool add(StabbingLine line);
  bool is_limit(StabbingLine line);
  std::vector<Key> keys(const Node& node) const;
  std::optional<Key> key_of(std::size_t e, std::size_t f, std::size_t g, const Node& node) const;
  void register_node(std::size_t number);
  Surd place_of(const StabbingLine& line, const Key& key) const;
  void sort(const Key& key, Group& group) const;
  void update(const Key& key, Group& group);
  std::optional<Swath> swath(const Key& key, Group& group, const Entry& from, const Entry& to,
                             bool& found_node);
  std::optional<Touch> touch_between(const Key& key, const StabbingLine& line, const Entry& from,
                                     const Entry& to, bool& found_node);
  bool touches(const Touch& touch, const Key& key) const;
  StabbingLine mean(const StabbingLine& a, const StabbingLine& b) const;
  bool add_zeros_in_pencil(const Key& key, const StabbingLine& a, const StabbingLine& b);
  bool add_zero(const StabbingLine& a, const StabbingLine& b, const LineVector& functional);
  bool add_zeros_in_regulus(const Group& group, const Entry& from, const Entry& to);

  LineArithmetic& arithmetic_;
  const ShaftFeatures& features_;
  FreeCells& cells_;
  std::vector<Node> nodes_;
  std::unordered_multimap<std::size_t, std::size_t> node_by_touch_;
  std::map<Key, Group> groups_;
};

}  // namespace viewcover::exact
