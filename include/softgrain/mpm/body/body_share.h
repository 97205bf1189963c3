// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_body_share_h
#define softgrain_mpm_body_body_share_h

#include <softgrain/base/exchange.h>
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/body/body.h>

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Which rank does the work on which body, and how the others come to know what it has found.
 *
 * A body has one rank, its owner; "owned" means by the rank that runs this. The owner alone has the points,
 * the shape functions there, the matrix and its factors. Between steps nodal values and the outline are known
 * to all ranks. Where bodies meet at their nodes, and of bodies that are driven, all ranks have the points as
 * well; the owner's stress and history count.
 *
 * Results do not depend on who owns what: the work on a body is the same on any rank, and sums over bodies
 * are taken by all ranks in the order of the bodies.
 */
class BodyShare
{
public:
  const Exchange exchange;

  bool alone() const { return exchange.alone(); }
  bool mine(const unsigned int b) const { return exchange.alone() || owner_of[b] == exchange.here(); }
  /// Whether the points of a body lie here.
  bool holds(const unsigned int b) const { return exchange.alone() || lies_here[b] != 0; }
  unsigned int owner(const unsigned int b) const { return exchange.alone() ? 0 : owner_of[b]; }

  /// Gives the bodies to these owners from now on. @param held of every body, whether its points lie here
  void give(std::vector<unsigned int> owners, std::vector<char> held)
  {
    owner_of = std::move(owners);
    lies_here = std::move(held);
  }

  /// Calls @p work for every owned body that is not driven, on all threads; it may write only to what
  /// is its body's. Ends when all are done, see Exchange::together().
  template <class Bodies, class Work>
  void for_mine(Bodies &bodies, const Work &work) const
  {
    exchange.together([&]() { for_mine_here(bodies, work); });
  }

  /// Works on owned bodies without waiting for others, as a part of what is done together().
  template <class Bodies, class Work>
  void for_mine_here(Bodies &bodies, const Work &work) const
  {
    parallel_for(bodies.size(), 1,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   for (std::size_t b = begin; b < end; ++b)
                     if (!bodies[b].rigid.driven && mine(b))
                       work(bodies[b]);
                 });
  }

  /// What owners of bodies have to tell, collected to be sent at once. Where one owns all nothing is
  /// collected.
  class Message
  {
  public:
    explicit Message(const BodyShare &share) : share(share) {}

    /// One number per body.
    void add(std::vector<double> &numbers);
    /// A vector per body that is not driven, on its degrees of freedom; one of another size is zeroed.
    void add(const std::vector<Body<2>> &bodies, std::vector<Eigen::VectorXd> &vectors);
    /// Where the outline of a body is.
    void add_outline(Body<2> &body);
    /// Numbers of one body, as many for all.
    void add(unsigned int b, double *begin, std::size_t size);

    void send() const { share.exchange.share(pieces); }

  private:
    friend class BodyShare;
    const BodyShare &share;
    std::vector<Exchange::Piece> pieces;
  };

  /// for_mine(), after which all learn what @p fill adds to a message: all in one exchange.
  template <class Bodies, class Work, class Fill>
  void for_mine(Bodies &bodies, const Work &work, const Fill &fill) const
  {
    together([&]() { for_mine_here(bodies, work); }, fill);
  }

  /// Does any work together, see Exchange::together().
  template <class Work, class Fill>
  void together(const Work &work, const Fill &fill) const
  {
    exchange.together(work,
                      [&]()
                      {
                        Message message(*this);
                        fill(message);
                        return std::move(message.pieces);
                      });
  }

  /// @p n numbers of every body that is not driven, which @p work gives for owned ones, else 0: known
  /// to all.
  template <std::size_t n, class Bodies, class Work>
  std::vector<std::array<double, n>> numbers(Bodies &bodies, const Work &work) const
  {
    std::vector<std::array<double, n>> of_bodies(bodies.size(), std::array<double, n>{});
    for_mine(
        bodies, [&](auto &body) { of_bodies[body.index] = work(body); },
        [&](Message &message)
        {
          for (unsigned int b = 0; b < of_bodies.size(); ++b)
            message.add(b, of_bodies[b].data(), n);
        });
    return of_bodies;
  }

  /// Lists of any length, one per body, that @p work makes for owned bodies.
  template <class Work>
  void share_lists(const Work &work, std::vector<std::vector<double>> &lists) const
  {
    std::vector<double> sizes;
    together(work,
             [&](Message &message)
             {
               for (const std::vector<double> &list : lists)
                 sizes.push_back(list.size());
               message.add(sizes);
             });
    if (!alone())
      send_lists(sizes, lists);
  }

private:
  void send_lists(const std::vector<double> &sizes, std::vector<std::vector<double>> &lists) const;

  std::vector<unsigned int> owner_of; ///< rank of every body
  std::vector<char> lies_here;        ///< see holds()
};
} // namespace softgrain::mpm

#endif
