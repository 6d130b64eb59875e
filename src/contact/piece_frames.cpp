#include "incision/contact/piece_frames.h"

#include <algorithm>
#include <cmath>

#include "incision/base/parallel.h"
#include "incision/fem/rotation.h"

namespace incision {
namespace {

using Frame = PieceFrames::Frame;

/// Where the points of one shape have gone as seen from another piece: an affine function of the point, so the one that
/// has gone farthest is a corner of the shape's box.
double farthest(const Eigen::AlignedBox3d& shape, const Frame& of, const Frame& seen_from, const Frame& of_now,
                const Frame& seen_from_now) {
  const Mat3 turn = seen_from_now.turn.transpose() * of_now.turn - seen_from.turn.transpose() * of.turn;
  const Vec3 shift = seen_from_now.turn.transpose() * (of_now.centre - seen_from_now.centre) -
                     seen_from.turn.transpose() * (of.centre - seen_from.centre);
  double most = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 s = shape.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    most = std::max(most, (turn * s + shift).squaredNorm());
  }
  return std::sqrt(most);
}

}  // namespace

double movedApart(const PieceFrames::Piece& a, const PieceFrames::Piece& b, const Frame& from_a, const Frame& from_b,
                  int end) {
  return std::min(farthest(a.shape, from_a, from_b, a.frames[end], b.frames[end]),
                  farthest(b.shape, from_b, from_a, b.frames[end], a.frames[end]));
}

void PieceFrames::surfaceChanged(const ContactSurface& surface) {
  vertices_ = sortedByList(surface.vertex_piece, surface.pieces);
  shape_.resize(vertices_.values().size());
  pieces_.assign(surface.pieces, {});
  for (std::size_t v = 0; v < surface.size.size(); ++v) {
    double& size = pieces_[surface.vertex_piece[v]].size;
    size = std::max(size, surface.size[v]);
  }
}

void PieceFrames::update(const std::vector<Vec3>& x, const std::vector<Vec3>& ahead, double most, int threads) {
  parallelFor(static_cast<int>(pieces_.size()), threads, [&](int piece) { follow(x, ahead, most, piece); });
}

void PieceFrames::follow(const std::vector<Vec3>& x, const std::vector<Vec3>& ahead, double most, int piece) {
  Piece& followed = pieces_[piece];
  followed.way.setEmpty();
  for (int v : std::as_const(vertices_)[piece]) {
    followed.way.extend(x[v]);
    followed.way.extend(x[v] + ahead[v]);
  }
  if (!followed.is_followed) begin(x, piece);
  fit(piece, 0, x, ahead);
  if (followed.off[0] > most) {
    followed.worn += followed.off[0];
    takeShape(x, piece);
  }
  followed.frames[1] = followed.frames[0];
  fit(piece, 1, x, ahead);
}

void PieceFrames::begin(const std::vector<Vec3>& x, int piece) {
  const Span<const int> vertices = std::as_const(vertices_)[piece];
  Vec3 sum = Vec3::Zero();
  for (int v : vertices) sum += x[v];
  pieces_[piece].frames[0] = {Mat3::Identity(), sum / std::max(1, vertices.size())};
  pieces_[piece].is_followed = true;
  takeShape(x, piece);
}

void PieceFrames::takeShape(const std::vector<Vec3>& x, int piece) {
  Piece& taken = pieces_[piece];
  const Span<const int> vertices = std::as_const(vertices_)[piece];
  taken.off[0] = 0;
  taken.shape.setEmpty();
  for (int i = 0; i < vertices.size(); ++i) {
    Vec3& s = shape_[vertices_.start(piece) + i];
    s = taken.frames[0].turn.transpose() * (x[vertices[i]] - taken.frames[0].centre);
    taken.shape.extend(s);
  }
}

/// The rotation that fits best, from the last one on.
void PieceFrames::fit(int piece, int end, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead) {
  Piece& fitted = pieces_[piece];
  const Span<const int> vertices = std::as_const(vertices_)[piece];
  const Vec3* shape = shape_.data() + vertices_.start(piece);
  const auto at = [&](int v) { return end == 0 ? x[v] : Vec3(x[v] + ahead[v]); };
  Vec3 sum = Vec3::Zero();
  Mat3 F = Mat3::Zero();
  for (int i = 0; i < vertices.size(); ++i) {
    const Vec3 p = at(vertices[i]) - fitted.frames[0].centre;
    sum += p;
    F += p * shape[i].transpose();
  }
  Frame& frame = fitted.frames[end];
  frame.turn = polarRotation(F, frame.turn);
  frame.centre = fitted.frames[0].centre + sum / std::max(1, vertices.size());
  double off = 0;
  for (int i = 0; i < vertices.size(); ++i)
    off = std::max(off, (at(vertices[i]) - frame.centre - frame.turn * shape[i]).squaredNorm());
  fitted.off[end] = std::sqrt(off);
}

}  // namespace incision
