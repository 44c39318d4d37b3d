#include "show/ray_scene.h"

#include <embree3/rtcore.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace viewcover {

struct RayScene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::uint32_t> polygon_of_triangle;

  Embree() {
    // One thread builds: the tree, and with it which of two equal hits wins, is always the same.
    device = rtcNewDevice("threads=1");
    if (device == nullptr) throw std::runtime_error("Embree cannot start on this processor");
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  }
  ~Embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
};

RayScene::RayScene(std::span<const ConvexPolygon> polygons) : embree_(std::make_unique<Embree>()) {
  std::size_t corners = 0, triangles = 0;
  for (const ConvexPolygon& polygon : polygons) {
    if (polygon.size() < 3) continue;
    corners += polygon.size();
    triangles += polygon.size() - 2;
  }
  if (triangles > 0) {
    RTCGeometry mesh = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corners));
    auto* index = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles));
    if (corner == nullptr || index == nullptr) throw std::bad_alloc();
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      if (polygons[i].size() < 3) continue;
      const auto count = static_cast<std::uint32_t>(polygons[i].size());
      for (const Point& p : polygons[i]) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) *corner++ = static_cast<float>(p[axis]);
      }
      for (std::uint32_t k = 2; k < count; ++k) {
        *index++ = first;
        *index++ = first + k - 1;
        *index++ = first + k;
        embree_->polygon_of_triangle.push_back(static_cast<std::uint32_t>(i));
      }
      first += count;
    }
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(embree_->scene, mesh);
    rtcReleaseGeometry(mesh);
  }
  rtcCommitScene(embree_->scene);
}

RayScene::~RayScene() = default;

RayScene::Hit RayScene::hit(const Point& origin, const Point& direction) const {
  RTCRayHit query{};
  const Eigen::Vector3f from = origin.cast<float>(), to = direction.cast<float>();
  query.ray = {from.x(), from.y(), from.z(),
               0,        to.x(),   to.y(),
               to.z(),   0,        std::numeric_limits<float>::infinity(),
               ~0u,      0,        0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    return {kNone, std::numeric_limits<float>::infinity()};
  }
  return {embree_->polygon_of_triangle[query.hit.primID], query.ray.tfar};
}

}  // namespace viewcover
