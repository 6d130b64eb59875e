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

/// The same of friction that is off its bound, as a share of all friction there may be.
constexpr double FRICTION_TOLERANCE = 0.02;

/// Gaps this small, in elements, are rounding: faces just cut lie in each other's plane.
constexpr double TOUCHING = 1e-9;

Vec3 stretchOf(const Candidate& candidate, double time_step, const std::vector<Vec3>& v_end) {
  Vec3 rate = Vec3::Zero();
  for (int i = 0; i < candidate.held.count; ++i) rate += candidate.held.weights[i] * v_end[candidate.held.copies[i]];
  return time_step * rate - candidate.drift;
}

}  // namespace

Contact::Contact(const ContactSettings& settings, Obstacles obstacles, double young_modulus, int threads)
    : settings_(settings), obstacles_(std::move(obstacles)), young_modulus_(young_modulus), threads_(threads) {}

void Contact::surfaceChanged(const Surface& surface, const CutMesh& mesh, const std::vector<int>& piece) {
  surface_ = makeContactSurface(surface, mesh, piece);
  fragments_.surfaceChanged();
  const auto before = [](const SurfaceVertex& a, const SurfaceVertex& b) {
    if (a.copies != b.copies) return a.copies < b.copies;
    return std::lexicographical_compare(a.weights.data(), a.weights.data() + 4, b.weights.data(), b.weights.data() + 4);
  };
  // Where a contact is now, if the cut has left its vertex alone.
  std::sort(touches_.begin(), touches_.end(),
            [&](const Touch& a, const Touch& b) { return before(a.vertex, b.vertex); });
  for (Touch& contact : touches_) contact.sample = -1;
  const auto place = [&](int sample, int vertex, int order, bool of_body) {
    const SurfaceVertex& at = surface.vertices[vertex];
    auto contact = std::lower_bound(touches_.begin(), touches_.end(), at,
                                    [&](const Touch& a, const SurfaceVertex& b) { return before(a.vertex, b); });
    for (; contact != touches_.end() && !before(at, contact->vertex); ++contact)
      if (contact->order == order && (contact->partner == Candidate::BODY) == of_body) contact->sample = sample;
  };
  for (int s = 0; s < static_cast<int>(surface_.samples.size()); ++s)
    place(s, surface_.samples[s].vertex, orderOf(s), true);
  for (int v = 0; v < static_cast<int>(surface.vertices.size()); ++v) place(v, v, 0, false);
  touches_.erase(
      std::remove_if(touches_.begin(), touches_.end(), [](const Touch& contact) { return contact.sample < 0; }),
      touches_.end());
  std::sort(touches_.begin(), touches_.end(), comesBefore<Touch, Touch>);
}

int Contact::orderOf(int sample) const { return sample - surface_.sample_start[surface_.samples[sample].vertex]; }

void Contact::begin(const Motion& motion, double time_step, const LinkMotion& links) {
  interpolate(*surface_.surface, motion.x, threads_, &x_);
  interpolate(*surface_.surface, motion.v, threads_, &v_);
  candidates_.clear();
  if (settings_.self)
    fragments_.find(surface_, x_, v_, time_step, CONTACT_STIFFNESS * young_modulus_, threads_, &candidates_);
  findObstacleContacts(surface_, x_, v_, time_step, OBSTACLE_STIFFNESS * young_modulus_, obstacles_, links, touches_,
                       &candidates_);
  recall(time_step);
  candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(),
                                   [](const Candidate& c) {
                                     return c.partner == Candidate::BODY && c.ignored > DEEPEST_BEGIN * c.size;
                                   }),
                    candidates_.end());
  used_.assign(candidates_.size(), Trial());
  trials_.resize(candidates_.size());
}

/// Takes over what the contacts of the last step have left. What lies in an obstacle is brought out of it; among pieces
/// that hold each other in place that would wind up springs, so there a depth only goes as the pieces part.
void Contact::recall(double time_step) {
  auto touch = touches_.begin();
  for (Candidate& candidate : candidates_) {
    const double depth = std::max(0.0, -candidate.gap);
    candidate.ignored = depth;
    while (touch != touches_.end() && comesBefore(*touch, candidate)) ++touch;
    if (touch == touches_.end() || comesBefore(candidate, *touch)) continue;
    const double worked_off = RECOVERY * candidate.size * time_step, beyond = touch->gap - candidate.gap;
    const double left = candidate.partner == Candidate::BODY ? std::max(touch->ignored - worked_off, beyond)
                                                             : std::max(touch->ignored, beyond) - worked_off;
    candidate.ignored = std::clamp(left, 0.0, depth);
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
  const double most = frictionOf(candidate) * candidate.stiffness * std::max(0.0, -trial.gap), drag = trial.slip.norm();
  trial.tangential = TANGENTIAL * candidate.stiffness;
  if (trial.tangential * drag > most) trial.tangential = most / drag;
  return trial;
}

double Contact::frictionOf(const Candidate& candidate) const {
  return candidate.held.tool ? obstacles_.tool.friction : settings_.friction;
}

bool Contact::update(double time_step, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings) {
  parallelFor(static_cast<int>(candidates_.size()), threads_,
              [&](int i) { trials_[i] = tryAt(candidates_[i], time_step, v_end); });
  double wrong = 0, all = 0, wrong_friction = 0, all_friction = 0;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Trial &trial = trials_[i], &used = used_[i];
    const double force = candidates_[i].stiffness * std::abs(trial.gap);
    if (trial.presses != used.presses) wrong += force;
    if (!trial.presses) continue;
    all += force;
    all_friction += frictionOf(candidates_[i]) * force;
    if (used.presses) wrong_friction += std::abs(trial.tangential - used.tangential) * trial.slip.norm();
    Coupling coupling = candidates_[i].held;
    const Candidate& candidate = candidates_[i];
    const Mat3 across = candidate.normal * candidate.normal.transpose();
    coupling.stiffness = candidate.stiffness * across + trial.tangential * (Mat3::Identity() - across);
    coupling.force = coupling.stiffness * candidate.drift -
                     candidate.stiffness * (candidate.gap + candidate.ignored) * candidate.normal -
                     trial.tangential * candidate.slip;
    couplings->push_back(coupling);
  }
  used_.swap(trials_);
  return wrong > NORMAL_TOLERANCE * all || wrong_friction > FRICTION_TOLERANCE * all_friction;
}

ContactReport Contact::accept(double time_step, const std::vector<Vec3>& v_end) {
  ContactReport report;
  touches_.clear();
  for (const Candidate& candidate : candidates_) {
    const Trial trial = tryAt(candidate, time_step, v_end);
    const bool of_body = candidate.partner == Candidate::BODY, is_inside = trial.gap < candidate.ignored;
    if (!trial.presses && (of_body || !is_inside)) continue;  // in an obstacle it is brought out, pressed or not
    const double drag = trial.tangential / (TANGENTIAL * candidate.stiffness);
    const int vertex = of_body ? surface_.samples[candidate.sample].vertex : candidate.sample;
    touches_.push_back({candidate.sample, candidate.partner, trial.gap, candidate.ignored, drag * trial.slip,
                        candidate.side, surface_.surface->vertices[vertex], of_body ? orderOf(candidate.sample) : 0});
    if (!trial.presses) continue;
    ++report.count;
    report.energy +=
        0.5 * candidate.stiffness * (trial.gap * trial.gap + TANGENTIAL * (drag * trial.slip).squaredNorm());
    report.deepest = std::max(report.deepest, candidate.ignored - trial.gap);
  }
  return report;
}

}  // namespace incision
