// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/adhesion.h>
#include <softgrain/model/state_file.h>

#include <algorithm>
#include <utility>

namespace softgrain
{
Adhesion::Adhesion(std::shared_ptr<const ContactLaw> contact_law, const double touching)
    : law(contact_law != nullptr && contact_law->adheres() ? std::move(contact_law) : nullptr)
    , touching(touching)
{
}

double Adhesion::reach() const
{
  return acts() ? std::max(law->range(), touching) : 0.;
}

double Adhesion::memory_of(const std::uint64_t key, const double gap) const
{
  if (!started)
    return first_memory(gap);
  const auto found = memory.find(key);
  return found == memory.end() ? 0. : found->second;
}

double Adhesion::share(const std::uint64_t key, const double gap) const
{
  const double apart = gap_between_surfaces(gap);
  return law->share(apart, law->remembers() ? memory_of(key, apart) : 0.);
}

double Adhesion::nearest(const double gap, const std::array<double, 2> &lift) const
{
  return resolves_range() ? gap + std::min({0., lift[0], lift[1]}) : gap;
}

void Adhesion::note(const std::uint64_t key, const double gap, const ContactEvent &event)
{
  const double after = memory_after(memory_of(key, gap), event);
  if (after != 0.)
    next[key] = after;
}

double Adhesion::first_memory(const double gap) const
{
  return !started && gap_between_surfaces(gap) <= 0. ? law->memory_at_start() : 0.;
}

double Adhesion::mean_share(const double remembered, const double gap, const double end) const
{
  return resolves_range() ? law->mean_share(gap, end, remembered)
                          : law->share(gap_between_surfaces(gap), remembered);
}

double Adhesion::memory_after(const double remembered, ContactEvent event) const
{
  event.gap = gap_between_surfaces(event.gap);
  return law->memory_after(remembered, event);
}

void Adhesion::finish_step()
{
  started = true;
  memory.swap(next);
  next.clear();
}

void Adhesion::save(StateWriter &out, const std::string &name) const
{
  if (!remembers())
    return;
  // Sorted, so that equal states give equal files.
  std::vector<std::pair<std::uint64_t, double>> sorted(memory.begin(), memory.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint64_t> keys;
  std::vector<double> values;
  for (const auto &[key, value] : sorted)
  {
    keys.push_back(key);
    values.push_back(value);
  }
  out.write(name + "/started", std::vector<std::uint64_t>{started});
  out.write(name + "/keys", keys);
  out.write(name + "/memory", values);
}

void Adhesion::load(const StateReader &in, const std::string &name)
{
  if (!remembers())
    return;
  const std::vector<std::uint64_t> keys = in.read_keys(name + "/keys", ListSize::rows_of(1));
  const std::vector<double> values = in.read_doubles(name + "/memory", keys.size());
  started = in.read_integers(name + "/started", 1, 2)[0] != 0;
  memory.clear();
  for (std::size_t k = 0; k < values.size(); ++k)
    memory[keys[k]] = values[k];
}
} // namespace softgrain
