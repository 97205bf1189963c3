// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_refusal_h
#define softgrain_constitutive_refusal_h

#include <softgrain/constitutive/point_data.h>

#include <string>

namespace softgrain::constitutive
{
/**
 * @brief A law that refuses more than points that are inside out, and can say why.
 *
 * A law derives from this beside Law; it is asked only when Law::update() has ended at a point and the reason
 * goes into a message.
 */
template <int dim>
class Refusal
{
public:
  virtual ~Refusal() = default;

  /// Why the law does not admit the only point of @p point, as the end of a sentence that begins with "a
  /// material point of body 'NAME'"; empty when it has nothing against it, or the point is inside out.
  virtual std::string why_refused(const Inputs<dim> &point) const = 0;
};
} // namespace softgrain::constitutive

#endif
