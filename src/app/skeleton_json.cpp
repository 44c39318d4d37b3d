#include "app/skeleton_json.h"

#include <boost/range/iterator_range.hpp>

namespace viewcover {
namespace {

std::string text(const RootNumber& x) {
  if (x.b == "0") return x.a;
  const std::string root = "sqrt(" + x.root + ")";
  const std::string term = x.b == "1" ? root : x.b == "-1" ? "-" + root : x.b + "*" + root;
  if (x.a == "0") return term;
  return x.a + (term.front() == '-' ? "" : "+") + term;
}

Json coordinates(const Point& p) { return Json{p.x(), p.y(), p.z()}; }

Json to_json(const PolygonName& name) {
  switch (name.role) {
    case PolygonName::Role::kRegion:
      return {{"polygon", "region"}};
    case PolygonName::Role::kElement:
      return {{"polygon", "element"}};
    case PolygonName::Role::kOccluder:
      break;
  }
  return {{"polygon", "occluder"}, {"occluder", name.number}};
}

Json to_json(const Generator& generator) {
  Json json = to_json(generator.polygon);
  json[generator.feature == Generator::Feature::kVertex ? "vertex" : "edge"] = generator.index;
  if (generator.cut == Generator::Cut::kRegionPlane) json["cut"] = "region_plane";
  if (generator.cut == Generator::Cut::kElementPlane) json["cut"] = "element_plane";
  return json;
}

template <class Named>
Json list(const std::vector<Named>& all) {
  Json json = Json::array();
  for (const Named& one : all) json.push_back(to_json(one));
  return json;
}

Json to_json(const SkeletonNode& node) {
  Json json;
  json["kind"] = node.kind;
  for (const RootNumber& x : node.line) json["line"].push_back(text(x));
  json["rounded"] = node.rounded;
  json["from"] = coordinates(node.region_point);
  json["to"] = coordinates(node.element_point);
  json["generators"] = list(node.generators);
  if (!node.faces.empty()) json["faces"] = list(node.faces);
  return json;
}

}  // namespace

Json to_json(const SkeletonGraph& graph) {
  Json json = {{"nodes", Json::array()}, {"arcs", Json::array()}};
  for (const auto node : boost::make_iterator_range(boost::vertices(graph))) {
    json["nodes"].push_back(to_json(graph[node]));
  }
  for (const auto arc : boost::make_iterator_range(boost::edges(graph))) {
    json["arcs"].push_back({{"nodes", {boost::source(arc, graph), boost::target(arc, graph)}},
                            {"kind", graph[arc].kind},
                            {"generators", list(graph[arc].generators)}});
  }
  return json;
}

}  // namespace viewcover
