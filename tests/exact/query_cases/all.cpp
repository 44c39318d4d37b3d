#include <iterator>

#include "exact/query_cases.h"

namespace viewcover::testing {
namespace {

void add_facing(QueryCaseList& list) {
  const Ends parallel{square(kS, 0), square(kS, 4)};
  list.fully("parallel squares", parallel, {}, "Nothing is between.");
  list.fully("skew triangles",
             {{{0, 0, 0}, {4, 0, 1}, {0, 4, 2}}, {{10, 1, 5}, {12, 3, 9}, {9, 5, 7}}}, {},
             "Nothing is between, and the planes differ.");
  list.fully("octagon and standing pentagon that cuts its plane",
             {octagon(2 * kS, kS, 0),
              {{3 * kS, 0, 3}, {3 * kS, 3, 1}, {3 * kS, 2, -2}, {3 * kS, -2, -2}, {3 * kS, -3, 1}}},
             {}, "Nothing is between; both sides of the pentagon's horizontal cut are seen.");
  list.fully("region of one unit under a large element",
             {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, square(4 * kS, 1)}, {}, "Nothing is between.");
  list.fully("element one unit above the region", {square(kS, 0), square(kS, 1)}, {},
             "Nothing is between.");
  list.fully("one corner one unit off the common plane",
             {horizontal(0, 0, kS, kS, 0), {{2 * kS, 0, 0}, {3 * kS, 0, 0}, {3 * kS, kS, 1}}}, {},
             "The planes differ and meet in the line y = z = 0 only.");
  list.fully("corners within edges, the first three on a line",
             {{{-4, -4, 0}, {0, -4, 0}, {4, -4, 0}, {4, 0, 0}, {4, 4, 0}, {-4, 4, 0}},
              {{-4, -4, 4}, {-1, -4, 4}, {2, -4, 4}, {4, -4, 4}, {0, 4, 4}}},
             {}, "Nothing is between; corners within edges change no polygon.");

  list.hidden("coplanar, apart", {square(kS, 0), horizontal(2 * kS, 0, 3 * kS, kS, 0)}, {},
              "All segments lie in the common plane.");
  list.hidden("coplanar, equal", {square(kS, 0), square(kS, 0)}, {},
              "All segments lie in the common plane.");
  list.hidden("coplanar, sharing an edge",
              {horizontal(0, 0, kS, kS, 0), horizontal(kS, 0, 2 * kS, kS, 0)}, {},
              "All segments lie in the common plane.");
  list.hidden("coplanar in a skew plane",
              {{{12, 0, 0}, {0, 6, 0}, {0, 0, 4}}, {{24, -6, 0}, {6, 0, 2}, {18, 0, -2}}}, {},
              "All corners solve x + 2y + 3z = 12.");
  list.hidden("coplanar, corners within edges first",
              {{{0, 0, 0}, {3, 0, 0}, {6, 0, 0}, {0, 6, 0}}, {{7, 0, 0}, {9, 0, 0}, {9, 5, 0}}}, {},
              "All segments lie in the common plane.");
}

void add_one_sided(QueryCaseList& list) {
  const auto one_sided = [](QueryCase& c) { c.query.one_sided = true; };
  const Ends parallel{square(kS, 0), square(kS, 4)};
  one_sided(list.fully("one-sided, front", {parallel.region, flipped(parallel.element)}, {},
                       "The element faces down, to the region."));
  one_sided(
      list.hidden("one-sided, back", parallel, {}, "The element faces up, the region is below."));
  one_sided(list.visible("one-sided, front through a slit of one unit",
                         {parallel.region, flipped(parallel.element)}, slit_x(kS, 2, 0, 1),
                         "Upright segments with x in (0, 1) are free."));

  // Front +x; the part x > 0 of the region is in front.
  const Ends cut{square(2 * kS, 0), upright_x(0, -kS, kS, kS, 2 * kS)};
  one_sided(list.fully("one-sided, plane cuts the region", cut, {},
                       "Half of the region is in front, nothing is between."));
  one_sided(list.hidden("one-sided, region touches the plane from behind",
                        {horizontal(-kS, -kS, 0, kS, 0), cut.element}, {},
                        "No point of the region is in front."));
  one_sided(list.fully("one-sided, region touches the plane from the front",
                       {horizontal(0, -kS, kS, kS, 0), cut.element}, {},
                       "All of the region is in front, nothing is between."));
  const std::string shelf =
      "A segment from x = p in front to height q passes z = S at x = p (1 - S/q) <= S.";
  one_sided(list.hidden("one-sided, the front is covered, the back free", cut,
                        {horizontal(0, -2 * kS, kS, 2 * kS, kS)},
                        shelf + " The shelf reaches to S, and the back does not count."));
  list.visible("two-sided, the front is covered, the back free", cut,
               {horizontal(0, -2 * kS, kS, 2 * kS, kS)}, "The part x < 0 sees the back.");
  one_sided(list.visible("one-sided, the front is covered but for one unit", cut,
                         {horizontal(0, -2 * kS, kS - 1, 2 * kS, kS)},
                         shelf + " The shelf reaches to S - 1."));
  one_sided(
      list.hidden("one-sided, the front is covered in two pieces", cut,
                  {horizontal(0, -2 * kS, 5, 2 * kS, kS), horizontal(5, -2 * kS, kS, 2 * kS, kS)},
                  shelf + " The pieces abut and reach to S."));

  const Ends corner{horizontal(0, 0, kS, kS, 0), upright_x(0, 0, 0, kS, kS)};
  one_sided(list.fully("one-sided wall on the region's edge, front", corner, {},
                       "The region is in front of the wall, nothing is between."));
  one_sided(list.hidden("one-sided wall on the region's edge, back",
                        {corner.region, flipped(corner.element)}, {},
                        "No point of the region is in front."));
  one_sided(list.fully("one-sided, both planes cut",
                       {square(kS, 0), upright_x(0, 2 * kS, -kS, 3 * kS, kS)}, {},
                       "The part x > 0 of the region sees both parts of the element."));
}

}  // namespace

std::vector<QueryCase> open_cases() {
  QueryCaseList list;
  add_facing(list);
  add_one_sided(list);
  return list.take();
}

std::vector<QueryCase> query_cases() {
  std::vector<QueryCase> all;
  for (auto* theme : {&open_cases, &contact_cases, &slit_cases, &plane_cases, &enclosure_cases}) {
    std::vector<QueryCase> cases = theme();
    all.insert(all.end(), std::make_move_iterator(cases.begin()),
               std::make_move_iterator(cases.end()));
  }
  return all;
}

}  // namespace viewcover::testing
