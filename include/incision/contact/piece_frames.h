#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "incision/base/lists.h"
#include "incision/contact/contact_surface.h"
#include "incision/contact/surface_match.h"

namespace incision {

/// How each piece moves as a rigid body, and by how much it does not, from one search for contacts to the next.
class PieceFrames {
 public:
  /// Where a piece is: s ↦ turn s + centre takes its shape there.
  struct Frame {
    Mat3 turn = Mat3::Identity();
    Vec3 centre = Vec3::Zero();
  };

  /// A piece when a step starts, at [0], and where it would be when the step ends, at [1].
  struct Piece {
    std::array<Frame, 2> frames;
    std::array<double, 2> off = {0, 0};  ///< how far vertices are from where the shape has them, the most [m]
    Eigen::AlignedBox3d way;             ///< round all that it passes in the step
    Eigen::AlignedBox3d shape;           ///< round its shape
    double worn = 0;                     ///< by how much shapes that were taken anew differ, all together [m]
    bool is_followed = false;            ///< it has a shape
    double size = 0;                     ///< the largest of its vertices' [m]
  };

  /// The surface is another one, of which this is `known`, and its vertices are at `x` [m]. Pieces that there were keep
  /// their shapes, and what is new of them counts from where it is.
  void surfaceChanged(const ContactSurface& surface, const SurfaceMatch& known, const std::vector<Vec3>& x);

  /// The shape of a piece that is off by more than `most` [m] is taken anew, in the frame that the piece has.
  void update(const std::vector<Vec3>& x, const std::vector<Vec3>& ahead, double most, int threads);

  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  void follow(const std::vector<Vec3>& x, const std::vector<Vec3>& ahead, double most, int piece);
  void begin(const std::vector<Vec3>& x, int piece);
  void takeShape(const std::vector<Vec3>& x, int piece);
  void goOn(const std::vector<Vec3>& x, const std::vector<const Vec3*>& known_shape, int piece);
  void fit(int piece, int end, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead);

  Lists<int> vertices_;      // of each piece
  std::vector<Vec3> shape_;  // of each piece, its vertices in the order of vertices_ [m]
  std::vector<Piece> pieces_;
};

/// The most that a point of piece a, or of piece b as seen from a, has moved relative to the other since they were at
/// `from_a` and `from_b`, until the start of the step, end = 0, or its end, end = 1 [m].
double movedApart(const PieceFrames::Piece& a, const PieceFrames::Piece& b, const PieceFrames::Frame& from_a,
                  const PieceFrames::Frame& from_b, int end);

}  // namespace incision
