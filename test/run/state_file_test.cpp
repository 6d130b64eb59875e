// What one run of the batch program saves, another goes on from as if it had never been saved.
#include "incision/run/state_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/body/quantities.h"
#include "support/batch_folder.h"
#include "support/sanitized.h"
#include "support/solid_meshes.h"

namespace incision {
namespace {

namespace fs = std::filesystem;

/// A slab on the ground that breaks and is cut, while a blade goes through it and forceps hold its edge.
constexpr const char* EVERYTHING = R"(
body:
  grid: {cells: [10, 5, 1], size: [0.04, 0.02, 0.003], origin: [0, -0.01, -0.0015]}
  material: {young_modulus: 3.0e4, poisson_ratio: 0.3, density: 1000, mass_damping: 10, stiffness_damping: 2.0e-3}
gravity: [3, 0, -9.81]
boundary: [{box: [[0.039999, -1, -1], [1, 1, 1]]}]
solver: {time_step: 0.005, method: METHOD, integrator: bdf2, threads: 1}
cuts: [{time: 0.06, label: across, point: [0.03, 0, 0], normal: [1, 0.2, 0.3], length: 0.012, tangent: [0, 1, 0]}]
fracture: {tensile_strength: 250, fracture_energy: 0.05}
contact: {ground: -0.0016}
tools:
  scalpel: {type: blade, edge: [[0, 0, -0.004], [0, 0, 0.004]], cutting_force: 0.5, poses: [[0, 0.02, -0.015, 0, 0, 0, 0, 1], [0.4, 0.0201, 0.015, 0, 0, 0, 0, 1]]}
  forceps: {type: grasper, description: FORCEPS, link: palm, joint: jaw, closed: 0.05, grip: 0.05, poses: [[0, -0.012, 0, 0, 0, 0, 0, 1], [0.05, -0.012, 0, 0, 0, 0, 0, 1], [0.4, -0.016, 0, 0, 0, 0, 0, 1]], jaw: [[0, 0.5], [0.02, 0.03]]}
)";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void put(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

class SavedRun : public BatchFolder, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    BatchFolder::SetUp();
    put(file("all.yaml"), sceneOf(GetParam()));
  }
  static std::string sceneOf(const std::string& method) {
    return replaced(replaced(EVERYTHING, "FORCEPS", INCISION_SOURCE_DIR "/config/forceps.urdf"), "METHOD", method);
  }

  /// What the batch program says at the end; with `process` in one of its own.
  nlohmann::json end(const std::string& options, bool process = false) {
    std::vector<std::string> arguments = {file("all.yaml")};
    std::istringstream in(options);
    for (std::string option; in >> option;) arguments.push_back(option);
    if (!process) {
      EXPECT_EQ(run(arguments), BatchStatus::DONE) << err_.str();
      return nlohmann::json::parse(out_.str());
    }
    std::string command = (fs::read_symlink("/proc/self/exe").parent_path() / "incision_batch").string();
    for (const std::string& argument : arguments) command += " '" + argument + "'";
    command += " > '" + file("end.json") + "' 2> '" + file("err") + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << contentOf(file("err"));
    return nlohmann::json::parse(contentOf(file("end.json")));
  }
};

TEST_P(SavedRun, GoesOnAsIfItHadNeverBeenSaved) {
  const std::string state = file("half.state");
  const nlohmann::json half = end("--steps 20 --save " + state);
  for (const char* number : {"gripped", "area"})
    EXPECT_GT(half["tools"][number == std::string("area") ? "scalpel" : "forceps"][number].get<double>(), 0);
  EXPECT_GT(half["cracks"].get<int>(), 2);
  EXPECT_GT(half["contacts"]["count"].get<int>(), 0);
  for (const int later : {0, 1, 2, 10}) {
    const nlohmann::json whole = end("--steps " + std::to_string(20 + later));
    const std::string go_on = "--restore " + state + " --steps " + std::to_string(later);
    for (const nlohmann::json& other : {end(go_on), end(go_on, true), end(go_on + " --threads 2", later == 10)}) {
      EXPECT_EQ(other["steps"], 20 + later);
      EXPECT_EQ(other["time"], whole["time"]);
      EXPECT_EQ(other["state_hash"], whole["state_hash"]) << later;
      EXPECT_EQ(other["unsettled_steps"], whole["unsettled_steps"]);
    }
  }
}

// One run of 60 steps, and one that is saved and restored at each twentieth, in the same file.
TEST_P(SavedRun, MayBeSavedInTheFileItWasRestoredFrom) {
  const std::string state = file("on.state");
  const nlohmann::json whole = end("--steps 60");
  end("--steps 20 --save " + state);
  end("--steps 20 --restore " + state + " --save " + state + " --threads 2", true);
  EXPECT_EQ(end("--steps 20 --restore " + state)["state_hash"], whole["state_hash"]);
  EXPECT_FALSE(fs::exists(state + ".tmp"));
}

/// Slow enough that all goes on in a run of 1000 steps.
std::string longScene(const std::string& scene) {
  return replaced(replaced(scene, "[0.4, 0.0201, 0.015", "[5, 0.0201, 0.015"), "[0.4, -0.016", "[5, -0.016");
}

// 1000 steps are 500, saved, restored in every way, and 500 more, by the state after each of these.
TEST_P(SavedRun, FullThousandStepsAreTheSameInEveryLaterStep) {
  constexpr int HALF = 500, PART = 100;
  put(file("all.yaml"), longScene(sceneOf(GetParam())));
  const Scene scene = loadScene(file("all.yaml"));
  const Descriptions descriptions = loadDescriptions(scene);
  ASSERT_EQ(scene.tools[0].name, "forceps");
  DeformableBody whole(scene, loadMesh(scene), descriptions);
  std::string saved;
  std::vector<std::uint64_t> hashes;
  int pressing = 0, cracked = 0;
  for (int k = 0; k < 2 * HALF; ++k) {
    if (k == HALF) saved = savedState(whole).body;
    const StepResult result = whole.step();
    if (k < HALF) continue;
    hashes.push_back(whole.stateHash());
    pressing += result.contact.count > 0 && result.tools[0].gripped > 0;
    cracked += static_cast<int>(result.cracks.size());
  }
  EXPECT_GT(pressing, HALF / 2);
  EXPECT_GT(whole.counts().cracks, 2);
  RecordProperty("cracked", cracked);
  for (const int threads : {1, 2}) {
    Scene other = scene;
    other.solver.threads = threads;
    DeformableBody on(other, loadMesh(other), descriptions);
    DeformableBody* const body = threads == 1 ? &whole : &on;
    body->restore(saved);
    for (int k = 0; k < HALF; ++k) {
      body->step();
      ASSERT_EQ(body->stateHash(), hashes[static_cast<std::size_t>(k)])
          << "step " << k << ", " << threads << " threads";
    }
  }
  // In processes of their own.
  const std::string state = file("on.state");
  end("--steps " + std::to_string(HALF) + " --save " + state, true);
  for (int k = PART; k <= HALF; k += PART) {
    const nlohmann::json on =
        end("--steps " + std::to_string(PART) + " --restore " + state + " --save " + state + " --threads 2", true);
    EXPECT_EQ(on["state_hash"], hexadecimal(hashes[static_cast<std::size_t>(k - 1)])) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, SavedRun, ::testing::Values("direct", "iterative"));

/// A body in mid-run, and the file of another that has taken ten steps of the same scene.
class StateFiles : public BatchFolder {
 protected:
  void SetUp() override {
    BatchFolder::SetUp();
    scene_ = loadScene(file("bar.yaml"));
    body_ = std::make_unique<DeformableBody>(scene_, loadMesh(scene_));
    for (int k = 0; k < 3; ++k) body_->step();
    DeformableBody other(scene_, loadMesh(scene_));
    for (int k = 0; k < 10; ++k) other.step();
    StateFile(file("ten.state")).save(packed(savedState(other), keyOf(other, {}), 1));
    bytes_ = contentOf(file("ten.state"));
  }

  /// Why the body does not take these bytes. It must be as it was.
  std::string complaint(const std::string& bytes, const SceneKey& key) {
    put(file("bad.state"), bytes);
    const std::uint64_t before = body_->stateHash();
    std::string why;
    try {
      restoreState(file("bad.state"), key, body_.get());
    } catch (const InputError& error) {
      why = error.what();
    }
    EXPECT_EQ(body_->stateHash(), before);
    EXPECT_EQ(why.find(file("bad.state") + ": "), 0u) << why;
    return why;
  }
  std::string complaint(const std::string& bytes) { return complaint(bytes, keyOf(*body_, {})); }

  Scene scene_;
  std::unique_ptr<DeformableBody> body_;
  std::string bytes_;
};

TEST_F(StateFiles, CutShortAreRefused) {
  for (std::size_t length = 0; length < bytes_.size(); length += length < 300 ? 1 : 37)
    ASSERT_NE(complaint(bytes_.substr(0, length)), "") << length;
  EXPECT_NE(complaint(bytes_.substr(0, bytes_.size() - 1)).find("cut short"), std::string::npos);
  EXPECT_NE(complaint(bytes_ + "x").find("followed by 1 bytes"), std::string::npos);
}

TEST_F(StateFiles, WithAnyBitFlippedAreRefused) {
  std::mt19937 random(1);
  for (std::size_t i = 0; i < bytes_.size(); i += i < 300 ? 1 : test::SANITIZED ? 211 : 31) {
    std::string bad = bytes_;
    bad[i] = static_cast<char>(bad[i] ^ (1 << random() % 8));
    ASSERT_NE(complaint(bad), "") << i;
  }
}

TEST_F(StateFiles, OfAnotherFormatAreRefused) {
  std::string bad = bytes_;
  bad[8] = static_cast<char>(STATE_FORMAT + 1);
  EXPECT_NE(complaint(bad).find("of format " + std::to_string(STATE_FORMAT + 1) +
                                " (allowed: " + std::to_string(STATE_FORMAT) + ")"),
            std::string::npos);
  EXPECT_NE(complaint("body: {grid: {cells: [1, 1, 1]}}  # a scene").find("not a saved body"), std::string::npos);
}

TEST_F(StateFiles, OfAnotherSceneOrMeshAreRefusedButNotForThreads) {
  const auto keyWith = [&](const std::vector<std::string>& changes) {
    const Scene scene = loadScene(file("bar.yaml"), changes);
    return keyOf(DeformableBody(scene, loadMesh(scene)), {});
  };
  EXPECT_NE(complaint(bytes_, keyWith({"body.grid.cells=[5,1,1]"})).find("of another mesh, of 20 nodes and 24"),
            std::string::npos);
  EXPECT_NE(complaint(bytes_, keyWith({"body.grid.size=[1,0.25,0.26]"})).find("of another mesh"), std::string::npos);
  for (const char* change :
       {"gravity=[0,0,-9.8]", "solver.time_step=0.02", "solver.method=iterative", "body.material.density=999",
        "boundary.0.velocity=[0,0,1]", "cuts.1.time=0.03", "contact.ground=-1",
        "loads=[{box: [[0,0,0],[1,1,1]], "
        "pressure: 1}]",
        "body.regions=[{box: [[0,0,0],[1,1,1]], material: {density: 5}}]", "fracture.tensile_strength=1e9"})
    EXPECT_NE(complaint(bytes_, keyWith({change})).find("of another scene"), std::string::npos) << change;
  SceneKey with_urdf = keyOf(*body_, {{}, "<robot/>"});
  EXPECT_NE(complaint(bytes_, with_urdf).find("of another scene"), std::string::npos);

  restoreState(file("ten.state"), keyWith({"solver.threads=7"}), body_.get());
  EXPECT_EQ(body_->steps(), 10);
}

TEST_F(StateFiles, OfOtherMeshesInTheSameUrdfAreRefused) {
  put(file("room.urdf"),
      "<robot name='room'><link name='post'><collision><geometry><mesh filename='post.stl'/></geometry></collision>"
      "</link></robot>");
  const auto keyWithPost = [&](double size) {
    TriangleMesh post = test::angleMesh();
    for (Vec3& vertex : post.vertices) vertex *= size;
    put(file("post.stl"), test::asBinaryStl(post));
    const Scene scene = loadScene(file("bar.yaml"), {"contact.obstacles=room.urdf"});
    const Descriptions descriptions = loadDescriptions(scene);
    return keyOf(DeformableBody(scene, loadMesh(scene), descriptions), descriptions);
  };
  EXPECT_EQ(keyWithPost(1).scene, keyWithPost(1).scene);
  EXPECT_NE(keyWithPost(1).scene, keyWithPost(1.01).scene);
}

TEST_F(StateFiles, ThatCannotBeReadOrWrittenAreToldOf) {
  const std::string saved = "--save", restored = "--restore";
  for (const auto& [option, path] :
       std::vector<std::pair<std::string, std::string>>{{saved, file("no/such/folder.state")},
                                                        {saved, folder_.string()},
                                                        {saved, "/dev/null"},
                                                        {restored, file("none.state")},
                                                        {restored, folder_.string()},
                                                        {restored, "/dev/zero"},
                                                        {restored, file("bar.yaml")}}) {
    EXPECT_EQ(run({file("bar.yaml"), "--steps", "1", option, path}), BatchStatus::BAD_INPUT) << option << path;
    EXPECT_EQ(err_.str().find("incision_batch: " + path + ": "), 0u) << err_.str();
    EXPECT_EQ(err_.str().find('\n'), err_.str().size() - 1) << err_.str();
  }
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

// The program may write no more than 2 KiB into any file, less than the body takes and enough for libraries that note
// something in one when they start: so the disk is full for it.
TEST_F(StateFiles, ThatAFullDiskDoesNotTakeLeaveTheOldOne) {
  const std::string state = file("ten.state");
  const std::string command = "trap '' XFSZ; ulimit -f 4; exec '" +
                              (fs::read_symlink("/proc/self/exe").parent_path() / "incision_batch").string() + "' '" +
                              file("bar.yaml") + "' --steps 2 --set body.grid.cells=[9,9,9] --save '" + state +
                              "' > '" + file("end.json") + "' 2> '" + file("err") + "'";
  const int status = std::system(("sh -c \"" + command + "\"").c_str());
  EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(BatchStatus::FAILED));
  EXPECT_NE(contentOf(file("err")).find(state + ": could not be written: "), std::string::npos)
      << contentOf(file("err"));
  EXPECT_EQ(contentOf(state), bytes_);
  EXPECT_FALSE(fs::exists(state + ".tmp"));
}

}  // namespace
}  // namespace incision
