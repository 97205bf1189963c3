// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/body_share.h>

namespace softgrain::mpm
{
void BodyShare::Message::add(std::vector<double> &numbers)
{
  for (unsigned int b = 0; b < numbers.size(); ++b)
    add(b, &numbers[b], 1);
}

void BodyShare::Message::add(const std::vector<Body<2>> &bodies, std::vector<Eigen::VectorXd> &vectors)
{
  if (share.alone())
    return;
  for (const Body<2> &body : bodies)
    if (!body.rigid.driven)
    {
      Eigen::VectorXd &vector = vectors[body.index];
      if (vector.size() != body.field.n_dofs())
        vector.setZero(body.field.n_dofs());
      add(body.index, vector.data(), vector.size());
    }
}

void BodyShare::Message::add_outline(Body<2> &body)
{
  std::vector<dealii::Point<2>> &outline = body.boundary.position;
  static_assert(sizeof(outline[0]) == 2 * sizeof(double), "points are not two numbers each");
  if (!outline.empty())
    add(body.index, outline[0].begin_raw(), 2 * outline.size());
}

void BodyShare::Message::add(const unsigned int b, double *const begin, const std::size_t size)
{
  if (!share.alone())
    pieces.push_back({share.owner(b), begin, size});
}

void BodyShare::send_lists(const std::vector<double> &sizes, std::vector<std::vector<double>> &lists) const
{
  Message message(*this);
  for (unsigned int b = 0; b < lists.size(); ++b)
  {
    lists[b].resize(static_cast<std::size_t>(sizes[b]));
    message.add(b, lists[b].data(), lists[b].size());
  }
  message.send();
}
} // namespace softgrain::mpm
