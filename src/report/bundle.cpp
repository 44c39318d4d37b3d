#include "report/bundle.h"

#include <system_error>

#include "report/file_writer.h"
#include "report/machine.h"
#include "report/scene_vtp.h"
#include "report/surface_meshes.h"
#include "report/tables.h"
#include "scene/error.h"

namespace viewcover {

Bundle::Bundle(std::filesystem::path folder, Json record)
    : folder_(std::move(folder)), record_(std::move(record)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (!error && !std::filesystem::is_directory(folder_, error) && !error) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) {
    throw InputError(folder_.string(), "cannot be made: " + error.message(),
                     "give a folder that can be written to");
  }
  record_["complete"] = false;
  write_record();
  remove_temporary_files(folder_);
}

void Bundle::write(const Solution& solution) const {
  write_regions(solution, folder_ / "regions.csv");
  write_faces(solution, folder_ / "faces.csv");
  write_elements(solution, folder_ / "elements.csv");
  write_links(solution, folder_ / "links.csv");
  write_visibility(solution.matrix, folder_ / "visibility.mtx");
  write_cover(solution.cover, folder_ / "cover.csv");
  write_proof(solution, folder_ / "cover.proof");
  write_wide(solution, folder_);
  write_viewpoints(solution, folder_ / "viewpoints.csv");
  write_viewpoint_visibility(solution, folder_ / "viewpoints.mtx");
  write_witnesses(solution, folder_ / "witnesses.csv");
  write_refined_bound(solution, folder_);
  write_scene_vtp(solution, folder_ / "scene.vtp");
  write_surface_mesh(solution, folder_ / "surface.ply");
  write_surface_mesh(solution, folder_ / "surface.om");
}

void Bundle::complete(const Solution& solution, Guarantee guarantee, const RunSeconds& seconds) {
  add_results(record_, solution, guarantee, seconds);
  record_["measured"]["finished"] = utc_now();
  record_["complete"] = true;
  write_record();
}

void Bundle::abandon(std::string_view reason) {
  record_["measured"]["ended"] = reason;
  write_record();
}

void Bundle::write_record() const {
  FileWriter out(folder_ / "run.json");
  // Names of files and groups are bytes; what is no UTF-8 is shown, not refused.
  out << record_.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  out.commit();
}

}  // namespace viewcover
