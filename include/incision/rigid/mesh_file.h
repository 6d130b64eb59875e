#pragma once

#include <memory>
#include <string>

#include "incision/rigid/mesh_solid.h"

namespace incision {

/// The solid in a mesh file, which is read when it is first asked for something: a description may name files that
/// nobody needs. That first time must not be on two threads at once; `check` sees to it.
class MeshFile : public Solid {
 public:
  /// `address` as the description says it: package://, file://, absolute, or relative to `folder`, which is empty where
  /// there is none. `scale` stretches the file's axes, a negative one mirrors. `where` is what errors begin with unless
  /// `check` finds them.
  MeshFile(std::string address, std::string folder, const Vec3& scale, std::string where)
      : address_(std::move(address)), folder_(std::move(folder)), scale_(scale), where_(std::move(where)) {}

  SolidDistance distanceTo(const Vec3& point) const override { return solid().distanceTo(point); }
  SolidDistance distanceAgainst(const Vec3& point, const Vec3& n) const override {
    return solid().distanceAgainst(point, n);
  }
  double thickness() const override { return solid().thickness(); }
  double reachAlong(const Vec3& n) const override { return solid().reachAlong(n); }
  double reach() const override { return solid().reach(); }
  bool isConvex() const override { return solid().isConvex(); }
  bool isClearOf(const Vec3& point, double room) const override { return solid().isClearOf(point, room); }
  std::string remark() const override;
  void check(const std::string& where) const override;
  Drawing drawing() const override;

 private:
  const MeshSolid& solid() const {
    if (!solid_) read(where_);
    return *solid_;
  }
  void read(const std::string& where) const;
  /// The file's absolute path. Throws InputError.
  std::string path() const;

  std::string address_, folder_;
  Vec3 scale_;
  std::string where_;
  mutable std::unique_ptr<const MeshSolid> solid_;
  mutable std::string remark_;
};

}  // namespace incision
