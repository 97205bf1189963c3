// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/snapshot_cell.h>
#include <softgrain/driving/folded_bodies.h>

namespace softgrain
{
FoldedBodies::FoldedBodies(Snapshot<2> &snapshot, const PeriodicCell<2> &cell) : cell(cell)
{
  for (BodyState<2> &body : snapshot.bodies)
  {
    copies.push_back(cell.image_of(body.center));
    const dealii::Tensor<1, 2> way = cell.shift(copies.back());
    body.center -= way;
    for (auto &line : body.outline)
      for (dealii::Point<2> &x : line)
        x -= way;
  }
  for (std::size_t p = 0; p < snapshot.points.position.size(); ++p)
    snapshot.points.position[p] -= cell.shift(copies[snapshot.points.body[p]]);
}

void FoldedBodies::fold(ContactState<2> &contact,
                        const PeriodicCell<2>::Image &body_fold,
                        const PeriodicCell<2>::Image &image) const
{
  const PeriodicCell<2>::Image &a = copies[contact.body_a];
  contact.place += cell.shift({{body_fold[0] - a[0], body_fold[1] - a[1]}});
  if (contact.body_b == ContactState<2>::not_a_body)
    return;
  const PeriodicCell<2>::Image &b = copies[contact.body_b];
  contact.image = cell.shift({{image[0] - a[0] + b[0], image[1] - a[1] + b[1]}});
}

std::optional<FoldedBodies> fold_bodies(Snapshot<2> &snapshot)
{
  const PeriodicCell<2> cell = cell_of(snapshot.walls);
  if (!cell.repeats())
    return std::nullopt;
  return FoldedBodies(snapshot, cell);
}
} // namespace softgrain
