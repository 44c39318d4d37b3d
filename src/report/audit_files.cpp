#include "report/audit_files.h"

#include <array>

#include "report/file_writer.h"
#include "report/poly_data.h"

namespace viewcover {
namespace {

constexpr std::array<std::string_view, 3> kSeenNames = {"not", "in_part", "wholly"};

double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 100; }

void write_table(const AuditTask& task, const Audit& audit, const std::filesystem::path& file) {
  FileWriter out(file);
  out << "element,surface,area,imaged_area,imaged_percent,images_max,images_mean,seen,"
         "imaged_share\n";
  for (std::size_t i = 0; i < audit.elements.size(); ++i) {
    const ElementAudit& element = audit.elements[i];
    out << i + 1 << ',' << task.elements[i].owner().value + 1 << ',' << element.area << ','
        << element.imaged_area << ',' << percent(element.imaged_area, element.area) << ','
        << element.images_max() << ',' << element.images_mean() << ','
        << kSeenNames[static_cast<std::size_t>(element.seen)] << ',' << element.imaged_share
        << '\n';
  }
  out.commit();
}

void write_pieces(const AuditTask& task, const Audit& audit, const std::filesystem::path& file) {
  std::vector<ConvexPolygon> polygons;
  std::vector<CellArray> arrays = {{"images", {}}, {"element", {}}, {"surface", {}}};
  for (std::size_t i = 0; i < audit.elements.size(); ++i) {
    for (const ImagedPiece& piece : audit.elements[i].pieces) {
      polygons.push_back(piece.polygon);
      arrays[0].values.push_back(piece.images);
      arrays[1].values.push_back(static_cast<std::uint32_t>(i + 1));
      arrays[2].values.push_back(task.elements[i].owner().value + 1);
    }
  }
  write_poly_data(file, polygons, arrays, "images");
}

void write_record(const AuditTask& task, const AuditSummary& summary,
                  const std::filesystem::path& file) {
  Json record;
  record["source"] = task.source;
  record["positions"] = Json::array();
  for (const Point& p : task.viewpoints) record["positions"].push_back({p.x(), p.y(), p.z()});
  record["audit"] = to_json(summary);
  FileWriter out(file);
  out << record.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  out.commit();
}

}  // namespace

AuditSummary summary_of(const AuditTask& task, const Audit& audit) {
  AuditSummary sum;
  sum.viewpoints = audit.viewpoints;
  sum.elements = audit.elements.size();
  double imaged_coverable = 0;
  for (std::size_t i = 0; i < audit.elements.size(); ++i) {
    const ElementAudit& element = audit.elements[i];
    const bool in_part = element.seen == ElementAudit::Seen::kInPart;
    sum.seen_wholly += element.seen == ElementAudit::Seen::kWholly;
    sum.seen_in_part += in_part;
    sum.not_seen += element.seen == ElementAudit::Seen::kNot;
    sum.area += element.area;
    sum.imaged_area += element.imaged_area;
    sum.area_seen_in_part += in_part ? element.area : 0;
    if (task.times_visible[i] == 0) continue;
    sum.coverable_area += element.area;
    imaged_coverable += element.imaged_area;
    sum.missed_area += element.area - element.imaged_area;
  }
  sum.imaged_percent = percent(imaged_coverable, sum.coverable_area);
  return sum;
}

Json to_json(const AuditSummary& summary) {
  return {{"viewpoints", summary.viewpoints},
          {"elements", summary.elements},
          {"seen_wholly", summary.seen_wholly},
          {"seen_in_part", summary.seen_in_part},
          {"not_seen", summary.not_seen},
          {"area", summary.area},
          {"coverable_area", summary.coverable_area},
          {"imaged_area", summary.imaged_area},
          {"imaged_percent", summary.imaged_percent},
          {"missed_area", summary.missed_area},
          {"area_seen_in_part", summary.area_seen_in_part}};
}

void remove_audit(const std::filesystem::path& folder) {
  for (const char* file : {"audit.csv", "audit.vtp", "audit.json"}) {
    std::error_code ignored;
    std::filesystem::remove(folder / file, ignored);
  }
}

AuditSummary write_audit(const AuditTask& task, const std::filesystem::path& folder,
                         const AuditOptions& options) {
  AuditOptions all = options;
  all.one_sided = task.one_sided;
  const Audit audit = audit_images(task.scene, task.clusters, task.elements, task.viewpoints, all);
  const AuditSummary summary = summary_of(task, audit);
  write_table(task, audit, folder / "audit.csv");
  write_pieces(task, audit, folder / "audit.vtp");
  write_record(task, summary, folder / "audit.json");
  return summary;
}

}  // namespace viewcover
