// SPDX-License-Identifier: LGPL-2.1-or-later
// The order in which the unknowns of a contact problem are eliminated.
#include <softgrain/mpm/contact/frame_system.h>

#include <Eigen/OrderingMethods>

#include <vector>

namespace softgrain::mpm
{
template <int dim>
void FrameSystem<dim>::find_order()
{
  std::vector<int> frame_of; // numbers of frames with columns, by column
  std::vector<unsigned int> first;
  for (unsigned int i = 0; i < columns.size(); ++i)
  {
    if (columns[i].kind != Column::wall && (first.empty() || columns[i].frame != columns[i - 1].frame))
      first.push_back(i);
    frame_of.push_back(first.size() - 1);
  }
  first.push_back(columns.size());
  const int n = first.size() - 1;
  std::vector<Eigen::Triplet<double>> pairs;
  for (const auto &list : of_body)
  {
    std::vector<int> of_this; // frames
    for (const unsigned int i : list)
      if (columns[i].kind != Column::wall && (of_this.empty() || of_this.back() != frame_of[i]))
        of_this.push_back(frame_of[i]);
    for (const int one : of_this)
      for (const int other : of_this)
        pairs.emplace_back(one, other, 1.);
  }
  Eigen::SparseMatrix<double> graph(n, n);
  graph.setFromTriplets(pairs.begin(), pairs.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(graph, permutation);
  order.clear();
  for (int f = 0; f < n; ++f)
  {
    const unsigned int begin = first[permutation.indices()[f]], end = first[permutation.indices()[f] + 1];
    for (unsigned int i = begin; i < end; ++i)
      if (columns[i].kind != Column::motion)
        order.push_back(i);
    for (unsigned int i = begin; i < end; ++i)
      if (columns[i].kind == Column::motion)
        order.push_back(i);
  }
  // Walls meet many.
  for (unsigned int w = 0; w < ways.size(); ++w)
    order.push_back(w);
  // Walls under loads have a block of their own, which meets all others.
  n_blocks = n + !ways.empty();
  block_of.assign(columns.size(), n);
  const Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> block_of_frame = permutation.inverse();
  for (unsigned int i = ways.size(); i < columns.size(); ++i)
    block_of[i] = block_of_frame.indices()[frame_of[i]];
  neighbours.clear();
  for (int block = 0; block + 1 < n_blocks && !ways.empty(); ++block)
    neighbours.emplace_back(n, block);
  for (const auto &pair : pairs)
    neighbours.emplace_back(block_of_frame.indices()[pair.row()], block_of_frame.indices()[pair.col()]);
}

template void FrameSystem<2>::find_order();
template void FrameSystem<3>::find_order();
} // namespace softgrain::mpm
