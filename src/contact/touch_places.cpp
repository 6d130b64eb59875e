#include "incision/contact/touch_places.h"

#include <algorithm>
#include <utility>

namespace incision {
namespace {

bool comesBeforeInBody(const SurfaceVertex& a, const SurfaceVertex& b) {
  if (a.copies != b.copies) return a.copies < b.copies;
  return std::lexicographical_compare(a.weights.data(), a.weights.data() + 4, b.weights.data(), b.weights.data() + 4);
}

/// The numbers that a surface has for some of its vertices.
class Numbers {
 public:
  void ask(const SurfaceVertex& vertex) { asked_.emplace_back(vertex, Touch::GONE); }

  void answer(const std::vector<SurfaceVertex>& vertices) {
    std::sort(asked_.begin(), asked_.end(), comesBefore);
    for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
      const std::pair<SurfaceVertex, int> key(vertices[v], v);
      for (auto at = std::lower_bound(asked_.begin(), asked_.end(), key, comesBefore);
           at != asked_.end() && !comesBefore(key, *at); ++at)
        at->second = v;
    }
  }

  int of(const SurfaceVertex& vertex) const {
    return std::lower_bound(asked_.begin(), asked_.end(), std::make_pair(vertex, 0), comesBefore)->second;
  }

 private:
  static bool comesBefore(const std::pair<SurfaceVertex, int>& a, const std::pair<SurfaceVertex, int>& b) {
    return comesBeforeInBody(a.first, b.first);
  }

  std::vector<std::pair<SurfaceVertex, int>> asked_;
};

/// Number `which` of those of a vertex, or GONE.
int numbered(const std::vector<int>& start, int vertex, int which) {
  if (vertex == Touch::GONE || start[vertex] + which >= start[vertex + 1]) return Touch::GONE;
  return start[vertex] + which;
}

/// The edges of a touch are in the order of their numbers.
void putInOrder(Touch* touch) {
  if (touch->partner != Candidate::EDGES || touch->sample < touch->other) return;
  std::swap(touch->sample, touch->other);
  touch->normal_in_solid = -touch->normal_in_solid;
  touch->slip = -touch->slip;
}

}  // namespace

void tellPlace(const ContactSurface& surface, Touch* touch) {
  const auto& vertices = surface.surface->vertices;
  touch->sample_of_vertex = touch->edge_of_other = 0;
  if (touch->partner == Candidate::EDGES) {
    const int one = surface.edges[touch->sample].from, other = surface.edges[touch->other].from;
    touch->vertex = vertices[one];
    touch->sample_of_vertex = touch->sample - surface.edge_start[one];
    touch->other_vertex = vertices[other];
    touch->edge_of_other = touch->other - surface.edge_start[other];
    return;
  }
  const bool of_body = touch->partner == Candidate::BODY;
  const int vertex = of_body ? surface.samples[touch->sample].vertex : touch->sample;
  touch->vertex = touch->other_vertex = vertices[vertex];
  if (!of_body) return;
  touch->sample_of_vertex = touch->sample - surface.sample_start[vertex];
  touch->other_vertex = vertices[touch->other];
}

const Touch* touchBefore(const ContactSurface& surface, const std::vector<Touch>& touches, int partner, int sample,
                         int other) {
  const struct { int partner, sample; } sought{partner, sample};
  const auto goes_on = [&](const Touch& touch) {
    if (partner == Candidate::BODY) return surface.vertex_piece[touch.other] == surface.vertex_piece[other];
    return partner != Candidate::EDGES || touch.other == other;
  };
  for (auto at = std::lower_bound(touches.begin(), touches.end(), sought, comesBefore<Touch, decltype(sought)>);
       at != touches.end() && !comesBefore(sought, *at); ++at)
    if (goes_on(*at)) return &*at;
  return nullptr;
}

void renumber(const ContactSurface& surface, std::vector<Touch>* touches) {
  if (touches->empty()) return;
  Numbers numbers;
  for (const Touch& touch : *touches) {
    numbers.ask(touch.vertex);
    if (touch.partner < 0) numbers.ask(touch.other_vertex);
  }
  numbers.answer(surface.surface->vertices);
  for (Touch& touch : *touches) {
    const int vertex = numbers.of(touch.vertex);
    touch.sample = vertex;
    if (touch.partner >= 0) continue;
    const bool edges = touch.partner == Candidate::EDGES;
    touch.sample = numbered(edges ? surface.edge_start : surface.sample_start, vertex, touch.sample_of_vertex);
    touch.other = numbers.of(touch.other_vertex);
    if (edges) touch.other = numbered(surface.edge_start, touch.other, touch.edge_of_other);
  }
  const auto gone = [](const Touch& touch) {
    return touch.sample == Touch::GONE || (touch.partner < 0 && touch.other == Touch::GONE);
  };
  touches->erase(std::remove_if(touches->begin(), touches->end(), gone), touches->end());
  for (Touch& touch : *touches) putInOrder(&touch);
  std::stable_sort(touches->begin(), touches->end(), comesBefore<Touch, Touch>);
}

}  // namespace incision
