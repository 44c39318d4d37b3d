#include "hard_instances.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

namespace viewcover::reference {
namespace {

/// The rows of each column.
using Columns = std::vector<std::vector<std::size_t>>;

BitRows matrix_of(const Columns& columns, std::size_t rows) {
  BitRows matrix(rows, columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (const std::size_t row : columns[c]) matrix.set(row, c);
  }
  return matrix;
}

}  // namespace

HardInstance affine_lines(int dimension) {
  std::size_t points = 1;
  for (int i = 0; i < dimension; ++i) points *= 3;
  // Three points lie on a line iff they add up to 0 in every coordinate modulo 3.
  Columns lines;
  for (std::size_t a = 0; a < points; ++a) {
    for (std::size_t b = a + 1; b < points; ++b) {
      std::size_t c = 0;
      for (std::size_t digit = 1; digit < points; digit *= 3) {
        c += (6 - a / digit % 3 - b / digit % 3) % 3 * digit;
      }
      if (c > b) lines.push_back({a, b, c});
    }
  }
  static const std::map<int, std::size_t> kBest = {{2, 5}, {3, 18}, {4, 61}, {5, 198}, {6, 617}};
  return {"AG(" + std::to_string(dimension) + ",3)", matrix_of(lines, points), kBest.at(dimension),
          true};
}

HardInstance cube_cycles(int dimension) {
  const std::size_t vertices = std::size_t{1} << dimension;
  const auto d = static_cast<std::size_t>(dimension);
  // An edge along an axis is named after its end with a 0 there.
  const auto edge = [&](std::size_t end, std::size_t axis) { return end * d + axis; };
  std::map<std::size_t, std::size_t> row_of;
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      if ((v >> axis & 1) == 0) row_of.emplace(edge(v, axis), row_of.size());
    }
  }
  Columns cycles;
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t a = 0; a < d; ++a) {
      for (std::size_t b = a + 1; b < d; ++b) {
        const std::size_t at = std::size_t{1} << a, bt = std::size_t{1} << b;
        if ((v & at) != 0 || (v & bt) != 0) continue;
        cycles.push_back({row_of.at(edge(v, a)), row_of.at(edge(v, b)), row_of.at(edge(v | bt, a)),
                          row_of.at(edge(v | at, b))});
      }
    }
  }
  static const std::map<int, std::size_t> kBest = {{6, 60},  {7, 144},   {8, 342},
                                                   {9, 772}, {10, 1794}, {11, 3968}};
  return {"cube " + std::to_string(dimension), matrix_of(cycles, row_of.size()),
          kBest.at(dimension), dimension == 6};
}

HardInstance bipartitions(int points) {
  std::vector<std::uint32_t> subsets;
  const std::uint32_t all = (1u << points) - 1;
  for (std::uint32_t set = 0; set <= all; ++set) {
    if (std::popcount(set) == 4) subsets.push_back(set);
  }
  // The part with the first point names a bipartition.
  BitRows matrix(subsets.size(), (1u << (points - 1)) - 1);
  std::size_t column = 0;
  for (std::uint32_t part = 1; part < all; part += 2, ++column) {
    for (std::size_t r = 0; r < subsets.size(); ++r) {
      const std::uint32_t inside = subsets[r] & part;
      if (inside == 0 || inside == subsets[r]) matrix.set(r, column);
    }
  }
  static const std::map<int, std::size_t> kBest = {{10, 25}, {11, 23}, {12, 23}, {13, 23}};
  return {"bipartitions of " + std::to_string(points), std::move(matrix), kBest.at(points),
          points == 11};
}

HardInstance planted_cover(std::size_t planted, std::size_t share, std::size_t decoys,
                           std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::size_t rows = planted + decoys, columns = planted * share;
  std::vector<std::size_t> row_order(rows), column_order(columns);
  std::iota(row_order.begin(), row_order.end(), std::size_t{0});
  std::iota(column_order.begin(), column_order.end(), std::size_t{0});
  std::ranges::shuffle(row_order, random);
  std::ranges::shuffle(column_order, random);
  BitRows matrix(rows, columns);
  for (std::size_t i = 0; i < columns; ++i) matrix.set(row_order[i / share], column_order[i]);
  for (std::size_t i = planted; i < rows; ++i) {
    std::ranges::shuffle(column_order, random);
    for (std::size_t j = 0; j < share; ++j) matrix.set(row_order[i], column_order[j]);
  }
  return {"planted " + std::to_string(planted), std::move(matrix), planted, true};
}

HardInstance greedy_trap(int levels, std::size_t copies) {
  const std::size_t rows = static_cast<std::size_t>(levels) + 2;
  const std::size_t columns = 2 * ((std::size_t{1} << levels) - 1);
  BitRows matrix(copies * rows, copies * columns);
  for (std::size_t copy = 0; copy < copies; ++copy) {
    const std::size_t first_row = copy * rows;
    std::size_t column = copy * columns;
    for (int level = levels; level >= 1; --level) {
      const std::size_t half = std::size_t{1} << (level - 1);
      matrix.set_range(first_row + static_cast<std::size_t>(levels - level), column, 2 * half);
      matrix.set_range(first_row + rows - 2, column, half);
      matrix.set_range(first_row + rows - 1, column + half, half);
      column += 2 * half;
    }
  }
  return {"greedy trap " + std::to_string(levels), std::move(matrix), 2 * copies, true};
}

HardInstance camera_placement(const CameraRoom& room) {
  constexpr int kSide = 11, kLayers = 5, kDirections = 8;
  // Places on the border of a pyramid count, on every machine.
  constexpr double kSlack = 1e-9;
  const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
  const double wide = std::tan(radians(room.horizontal / 2)),
               high = std::tan(radians(room.vertical / 2));
  using Vector = Eigen::Vector3d;
  const auto for_each_place = [&](int layers, const auto& visit) {
    for (int x = 0; x < kSide; ++x) {
      for (int y = 0; y < kSide; ++y) {
        for (int z = 0; z < layers; ++z) visit(Vector(x, y, z));
      }
    }
  };
  BitRows matrix(kSide * kSide * kDirections * room.tilts.size(), kSide * kSide * kLayers);
  std::size_t row = 0;
  for_each_place(1, [&](const Vector& below) {
    const Vector camera = below + Vector(0, 0, room.height);
    for (const double tilt : room.tilts) {
      for (int k = 0; k < kDirections; ++k, ++row) {
        const double up = radians(tilt), round = 2 * std::numbers::pi * k / kDirections;
        const Vector forward(std::cos(up) * std::cos(round), std::cos(up) * std::sin(round),
                             std::sin(up));
        const Vector right(std::sin(round), -std::cos(round), 0);
        const Vector above = right.cross(forward);
        std::size_t column = 0;
        for_each_place(kLayers, [&](const Vector& place) {
          const Vector d = place - camera;
          const double depth = d.dot(forward);
          if (depth > kSlack && std::fabs(d.dot(right)) <= wide * depth + kSlack &&
              std::fabs(d.dot(above)) <= high * depth + kSlack && d.norm() <= room.range + kSlack) {
            matrix.set(row, column);
          }
          ++column;
        });
      }
    }
  });
  return {"cameras to " + std::to_string(room.range).substr(0, 3), std::move(matrix), room.best,
          room.proved};
}

std::vector<HardInstance> hard_instances() {
  std::vector<HardInstance> instances;
  for (const int dimension : {2, 3, 4}) instances.push_back(affine_lines(dimension));
  for (const int dimension : {6, 7, 8}) instances.push_back(cube_cycles(dimension));
  instances.push_back(bipartitions(11));
  instances.push_back(planted_cover(20, 30, 400, 1));
  instances.push_back(greedy_trap(6, 20));
  return instances;
}

std::vector<HardInstance> library_instances() {
  std::vector<HardInstance> instances;
  for (const int points : {10, 12, 13}) instances.push_back(bipartitions(points));
  for (const int dimension : {5, 6}) instances.push_back(affine_lines(dimension));
  for (const int dimension : {9, 10, 11}) instances.push_back(cube_cycles(dimension));
  return instances;
}

std::vector<HardInstance> camera_instances() {
  std::vector<HardInstance> instances;
  const std::array<double, 3> steep = {-22.5, -45, -67.5}, flat = {-15, -45, -75},
                              level = {0, -45, -90}, down = {-30, -45, -60};
  for (const CameraRoom& room :
       {CameraRoom{4, steep, 60, 45, 8, 8, true}, CameraRoom{4, level, 65, 48, 9.9, 8, true},
        CameraRoom{4, flat, 60, 45, 9, 8, true}, CameraRoom{4.5, down, 65, 48, 7, 15, true},
        CameraRoom{4.5, down, 65, 48, 5.5, 23, false}}) {
    instances.push_back(camera_placement(room));
  }
  return instances;
}

}  // namespace viewcover::reference
