#include <fmt/core.h>
#include <tbb/global_control.h>

#include <atomic>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "report/audit_files.h"
#include "report/bundle_scene.h"
#include "scene/error.h"

namespace viewcover {
namespace {

struct AuditText {
  CommonOptions common;
  std::string folder, scene, viewpoints;
};

std::string table(const AuditSummary& summary) {
  std::string text =
      fmt::format("{:>10} {:>12} {:>12} {:>10} {:>14} {:>14} {:>12}\n", "elements", "seen wholly",
                  "seen in part", "not seen", "imaged area", "missed area", "percent");
  text += fmt::format("{:>10} {:>12} {:>12} {:>10} {:>14.6g} {:>14.6g} {:>12.6f}\n",
                      summary.elements, summary.seen_wholly, summary.seen_in_part, summary.not_seen,
                      summary.imaged_area, summary.missed_area, summary.imaged_percent);
  return text;
}

std::vector<Point> viewpoints_of(const std::filesystem::path& file) {
  std::vector<Point> positions = read_positions(file);
  if (positions.empty()) {
    throw InputError(file.string(), "holds no viewpoints",
                     "give others with --viewpoints FILE.csv, columns x, y and z");
  }
  return positions;
}

int audit(const AuditText& text) {
  if (text.folder.empty()) throw InputError("DIR", "is missing", "give the folder of a run");
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(thread_count(text.common)));
  const std::filesystem::path folder = text.folder;
  const BundleScene bundle = load_bundle_scene(folder, text.scene);
  const std::vector<Point> viewpoints = viewpoints_of(
      text.viewpoints.empty() ? folder / kViewpointsFile : std::filesystem::path(text.viewpoints));
  const ClusterTree clusters(bundle.scene);
  AuditTask task{bundle.scene,         clusters,   bundle.elements,
                 bundle.times_visible, viewpoints, bundle.one_sided};
  if (!text.viewpoints.empty()) task.source = text.viewpoints;

  std::atomic<std::size_t> done = 0;
  AuditOptions options;
  options.stop = &interrupt_flag();
  options.done = &done;
  AuditSummary summary;
  {
    const Progress shown(
        "audit",
        [&] {
          return Progress::State{
              static_cast<double>(done.load()) / static_cast<double>(task.elements.size()),
              fmt::format("{} of {} elements", done.load(), task.elements.size())};
        },
        text.common.quiet);
    summary = write_audit(task, folder, options);
  }
  if (!text.common.quiet) print_out(table(summary) + "\n");
  print_out(to_json(summary).dump() + "\n");
  return kDone;
}

}  // namespace

void add_audit_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<AuditText>();
  CLI::App* const command = app.add_subcommand(
      "audit", "measure exactly what the viewpoints of a run show of every element");
  command->add_option("folder", text->folder, "the folder of the run")->type_name("DIR");
  command->add_option("--scene", text->scene, "the scene of the run, where it has moved")
      ->type_name("FILE");
  command
      ->add_option("--viewpoints", text->viewpoints,
                   "other viewpoints: a CSV file with columns x, y and z")
      ->type_name("FILE");
  add_common_options(*command, text->common);
  command->callback([text, &exit_code] { exit_code = audit(*text); });
}

}  // namespace viewcover
