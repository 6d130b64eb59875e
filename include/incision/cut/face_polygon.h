#pragma once

#include <Eigen/Core>
#include <vector>

#include "incision/cut/part.h"

namespace incision {

/// A point on an element's face as weights of the face's three nodes.
using FacePoint = Eigen::Vector3d;

/// A convex polygon on a face, counter-clockwise for the order in which the face's nodes are listed.
using FacePolygon = std::vector<FacePoint>;

/// The corners of a polygon on `face` of an element, in the element's coordinates.
std::vector<Barycentric> inElement(const FacePolygon& polygon, int face);

/// Share of the face's area that a polygon covers.
double faceShare(const FacePolygon& polygon);

/// Centroid by area; with no area, the mean of the corners.
FacePoint centroid(const FacePolygon& polygon);

/// Common region of two convex polygons on one face; empty when they are apart.
FacePolygon overlap(const FacePolygon& a, const FacePolygon& b);

}  // namespace incision
