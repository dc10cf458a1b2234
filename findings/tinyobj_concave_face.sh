#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libtinyobjloader-dev 2.0.0~rc10+dfsg-2+b1.
# Behaviour: a concave face is cut into triangles that are not the face: a quad along its shorter diagonal, even if that lies outside, and
# of a concave pentagon two of three triangles are left out if its corners run clockwise.
# Expected: triangles whose areas add up to the face. The loader cuts faces by default, and for more than four corners it cuts ears, which
# is a method for concave polygons.
# Seen: an arrow head of area 1.5 becomes triangles of 4.5 in all; a pentagon of area 10 is cut right counterclockwise, and 4 of its 10 are
# left clockwise.
source "$(dirname "$0")/common.sh"
debian_packages libtinyobjloader-dev=2.0.0~rc10+dfsg-2+b1
cat >faces.cpp <<'END'
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
#include <cmath>
#include <cstdio>
#include <sstream>

double area(const char* text) {
  tinyobj::attrib_t vertices;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream stream(text);
  if (!tinyobj::LoadObj(&vertices, &shapes, &materials, &warning, &error, &stream) || !(warning + error).empty()) return -1;
  double sum = 0;
  const auto& corners = shapes[0].mesh.indices;
  const auto x = [&](size_t i) { return vertices.vertices[3 * corners[i].vertex_index]; };
  const auto y = [&](size_t i) { return vertices.vertices[3 * corners[i].vertex_index + 1]; };
  for (size_t i = 0; i < corners.size(); i += 3)
    sum += std::abs((x(i + 1) - x(i)) * (y(i + 2) - y(i)) - (y(i + 1) - y(i)) * (x(i + 2) - x(i))) / 2;
  return sum;
}

int main() {
  const std::string pentagon = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\n";
  std::printf("arrow head %.1f of 1.5\n", area("v -0.3 0 0\nv 0 5 0\nv 0.3 0 0\nv 0 10 0\nf 1 2 3 4\n"));
  std::printf("pentagon %.1f of 10.0\n", area((pentagon + "f 1 2 3 4 5\n").c_str()));
  std::printf("clockwise %.1f of 10.0\n", area((pentagon + "f 5 4 3 2 1\n").c_str()));
}
END
compile faces.cpp
look_at ./program
conclude "arrow head 4.5 of 1.5 pentagon 10.0 of 10.0 clockwise 4.0 of 10.0" "tinyobjloader cuts concave faces into triangles that are not the face"
