// The problems of code_aster in which rigid blocks are drawn off each other.
#include "report/benchmark/exact.h"

namespace incision::report {
namespace {

constexpr double FAR = 1e3;    // beyond every body [m]
constexpr double JUMP = 1e-3;  // [m]

/// What lies between two values of a coordinate.
RestBox between(int axis, double low, double high) {
  RestBox box{Vec3::Constant(-FAR), Vec3::Constant(FAR)};
  box.min[axis] = low;
  box.max[axis] = high;
  return box;
}

RestBox column(double x_low, double x_high, double y_low, double y_high) {
  return {Vec3(x_low, y_low, -FAR), Vec3(x_high, y_high, FAR)};
}

ZonesCase separation() {
  constexpr double LENGTH = 25, MOVE = 1e-6;
  return {"bar cut across",
          "SSNV173",
          block({1, 1, 1}, Vec3(5, 5, LENGTH)),
          LENGTH,
          {plane(Vec3(2.5, 2.5, LENGTH / 2), Vec3::UnitZ())},
          {{between(2, -FAR, LENGTH / 2), Vec3::Zero(), slab(2, 0)},
           {between(2, LENGTH / 2, FAR), Vec3(0, 0, MOVE), slab(2, LENGTH)}}};
}

/// The ends of a bar drawn off what is held in its middle, by two cuts in the middle of layers of elements.
ZonesCase threeBlocks(const char* problem, const std::array<int, 3>& cells) {
  constexpr double LENGTH = 50, LOW = LENGTH / 4, HIGH = 3 * LENGTH / 4, MOVE = 3e-3;
  return {problem,
          "SSNV195",
          block(cells, Vec3(5, 5, LENGTH)),
          LENGTH,
          {plane(Vec3(2.5, 2.5, LOW), Vec3::UnitZ()), plane(Vec3(2.5, 2.5, HIGH), Vec3::UnitZ())},
          {{between(2, -FAR, LOW), Vec3(0, 0, -MOVE), slab(2, 0)},
           {between(2, LOW, HIGH), Vec3::Zero(), slab(2, LENGTH / 2)},
           {between(2, HIGH, FAR), Vec3(0, 0, MOVE), slab(2, LENGTH)}}};
}

/// A plate of elements 1 m wide, its centre in the middle of one.
TetMesh plate(int cells) {
  return block({cells, cells, 1}, Vec3(cells, cells, 1), Vec3(-cells / 2.0, -cells / 2.0, 0));
}

const Vec3 MOVES[] = {JUMP * Vec3(1, 0.5, 0.2), JUMP* Vec3(-0.3, 1, -0.7), JUMP* Vec3(0.4, -0.8, 1),
                      JUMP* Vec3(-1, -0.6, 0)};

ZonesCase crossing() {
  return {"X: two cracks cross in an element",
          "SSNV511",
          plate(5),
          5,
          {plane(Vec3::Zero(), Vec3::UnitY()), plane(Vec3::Zero(), Vec3::UnitX())},
          {{column(-FAR, 0, -FAR, 0), MOVES[0], column(-2.6, -1.4, -2.6, -1.4)},
           {column(0, FAR, -FAR, 0), MOVES[1], column(1.4, 2.6, -2.6, -1.4)},
           {column(-FAR, 0, 0, FAR), MOVES[2], column(-2.6, -1.4, 1.4, 2.6)},
           {column(0, FAR, 0, FAR), MOVES[3], column(1.4, 2.6, 1.4, 2.6)}}};
}

ZonesCase joined() {
  return {"I: a crack between two others",
          "SSNV512",
          plate(9),
          9,
          {plane(Vec3(0, 2, 0), Vec3::UnitY()), plane(Vec3(0, -2, 0), Vec3::UnitY()),
           rectangle(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), 4, 0)},
          {{between(1, -FAR, -2), MOVES[0], between(1, -FAR, -2.4)},
           {between(1, 2, FAR), MOVES[1], between(1, 2.4, FAR)},
           {column(-FAR, 0, -2, 2), MOVES[2], column(-4.6, -1.4, -1.6, 1.6)},
           {column(0, FAR, -2, 2), MOVES[3], column(1.4, 4.6, -1.6, 1.6)}}};
}

ZonesCase branched() {
  return {"F: two cracks end at a third",
          "SSNV513",
          plate(9),
          9,
          {plane(Vec3::Zero(), Vec3::UnitX()), rectangle(Vec3(2.5, 2, 0), Vec3::UnitY(), Vec3::UnitX(), 5, 0),
           rectangle(Vec3(2.5, -2, 0), Vec3::UnitY(), Vec3::UnitX(), 5, 0)},
          {{between(0, -FAR, 0), MOVES[0], between(0, -FAR, -1.4)},
           {column(0, FAR, 2, FAR), MOVES[1], column(1.4, 4.6, 2.4, 4.6)},
           {column(0, FAR, -2, 2), MOVES[2], column(1.4, 4.6, -1.6, 1.6)},
           {column(0, FAR, -FAR, -2), MOVES[3], column(1.4, 4.6, -4.6, -2.4)}}};
}

}  // namespace

std::vector<ZonesCase> publishedZones() {
  return {separation(),
          threeBlocks("three blocks of a bar", {2, 2, 10}),
          threeBlocks("three blocks of two layers of elements", {1, 1, 2}),
          crossing(),
          joined(),
          branched()};
}

}  // namespace incision::report
