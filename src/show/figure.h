#pragma once

#include <filesystem>
#include <optional>

#include "show/camera.h"
#include "show/shading.h"

namespace viewcover {

struct FigureOptions {
  PixelSize size{1400, 1050};
  std::optional<ViewDirection> view;  ///< default: where most elements are in sight
  std::optional<int> up_axis;         ///< default: see up_axis_of
  ColourBy colour_by = ColourBy::kCoveredBy;
  std::optional<std::size_t> viewpoint;  ///< from 0: its panorama instead of the scene from outside
};

/// The axis across which the viewing region is flattest, z if there is no single one.
int up_axis_of(const RunData& run);

/// The direction from which most elements are in sight, of eight from above.
ViewDirection default_view(const RunData& run, const CommonElements& shown, int up_axis);

/// Draws a run in the manner of the paper's figures 6 to 11: elements coloured (`shade`), the
/// viewing region dark grey, chosen regions medium grey, viewpoints as light dots, outlines of the
/// surfaces; walls and ceilings between the camera and the region are cut (show/cutaway.h) and
/// leave their outlines. A legend below. With a viewpoint: all that it sees, without regions.
///
/// The same bytes for any number of threads. Errors: InputError for a viewpoint that is not there
/// and where the file cannot be written.
void draw_figure(const RunData& run, const CommonElements& shown, const FigureOptions& options,
                 const std::filesystem::path& file);

/// Removes the pictures and the page of an earlier run: figure.png, report.html, camera_N.png.
void remove_pictures(const std::filesystem::path& folder);

}  // namespace viewcover
