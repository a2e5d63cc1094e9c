#ifndef CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_COLUMN_OPTIMIZER_H
#define CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_COLUMN_OPTIMIZER_H
#include <CGAL/Tubular_meshing/Operators/internal/layers/Layer_directions.h>
namespace CGAL { namespace Tubular_meshing { namespace internal {
struct Column_optimizer {
  Column_optimizer(const Layer_surface&, const Layer_directions&, const std::vector<double>&, std::vector<Vector_3d>&) {}
  void run() {}
};
}}}
#endif
