#include "app/show_query.h"

#include <fmt/core.h>

#include <boost/range/iterator_range.hpp>
#include <fstream>

#include "app/console.h"
#include "app/exit_codes.h"
#include "app/interrupt.h"
#include "app/sight_json.h"
#include "exact/skeleton/skeleton.h"
#include "scene/error.h"
#include "show/query_picture.h"

namespace viewcover {
namespace {

void add_skeleton(const SightQuery& query, QueryPicture& picture) {
  const SkeletonGraph graph = visibility_skeleton(query);
  for (const auto node : boost::make_iterator_range(boost::vertices(graph))) {
    picture.lines.push_back(
        {graph[node].region_point, graph[node].element_point, graph[node].kind});
  }
}

QueryPicture picture_of(const Json& object, const ShowQueryOptions& options) {
  ReadQuery read = read_query(object);
  SightQuery& query = read.query;
  query.one_sided = options.one_sided;
  QueryPicture picture{
      query.region, query.viewpoint, query.element, query.occluders, {}, {}, {}, {}};
  SightAnswer answer;
  std::string more;
  if (read.from_viewpoint) {
    PointAnswer found = decide_from_point(query);
    more = fmt::format(", {:.4g} % of the element", 100 * found.visible_fraction);
    picture.visible_parts = std::move(found.visible_parts);
    answer = found;
  } else {
    answer = decide_from_region(query);
    if (options.skeleton) add_skeleton(query, picture);
    if (options.skeleton) more = fmt::format(", {} extremal stabbing lines", picture.lines.size());
  }
  if (answer.witness) {
    picture.witness.emplace(read.from_viewpoint
                                ? query.viewpoint
                                : weighted_point(query.region, answer.witness->region_weights),
                            weighted_point(query.element, answer.witness->element_weights));
  }
  const std::string id = read.id.is_string()
                             ? read.id.get<std::string>()
                             : read.id.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string how(name(answer.verdict));
  std::ranges::replace(how, '_', ' ');
  picture.caption = (read.id.is_null() ? "query" : "query " + id) + ": " + how + more;
  return picture;
}

}  // namespace

int show_queries(const ShowQueryOptions& options) {
  std::ifstream in(options.file);
  if (!in) throw InputError(options.file.string(), "cannot be read", "give a file of JSON lines");
  bool any_bad = false;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    if (interrupt_flag()) throw Interrupted();
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    ++number;
    Json object, result;
    std::optional<QueryPicture> picture;
    try {
      object = Json::parse(line);
      picture = picture_of(object, options);
    } catch (const Json::exception& error) {
      result = {{"id", id_of(object)}, {"error", std::string("no JSON: ") + error.what()}};
    } catch (const InputError& error) {
      result = {{"id", id_of(object)}, {"error", error.what()}};
    }
    if (picture) {
      const auto file = options.folder / fmt::format("query_{}.png", number);
      draw_query(*picture, options.view, options.size, file);
      result = {{"id", id_of(object)}, {"figure", file.string()}};
    }
    any_bad = any_bad || !picture;
    print_out(result.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  }
  return any_bad ? kBadInput : kDone;
}

}  // namespace viewcover
