// SPDX-License-Identifier: LGPL-2.1-or-later
// Where two surfaces are near each other: disks and balls side by side have one stretch about the line of
// centres, a disk that lies in a ring one at its bottom, one that fills the ring several all around, a bar
// between the arms of a C one at each arm, a ball in a shell likewise. A triangle's tip on a side, and tip on
// tip, are found. What is far, or back to back, is not. Exchanged and mirrored, all are the same. A C whose
// lips are near each other has a stretch with itself, a narrow hole likewise; what is thin, or open, has
// none.
#include <softgrain/mpm/contact/folded_surface.h>
#include <softgrain/mpm/contact/near_stretches.h>

#include <cmath>
#include <iostream>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
template <int dim>
using Surface = SampledSurface<dim>;
using Vector2 = dealii::Tensor<1, 2>;

constexpr double spacing = 0.1;

/// Closed polygon, its solid to the left; corners where it turns by more than 0.3 rad.
void add_loop(const std::vector<dealii::Point<2>> &corners, Surface<2> &surface)
{
  const unsigned int first = surface.samples.size(), n = corners.size();
  const auto edge = [&](const unsigned int i)
  {
    const Vector2 way = corners[(i + 1) % n] - corners[i % n];
    return way / way.norm();
  };
  for (unsigned int i = 0; i < n; ++i)
  {
    const Vector2 before = edge(i + n - 1), after = edge(i);
    const double length = corners[i].distance(corners[(i + 1) % n]);
    const unsigned int parts = std::max(1., std::ceil(length / spacing));
    for (unsigned int k = 0; k < parts; ++k)
    {
      Surface<2>::Sample sample;
      sample.position = corners[i] + k * length / parts * after;
      const Vector2 along = k == 0 ? (before + after) / (before + after).norm() : after;
      sample.normal = Vector2({along[1], -along[0]});
      const double half = k == 0 ? 0.5 * std::acos(std::min(1., before * after)) : 0.;
      // A dent has no cone of normals.
      sample.corner = half > 0.15 && before[0] * after[1] - before[1] * after[0] > 0. ? half : 0.;
      surface.samples.push_back(sample);
    }
  }
  const unsigned int end = surface.samples.size();
  for (unsigned int i = first; i < end; ++i)
    surface.neighbours.emplace_back(i, i + 1 == end ? first : i + 1);
  surface.spacing = spacing;
}

void add_circle(const dealii::Point<2> &center, const double radius, const bool hole, Surface<2> &surface)
{
  std::vector<dealii::Point<2>> corners;
  const unsigned int n = std::ceil(2. * M_PI * radius / spacing);
  for (unsigned int i = 0; i < n; ++i)
  {
    const double angle = (hole ? -2. : 2.) * M_PI * (i + 0.3) / n;
    corners.emplace_back(center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle));
  }
  add_loop(corners, surface);
}

Surface<2> disk(const dealii::Point<2> &center, const double radius)
{
  Surface<2> surface;
  add_circle(center, radius, false, surface);
  return surface;
}

Surface<2> ring(const dealii::Point<2> &center, const double outer, const double inner)
{
  Surface<2> surface = disk(center, outer);
  add_circle(center, inner, true, surface);
  return surface;
}

Surface<2> polygon(const std::vector<dealii::Point<2>> &corners)
{
  Surface<2> surface;
  add_loop(corners, surface);
  return surface;
}

/// @param hole it is the inner surface of a shell
Surface<3> ball(const dealii::Point<3> &center, const double radius, const bool hole = false)
{
  Surface<3> surface;
  const unsigned int n = std::ceil(4. * M_PI * radius * radius / (0.4 * spacing * spacing));
  for (unsigned int i = 0; i < n; ++i) // a spiral
  {
    const double z = 1. - 2. * (i + 0.5) / n, angle = i * M_PI * (3. - std::sqrt(5.)),
                 r = std::sqrt(1. - z * z);
    Surface<3>::Sample sample;
    sample.normal = dealii::Tensor<1, 3>({r * std::cos(angle), r * std::sin(angle), z});
    sample.position = center + radius * sample.normal;
    if (hole)
      sample.normal *= -1.;
    surface.samples.push_back(sample);
  }
  surface.spacing = spacing;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < i; ++j)
      if (surface.samples[i].position.distance(surface.samples[j].position) < spacing)
        surface.neighbours.emplace_back(j, i);
  return surface;
}

template <int dim>
void mirror(Surface<dim> &surface)
{
  for (auto &sample : surface.samples)
  {
    sample.position[0] *= -1.;
    sample.normal[0] *= -1.;
  }
}

template <int dim>
void show(const std::string &name, Surface<dim> a, Surface<dim> b, const double reach)
{
  const auto found = near_stretches(a, b, reach), exchanged = near_stretches(b, a, reach);
  mirror(a);
  mirror(b);
  const auto mirrored = near_stretches(a, b, reach);
  std::cout << name << ": " << found.size() << " stretches, exchanged " << exchanged.size() << ", mirrored "
            << mirrored.size() << '\n';
  double off = 0.;
  for (unsigned int s = 0; s < found.size(); ++s)
  {
    double least = 1e9, least_mirrored = 1e9;
    for (const auto &other : exchanged)
      least = std::min(least, (found[s].middle - other.middle).norm() +
                                  (found[s].direction + other.direction).norm() +
                                  std::abs(found[s].gap - other.gap));
    for (const auto &other : mirrored)
    {
      auto middle = other.middle;
      auto direction = other.direction;
      middle[0] *= -1.;
      direction[0] *= -1.;
      least_mirrored = std::min(least_mirrored,
                                (found[s].middle - middle).norm() + (found[s].direction - direction).norm());
    }
    off = std::max({off, least, least_mirrored});
    if (found.size() < 4)
      std::cout << "  middle " << found[s].middle << ", direction " << found[s].direction << ", gap "
                << found[s].gap << '\n';
  }
  std::cout << "  exchanged and mirrored differ by " << off << '\n';
}

/// A C that opens to the right. @param apart its lips
Surface<2> clamp(const double apart)
{
  return polygon({{0., 0.},
                  {2., 0.},
                  {2., 0.5},
                  {0.7, 0.5},
                  {0.7, 0.5 + apart},
                  {2., 0.5 + apart},
                  {2., 1. + apart},
                  {0., 1. + apart}});
}

void show_fold(const std::string &name, const Surface<2> &surface)
{
  const auto found = stretches_of_fold(surface, 0.1);
  std::cout << name << (is_folded(surface) ? ": may meet itself, " : ": is not looked at, ") << found.size()
            << " stretches\n";
  for (const auto &stretch : found)
    std::cout << "  middle " << stretch.middle << ", direction up or down " << std::abs(stretch.direction[1])
              << ", gap " << stretch.gap << '\n';
}
} // namespace

int main()
{
  std::cout.precision(3);
  show<2>("disks", disk({0., 0.}, 1.), disk({2.04, 0.3}, 1.), 0.2);
  show<2>("disks that overlap", disk({0., 0.}, 1.), disk({1.9, 0.}, 1.), 0.2);
  show<2>("disks far apart", disk({0., 0.}, 1.), disk({2.4, 0.}, 1.), 0.2);
  show<2>("disk lies in ring", disk({0.1, -0.48}, 0.5), ring({0., 0.}, 1.2, 1.), 0.05);
  show<2>("disk fills ring", disk({0., 0.}, 0.99), ring({0., 0.}, 1.2, 1.), 0.05);
  show<2>("disk outside of a thin ring", disk({1.62, 0.}, 0.6), ring({0., 0.}, 1.0, 0.95), 0.1);
  show<2>("bar in C", polygon({{-1., -0.4}, {1., -0.4}, {1., 0.4}, {-1., 0.4}}),
          polygon({{-2., -1.},
                   {0.8, -1.},
                   {0.8, -0.45},
                   {-1.5, -0.45},
                   {-1.5, 0.45},
                   {0.8, 0.45},
                   {0.8, 1.},
                   {-2., 1.}}),
          0.1);
  show<2>("tip on a side", polygon({{0.3, 0.02}, {0.6, 1.}, {-0.1, 1.}}),
          polygon({{-1., -1.}, {1., -1.}, {1., 0.}, {-1., 0.}}), 0.1);
  show<2>("tip on tip", polygon({{0.02, 0.03}, {0.4, 1.}, {-0.4, 1.}}),
          polygon({{-0.4, -1.}, {0.4, -1.}, {0., 0.}}), 0.1);
  show<2>("small disk in a corner", disk({0.12, 0.11}, 0.1),
          polygon({{0., 0.}, {0., 1.}, {-0.5, 1.}, {-0.5, -0.5}, {1., -0.5}, {1., 0.}}), 0.03);
  show<3>("balls", ball({0., 0., 0.}, 1.), ball({1.2, 1.4, 0.84}, 1.), 0.2);
  show<3>("ball fills a shell", ball({0., 0., 0.}, 0.97), ball({0., 0., 0.}, 1., true), 0.05);
  show<3>("ball in a shell", ball({0., 0., -0.48}, 0.5), ball({0., 0., 0.}, 1., true), 0.05);
  show_fold("disk with itself", disk({0., 0.}, 1.));
  show_fold("strip thinner than the reach", polygon({{0., 0.}, {2., 0.}, {2., 0.05}, {0., 0.05}}));
  show_fold("C whose lips are near each other", clamp(0.06));
  show_fold("C whose lips have come 0.03 into each other", clamp(-0.03));
  show_fold("C that is open", clamp(0.3));
  show_fold("ring with a wide hole", ring({0., 0.}, 1., 0.5));
}
