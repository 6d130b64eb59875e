#include "incision/contact/contact.h"

#include <algorithm>
#include <cmath>

#include "incision/base/parallel.h"

namespace incision {
namespace {

/// k_t/k: as a half space gives way to a shear, roughly.
constexpr double TANGENTIAL = 0.5;

/// Another solve is worth it where contacts that should press and do not, or the other way round, would carry more than
/// this share of all contact forces.
constexpr double NORMAL_TOLERANCE = 0.01;

/// Another solve is worth it where friction is off its bound by more than this share of all friction there may be.
constexpr double FRICTION_TOLERANCE = 0.02;

/// Gaps this small, in elements, are rounding: faces just cut lie in each other's plane.
constexpr double TOUCHING = 1e-9;

Vec3 stretchOf(const Candidate& candidate, double time_step, const std::vector<Vec3>& v_end) {
  return time_step * weightedSum(candidate.point, v_end) - candidate.drift;
}

bool comesBeforeInBody(const SurfaceVertex& a, const SurfaceVertex& b) {
  if (a.copies != b.copies) return a.copies < b.copies;
  return std::lexicographical_compare(a.weights.data(), a.weights.data() + 4, b.weights.data(), b.weights.data() + 4);
}

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

int Contact::sampleOfVertex(int sample) const {
  const ContactSurface& surface = skin_->surface();
  return sample - surface.sample_start[surface.samples[sample].vertex];
}

/// The memory's touches with their samples as the skin numbers them now, less those whose vertex a cut has taken away.
const std::vector<Touch>& Contact::touchesOnSkin() {
  if (skin_version_ == skin_->version()) return memory_;
  const ContactSurface& surface = skin_->surface();
  const std::vector<SurfaceVertex>& vertices = surface.surface->vertices;
  renumbered_ = memory_;
  std::sort(renumbered_.begin(), renumbered_.end(),
            [](const Touch& a, const Touch& b) { return comesBeforeInBody(a.vertex, b.vertex); });
  for (Touch& touch : renumbered_) touch.sample = Touch::GONE;
  const auto place = [&](int sample, int vertex, int sample_of_vertex, bool of_body) {
    const SurfaceVertex& at = vertices[vertex];
    auto touch =
        std::lower_bound(renumbered_.begin(), renumbered_.end(), at,
                         [](const Touch& a, const SurfaceVertex& b) { return comesBeforeInBody(a.vertex, b); });
    for (; touch != renumbered_.end() && !comesBeforeInBody(at, touch->vertex); ++touch)
      if (touch->sample_of_vertex == sample_of_vertex && (touch->partner == Candidate::BODY) == of_body)
        touch->sample = sample;
  };
  if (!renumbered_.empty()) {
    for (int s = 0; s < static_cast<int>(surface.samples.size()); ++s)
      place(s, surface.samples[s].vertex, sampleOfVertex(s), true);
    for (int v = 0; v < static_cast<int>(vertices.size()); ++v) place(v, v, 0, false);
  }
  const auto gone = [](const Touch& touch) { return touch.sample == Touch::GONE; };
  renumbered_.erase(std::remove_if(renumbered_.begin(), renumbered_.end(), gone), renumbered_.end());
  std::sort(renumbered_.begin(), renumbered_.end(), comesBefore<Touch, Touch>);
  return renumbered_;
}

bool Contact::begin(const StepStart& start) {
  report_ = ContactReport();
  candidates_.clear();
  if (isThere()) {
    skin_->begin(start);
    const std::vector<Touch>& touches = touchesOnSkin();
    find(*skin_, start, touches, &candidates_);
    continueTouches(touches, start.span.time_step);
  }
  const auto too_deep = [](const Candidate& candidate) {
    return candidate.partner == Candidate::BODY && candidate.ignored > DEEPEST_BEGIN * candidate.size;
  };
  candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), too_deep), candidates_.end());
  used_.assign(candidates_.size(), Trial());
  trials_.resize(candidates_.size());
  return !candidates_.empty() || !memory_.empty();
}

/// Takes over what the contacts of the last step have left. What lies in an obstacle is brought out of it; among pieces
/// that block each other that would wind up springs, so there a depth only goes as the pieces part.
void Contact::continueTouches(const std::vector<Touch>& touches, double time_step) {
  auto touch = touches.begin();
  for (Candidate& candidate : candidates_) {
    const double depth = std::max(0.0, -candidate.gap);
    candidate.ignored = depth;
    while (touch != touches.end() && comesBefore(*touch, candidate)) ++touch;
    if (touch == touches.end() || comesBefore(candidate, *touch)) continue;
    const double worked_off = RECOVERY * candidate.size * time_step, beyond = touch->gap - candidate.gap;
    const double ignored = candidate.partner == Candidate::BODY ? std::max(touch->ignored - worked_off, beyond)
                                                                : std::max(touch->ignored, beyond) - worked_off;
    candidate.ignored = std::clamp(ignored, 0.0, depth);
    candidate.slip = touch->slip - candidate.normal.dot(touch->slip) * candidate.normal;
  }
}

Contact::Trial Contact::tryAt(const Candidate& candidate, double time_step, const std::vector<Vec3>& v_end) const {
  const Vec3 stretch = stretchOf(candidate, time_step, v_end);
  const double closing = candidate.normal.dot(stretch);
  Trial trial;
  trial.gap = candidate.gap + candidate.ignored + closing;
  trial.slip = candidate.slip + stretch - closing * candidate.normal;
  trial.presses = trial.gap < -TOUCHING * candidate.size;
  // Where it slides, the spring that gives the friction there is: a secant, so the system stays symmetric.
  const double most = friction_ * candidate.stiffness * std::max(0.0, -trial.gap), drag = trial.slip.norm();
  trial.tangential = TANGENTIAL * candidate.stiffness;
  if (trial.tangential * drag > most) trial.tangential = most / drag;
  return trial;
}

Spring Contact::springOf(const Candidate& candidate, const Trial& trial) const {
  Spring spring = candidate.point;
  const Mat3 across = candidate.normal * candidate.normal.transpose();
  spring.stiffness = candidate.stiffness * across + trial.tangential * (Mat3::Identity() - across);
  spring.force = spring.stiffness * candidate.drift -
                 candidate.stiffness * (candidate.gap + candidate.ignored) * candidate.normal -
                 trial.tangential * candidate.slip;
  return spring;
}

bool Contact::update(const StepSpan& span, const std::vector<Vec3>& v_end, std::vector<Spring>* springs) {
  parallelFor(static_cast<int>(candidates_.size()), skin_->threads(),
              [&](int i) { trials_[i] = tryAt(candidates_[i], span.time_step, v_end); });
  double wrong = 0, all = 0, wrong_friction = 0, all_friction = 0;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Trial &trial = trials_[i], &used = used_[i];
    const double force = candidates_[i].stiffness * std::abs(trial.gap);
    if (trial.presses != used.presses) wrong += force;
    if (!trial.presses) continue;
    all += force;
    all_friction += friction_ * force;
    if (used.presses) wrong_friction += std::abs(trial.tangential - used.tangential) * trial.slip.norm();
    springs->push_back(springOf(candidates_[i], trial));
  }
  used_.swap(trials_);
  return wrong > NORMAL_TOLERANCE * all || wrong_friction > FRICTION_TOLERANCE * all_friction;
}

Touch Contact::touchOf(const Candidate& candidate, const Trial& trial) const {
  const ContactSurface& surface = skin_->surface();
  const bool of_body = candidate.partner == Candidate::BODY;
  const int vertex = of_body ? surface.samples[candidate.sample].vertex : candidate.sample;
  const double sticking = trial.tangential / (TANGENTIAL * candidate.stiffness);
  return {candidate.sample,
          candidate.partner,
          trial.gap,
          candidate.ignored,
          sticking * trial.slip,
          candidate.normal_in_solid,
          surface.surface->vertices[vertex],
          of_body ? sampleOfVertex(candidate.sample) : 0};
}

void Contact::accept(const StepSpan& span, const Motion& end, const Wrench& /*felt*/) {
  memory_.clear();
  skin_version_ = skin_->version();
  for (const Candidate& candidate : candidates_) {
    const Trial trial = tryAt(candidate, span.time_step, end.v);
    const bool of_body = candidate.partner == Candidate::BODY, is_inside = trial.gap < candidate.ignored;
    if (!trial.presses && (of_body || !is_inside)) continue;  // in an obstacle it is brought out, pressed or not
    const Touch touch = touchOf(candidate, trial);
    memory_.push_back(touch);
    if (!trial.presses) continue;
    ++report_.count;
    report_.energy += 0.5 * candidate.stiffness * (trial.gap * trial.gap + TANGENTIAL * touch.slip.squaredNorm());
    report_.deepest = std::max(report_.deepest, candidate.ignored - trial.gap);
  }
}

}  // namespace incision
