#pragma once

#include <limits>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/contact/contact_surface.h"
#include "incision/solver/spring.h"
#include "incision/surface/surface.h"

namespace incision {

/// Between pieces the contact is this much stiffer than the layer of elements it lies on: κ = CONTACT_STIFFNESS E/h
/// [Pa/m]. A pressure p presses in by p h/(CONTACT_STIFFNESS E): below 1 % of an element up to p = E/5, where the body
/// itself gives way by a fifth. More costs iterations, as the root of it.
inline constexpr double CONTACT_STIFFNESS = 20;

/// Against obstacles the contact is so much stiffer than the layer of elements, as it costs nothing there.
inline constexpr double OBSTACLE_STIFFNESS = 200;

/// Gaps this wide, in elements, are watched even where nothing moves: what a step's forces may close.
inline constexpr double MARGIN = 0.1;

/// A contact that begins inside, as where a scene starts with an overlap, or that gets deeper by coming upon another
/// plane, leaves that depth alone: a spring that is there at once would come with energy from nowhere, and shoot the
/// body out. The depth inside an obstacle in which it begins is worked off at this speed, in elements a second; that is
/// the obstacle's work.
inline constexpr double RECOVERY = 1;

/// Contacts of the body with itself that begin deeper than this, in elements, are none: the point lies behind a face of
/// something thin, which another face keeps it out of. Those that go on from the last step, on a side that is known,
/// stay up to MAX_DEPTH.
inline constexpr double DEEPEST_BEGIN = 0.05;

/// A place where a point of the surface may touch a plane in this step.
struct Candidate {
  int sample;         ///< of the ContactSurface; for obstacles the vertex, for EDGES the first edge
  int partner;        ///< the obstacle, BODY: the body's own face, or EDGES: two of the body's edges
  int other = -1;     ///< for EDGES the second edge, for BODY a vertex of the face
  int triangle = -1;  ///< for BODY: the face
  Vec3 normal;        ///< n, unit, from the partner to the point
  double gap = 0;     ///< g [m] when the step starts, negative inside
  double way_out = std::numeric_limits<double>::infinity();  ///< a bound on how deep it counts, by another way out [m]
  double ignored = 0;                                        ///< depth that the force leaves alone [m]
  double worked_off = 0;                                     ///< how much of it is still to be worked off [m]
  bool goes_on = false;                                      ///< as one of the last step's, on the side that is known
  Vec3 drift;             ///< of the partner in the step, where it is an obstacle [m]
  double stiffness = 0;   ///< k [N/m]
  double tangential = 0;  ///< k_t [N/m]
  double size = 0;        ///< h of the elements there [m]
  Vec3 slip;              ///< s, tangential: how far the point has dragged on the partner, elastically [m]
  Vec3 normal_in_solid;   ///< the normal in the frame of the solid; that of the body itself where it is the partner
  Spring point;           ///< y: the point less what it meets on the body; its stiffness and force are for update()

  static constexpr int BODY = -1, EDGES = -2;

  bool isOfBody() const { return partner < 0; }
};

/// What a contact leaves for the next step.
struct Touch {
  int sample, partner, other;    ///< of the candidate
  double gap;                    ///< at the end of the step, less the depth that is ignored [m]
  double ignored, worked_off;    ///< of the candidate [m]
  double stiffness, tangential;  ///< of the candidate [N/m]
  Vec3 slip;                     ///< at the end of the step [m]
  Vec3 normal_in_solid;          ///< of the candidate
  SurfaceVertex vertex;          ///< where it is, and
  int sample_of_vertex;          ///< which of the vertex's samples: so that it is found again after a cut
  SurfaceVertex other_vertex;    ///< that of the face, or where the second edge begins, and
  int edge_of_other;             ///< which of those it is that begin there

  static constexpr int GONE = -1;  ///< a sample that a cut has taken away
};

template <class Archive>
void serialize(Archive& archive, Touch& touch) {
  auto& [sample, partner, other, gap, ignored, worked_off, stiffness, tangential, slip, normal_in_solid, vertex,
         sample_of_vertex, other_vertex, edge_of_other] = touch;
  archive(sample, partner, other, gap, ignored, worked_off, stiffness, tangential, slip, normal_in_solid, vertex,
          sample_of_vertex, other_vertex, edge_of_other);
}

void check(const std::vector<Touch>& touches, const MemoryLimits& limits);

/// Contacts are in the order of their partners, and then of their samples.
template <typename T, typename U>
bool comesBefore(const T& a, const U& b) {
  return a.partner != b.partner ? a.partner < b.partner : a.sample < b.sample;
}

/// The touch of the last step that a candidate with this partner, sample and other goes on from, or null: of those that
/// the sample had, that with the same piece or the same edge.
const Touch* touchBefore(const ContactSurface& surface, const std::vector<Touch>& touches, int partner, int sample,
                         int other);

}  // namespace incision
