#include "incision/contact/contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "incision/base/parallel.h"
#include "incision/contact/skin_in_step.h"
#include "incision/contact/touch_places.h"

namespace incision {
namespace {

/// k_t/k: as a half space gives way to a shear, roughly.
constexpr double TANGENTIAL = 0.5;

/// Against obstacles, which do not give way, so many times that as far as the copies resist: what is held and pressed
/// by one sinks in by less than 0.2 % of what it gives way by itself.
constexpr double STIFFER_ON_OBSTACLES = 12;

/// A contact is stiffer than STIFFEST where its point would otherwise go in far, however soft the body: as many times
/// that mass as the depth has multiples of the one here, in elements, and up to STIFFEST_IMPACT times. Against
/// obstacles that is for what hits them fast, which must neither come out behind nor overlap by much; between pieces
/// also for what is light and squeezed by heavy ones, which else would store energy and be thrown out.
constexpr double IMPACT_DEPTH = 0.005, SQUEEZE_DEPTH = 0.0005, STIFFEST_IMPACT = 1000;

/// What a point that slides resists along its way, as a share of what it does across it. Along it the force is
/// constant, so that a Newton step would go far beyond where it turns round; what has turned round since the last one
/// resists all of it, lest it turn again and again.
constexpr double SLIDING = 0.2, TURNED = 1;

/// Gaps this small, in elements, are rounding: faces just cut lie in each other's plane.
constexpr double TOUCHING = 1e-9;

}  // namespace

void ContactReport::add(const ContactReport& other) {
  count += other.count;
  deepest = std::max(deepest, other.deepest);
  energy += other.energy;
}

void Contact::recall(const std::any& kept) {
  WithMemory::recall(kept);
  skin_version_ = 0;
}

/// The memory's touches as the skin numbers samples now.
const std::vector<Touch>& Contact::touchesOnSkin() {
  if (skin_version_ == skin_->version()) return memory_;
  renumbered_ = memory_;
  renumber(skin_->surface(), &renumbered_);
  return renumbered_;
}

bool Contact::begin(const StepStart& start, std::vector<Spring>* springs) {
  report_ = ContactReport();
  candidates_.clear();
  if (isThere()) {
    skin_->begin(start);
    const std::vector<Touch>& touches = touchesOnSkin();
    find(*skin_, start, touches, &candidates_);
    softenStiffest(start);
    continueTouches(touches, start.span.time_step);
  }
  const auto too_deep = [](const Candidate& candidate) {
    const double deepest = candidate.goes_on ? MAX_DEPTH : DEEPEST_BEGIN;
    return candidate.isOfBody() && candidate.ignored > deepest * candidate.size;
  };
  candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), too_deep), candidates_.end());
  gaps_.clear();
  frictions_.clear();
  for (const Candidate& candidate : candidates_) {
    springs->push_back(candidate.point);
    const double unmoved = candidate.gap + candidate.ignored + TOUCHING * candidate.size;
    gaps_.push_back({candidate.normal, unmoved - candidate.normal.dot(candidate.drift), true});
    frictions_.push_back({0, Vec3::Zero(), SLIDING});
  }
  return !candidates_.empty() || !memory_.empty();
}

/// Δt² k is at most so many times the mass that resists at the point: that of its copies, of what they hang on within a
/// step, and of its pieces.
void Contact::softenStiffest(const StepStart& start) {
  const double squared_step = start.span.time_step * start.span.time_step;
  parallelFor(static_cast<int>(candidates_.size()), skin_->threads(), [&](int i) {
    Candidate& candidate = candidates_[i];
    const Spring& point = candidate.point;
    double of_copies = 0, of_pieces = 0;
    for (int k = 0; k < point.count; ++k) {
      const int copy = point.copies[k], piece = start.piece[copy];
      of_copies += point.weights[k] * point.weights[k] / start.inertia[copy];
      double on_piece = 0;
      for (int l = 0; l < point.count; ++l)
        if (start.piece[point.copies[l]] == piece) on_piece += point.weights[l];
      of_pieces += point.weights[k] * on_piece / start.piece_mass[piece];
    }
    const double bare = candidate.stiffness, mobility = squared_step * (of_copies + of_pieces);
    candidate.tangential = TANGENTIAL * bare;
    if (!(mobility > 0)) return;
    const double on_obstacle = candidate.isOfBody() ? 1 : STIFFER_ON_OBSTACLES;
    candidate.stiffness = std::min(bare, STIFFEST / (squared_step * (of_copies / on_obstacle + of_pieces)));
    candidate.tangential = TANGENTIAL * std::min(bare, STIFFEST / mobility);
    const double depth = -candidate.gap - candidate.normal.dot(weightedSum(point, start.ahead) - candidate.drift);
    const double tolerated = (candidate.isOfBody() ? SQUEEZE_DEPTH : IMPACT_DEPTH) * candidate.size;
    const double impact = std::min(depth / tolerated, STIFFEST_IMPACT);
    if (impact > STIFFEST) candidate.stiffness = std::max(candidate.stiffness, impact / mobility);
  });
}

/// Takes over what the contacts of the last step have left: no more energy than that. What begins in an obstacle is
/// brought out of it; among pieces that block each other that would wind up springs, so there a depth only goes as the
/// pieces part.
void Contact::continueTouches(const std::vector<Touch>& touches, double time_step) {
  legacy_.begin(touches);
  for (Candidate& candidate : candidates_) {
    const double depth = std::max(0.0, -candidate.gap);
    const bool of_body = candidate.isOfBody();
    candidate.ignored = depth;
    candidate.worked_off = of_body ? 0 : depth;
    const Touch* touch = touchBefore(skin_->surface(), touches, candidate.partner, candidate.sample, candidate.other);
    if (!touch) continue;
    candidate.goes_on = true;
    legacy_.goesOn(*touch);
    const double same_energy = std::sqrt(std::min(1.0, touch->stiffness / candidate.stiffness));
    const double same_drag = std::sqrt(std::min(1.0, touch->tangential / candidate.tangential));
    const double most = RECOVERY * candidate.size * time_step, worked_off = std::min(most, touch->worked_off);
    const double beyond = same_energy * touch->gap - TOUCHING * candidate.size - candidate.gap;
    const double ignored =
        of_body ? std::max(touch->ignored - most, beyond) : std::max(touch->ignored, beyond) - worked_off;
    candidate.ignored = std::clamp(ignored, 0.0, depth);
    candidate.worked_off = std::min(touch->worked_off - worked_off, candidate.ignored);
    candidate.slip = same_drag * (touch->slip - candidate.normal.dot(touch->slip) * candidate.normal);
  }
  legacy_.share(skin_->surface(), &candidates_);
}

/// s + Δy_t at a trial [m].
Vec3 Contact::slipAt(const Candidate& candidate, const Vec3& moved) const {
  const Vec3 stretch = moved - candidate.drift;
  return candidate.slip + stretch - candidate.normal.dot(stretch) * candidate.normal;
}

/// Friction may be as large as the pressure allows.
void Contact::takeBounds(Span<const Vec3> moved, Span<const double> share) {
  if (friction_ == 0) return;
  parallelFor(moved.size(), skin_->threads(), [&](int i) {
    const double gap = gaps_[i].at(moved[i]), most = gap < 0 ? friction_ * candidates_[i].stiffness * -gap : 0;
    frictions_[i].most += share[i] * (most - frictions_[i].most);
    findSteepness(i, moved[i]);
  });
}

/// Here, and with what is remembered of where the search was before.
void Contact::findSteepness(int i, const Vec3& moved) {
  Friction& friction = frictions_[static_cast<std::size_t>(i)];
  const Candidate& candidate = candidates_[static_cast<std::size_t>(i)];
  Vec3 slid = Vec3::Zero();
  if (friction.most > 0) slid = slipAt(candidate, moved);
  if (!(candidate.tangential * slid.norm() > friction.most)) slid.setZero();
  friction.steepness = slid.dot(friction.slid) < 0 ? TURNED : SLIDING;
  friction.slid = slid;
}

/// The forces descend from ½ k g², where g is negative, and from ½ k_t s², which goes on evenly beyond the bound.
void Contact::update(Span<const Vec3> moved, Span<Spring> springs) {
  parallelFor(moved.size(), skin_->threads(), [&](int i) {
    const double gap = gaps_[i].at(moved[i]);
    const bool is_open = !(gap < 0) && !(frictions_[i].most > 0), was_open = std::exchange(gaps_[i].is_open, is_open);
    if (!is_open)
      updatePressed(i, gap, moved[i], &springs[i]);
    else if (!was_open)
      springs[i].set(Mat3::Zero(), Vec3::Zero(), moved[i]);
  });
}

void Contact::updatePressed(int i, double gap, const Vec3& moved, Spring* spring) const {
  const Candidate& candidate = candidates_[static_cast<std::size_t>(i)];
  const Friction& friction = frictions_[static_cast<std::size_t>(i)];
  const double pressure = std::max(0.0, -candidate.stiffness * gap), most = friction.most;
  const Mat3 across = candidate.normal * candidate.normal.transpose();
  Vec3 force = pressure * candidate.normal;
  Mat3 stiffness = gap < 0 ? Mat3(candidate.stiffness * across) : Mat3::Zero();
  if (most > 0) {
    const Vec3 slip = slipAt(candidate, moved);
    const double k = candidate.tangential, drag = slip.norm();
    const bool slides = k * drag > most;
    const double secant = slides ? most / drag : k;
    force -= secant * slip;
    stiffness += secant * (Mat3::Identity() - across);
    if (slides) stiffness -= (1 - friction.steepness) * secant / (drag * drag) * slip * slip.transpose();
  }
  spring->set(stiffness, force, moved);
}

Touch Contact::touchOf(const Candidate& candidate, double gap, const Vec3& moved, double most) const {
  const Vec3 slip = slipAt(candidate, moved);
  const double drag = candidate.tangential * slip.norm();
  const double sticking = drag > most ? most / drag : 1;
  Touch touch;
  touch.sample = candidate.sample;
  touch.partner = candidate.partner;
  touch.other = candidate.other;
  touch.gap = gap;
  touch.ignored = candidate.ignored;
  touch.worked_off = candidate.worked_off;
  touch.stiffness = candidate.stiffness;
  touch.tangential = candidate.tangential;
  touch.slip = sticking * slip;
  touch.normal_in_solid = candidate.normal_in_solid;
  tellPlace(skin_->surface(), &touch);
  return touch;
}

void Contact::accept(const StepSpan& /*span*/, Span<const Vec3> moved, const Motion& /*end*/, const Wrench& /*felt*/) {
  memory_.clear();
  skin_version_ = skin_->version();
  for (int i = 0; i < moved.size(); ++i) {
    const Candidate& candidate = candidates_[i];
    const double gap = gaps_[i].at(moved[i]);
    const bool presses = gap < 0, is_near = gap < candidate.ignored + MARGIN * candidate.size;
    // What is in an obstacle, or beside it, is known to be on this side of it, pressed or not; edges likewise.
    if (!presses && (candidate.partner == Candidate::BODY || !is_near)) continue;
    const Touch touch = touchOf(candidate, gap, moved[i], frictions_[i].most);
    memory_.push_back(touch);
    if (!presses) continue;
    ++report_.count;
    report_.energy += 0.5 * (candidate.stiffness * gap * gap + candidate.tangential * touch.slip.squaredNorm());
    const double depth = candidate.ignored + TOUCHING * candidate.size - gap;
    report_.deepest = std::max(report_.deepest, std::min(depth, candidate.way_out));
  }
}

void Contact::addPoints(Span<const Vec3> moved, Span<const Vec3> impulses, double time, int tool,
                        const std::vector<Vec3>& x, std::vector<ContactPoint>* points) const {
  for (int i = 0; i < impulses.size(); ++i) {
    if (impulses[i].isZero(0)) continue;
    const Candidate& candidate = candidates_[static_cast<std::size_t>(i)];
    ContactPoint point;
    double weight = 0;  // of the point; what it meets on the body has weights below zero
    for (int k = 0; k < candidate.point.count; ++k) {
      const double own = std::max(0.0, candidate.point.weights[k]);
      point.point += own * x[candidate.point.copies[k]];
      weight += own;
    }
    point.point /= weight;
    point.normal = candidate.normal;
    point.force = impulses[i] / time;
    point.depth = std::max(0.0, -candidate.gap - candidate.normal.dot(moved[i] - candidate.drift));
    point.partner = candidate.partner;
    point.tool = tool;
    points->push_back(point);
  }
}

}  // namespace incision
