// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_node_weights_h
#define softgrain_mpm_field_node_weights_h

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace softgrain::mpm
{
/// Weights by which independent nodes give the value at one place: value = sum of weight * node value. In the
/// plane there are seldom more than 16: searches for contact make thousands of these.
struct NodeWeights
{
  boost::container::small_vector<unsigned int, 16> node; ///< in ascending order
  boost::container::small_vector<double, 16> weight;

  /// These, where several may refer to them.
  std::shared_ptr<const NodeWeights> shared() &&
  {
    return std::make_shared<const NodeWeights>(std::move(*this));
  }
};

/// Weights of nodes that are kept elsewhere.
struct NodeWeightsView
{
  const unsigned int *node;
  const double *weight;
  unsigned int size;

  NodeWeights copy() const
  {
    NodeWeights result;
    result.node.assign(node, node + size);
    result.weight.assign(weight, weight + size);
    return result;
  }
};

/// Those of many places in little memory.
class WeightsOfPlaces
{
public:
  std::size_t size() const { return end.size(); }

  void clear()
  {
    end.clear();
    node.clear();
    weight.clear();
  }

  /// Those of the next place, of which there are @p n.
  template <class Nodes, class Weights>
  void add(const Nodes nodes, const Weights weights, const std::size_t n)
  {
    node.insert(node.end(), nodes, nodes + n);
    weight.insert(weight.end(), weights, weights + n);
    end.push_back(node.size());
  }

  /// Gives back memory that is not needed when all have been added.
  void finish()
  {
    end.shrink_to_fit();
    node.shrink_to_fit();
    weight.shrink_to_fit();
  }

  NodeWeightsView operator[](const std::size_t place) const
  {
    const unsigned int begin = place == 0 ? 0 : end[place - 1];
    return {node.data() + begin, weight.data() + begin, end[place] - begin};
  }

private:
  std::vector<unsigned int> end; ///< of the entries of every place
  std::vector<unsigned int> node;
  std::vector<double> weight;
};
} // namespace softgrain::mpm

#endif
