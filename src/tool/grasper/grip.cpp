#include "incision/tool/grasper/grip.h"

#include <algorithm>
#include <cmath>

namespace incision {
namespace {

/// All springs together have k = GRIP_STIFFNESS E ℓ, with the length ℓ of the mouth, or of an element where that is
/// longer: what is held gives way by a twentieth of what the tissue round it does. More costs iterations.
constexpr double GRIP_STIFFNESS = 20;

/// Points that stand for what is held: no more than a few in an element, and each a sixtieth of the force.
constexpr std::size_t MOST_POINTS = 64;

}  // namespace

Grip::Grip(double largest, const Mouth& mouth, ToolInStep* tool, const Materials& materials, const CutMesh& mesh)
    : largest_(largest), mouth_(mouth), tool_(tool), materials_(materials), mesh_(mesh) {}

void Grip::close(const Pose& link, const std::vector<Vec3>& x) {
  memory_.points = gripPoints(mouth_, link, x, mesh_, MOST_POINTS);
  memory_.taken = static_cast<int>(memory_.points.size());
}

void Grip::changed(const CutMesh& mesh) {
  std::vector<GripPoint>& points = memory_.points;
  const auto lost = [&](GripPoint& grip) { return !findPart(mesh, &grip.held); };
  points.erase(std::remove_if(points.begin(), points.end(), lost), points.end());
}

bool Grip::begin(const StepStart& start, std::vector<Spring>* springs) {
  if (memory_.points.empty() || !tool_->in_place) return false;
  const std::size_t first = springs->size();
  for (const GripPoint& grip : memory_.points) {
    Spring& spring = springs->emplace_back();
    for (int I = 0; I < 4; ++I) spring.add(start.mesh.parts()[grip.held.part].copies[I], grip.held.point[I]);
  }
  const Span<Spring> own(springs->data() + first, springs->data() + springs->size());
  pulls_.resize(memory_.points.size());
  slipping_.reserve(pulls_.size());
  slipped_to_.reserve(pulls_.size());
  found_.reserve(pulls_.size());
  findStiffness(start, own);
  const Pose from = tool_->groups[0].at(start.span.from), to = tool_->groups[0].at(start.span.to);
  for (int i = 0; i < own.size(); ++i) {
    const GripPoint& grip = memory_.points[static_cast<std::size_t>(i)];
    Pull& pull = pulls_[static_cast<std::size_t>(i)];
    // A spring that gets stiffer keeps its energy.
    const double kept = grip.stiffness > 0 ? std::sqrt(std::min(1.0, grip.stiffness / pull.stiffness)) : 1;
    const Vec3 slip = placed(grip.end, from) - weightedSum(own[i], start.motion.x);
    pull.slip = kept * slip;
    pull.end = grip.end - from.orientation.conjugate() * (slip - pull.slip);
    pull.drift = placed(pull.end, to) - placed(pull.end, from);
  }
  return true;
}

/// What resists at a point is that of its copies, and that of its piece, each shared by all the points that pull at it.
void Grip::findStiffness(const StepStart& start, Span<Spring> springs) {
  crowd_.resize(start.inertia.size());
  on_piece_.resize(start.piece_mass.size());
  const auto pieceOf = [&](const Spring& spring) { return static_cast<std::size_t>(start.piece[spring.copies[0]]); };
  for (const Spring& spring : springs) {
    for (int k = 0; k < spring.count; ++k) crowd_[spring.copies[k]] += std::abs(spring.weights[k]);
    ++on_piece_[pieceOf(spring)];
  }
  const double squared_step = start.span.time_step * start.span.time_step, length = mouth_.box().sizes().maxCoeff();
  for (int i = 0; i < springs.size(); ++i) {
    const Spring& spring = springs[i];
    double mobility = on_piece_[pieceOf(spring)] / start.piece_mass[pieceOf(spring)];
    for (int k = 0; k < spring.count; ++k)
      mobility += std::abs(spring.weights[k]) * crowd_[spring.copies[k]] / start.inertia[spring.copies[k]];
    const int element = memory_.points[static_cast<std::size_t>(i)].held.element;
    const double of_tissue =
        GRIP_STIFFNESS * materials_.youngModulus(element) * std::max(length, materials_.size(element)) / memory_.taken;
    pulls_[static_cast<std::size_t>(i)].stiffness = std::min(of_tissue, STIFFEST / (squared_step * mobility));
  }
  for (const Spring& spring : springs) {
    for (int k = 0; k < spring.count; ++k) crowd_[spring.copies[k]] = 0;
    on_piece_[pieceOf(spring)] = 0;
  }
}

Grip::Trial Grip::tryAt(const Pull& pull, const Vec3& moved) const {
  Trial trial;
  trial.slip = pull.slip + pull.drift - moved;
  const double slip = trial.slip.norm();
  trial.slips = pull.stiffness * slip > share();
  trial.secant = trial.slips ? share() / slip : pull.stiffness;
  return trial;
}

/// The forces descend from ½ k s², which goes on evenly from the share on.
void Grip::update(Span<const Vec3> moved, Span<Spring> springs) {
  for (int i = 0; i < springs.size(); ++i) {
    const Trial trial = tryAt(pulls_[static_cast<std::size_t>(i)], moved[i]);
    Mat3 free = Mat3::Identity();
    if (trial.slips) free -= trial.slip * trial.slip.transpose() / trial.slip.squaredNorm();
    springs[i].set(trial.secant * free, trial.secant * trial.slip, moved[i]);
  }
}

void Grip::accept(const StepSpan& span, Span<const Vec3> moved, const Motion& end, const Wrench& felt) {
  tool_->feel(0, span, felt);
  const Pose link = tool_->groups[0].at(span.to);
  slipping_.clear();
  slipped_to_.clear();
  for (std::size_t i = 0; i < memory_.points.size(); ++i) {
    GripPoint& grip = memory_.points[i];
    const Trial trial = tryAt(pulls_[i], moved[static_cast<int>(i)]);
    grip.stiffness = pulls_[i].stiffness;
    grip.end = pulls_[i].end;
    if (!trial.slips) continue;
    grip.end = grip.anchor;
    slipping_.push_back(i);
    slipped_to_.push_back(placed(grip.anchor, link) - trial.secant / grip.stiffness * trial.slip);
  }
  if (!slipping_.empty()) letSlip(end.x);
}

/// Each anchor whose material slips holds what has come to be where its spring ends, and is done with where that is
/// nothing.
void Grip::letSlip(const std::vector<Vec3>& x) {
  findMaterial(slipped_to_, x, mesh_, &found_);
  for (std::size_t k = 0; k < slipping_.size(); ++k)
    if (found_[k]) memory_.points[slipping_[k]].held = *found_[k];
  std::size_t k = 0, kept = 0;
  for (std::size_t i = 0; i < memory_.points.size(); ++i) {
    const bool slips = k < slipping_.size() && slipping_[k] == i;
    if (!slips || found_[k]) memory_.points[kept++] = memory_.points[i];
    if (slips) ++k;
  }
  memory_.points.resize(kept);
}

}  // namespace incision
