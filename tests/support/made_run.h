#pragma once

#include <string>
#include <vector>

#include "report/run_data.h"

namespace viewcover::testing {

inline Json made_record(const std::string& name) {
  return {{"complete", true}, {"scene", {{"name", name}}}};
}

/// A run made by hand: each surface is one element, each region sees what its row of `seen` says,
/// all regions are chosen.
inline RunData made_run(const std::vector<ConvexPolygon>& surfaces,
                        const std::vector<std::string>& groups,
                        const std::vector<ConvexPolygon>& regions,
                        const std::vector<std::vector<std::size_t>>& seen) {
  RunData run;
  run.record = made_record("made");
  Scene& scene = run.bundle.scene;
  scene.name = "made";
  scene.groups = groups;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    scene.surfaces.push_back({surfaces[i], GroupId(i % groups.size()), 0});
    scene.bounds.extend(bounding_box(surfaces[i]));
    run.bundle.elements.emplace_back(SurfaceId(i), 0, 0);
    run.areas.push_back(area(surfaces[i]));
  }
  run.regions.assign(regions.begin(), regions.end());
  for (std::size_t i = 0; i < regions.size(); ++i) run.region_addresses.emplace_back(PartId(i));
  run.seen = BitRows(regions.size(), surfaces.size());
  CoverRow all;
  for (std::size_t region = 0; region < regions.size(); ++region) {
    for (const std::size_t element : seen.at(region)) run.seen.set(region, element);
    all.regions.push_back(region);
  }
  run.covers = {all};
  run.bundle.times_visible = column_counts(run.seen);
  run.seen_from_viewpoints = BitRows(0, surfaces.size());
  return run;
}

/// [x0, x1] x [z0, z1] at y, front towards smaller y.
inline ConvexPolygon upright(double x0, double x1, double z0, double z1, double y) {
  return {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
}
/// [x0, x1] x [y0, y1] at z, front up.
inline ConvexPolygon level(double x0, double x1, double y0, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

}  // namespace viewcover::testing
