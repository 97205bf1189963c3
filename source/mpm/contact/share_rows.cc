// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/contact/share_rows.h>

#include <iterator>

namespace softgrain::mpm
{
namespace
{
using Row = ContactRow<2>;
using Slide = std::shared_ptr<const PlaceSlide<2>>;

/// A row, number by number. What packs and what unpacks it name its parts in the same order.
class Packer
{
public:
  Packer(std::vector<double> &numbers, const bool with_places) : numbers(numbers), with_places(with_places) {}

  void operator()(const double value) { numbers.push_back(value); }
  void operator()(const unsigned int value) { numbers.push_back(value); }
  void operator()(const bool value) { numbers.push_back(value); }
  void operator()(const std::uint64_t value)
  {
    // Halves: a double has fewer bits.
    numbers.push_back(static_cast<double>(value >> 32));
    numbers.push_back(static_cast<double>(value & 0xffffffff));
  }
  void operator()(const dealii::Tensor<1, 2> &value)
  {
    for (unsigned int d = 0; d < 2; ++d)
      numbers.push_back(value[d]);
  }
  void operator()(const PeriodicCell<2>::Image &value)
  {
    for (unsigned int d = 0; d < 2; ++d)
      numbers.push_back(value[d]);
  }
  void operator()(const std::shared_ptr<const NodeWeights> &value)
  {
    if (value == nullptr)
      numbers.push_back(0.);
    else
      (*this)(*value);
  }
  void operator()(const NodeWeights &value)
  {
    numbers.push_back(value.node.size());
    numbers.insert(numbers.end(), value.node.begin(), value.node.end());
    numbers.insert(numbers.end(), value.weight.begin(), value.weight.end());
  }
  /// The rows of a pair have the same: it is packed once.
  void operator()(const Slide &value)
  {
    const bool is_new = value != nullptr && value != last;
    numbers.push_back(value == nullptr ? 0. : is_new ? 2. : 1.);
    if (!is_new)
      return;
    if (with_places)
      (*this)(value->place);
    (*this)(value->across);
    (*this)(value->of_body_centre);
    (*this)(value->of_centre);
    last = value;
  }

private:
  std::vector<double> &numbers;
  const bool with_places; ///< whether those of slides are told, else what slides do to bodies as a whole
  Slide last;
};

class Unpacker
{
public:
  Unpacker(const std::vector<double> &numbers, const bool with_places)
      : at(numbers.data()), end(at + numbers.size()), with_places(with_places)
  {
  }

  bool done() const { return at == end; }

  void operator()(double &value) { value = *at++; }
  void operator()(unsigned int &value) { value = static_cast<unsigned int>(*at++); }
  void operator()(bool &value) { value = *at++ != 0.; }
  void operator()(std::uint64_t &value)
  {
    value = static_cast<std::uint64_t>(*at++) << 32;
    value |= static_cast<std::uint64_t>(*at++);
  }
  void operator()(dealii::Tensor<1, 2> &value)
  {
    for (unsigned int d = 0; d < 2; ++d)
      value[d] = *at++;
  }
  void operator()(PeriodicCell<2>::Image &value)
  {
    for (unsigned int d = 0; d < 2; ++d)
      value[d] = static_cast<int>(*at++);
  }
  void operator()(std::shared_ptr<const NodeWeights> &value)
  {
    NodeWeights weights;
    (*this)(weights);
    value = std::move(weights).shared();
  }
  void operator()(NodeWeights &value)
  {
    const auto n = static_cast<std::size_t>(*at++);
    value.node.assign(at, at + n);
    value.weight.assign(at + n, at + 2 * n);
    at += 2 * n;
  }
  void operator()(Slide &value)
  {
    const double kind = *at++;
    if (kind == 2.)
    {
      const auto slide = std::make_shared<PlaceSlide<2>>();
      if (with_places)
        (*this)(slide->place);
      (*this)(slide->across);
      (*this)(slide->of_body_centre);
      (*this)(slide->of_centre);
      last = slide;
    }
    value = kind == 0. ? nullptr : last;
  }

private:
  const double *at, *end;
  const bool with_places;
  Slide last;
};

/// Every part of a row that is told, but for its two bodies; `gap_where_found` and `pull` are not.
template <typename Parts, typename SomeRow>
void for_parts(Parts &part, const RowParts &told, SomeRow &row)
{
  part(row.wall);
  if (told.weights)
  {
    part(row.body_weights);
    part(row.partner_weights);
  }
  part(row.partner_marker);
  part(row.partner_share);
  part(row.place);
  part(row.normal);
  part(row.gap);
  part(row.length);
  part(row.friction);
  part(row.slide);
  part(row.slope);
  part(row.key);
  if (told.subgrid)
  {
    part(row.log_full_width[0]);
    part(row.log_full_width[1]);
  }
  if (told.adhesion)
  {
    part(row.adhesion);
    part(row.lift[0]);
    part(row.lift[1]);
  }
  if (told.obstacles)
  {
    part(row.obstacle);
    part(row.dented);
    part(row.partner_velocity);
  }
  if (told.cell)
  {
    part(row.branch);
    part(row.image);
    part(row.fold);
  }
}
constexpr unsigned int numbers_of_most_rows = 16;
} // namespace

void share_rows(const BodyShare &share,
                const std::vector<Body<2>> &bodies,
                const std::function<void()> &find,
                const RowParts &told,
                std::vector<Row> &rows)
{
  std::vector<std::vector<double>> packed(bodies.size());
  share.share_lists(
      [&]()
      {
        find();
        for (std::size_t first = 0, end; first < rows.size(); first = end)
        {
          for (end = first; end < rows.size() && rows[end].body == rows[first].body;)
            ++end;
          packed[rows[first].body].reserve(numbers_of_most_rows * (end - first));
          Packer pack(packed[rows[first].body], told.weights);
          pack(static_cast<unsigned int>(end - first));
          for (std::size_t r = first; r < end; ++r)
          {
            pack(rows[r].partner);
            for_parts(pack, told, rows[r]);
          }
        }
      },
      packed);
  std::size_t n_rows = 0;
  for (const std::vector<double> &of_body : packed)
    n_rows += of_body.empty() ? 0 : static_cast<std::size_t>(of_body[0]);
  std::vector<Row> all;
  all.reserve(n_rows);
  std::size_t own = 0;
  for (unsigned int b = 0; b < bodies.size(); ++b)
  {
    const std::size_t first = own;
    while (own < rows.size() && rows[own].body == b)
      ++own;
    if (share.mine(b))
      all.insert(all.end(), std::make_move_iterator(rows.begin() + first),
                 std::make_move_iterator(rows.begin() + own));
    else if (!packed[b].empty())
    {
      Unpacker unpack(packed[b], told.weights);
      unsigned int n_of_body = 0;
      unpack(n_of_body);
      for (unsigned int r = 0; r < n_of_body; ++r)
      {
        Row &row = all.emplace_back();
        row.body = b;
        unpack(row.partner);
        for_parts(unpack, told, row);
        if (!told.weights && row.partner != Row::none && share.mine(row.partner) &&
            !bodies[row.partner].driven)
          row.partner_weights =
              weights_on_outline(bodies[row.partner], row.partner_marker, row.partner_share).shared();
      }
    }
  }
  rows = std::move(all);
}

GapsByRow share_gaps_where_found(const BodyShare &share,
                                 const std::size_t n_bodies,
                                 const std::function<void()> &find,
                                 const std::vector<Row> &rows)
{
  std::vector<std::vector<double>> packed(n_bodies);
  share.share_lists(
      [&]()
      {
        find();
        for (const Row &row : rows)
        {
          Packer pack(packed[row.body], false);
          pack(row.key);
          pack(row.gap_where_found);
        }
      },
      packed);
  GapsByRow gaps;
  std::size_t n_numbers = 0;
  for (const std::vector<double> &numbers : packed)
    n_numbers += numbers.size();
  gaps.reserve(n_numbers / 3); // a key is two
  for (const std::vector<double> &numbers : packed)
    for (Unpacker unpack(numbers, false); !unpack.done();)
    {
      std::uint64_t key = 0;
      double gap = 0.;
      unpack(key);
      unpack(gap);
      gaps[key] = gap;
    }
  return gaps;
}
} // namespace softgrain::mpm
