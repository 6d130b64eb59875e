#include "incision/solver/first_guess.h"

namespace incision {
namespace {

/// What must be left of a vector's square when the ones before it are taken out: the products are sums of floats.
constexpr double LEAST_REST = 1e-5;

}  // namespace

// G = L D Lᵀ, a dropped vector having no row and column in it.
BasisVector bestCombination(const BasisMatrix& G, const BasisVector& h) {
  BasisMatrix L = BasisMatrix::Identity();
  BasisVector D = BasisVector::Zero(), c = h;
  for (int j = 0; j < BASIS_SIZE; ++j) {
    double d = G(j, j);
    for (int k = 0; k < j; ++k) d -= L(j, k) * L(j, k) * D[k];
    const bool dropped = !(d > LEAST_REST * G(j, j));
    D[j] = dropped ? 0 : d;
    for (int i = j + 1; i < BASIS_SIZE; ++i) {
      double l = G(i, j);
      for (int k = 0; k < j; ++k) l -= L(i, k) * L(j, k) * D[k];
      L(i, j) = dropped ? 0 : l / d;
    }
    for (int k = 0; k < j; ++k) c[j] -= L(j, k) * c[k];
  }
  for (int j = BASIS_SIZE - 1; j >= 0; --j) {
    c[j] = D[j] > 0 ? c[j] / D[j] : 0;
    if (D[j] > 0)
      for (int i = j + 1; i < BASIS_SIZE; ++i) c[j] -= L(i, j) * c[i];
  }
  return c;
}

}  // namespace incision
