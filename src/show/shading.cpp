#include "show/shading.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "scene/error.h"

namespace viewcover {
namespace {

constexpr std::array<std::string_view, 6> kNames = {"times_visible", "covered_by", "viewpoints",
                                                    "difference",    "group",      "unseen"};
/// Up to here each number has its own field in the legend.
constexpr std::uint32_t kMostSteps = 8;
/// Groups named in the legend.
constexpr std::size_t kNamedGroups = 7;
/// Longer names of groups are cut in the legend; characters.
constexpr std::size_t kLongestName = 18;

/// Where the number n >= 1 lies on a ramp that ends at `most`.
double ramp_place(std::uint32_t n, std::uint32_t most) {
  return most <= 1 ? 1.0 : static_cast<double>(n - 1) / static_cast<double>(most - 1);
}

Shading shade_counts(const std::vector<std::uint32_t>& counts, const CommonElements& shown,
                     std::string title) {
  Shading shading;
  shading.title = std::move(title);
  const std::uint32_t most = counts.empty() ? 0 : *std::ranges::max_element(counts);
  for (const std::size_t element : shown.first) {
    const std::uint32_t n = counts[element];
    shading.colours.push_back(n == 0 ? kNeverSeen : ramp(ramp_place(n, most)));
  }
  shading.entries.push_back({kNeverSeen, "never"});
  if (most > kMostSteps) {
    shading.ramp_end = most;
  } else {
    for (std::uint32_t n = 1; n <= most; ++n) {
      shading.entries.push_back({ramp(ramp_place(n, most)), std::to_string(n)});
    }
  }
  return shading;
}

Shading shade_difference(const CommonElements& shown) {
  if (shown.differences.empty()) {
    throw InputError("--colour-by difference", "there is one run only",
                     "give another with --against DIR2");
  }
  std::uint32_t most_missed = 0, most_excess = 0;
  for (const Difference& d : shown.differences) {
    most_missed = std::max(most_missed, d.missed);
    most_excess = std::max(most_excess, d.excess);
  }
  Shading shading;
  shading.title = "regions that see it in one run only";
  for (const Difference& d : shown.differences) {
    shading.colours.push_back(d.missed > 0   ? missed_ramp(ramp_place(d.missed, most_missed))
                              : d.excess > 0 ? excess_ramp(ramp_place(d.excess, most_excess))
                                             : kUnchanged);
  }
  shading.entries = {{kUnchanged, "none"}};
  const auto add = [&](auto colour_of, std::uint32_t most, const std::string& what) {
    if (most == 0) return;
    shading.entries.push_back({colour_of(0.0), "1"});
    shading.entries.push_back({colour_of(1.0), std::to_string(most) + " " + what});
  };
  add(missed_ramp, most_missed, "missed by the other");
  add(excess_ramp, most_excess, "by the other only");
  return shading;
}

/// Whole UTF-8 characters only.
std::string shortened(const std::string& name) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if ((static_cast<unsigned char>(name[i]) & 0xC0) == 0x80) continue;
    if (++characters > kLongestName) return name.substr(0, i) + "...";
  }
  return name.empty() ? "(no name)" : name;
}

/// The largest groups have colours of their own, the rest shares one.
Shading shade_groups(const RunData& run, const CommonElements& shown) {
  const Scene& scene = run.bundle.scene;
  std::vector<double> areas(scene.groups.size(), 0);
  for (const Surface& surface : scene.surfaces) {
    areas[surface.group.value] += area(surface.polygon);
  }
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t group) { return areas[group]; });

  Shading shading;
  shading.title = "group";
  std::vector<Colour> colours(areas.size(), category(kNamedGroups));
  for (std::size_t rank = 0; rank < std::min(order.size(), kNamedGroups); ++rank) {
    colours[order[rank]] = category(rank);
    shading.entries.push_back({category(rank), shortened(scene.groups[order[rank]])});
  }
  if (order.size() > kNamedGroups) {
    shading.entries.push_back(
        {category(kNamedGroups), std::to_string(order.size() - kNamedGroups) + " others"});
  }
  for (const ElementAddress element : shown.addresses) {
    shading.colours.push_back(colours[scene[element.owner()].group.value]);
  }
  return shading;
}

Shading shade_unseen(const RunData& run, const CommonElements& shown) {
  Shading shading;
  shading.title = "regions that see it";
  shading.entries = {{kNeverSeen, "none"}, {kHardlySeen, "1"}, {kUnchanged, "2 or more"}};
  for (const std::size_t element : shown.first) {
    const std::uint32_t n = run.bundle.times_visible[element];
    shading.colours.push_back(n == 0 ? kNeverSeen : n == 1 ? kHardlySeen : kUnchanged);
  }
  return shading;
}

}  // namespace

std::span<const std::string_view> colour_by_names() { return kNames; }

std::optional<ColourBy> colour_by_named(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<ColourBy>(found - kNames.begin());
}

Shading shade(const RunData& run, const CommonElements& shown, ColourBy by) {
  switch (by) {
    case ColourBy::kTimesVisible:
      return shade_counts(run.bundle.times_visible, shown, "regions that see it");
    case ColourBy::kCoveredBy:
      return shade_counts(column_counts(run.seen, run.chosen()), shown,
                          "chosen regions that see it");
    case ColourBy::kViewpoints:
      if (run.viewpoints.empty()) {
        throw InputError("--colour-by viewpoints", "the run has none",
                         "solve with --viewpoints sa");
      }
      return shade_counts(column_counts(run.seen_from_viewpoints), shown, "viewpoints that see it");
    case ColourBy::kDifference:
      return shade_difference(shown);
    case ColourBy::kGroup:
      return shade_groups(run, shown);
    case ColourBy::kUnseen:
      break;
  }
  return shade_unseen(run, shown);
}

}  // namespace viewcover
