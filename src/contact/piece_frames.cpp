#include "incision/contact/piece_frames.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Fewer vertices do not tell how a piece is turned.
constexpr int MIN_KNOWN = 4;

/// The frame, near another one, that brings the points of a shape, shapeOf(i), best to where they are, at(i).
template <typename ShapeOf, typename At>
Frame fitted(const Frame& near, int count, const ShapeOf& shapeOf, const At& at) {
  Vec3 way = Vec3::Zero(), mean = Vec3::Zero();  // of the points from near.centre, and of the shape
  Mat3 F = Mat3::Zero();
  for (int i = 0; i < count; ++i) {
    const Vec3 p = at(i) - near.centre, s = shapeOf(i);
    way += p;
    mean += s;
    F += p * s.transpose();
  }
  way /= std::max(1, count);
  mean /= std::max(1, count);
  F -= count * way * mean.transpose();
  Frame frame;
  frame.turn = polarRotation(F, near.turn);
  frame.centre = near.centre + way - frame.turn * mean;
  return frame;
}

}  // namespace

double movedApart(const PieceFrames::Piece& a, const PieceFrames::Piece& b, const Frame& from_a, const Frame& from_b,
                  int end) {
  return std::min(farthest(a.shape, from_a, from_b, a.frames[end], b.frames[end]),
                  farthest(b.shape, from_b, from_a, b.frames[end], a.frames[end]));
}

void PieceFrames::surfaceChanged(const ContactSurface& surface, const SurfaceMatch& known, const std::vector<Vec3>& x) {
  PieceFrames now;
  now.vertices_ = sortedByList(surface.vertex_piece, surface.pieces);
  now.shape_.resize(now.vertices_.values().size());
  now.pieces_.resize(surface.pieces);
  std::vector<const Vec3*> known_shape(surface.size.size(), nullptr);
  for (int p = 0; p < static_cast<int>(pieces_.size()); ++p) {
    if (known.pieces[p] < 0 || !pieces_[p].is_followed) continue;
    now.pieces_[known.pieces[p]] = pieces_[p];
    now.pieces_[known.pieces[p]].size = 0;
    for (int i = vertices_.start(p); i < vertices_.start(p + 1); ++i)
      if (const int v = known.vertices[vertices_.values()[i]]; v >= 0) known_shape[v] = &shape_[i];
  }
  for (std::size_t v = 0; v < surface.size.size(); ++v) {
    double& size = now.pieces_[surface.vertex_piece[v]].size;
    size = std::max(size, surface.size[v]);
  }
  for (int piece = 0; piece < surface.pieces; ++piece)
    if (now.pieces_[piece].is_followed) now.goOn(x, known_shape, piece);
  *this = std::move(now);
}

/// A piece that has other vertices than it had.
void PieceFrames::goOn(const std::vector<Vec3>& x, const std::vector<const Vec3*>& known_shape, int piece) {
  Piece& followed = pieces_[piece];
  const Span<const int> vertices = std::as_const(vertices_)[piece];
  std::vector<int> known;
  for (int v : vertices)
    if (known_shape[v]) known.push_back(v);
  const int count = static_cast<int>(known.size());
  followed.is_followed = count >= MIN_KNOWN;
  if (!followed.is_followed) return;
  const Frame frame = fitted(
      followed.frames[0], count, [&](int i) { return *known_shape[known[i]]; }, [&](int i) { return x[known[i]]; });
  followed.frames[0] = frame;
  for (int i = 0; i < vertices.size(); ++i) {
    const int v = vertices[i];
    Vec3& s = shape_[vertices_.start(piece) + i];
    s = known_shape[v] ? *known_shape[v] : Vec3(frame.turn.transpose() * (x[v] - frame.centre));
    followed.shape.extend(s);
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

void PieceFrames::fit(int piece, int end, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead) {
  Piece& followed = pieces_[piece];
  const Span<const int> vertices = std::as_const(vertices_)[piece];
  const Vec3* shape = shape_.data() + vertices_.start(piece);
  const auto at = [&](int i) { return end == 0 ? x[vertices[i]] : Vec3(x[vertices[i]] + ahead[vertices[i]]); };
  Frame& frame = followed.frames[end];
  frame = fitted(
      frame, vertices.size(), [&](int i) -> const Vec3& { return shape[i]; }, at);
  double off = 0;
  for (int i = 0; i < vertices.size(); ++i)
    off = std::max(off, (at(i) - frame.centre - frame.turn * shape[i]).squaredNorm());
  followed.off[end] = std::sqrt(off);
}

}  // namespace incision
