// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/model/model_factory.h>

#include <softgrain/base/exceptions.h>

#include <deal.II/base/parameter_handler.h>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::ModelFactory)

namespace softgrain
{
void ModelFactory::refuse_space(const dealii::ParameterHandler &prm)
{
  throw InputError("'Dimension' = '3' is not allowed with 'Model' = '" + prm.get("Model") +
                   "', which works in the plane: choose 'Model' = 'mpm'");
}
} // namespace softgrain
