// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/snapshot_cell.h>
#include <softgrain/driving/folded_bodies.h>

namespace softgrain
{
template <int dim>
FoldedBodies<dim>::FoldedBodies(Snapshot<dim> &snapshot, const PeriodicCell<dim> &cell) : cell(cell)
{
  for (BodyState<dim> &body : snapshot.bodies)
  {
    copies.push_back(cell.image_of(body.center));
    const dealii::Tensor<1, dim> way = cell.shift(copies.back());
    body.center -= way;
    for (auto &line : body.outline)
      for (dealii::Point<dim> &x : line)
        x -= way;
  }
  for (std::size_t p = 0; p < snapshot.points.position.size(); ++p)
    snapshot.points.position[p] -= cell.shift(copies[snapshot.points.body[p]]);
}

template <int dim>
void FoldedBodies<dim>::fold(ContactState<dim> &contact, const Image &body_fold, const Image &image) const
{
  Image place_fold = body_fold, partner = image;
  for (unsigned int d = 0; d < dim; ++d)
  {
    place_fold[d] -= copies[contact.body_a][d];
    partner[d] -= copies[contact.body_a][d];
    if (contact.body_b != ContactState<dim>::not_a_body)
      partner[d] += copies[contact.body_b][d];
  }
  contact.place += cell.shift(place_fold);
  if (contact.body_b != ContactState<dim>::not_a_body)
    contact.image = cell.shift(partner);
}

template <int dim>
std::optional<FoldedBodies<dim>> fold_bodies(Snapshot<dim> &snapshot)
{
  const PeriodicCell<dim> cell = cell_of(snapshot.walls);
  if (!cell.repeats())
    return std::nullopt;
  return FoldedBodies<dim>(snapshot, cell);
}

template class FoldedBodies<2>;
template class FoldedBodies<3>;
template std::optional<FoldedBodies<2>> fold_bodies(Snapshot<2> &);
template std::optional<FoldedBodies<3>> fold_bodies(Snapshot<3> &);
} // namespace softgrain
