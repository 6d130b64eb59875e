#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/fem/assembly.h"
#include "incision/fracture/fringe.h"
#include "incision/fracture/front.h"
#include "incision/fracture/rankine.h"
#include "incision/fracture/stress.h"

namespace incision {

/// How a crack is to go on in this step.
struct CrackAdvance {
  std::optional<int> crack;                   ///< without: it starts
  std::vector<int> parts;                     ///< that it splits, ascending
  std::vector<double> reached;                ///< when it comes to each of them [s]
  std::vector<std::pair<int, double>> fresh;  ///< φ [m] at the copies it has not met before
  Loading loading;                            ///< of the most loaded of the parts
};

enum class CrackChange : std::uint8_t { STARTED = 0, GREW = 1, FUSED = 2, STOPPED = 3 };

/// What a crack did in one step.
struct CrackResult {
  double time = 0;  ///< at which the step starts [s]
  int crack = -1;   ///< −1: it could not start
  CrackChange change = CrackChange::STARTED;
  int other = -1;               ///< the crack with which it fused, or −1
  std::vector<int> elements;    ///< that it went through, ascending
  Vec3 where = Vec3::Zero();    ///< centroid of the new surface, or midway between fused fringes, deformed body [m]
  Vec3 normal = Vec3::UnitX();  ///< mean normal of that surface
  FailureKind kind = FailureKind::TENSION;
  double stress = 0;  ///< the principal stress [Pa] that decided; 0 where none did
};

/// The cracks that a body grows by itself: where they are, and where the stress drives them. It changes nothing: it
/// says how cracks are to advance, and is told what became of it.
class CrackGrowth {
 public:
  /// What outlasts a step. Everything else is found again from this and the mesh, by `topologyChanged`.
  struct Memory {
    GrowingCracks cracks;
    int known_copies = 0;       ///< how many of the mesh's copies have φ of the cracks from their parents
    std::set<int> barred;       ///< parts in which no crack can start
    std::vector<char> waiting;  ///< of every node: parts that have it wait until the next step is taken
    bool any_waiting = false;
  };

  explicit CrackGrowth(const FractureSettings& settings) : settings_(settings) {}

  const Memory& memory() const { return memory_; }
  /// Another number after each change of the memory.
  std::uint64_t version() const { return version_; }
  /// Takes back a memory. `topologyChanged` must follow, without touched nodes, on the mesh that belongs to it.
  void recall(const Memory& memory) {
    ++version_;
    memory_ = memory;
  }

  /// Before the first step and after every change of the mesh, of which `touched` are the nodes: parts round them wait
  /// until `stepTaken`, as their stress is not that of the new mesh.
  void topologyChanged(const Assembly& assembly, const std::vector<int>& touched);
  void stepTaken();

  /// Makes one crack of two whose fringes come within `fuse_distance` and `fuse_angle` of each other, one of them by
  /// its own growth: from now on they share their distances, so their surfaces meet without a step. Returns what to
  /// tell.
  std::vector<CrackResult> fuse(double time, const CutMesh& mesh, const std::vector<Vec3>& x);

  /// How the cracks advance in a step of `time_step` that starts at `time` [s] with the copies at `x` [m], which belong
  /// to the pieces `piece`: each crack at most once, by one element from each of its fringes, and each piece in which
  /// none advances starts at most one, at its most loaded part.
  std::vector<CrackAdvance> advances(double time, double time_step, const Assembly& assembly,
                                     const std::vector<Vec3>& x, const std::vector<int>& piece);

  /// The advance as a crack to insert, less the parts round the nodes that were touched meanwhile; empty where none is
  /// left.
  std::optional<CrackField> field(const CrackAdvance& advance, const CutMesh& mesh) const;

  /// The crack went into the mesh. Returns what to tell of it.
  CrackResult inserted(double time, const CrackAdvance& advance, const CrackField& field, const Insertion& done,
                       const CutMesh& mesh, const std::vector<Vec3>& x);

  /// The crack could not go into the mesh: it never tries these parts again. Returns what to tell where it matters.
  CrackResult refused(double time, const CrackAdvance& advance);

  /// A cut given from outside can grow like a crack. It must pass no node closer than SNAP.
  void adopt(const CrackField& field, const Insertion& done, const CutMesh& mesh);

 private:
  struct PieceLoad;

  /// What a fringe runs into, where cracks fuse.
  struct Target {
    Vec3 middle;                // of the fringe [m]
    std::optional<Vec3> point;  // of another crack's face [m]
    bool runs = false;          // there, as it has grown and goes on without load
    bool rests = false;         // as another fringe runs towards its crack
  };

  bool fuses() const { return settings_.fuse_distance > 0; }
  double load(const Assembly& assembly, const std::vector<Vec3>& x, bool any_runs);
  void wait(const std::vector<int>& nodes);
  bool waits(const CutMesh& mesh, int part) const;
  void findBeside(const CutMesh& mesh);
  bool isBeside(const CutMesh& mesh, int part) const;
  std::vector<PieceLoad> mostLoaded(const CutMesh& mesh, const std::vector<int>& piece) const;
  bool hasGrown(const Fringe& fringe, const CutMesh& mesh) const;
  void findTargets(const CutMesh& mesh, const std::vector<Vec3>& x, const std::vector<int>& piece);
  double arrival(const Fringe& fringe, double time, const CutMesh& mesh, const std::vector<Vec3>& x) const;
  double phiAhead(int fringe, const CutMesh& mesh, const std::vector<Vec3>& x) const;
  std::vector<CrackAdvance> grow(const std::vector<int>& fringes, double earliest, const CutMesh& mesh,
                                 const std::vector<Vec3>& x) const;
  CrackAdvance start(int part, double time, const CutMesh& mesh, const std::vector<Vec3>& x) const;
  GrowingCrack& remember(const CrackField& field, const Insertion& done, const CutMesh& mesh);
  void inherit(const CutMesh& mesh);

  FractureSettings settings_;
  Memory memory_;
  std::uint64_t version_ = 0;
  // Scratch: found again from memory and mesh.
  SmoothedStress stress_;
  std::vector<Strength> strengths_;  // of every region
  std::vector<Loading> loading_;     // of every part
  std::vector<char> looked_at_;      // of every part: whether its stress is known in this step
  std::vector<Fringe> fringes_;
  std::vector<CrackFace> faces_;  // of all cracks, where cracks fuse
  std::vector<Target> targets_;   // of every fringe, where cracks fuse
  std::vector<char> beside_;      // of every copy: used by a part at a fringe
};

template <class Archive>
void serialize(Archive& archive, CrackGrowth::Memory& memory) {
  auto& [cracks, known_copies, barred, waiting, any_waiting] = memory;
  archive(cracks, known_copies, barred, waiting, any_waiting);
}

void check(const CrackGrowth::Memory& memory, const MemoryLimits& limits);

}  // namespace incision
