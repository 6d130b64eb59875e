// What is left of a call in which memory runs out, wherever that is: nothing.
#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <sstream>

#include "incision/base/input_error.h"
#include "support/allocation_count.h"
#include "support/broken_plate.h"
#include "support/forceps.h"
#include "support/sanitized.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

/// Steps that are compared after the call.
constexpr int STEPS_AFTER = 3;

/// What there is to see of a body, but for what it takes memory to tell.
struct Seen {
  std::uint64_t hash = 0;
  std::size_t parts = 0, copies = 0;
  std::int64_t steps = 0, unsettled = 0;
  int cracks = 0;
  bool operator==(const Seen& other) const {
    return hash == other.hash && parts == other.parts && copies == other.copies && steps == other.steps &&
           unsettled == other.unsettled && cracks == other.cracks;
  }
};

Seen seen(const DeformableBody& body) {
  return {body.stateHash(), body.mesh().parts().size(), body.positions().size(),
          body.steps(),     body.unsettledSteps(),      body.mesh().numCracks()};
}

/// All that is told in steps, but for times.
std::string told(const StepResult& result) {
  std::ostringstream text;
  for (const CutResult& cut : result.cuts)
    text << "cut " << cut.label << ' ' << static_cast<int>(cut.status) << ' ' << cut.parts_split << ' ' << cut.pieces;
  for (const CrackResult& crack : result.cracks) text << "crack " << crack.crack << ' ' << crack.elements.size();
  for (const ToolReport& tool : result.tools) text << "tool " << tool.force.transpose() << ' ' << tool.stroke_area;
  text << "contacts " << result.contact.count << " solves " << result.solves << " halves " << result.divided;
  return text.str();
}

/// A call that is disturbed, on a body that has taken some steps.
struct Scenario {
  std::string name;
  Scene scene;
  Descriptions descriptions;
  int steps_before = 0;
  std::function<void(DeformableBody*, std::string* told)> call;
  int every = 1;  ///< of the allocations, is refused; all of them in the full tier
};

class Disturbed {
 public:
  explicit Disturbed(const Scenario& scenario) : scenario_(scenario) {
    DeformableBody body(scenario.scene, loadMesh(scenario.scene), scenario.descriptions);
    run(&body, scenario.steps_before);
    start_ = bytesOf(body);
    before_ = seen(body);
    after_ = goOn(&body);
  }

  /// Refuses so many allocations from the n-th on. Returns whether there were any.
  bool refuse(std::int64_t n, std::int64_t count) {
    DeformableBody body(scenario_.scene, loadMesh(scenario_.scene), scenario_.descriptions);
    body.restore(start_);
    std::string first;
    bool failed = false;
    const std::int64_t refused = refusing(n, count, [&] {
      try {
        scenario_.call(&body, &first);
      } catch (const std::bad_alloc&) {
        failed = true;
      }
    });
    if (!failed) {
      // The call did without.
      EXPECT_EQ(first + steps(&body), after_) << scenario_.name << ", number " << n;
      return refused > 0;
    }
    EXPECT_GT(refused, 0);
    // Of a step, what is due before it may have taken effect as a whole; all else is as it was.
    if (scenario_.name.find("step") == std::string::npos) {
      EXPECT_TRUE(seen(body) == before_) << scenario_.name << ", number " << n;
    }
    EXPECT_EQ(body.steps(), before_.steps) << scenario_.name << ", number " << n;
    EXPECT_GT(body.counts().pieces, 0);
    EXPECT_GT(body.surface().triangles.size(), 0u);
    EXPECT_EQ(goOn(&body), after_) << scenario_.name << ", number " << n;
    return refused > 0;
  }

 private:
  std::string goOn(DeformableBody* body) const {
    std::string first;
    scenario_.call(body, &first);
    return first + steps(body);
  }

  /// What the steps after the call tell, and where they leave the body.
  static std::string steps(DeformableBody* body) {
    std::ostringstream text;
    for (int k = 0; k < STEPS_AFTER; ++k) text << '\n' << std::hex << body->stateHash() << ' ' << told(body->step());
    text << '\n' << body->stateHash() << ' ' << body->counts().pieces;
    return text.str();
  }

  const Scenario& scenario_;
  std::string start_, after_;
  Seen before_;
};

void expectUndisturbed(const Scenario& scenario, int every) {
  Disturbed disturbed(scenario);
  // Some that follow each other too: then even what puts a body in order again has none.
  std::int64_t n = 1;
  while (disturbed.refuse(n, n % 2 == 1 ? 1 : 20) && !testing::Test::HasFailure()) n += every;
  EXPECT_GT(n, 1) << scenario.name;
  std::printf("%s: %d\n", scenario.name.c_str(), static_cast<int>(n));
}

void step(DeformableBody* body, std::string* first) {
  const StepResult result = body->step();
  sparing([&] { *first = told(result); });
}

/// A plate that rubs on the ground while it breaks, is cut by a blade against resistance and by a plane.
Scene breakingPlate(Method method) {
  Scene scene = everythingAtOnce(method);
  scene.body.grid->cells = {4, 2, 1};
  scene.solver.threads = 2;
  return scene;
}

Scenario cutting(Method method) {
  return {"cut", breakingPlate(method), {}, 12, [](DeformableBody* body, std::string* first) {
            const CutResult cut = body->cut(plane(Vec3(0.3, 0.2, 0.1), Vec3(1, -0.3, 0.2)));
            if (cut.reason == "memory ran out") throw std::bad_alloc();
            EXPECT_EQ(cut.status, CutStatus::APPLIED);
            *first = std::to_string(cut.parts_split) + ' ' + std::to_string(cut.pieces);
          }};
}

/// A slab that forceps close on and pull, in steps of second order while nothing touches.
Scenario gripping() {
  Scene scene = slabAndForceps(0.5, true);
  scene.solver.integrator = Integrator::BDF2;
  scene.solver.threads = 2;
  scene.body.pressure = Pressure::AVERAGED;
  scene.boundary = {SLAB_END};
  scene.tools[0].poses = {{0, AT_EDGE}, {0.02, AT_EDGE}, {0.06, facingX(-0.02)}};
  scene.tools[0].jaw->angles = {{0, FORCEPS_OPEN}, {0.01, 0.03}};
  return {"step of forceps", scene, {{forcepsUrdf({})}, ""}, 0, step};
}

std::vector<Scenario> scenarios() {
  std::vector<Scenario> all;
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    all.push_back(cutting(method));
    for (const int before : {5, 13})
      all.push_back({"step in which it breaks", breakingPlate(method), {}, before, step});
  }
  for (const int before : {1, 2, 5}) {
    all.push_back(gripping());
    all.back().steps_before = before;
  }
  Scene free = breakingPlate(Method::ITERATIVE);
  free.fracture.reset();
  free.contact.reset();
  free.solver.integrator = Integrator::BDF2;
  all.push_back({"step of a blade", free, {}, 6, step});
  all.push_back({"surface", free, {}, 6, [](DeformableBody* body, std::string* first) {
                   *first = std::to_string(body->surface().triangles.size());
                 }});
  all.push_back({"lift", free, {}, 8, [](DeformableBody* body, std::string* first) {
                   const auto ended = body->liftTool();
                   *first = ended ? std::to_string(ended->pieces) : "";
                 }});
  all.push_back({"reset", free, {}, 8, [](DeformableBody* body, std::string* first) {
                   for (const CutResult& stroke : body->reset()) *first += std::to_string(stroke.pieces) + ' ';
                 }});
  all.push_back({"save", free, {}, 6, [](DeformableBody* body, std::string* first) {
                   std::ostringstream out;
                   try {
                     body->save(out);
                   } catch (const std::runtime_error&) {  // the stream
                     throw std::bad_alloc();
                   }
                   *first = std::to_string(out.str().size());
                 }});
  const auto twin = std::make_shared<DeformableBody>(free, loadMesh(free));
  run(twin.get(), 9);
  all.push_back(
      {"restore", free, {}, 6, [bytes = bytesOf(*twin)](DeformableBody* body, std::string*) { body->restore(bytes); }});
  return all;
}

TEST(MemoryThatRunsOut, LeavesTheBodyAsIfItHadNotBeenTried) {
  for (const Scenario& scenario : scenarios()) expectUndisturbed(scenario, SANITIZED ? 499 : 97);
}

TEST(FullMemoryThatRunsOut, LeavesTheBodyAsIfItHadNotBeenTried) {
  for (const Scenario& scenario : scenarios()) expectUndisturbed(scenario, 1);
}

}  // namespace
}  // namespace incision::test
