// SPDX-License-Identifier: LGPL-2.1-or-later
// Perfect plasticity of von Mises at small strain: |s| <= k = 2 mu * yield strain, radial return, so that
// energy plus dissipation of a step is a potential of the stress. Plane strain is three dimensions without
// strain out of plane.
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/elastic_law.h>
#include <softgrain/constitutive/law_registry.h>

#include <deal.II/base/parameter_handler.h>

using namespace softgrain::constitutive;
using Strain = dealii::SymmetricTensor<2, 3>;

template <int dim>
class Dissipative final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Dissipative"; }
  Kinematics kinematics() const override { return Kinematics::small_strain; }
  unsigned int n_history() const override { return 12; }

  std::vector<std::string> history_names() const override
  {
    std::vector<std::string> names;
    for (const std::string start : {"strain_", "plastic_strain_"})
      for (const std::string component : {"xx", "yy", "zz", "xy", "xz", "yz"})
        names.push_back(start + component);
    return names;
  }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    ElasticLaw<dim>::declare_parameters(prm);
    prm.declare_entry("Yield strain", "0.05", dealii::Patterns::Double(1e-300),
                      "Norm of the elastic deviator at which the solid flows. Units: none.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    ElasticLaw<dim>::parse_parameters(prm);
    yield_strain = prm.get_double("Yield strain");
  }

  std::size_t update(const Inputs<dim> &in, const Outputs<dim> &out) const override
  {
    const double mu = this->mu, bulk = this->lambda + 2. / 3. * mu, k = 2 * mu * yield_strain;
    for (std::size_t q = 0; q < in.n_points; ++q)
    {
      if (!is_admissible(dealii::determinant(dealii::unit_symmetric_tensor<dim>() + in.increment[q])))
        return q;
      Strain strain, plastic;
      for (unsigned int i = 0; i < 6; ++i)
      {
        strain.access_raw_entry(i) = in.history_old[12 * q + i];
        plastic.access_raw_entry(i) = in.history_old[12 * q + 6 + i];
      }
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          strain[i][j] += 0.5 * (in.increment[q][i][j] + in.increment[q][j][i]);
      const Strain trial = 2 * mu * dealii::deviator(strain - plastic);
      const double size = trial.norm(), kept = size > k ? k / size : 1.;
      const Strain flow = (1. - kept) / (2 * mu) * trial;
      plastic += flow;
      const Strain stress = kept * trial + bulk * dealii::trace(strain) * dealii::unit_symmetric_tensor<3>();
      if (out.stress)
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = i; j < dim; ++j)
            out.stress[q][i][j] = stress[i][j];
      if (out.tangent)
      {
        out.tangent[q] = isotropic_modulus<dim>(bulk - 2. / 3. * mu * kept, mu * kept);
        for (unsigned int i = 0; i < dim && kept < 1.; ++i)
          for (unsigned int j = i; j < dim; ++j)
            for (unsigned int l = 0; l < dim; ++l)
              for (unsigned int m = l; m < dim; ++m)
                out.tangent[q][i][j][l][m] -= 2 * mu * kept * trial[i][j] * trial[l][m] / (size * size);
      }
      if (dim == 2 && out.out_of_plane_stress)
        out.out_of_plane_stress[q] = stress[2][2];
      if (out.energy)
        out.energy[q] = 0.5 * (stress * (strain - plastic));
      if (out.dissipation)
        out.dissipation[q] = k * flow.norm();
      if (out.history_new)
        for (unsigned int i = 0; i < 6; ++i)
        {
          out.history_new[12 * q + i] = strain.access_raw_entry(i);
          out.history_new[12 * q + 6 + i] = plastic.access_raw_entry(i);
        }
    }
    return in.n_points;
  }

private:
  double yield_strain = 0.05;
};

[[maybe_unused]] const bool registered =
    register_law<Dissipative>("dissipative", "Perfect plasticity at small strain, for tests.");
