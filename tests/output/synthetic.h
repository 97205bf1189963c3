// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_output_synthetic_h
#define softgrain_tests_output_synthetic_h

// Snapshots that look like a squeezed disk and like a packing of soft disks, made from formulas: no model
// runs.

#include <softgrain/analysis/snapshot.h>

#include <cmath>
#include <random>

namespace synthetic
{
using namespace softgrain;
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;

constexpr double pi = 3.14159265358979323846;
constexpr double poisson = 0.45;

inline Vector vector(const double x, const double y)
{
  Vector v;
  v[0] = x;
  v[1] = y;
  return v;
}

/// Adds Flamant's field of a line load @p force at @p place on a body, smeared over the length @p width.
inline void add_load(dealii::SymmetricTensor<2, 2> &stress,
                     const Point &point,
                     const Point &place,
                     const Vector &force,
                     const double width)
{
  const Vector r = point - place;
  const double squared = r.norm_square() + width * width;
  const double radial = -2. / pi * (force * r) / (squared * squared);
  stress[0][0] += radial * r[0] * r[0];
  stress[1][1] += radial * r[1] * r[1];
  stress[0][1] += radial * r[0] * r[1];
}

inline void add_point(Snapshot<2> &snapshot, const Point &place, const unsigned int body, const double area)
{
  snapshot.points.position.push_back(place);
  snapshot.points.body.push_back(body);
  snapshot.points.size.push_back(area);
}

inline void finish_stress(Snapshot<2> &snapshot, const dealii::SymmetricTensor<2, 2> &stress)
{
  snapshot.points.stress.push_back(stress);
  snapshot.points.out_of_plane_stress.push_back(poisson * (stress[0][0] + stress[1][1]));
  BodyState<2> &body = snapshot.bodies[snapshot.points.body.back()];
  body.mean_stress += (snapshot.points.size.back() / body.area) * stress;
}

inline void add_wall(Snapshot<2> &snapshot,
                     const char *name,
                     const Point &point,
                     const Vector &normal,
                     const double position,
                     const double force)
{
  WallState<2> wall;
  wall.name = name;
  wall.point = point;
  wall.normal = normal;
  wall.position = position;
  wall.normal_force = force;
  snapshot.walls.push_back(wall);
}

/// The place of a point (X, Y) of a disk of radius R squeezed to the height 2 R (1 - squeeze).
inline Point squeezed(const double X, const double Y, const double R, const double squeeze)
{
  const double H = R * (1 - squeeze), s = std::abs(Y) / H;
  const double y = Y / std::pow(1 + std::pow(s, 14), 1. / 14);
  const double x = X * (1 + squeeze * (1.1 - 0.6 * y * y / (H * H)));
  return {x, y + R * (1 - squeeze)};
}

/// A disk of E = 10 MPa between two walls, the lower at y = 0.
inline Snapshot<2> squeezed_disk(const double time, const double squeeze, const unsigned int n_across = 69)
{
  const double R = 5e-3, force = pi / 4 * 10e6 / (1 - poisson * poisson) * R * -std::log(1 - squeeze);
  const double H = 2 * R * (1 - squeeze), a = R * std::sqrt(std::max(1e-4, 1.3 * squeeze));
  Snapshot<2> snapshot;
  snapshot.time = time;
  snapshot.step = static_cast<std::uint64_t>(time * 1e7);
  BodyState<2> body;
  body.name = "disk";
  body.center = Point(0, H / 2);
  body.velocity = vector(0, -0.1);
  body.area = body.reference_area = pi * R * R;
  body.mass = 990 * body.area;
  body.outline.resize(1);
  for (unsigned int i = 0; i < 240; ++i)
    body.outline[0].push_back(
        squeezed(R * std::cos(2 * pi * i / 240), R * std::sin(2 * pi * i / 240), R, squeeze));
  snapshot.bodies.push_back(body);
  const double h = 2 * R / n_across;
  NamedField energy{"strain_energy_J_per_m3", {}};
  for (unsigned int i = 0; i < n_across; ++i)
    for (unsigned int j = 0; j < n_across; ++j)
    {
      const double X = -R + (i + 0.5) * h, Y = -R + (j + 0.5) * h, d = 1e-3 * h;
      if (X * X + Y * Y >= R * R)
        continue;
      dealii::Tensor<2, 2> F;
      for (unsigned int k = 0; k < 2; ++k)
      {
        const double dX = k == 0 ? d : 0, dY = k == 1 ? d : 0;
        const Vector column =
            (squeezed(X + dX, Y + dY, R, squeeze) - squeezed(X - dX, Y - dY, R, squeeze)) / (2 * d);
        F[0][k] = column[0];
        F[1][k] = column[1];
      }
      const Point place = squeezed(X, Y, R, squeeze);
      add_point(snapshot, place, 0, h * h * determinant(F));
      snapshot.points.deformation_gradient.push_back(F);
      snapshot.points.velocity.push_back(vector(0.1 * X / R, -0.2 * place[1] / H));
      dealii::SymmetricTensor<2, 2> stress;
      for (const int part : {-2, -1, 0, 1, 2})
      {
        const double x = 0.4 * part * a;
        const double share = force * std::sqrt(1 - 0.16 * part * part) / 3.8;
        add_load(stress, place, Point(x, 0), vector(0, share), 0.25 * a);
        add_load(stress, place, Point(x, H), vector(0, -share), 0.25 * a);
      }
      stress[0][0] += 0.5 * force / (pi * R);
      finish_stress(snapshot, stress);
      energy.values.push_back(stress.norm() * stress.norm() / 20e6);
    }
  snapshot.points.extra.push_back(energy);
  const unsigned int n = 15;
  for (unsigned int wall = 0; wall < 2; ++wall)
    for (unsigned int i = 0; i < n && squeeze > 0; ++i)
    {
      const double s = -1 + (2. * i + 1) / n;
      ContactState<2> contact;
      contact.body_a = 0;
      contact.wall = wall;
      contact.place = Point(a * s, wall == 0 ? 0 : H);
      contact.normal = vector(0, wall == 0 ? 1 : -1);
      contact.length = 2 * a / n;
      contact.force = (4 / pi * force / n * std::sqrt(1 - s * s)) * contact.normal;
      snapshot.contacts.push_back(contact);
    }
  add_wall(snapshot, "bottom", Point(0, 0), vector(0, 1), 0, force);
  add_wall(snapshot, "top", Point(0, H), vector(0, -1), H, force);
  snapshot.energies = {1e-6, 0.5 * force * 2 * R * squeeze, 0, 0.5 * force * 2 * R * squeeze};
  return snapshot;
}

/// Soft disks on a shaken hexagonal lattice in a box, flattened where they meet.
inline Snapshot<2> packing(const unsigned int n_columns, const unsigned int n_rows)
{
  std::mt19937 random(7);
  const auto uniform = [&](const double low, const double high)
  { return low + (high - low) * static_cast<double>(random()) / 4294967296.; };
  const double d = 2e-3, R = 0.54 * d, row_height = 0.5 * std::sqrt(3.) * d;
  const double width = (n_columns + 0.5) * d, height = (n_rows - 1) * row_height + d;
  Snapshot<2> snapshot;
  snapshot.time = 1.234e-3;
  snapshot.step = 12340;
  std::vector<Point> centers;
  for (unsigned int j = 0; j < n_rows; ++j)
    for (unsigned int i = 0; i < n_columns; ++i)
      centers.emplace_back((i + 0.5 + 0.5 * (j % 2)) * d + uniform(-0.06, 0.06) * d,
                           d / 2 + j * row_height + uniform(-0.06, 0.06) * d);

  struct Cut
  {
    Vector normal; ///< out of the body
    double distance, force;
  };
  std::vector<std::vector<Cut>> cuts(centers.size());
  const auto meet = [&](const unsigned int b, const Vector &normal, const double distance, const double force)
  {
    if (distance < R)
      cuts[b].push_back({normal, distance, force});
    return distance < R;
  };
  const auto contact = [&](const unsigned int a, const unsigned int b, const unsigned int wall,
                           const Vector &normal, const double distance, const double force)
  {
    ContactState<2> state;
    state.body_a = a;
    state.body_b = b;
    state.wall = wall;
    state.normal = -normal;
    state.place = centers[a] + distance * normal;
    state.force = -force * normal;
    state.length = 2 * std::sqrt(R * R - distance * distance);
    snapshot.contacts.push_back(state);
  };
  const unsigned int none = ContactState<2>::not_a_body;
  const auto strength = [&](const double overlap)
  { return 2e7 * overlap * std::pow(uniform(0, 1), 1.5) * 0.5; };
  for (unsigned int a = 0; a < centers.size(); ++a)
  {
    for (unsigned int b = a + 1; b < centers.size(); ++b)
    {
      const double distance = centers[a].distance(centers[b]) / 2;
      if (distance >= R)
        continue;
      const Vector normal = (centers[b] - centers[a]) / (2 * distance);
      const double force = strength(R - distance);
      meet(a, normal, distance, force);
      meet(b, -normal, distance, force);
      contact(a, b, none, normal, distance, force);
    }
    const double to_wall[] = {centers[a][1], height - centers[a][1], centers[a][0], width - centers[a][0]};
    const Vector outward[] = {vector(0, -1), vector(0, 1), vector(-1, 0), vector(1, 0)};
    for (unsigned int wall = 0; wall < 4; ++wall)
    {
      const double force = strength(std::max(0., R - to_wall[wall]));
      if (meet(a, outward[wall], to_wall[wall], force))
        contact(a, none, wall, outward[wall], to_wall[wall], force);
    }
  }

  for (unsigned int b = 0; b < centers.size(); ++b)
  {
    const auto radius = [&](const double angle)
    {
      // A smooth minimum rounds the corners, as a soft body does.
      double sum = std::pow(R, -24);
      for (const Cut &cut : cuts[b])
        if (const double c = cut.normal * vector(std::cos(angle), std::sin(angle)); c > 1e-3)
          sum += std::pow(cut.distance / c, -24);
      return std::pow(sum, -1. / 24);
    };
    BodyState<2> body;
    body.name = "disk" + std::to_string(b);
    body.center = centers[b];
    body.outline.resize(1);
    const unsigned int n = 96;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double angle = 2 * pi * i / n, r = radius(angle);
      body.outline[0].push_back(centers[b] + r * vector(std::cos(angle), std::sin(angle)));
      body.area += pi * r * r / n;
    }
    body.reference_area = pi * R * R;
    body.mass = 990 * body.reference_area;
    snapshot.bodies.push_back(body);
    const double h = 0.17 * R;
    for (double x = -1.2 * R + h / 2; x < 1.2 * R; x += h)
      for (double y = -1.2 * R + h / 2; y < 1.2 * R; y += h)
      {
        if (std::hypot(x, y) >= radius(std::atan2(y, x)))
          continue;
        const Point place = centers[b] + vector(x, y);
        add_point(snapshot, place, b, h * h);
        dealii::Tensor<2, 2> F;
        F[0][0] = F[1][1] = 1;
        snapshot.points.deformation_gradient.push_back(F);
        snapshot.points.velocity.push_back(vector(0, -place[1] / height));
        dealii::SymmetricTensor<2, 2> stress;
        for (const Cut &cut : cuts[b])
          add_load(stress, place, centers[b] + cut.distance * cut.normal, -cut.force * cut.normal, 0.15 * R);
        finish_stress(snapshot, stress);
      }
  }
  add_wall(snapshot, "bottom", Point(0, 0), vector(0, 1), 0, 3000);
  add_wall(snapshot, "top", Point(0, height), vector(0, -1), height, 3000);
  add_wall(snapshot, "left", Point(0, 0), vector(1, 0), 0, 2500);
  add_wall(snapshot, "right", Point(width, 0), vector(-1, 0), width, 2500);
  return snapshot;
}
} // namespace synthetic

#endif
