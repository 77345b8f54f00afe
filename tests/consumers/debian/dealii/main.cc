// What deal.II sees of a `.msh` file, and the temperature in the two rooms.
//   see_dealii FILE
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/numerics/matrix_tools.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <fstream>
#include <iostream>

using namespace dealii;

struct Exact : Function<2> {
  double value(const Point<2> &p, unsigned int) const override {
    return 10 * (p[0] - 1.3) / (p[0] < 1.3 ? 2 : 5) - 2 * p[1] + 1;
  }
};

int main(int, char **arguments) {
  Triangulation<2> mesh;
  GridIn<2> reader(mesh);
  std::ifstream file(arguments[1]);
  reader.read_msh(file);

  std::cout.precision(17);
  for (const auto &p : mesh.get_vertices())
    std::cout << "point " << p[0] << ' ' << p[1] << '\n';
  for (const auto &cell : mesh.active_cell_iterators()) {
    std::cout << "triangle " << cell->material_id() << ' ' << cell->measure() << '\n';
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        std::cout << "edge " << face->boundary_id() << ' ' << face->measure() << '\n';
  }

  const FE_SimplexP<2> element(1);
  const MappingFE<2> mapping(element);
  DoFHandler<2> dofs(mesh);
  dofs.distribute_dofs(element);
  DynamicSparsityPattern pattern(dofs.n_dofs());
  DoFTools::make_sparsity_pattern(dofs, pattern);
  SparsityPattern sparsity;
  sparsity.copy_from(pattern);
  SparseMatrix<double> matrix(sparsity);
  Vector<double> load(dofs.n_dofs()), solution(dofs.n_dofs());

  FEValues<2> values(mapping, element, QGaussSimplex<2>(2), update_gradients | update_JxW_values);
  FullMatrix<double> local(3, 3);
  std::vector<types::global_dof_index> indices(3);
  for (const auto &cell : dofs.active_cell_iterators()) {
    const double k = cell->material_id() == 11 ? 2 : cell->material_id() == 12 ? 5 : 1e30;
    values.reinit(cell);
    local = 0;
    for (const unsigned int q : values.quadrature_point_indices())
      for (const unsigned int i : values.dof_indices())
        for (const unsigned int j : values.dof_indices())
          local(i, j) += k * values.shape_grad(i, q) * values.shape_grad(j, q) * values.JxW(q);
    cell->get_dof_indices(indices);
    matrix.add(indices, local);
  }
  const Exact exact;
  std::map<types::boundary_id, const Function<2> *> fixed;
  for (const types::boundary_id side : {1, 2, 3, 9})
    fixed[side] = &exact;
  std::map<types::global_dof_index, double> given;
  VectorTools::interpolate_boundary_values(mapping, dofs, fixed, given);
  MatrixTools::apply_boundary_values(given, matrix, solution, load);
  SolverControl control(1000, 1e-14 * load.l2_norm());
  SolverCG<Vector<double>>(control).solve(matrix, solution, load, PreconditionIdentity());

  std::vector<Point<2>> places(dofs.n_dofs());
  DoFTools::map_dofs_to_support_points(mapping, dofs, places);
  double error = 0;
  for (unsigned int i = 0; i < places.size(); ++i)
    error = std::max(error, std::abs(solution(i) - exact.value(places[i], 0)));
  std::cout << "error " << error << '\n';
}
