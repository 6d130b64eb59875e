#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "incision/scene/scene.h"

namespace incision::bench {

/// The same step in the plainest way, written from the formulas alone: R by singular values, R K_e Rᵀ as a product of
/// 12×12 matrices, the whole system factorised with CHOLMOD every step. For bodies without cuts, loads and damping,
/// held at rest.
class PlainReference {
 public:
  PlainReference(const Scene& scene, TetMesh mesh);

  /// (M + Δt² K) Δv = Δt (f_ext − f_int − Δt K v),  v += Δv,  x += Δt v. Throws std::runtime_error when A cannot be
  /// factorised.
  void step();
  const std::vector<Vec3>& nodePositions() const { return x_; }

 private:
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  using Vector12 = Eigen::Matrix<double, 12, 1>;
  struct Element {
    Mat3 inverse_rest;  // D_m⁻¹
    Matrix12 stiffness;
  };

  void findPattern();
  Mat3 rotation(std::size_t element) const;
  void addElement(std::size_t element, Eigen::VectorXd* b);

  Scene scene_;
  TetMesh mesh_;
  std::vector<double> masses_;
  std::vector<Element> elements_;
  std::vector<int> unknown_;  // first one of each node, or −1 where it is held
  std::vector<Vec3> x_, v_;
  Eigen::SparseMatrix<double> A_;           // its lower triangle
  std::vector<std::array<int, 78>> slots_;  // of each entry of an element's lower triangle in A_, or −1
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> cholmod_;
};

}  // namespace incision::bench
