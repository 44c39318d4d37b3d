#pragma once

#include <filesystem>
#include <string_view>

#include "scene/read/polygon_soup.h"

namespace viewcover {

/// The polygons of a glTF 2.0 (.gltf, .glb) or COLLADA (.dae) file, read by assimp from its
/// content.
///
/// Every node that shows a mesh gives its own copy, placed by the transforms above it; copies that
/// are mirrored are turned round, so that fronts stay fronts. Polygons keep their corners and their
/// order: nodes depth first, their meshes in turn, faces in turn. Points and lines are passed over.
/// Groups are "NODE/MESH" after the node and its mesh, or the one of the two that has a name.
/// Units and axes: glTF is in metres with y up, and stays so; COLLADA keeps its axes and comes in
/// metres, as its `unit` says.
/// assimp has single precision: coordinates in a mesh and transforms are those of the file rounded
/// to 24 bits. Transforms are combined in double.
/// Opens no other file than the buffers of a .gltf (scene/read/asset_check.h). assimp crashes on
/// damaged files; it runs in a process of its own (scene/read/apart.h), so that they are refused
/// like others. Errors: InputError. Requires one of the three suffixes.
PolygonSoup parse_asset(std::string_view content, const std::filesystem::path& file);

}  // namespace viewcover
