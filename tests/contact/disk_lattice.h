// SPDX-License-Identifier: LGPL-2.1-or-later
// A Delassus operator of bodies that nothing but contacts holds, for tests of frictional contact.
#ifndef softgrain_tests_contact_disk_lattice_h
#define softgrain_tests_contact_disk_lattice_h

#include <softgrain/contact/block_delassus.h>

#include <cmath>
#include <vector>

/**
 * Disks on a triangular lattice between walls, three contacts side by side on every one of the six arcs: each
 * body has an elastic block and the rigid modes x, y, rotation with compliance 1/m = @p rigid (2/m for the
 * rotation at the rim).
 */
inline softgrain::contact::BlockDelassus
disk_lattice(const unsigned int n_x, const unsigned int n_y, const double rigid)
{
  struct Row
  {
    unsigned int contact;
    double angle, sign, offset;
  };
  std::vector<std::vector<Row>> bodies(n_x * n_y);
  unsigned int n_contacts = 0;
  const double pi = std::acos(-1.);
  for (unsigned int b = 0; b < bodies.size(); ++b)
    for (int side = 0; side < 6; ++side)
    {
      const int j = b / n_x, i = b % n_x, odd = j % 2;
      const int di[6] = {1, odd, odd - 1, -1, odd - 1, odd}, dj[6] = {0, 1, 1, 0, -1, -1};
      const int ni = i + di[side], nj = j + dj[side];
      const bool wall = ni < 0 || nj < 0 || ni >= int(n_x) || nj >= int(n_y);
      if (!wall && side >= 3)
        continue;
      for (const double offset : {-0.1, 0., 0.1})
      {
        bodies[b].push_back({n_contacts, side * pi / 3., 1., offset});
        if (!wall)
          bodies[nj * n_x + ni].push_back({n_contacts, side * pi / 3., -1., -offset});
        ++n_contacts;
      }
    }
  softgrain::contact::BlockDelassus W(n_contacts, 2);
  for (const auto &body : bodies)
  {
    // radius 1; w of a pair is velocity of the other side less that of this one along the normal, likewise
    // along t
    const unsigned int size = 2 * body.size();
    std::vector<unsigned int> rows(size);
    Eigen::MatrixXd modes(size, 3), elastic = Eigen::MatrixXd::Zero(size, size);
    for (unsigned int k = 0; k < body.size(); ++k)
    {
      const double c = std::cos(body[k].angle), s = std::sin(body[k].angle), sign = -body[k].sign;
      rows[2 * k] = 2 * body[k].contact;
      rows[2 * k + 1] = rows[2 * k] + 1;
      modes.row(2 * k) << sign * c, sign * s, -body[k].offset;
      modes.row(2 * k + 1) << -sign * s, sign * c, -std::sqrt(2.);
      for (unsigned int l = 0; l < body.size(); ++l)
      {
        const double angle = std::remainder(body[k].angle + (body[k].sign > 0. ? 0. : pi) - body[l].angle -
                                                (body[l].sign > 0. ? 0. : pi),
                                            2. * pi);
        const double offset = body[k].sign * body[k].offset - body[l].sign * body[l].offset;
        if (std::abs(angle) < 1e-6)
          for (unsigned int d = 0; d < 2; ++d)
            elastic(2 * k + d, 2 * l + d) = std::exp(-std::abs(offset) / 0.1);
      }
    }
    W.add_block(rows, elastic + rigid * modes * modes.transpose());
  }
  return W;
}

#endif
