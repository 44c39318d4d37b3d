#include <fmt/core.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/interrupt.h"
#include "app/memory_limit.h"
#include "app/progress.h"
#include "app/solve_options.h"
#include "app/solve_tables.h"
#include "full_coverage/full_search.h"
#include "links/refine.h"
#include "links/visibility_matrix.h"
#include "links/wide_visibility.h"
#include "optim/cover_methods.h"
#include "optim/stopwatch.h"
#include "report/audit_files.h"
#include "report/bundle.h"
#include "report/checkpoint.h"
#include "scene/error.h"
#include "show/figure.h"
#include "viewpoints/viewpoint_search.h"

namespace viewcover {
namespace {

/// Enough to close the gap in rooms, and no longer than the search before.
constexpr std::size_t kGapRounds = 24;
/// Where nothing is left of it: 0 would be none.
constexpr double kLeastTimeLimit = 1e-3;

void stop_if_interrupted() {
  if (interrupt_flag()) throw Interrupted();
}

/// The sums by name; names of a backend do not change while it decides.
BackendStatistics sum(BackendStatistics a, const BackendStatistics& b) {
  for (const auto& [name, count] : b) {
    const auto same = std::ranges::find(a, name, [](const auto& entry) { return entry.first; });
    if (same == a.end()) {
      a.emplace_back(name, count);
    } else {
      same->second += count;
    }
  }
  return a;
}

/// Refines as `find` does, with its progress shown and its interrupts.
template <class Find>
auto show_refinement(const char* stage, const SolveOptions& options, const Find& find) {
  RefineProgress progress;
  const ForwardInterrupt forward(progress.stop);
  const Progress shown(
      stage,
      [&progress] {
        return Progress::State{progress.share_done, fmt::format("{} links", progress.links.load())};
      },
      options.quiet);
  return tbb::task_arena(options.threads).execute([&] { return find(progress); });
}

/// Goes on from what the checkpoint has, whose statistics are left in `before`.
LinkSet find_links(const Scene& scene, const ClusterTree& clusters, const ViewingRegion& region,
                   const VisibilityBackend& backend, const RefineOptions& refine_options,
                   const SolveOptions& options, Checkpoint& checkpoint, BackendStatistics& before) {
  VisibilityState state;
  if (options.resume) state = checkpoint.load();
  before = std::move(state.statistics);
  RefineCheckpoints checkpoints{.batches_done = state.batches,
                                .links = std::move(state.links),
                                .seconds = options.checkpoint_seconds,
                                .save = [&](std::size_t batches, const LinkSet& links) {
                                  checkpoint.save(batches, links,
                                                  sum(before, backend.statistics()));
                                }};
  return show_refinement("visibility", options, [&](RefineProgress& progress) {
    return refine(scene, clusters, region, backend, refine_options, &progress, &checkpoints);
  });
}

RegionCover choose_regions(const BitRows& bits, std::span<const double> areas,
                           const SolveOptions& options) {
  const CoverInstance instance(bits, areas);
  const double bound = static_cast<double>(instance.lower_bound());
  std::atomic<std::size_t> regions = 0;
  std::atomic<double> percent = 0;
  const Progress shown(
      "region cover",
      [&] {
        // At least `bound` numbers of regions are tried; nobody knows how many more.
        const auto done = static_cast<double>(regions.load());
        return Progress::State{done / std::max(bound, done + 1),
                               fmt::format("{} regions see {:.4f} % of what is visible",
                                           regions.load(), percent.load())};
      },
      options.quiet);
  CoverOptions cover_options;
  cover_options.seed = options.seed;
  cover_options.time_limit_seconds = options.time_limit_seconds;
  cover_options.stop = &interrupt_flag();
  cover_options.on_step = [&](const CoverStep& step) {
    regions = step.k;
    percent = step.covered_percent;
  };
  return make_cover_method(options.optimizer)->solve(instance, cover_options);
}

std::optional<WideSolution> solve_without_narrow_gaps(const Scene& scene,
                                                      const ViewingRegion& region,
                                                      const VisibilityMatrix& matrix,
                                                      const VisibilityBackend& backend,
                                                      const RefineOptions& refine_options,
                                                      const SolveOptions& options) {
  if (options.aperture == 0) return std::nullopt;
  WideVisibility wide =
      show_refinement("visibility without gaps", options, [&](RefineProgress& progress) {
        return find_wide_visibility(scene, region, matrix, backend, refine_options,
                                    options.aperture, &progress);
      });
  if (wide.gaps_entered > 0 && !options.quiet) {
    print_error_line(
        fmt::format("{} patches of gaps narrower than {} stay open: the region passes through them",
                    wide.gaps_entered, options.aperture));
  }
  RegionCover cover = choose_regions(wide.bits, matrix.areas, options);
  return WideSolution{std::move(wide), std::move(cover)};
}

std::optional<ViewpointSet> choose_viewpoints(const ViewedScene& viewed, const RegionCover& cover,
                                              double seconds_used, const SolveOptions& options) {
  if (!options.find_viewpoints) return std::nullopt;
  const Stopwatch watch;
  ViewpointProgress progress;
  const Progress shown(
      "viewpoints",
      [&] {
        const std::size_t size = progress.viewpoints, bound = progress.lower_bound;
        std::string detail = fmt::format("{} positions", progress.positions.load());
        if (size > 0) detail = fmt::format("{} viewpoints, at least {}, ", size, bound) + detail;
        const double share =
            size > 0 ? static_cast<double>(bound) / static_cast<double>(size) : 0.0;
        return Progress::State{std::min(share, 1.0), std::move(detail)};
      },
      options.quiet);
  ViewpointOptions search;
  if (!cover.steps.empty()) search.chosen_regions = cover.steps.back().chosen;
  search.lower_bound = cover.lower_bound;
  search.seed = options.seed;
  if (options.time_limit_seconds > 0) {
    search.time_limit_seconds =
        std::max(options.time_limit_seconds - seconds_used, kLeastTimeLimit);
  }
  search.close_gap_seconds = options.close_gap_seconds.value_or(0);
  if (!options.close_gap_seconds && viewed.backend.guarantee() == Guarantee::kExact) {
    search.gap_rounds = kGapRounds;
  }
  search.stop = &interrupt_flag();
  search.progress = &progress;
  return tbb::task_arena(options.threads).execute([&] {
    const RegionViews views(viewed);
    ViewpointSet parts = find_viewpoints(views, search);
    if (!options.full_coverage) return parts;
    FullCoverageOptions full;
    full.missed_share = options.missed_share;
    full.seed = options.seed;
    full.close_gap_seconds = options.close_gap_seconds.value_or(0);
    if (options.close_gap_seconds == 0) full.patience = 0;
    if (options.time_limit_seconds > 0) {
      full.time_limit_seconds =
          std::max(options.time_limit_seconds - seconds_used - watch.seconds(), kLeastTimeLimit);
    }
    full.stop = &interrupt_flag();
    full.progress = &progress;
    return find_full_coverage(views, parts, full);
  });
}

/// What the images show of every element, into the bundle; nothing without viewpoints.
void audit_viewpoints(const Solution& solution, const Bundle& bundle, const SolveOptions& options) {
  remove_audit(bundle.folder());
  remove_pictures(bundle.folder());
  if (solution.viewpoints == nullptr) return;
  std::vector<Point> positions;
  for (const Viewpoint& viewpoint : solution.viewpoints->viewpoints) {
    positions.push_back(viewpoint.position);
  }
  const std::vector<std::uint32_t> times_visible = solution.matrix.times_visible();
  const AuditTask task{solution.scene, solution.clusters, solution.matrix.elements,
                       times_visible,  positions,         options.one_sided};
  const AuditOptions audit{.stop = &interrupt_flag()};
  tbb::task_arena(options.threads).execute([&] { write_audit(task, bundle.folder(), audit); });
}

void print_summary(const Json& record) {
  print_out(summary_line(record).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// The exit code of a complete run; says what is missing.
int end_of(const Json& record, const SolveOptions& options) {
  const std::size_t missing =
      record.at("results").value("elements_from_no_position", std::size_t{0});
  if (missing > 0 && !options.quiet) {
    print_error_line(fmt::format(
        "{} elements that a region sees are seen from none of the viewpoints", missing));
  }
  const bool limit_reached = record.at("measured").at("time_limit_reached");
  return limit_reached || missing > 0 ? kLimitReached : kDone;
}

/// What `--resume` does with a run that has ended.
int end_of_complete_run(const SolveOptions& options) {
  const Json record = read_complete_run(options.output);
  if (!options.quiet) {
    print_error_line(options.output.string() + ": complete; nothing is left to be done");
  }
  // One that was killed between its last two steps.
  Checkpoint(options.output).remove();
  print_summary(record);
  return end_of(record, options);
}

int solve(const SolveOptions& options) {
  const Stopwatch total;
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  const Scene scene = load_scene(options.scene_file, {.lattice_exponent = options.lattice_exponent,
                                                      .one_sided = options.one_sided,
                                                      .merge_coplanar = options.merge_coplanar,
                                                      .heal = options.heal,
                                                      .crop = options.crop,
                                                      .targets = options.targets});
  if (!scene.warning.empty() && !options.quiet) print_error_line(scene.warning);
  if (scene.repairs.any() && !options.quiet) {
    print_error_line(options.scene_file.string() + ": " + scene.repairs.summary());
  }
  const ViewingRegion region =
      load_viewing_region(options.region_file, scene.lattice, options.regions_per_part);
  check_region_is_free(options.region_file, scene, region,
                       {.clearance = options.clearance, .allow_outside = options.allow_outside});
  stop_if_interrupted();

  const RefineOptions refine_options{
      .element_area = options.element_area.value_or(default_element_area(scene)),
      .one_sided = options.one_sided};
  Json record = make_run_record(options.scene_file, options.region_file, scene, options.seed,
                                options.to_json(refine_options.element_area), options.threads);
  if (options.resume && state_of_run(options.output, record) == RunState::kComplete) {
    return end_of_complete_run(options);
  }
  Bundle bundle(options.output, std::move(record));
  Checkpoint checkpoint(options.output);
  if (!options.resume) checkpoint.remove();
  const MemoryLimit memory_limit(options.memory_limit);
  try {
    RunSeconds seconds;
    BackendStatistics before;
    const std::unique_ptr<VisibilityBackend> backend =
        options.backend->make(options.backend_options);
    const Stopwatch visibility;
    const ClusterTree clusters(scene);
    const LinkSet links =
        find_links(scene, clusters, region, *backend, refine_options, options, checkpoint, before);
    const VisibilityMatrix matrix = make_visibility_matrix(scene, region, links);
    seconds.visibility = visibility.seconds();
    stop_if_interrupted();

    const Stopwatch covering;
    const RegionCover cover = choose_regions(matrix.bits, matrix.areas, options);
    seconds.cover = covering.seconds();

    const Stopwatch widening;
    const std::optional<WideSolution> wide =
        solve_without_narrow_gaps(scene, region, matrix, *backend, refine_options, options);
    if (wide) seconds.wide = widening.seconds();

    const Stopwatch viewing;
    const std::optional<ViewpointSet> viewpoints =
        choose_viewpoints({scene, clusters, region, links, matrix, *backend, options.one_sided},
                          cover, seconds.cover, options);
    if (viewpoints) seconds.viewpoints = viewing.seconds();
    stop_if_interrupted();

    const Solution solution{scene,
                            clusters,
                            region,
                            links,
                            matrix,
                            cover,
                            sum(before, backend->statistics()),
                            viewpoints ? &*viewpoints : nullptr,
                            wide ? &*wide : nullptr};
    bundle.write(solution);
    audit_viewpoints(solution, bundle, options);
    stop_if_interrupted();
    seconds.total = total.seconds();
    bundle.complete(solution, backend->guarantee(), seconds);
    checkpoint.remove();
    if (!options.quiet) print_out(solve_tables(solution, backend->guarantee(), seconds) + "\n");
    print_summary(bundle.record());
    return end_of(bundle.record(), options);
  } catch (const Interrupted&) {
    // It has said so from the beginning; the reason is a courtesy that a full disk may prevent.
    try {
      bundle.abandon(memory_limit.reached() ? "memory limit" : "interrupted");
    } catch (const InputError&) {
    }
    if (memory_limit.reached()) throw MemoryLimit::error();
    print_error_line("interrupted; the bundle in " + options.output.string() +
                     " is marked incomplete; --resume continues it");
    return kInterrupted;
  }
}

}  // namespace

void add_solve_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<SolveText>();
  CLI::App* const command = app.add_subcommand(
      "solve", "find the fewest viewing regions and viewpoints that see all that is visible");
  text->add_to(*command);
  command->callback([text, &exit_code] { exit_code = solve(SolveOptions(*text)); });
}

}  // namespace viewcover
