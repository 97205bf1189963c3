// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_contact_settings_h
#define softgrain_driving_contact_settings_h

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/**
 * @brief What every model may be told about the solution of its contacts; section `Contact`.
 */
struct ContactSettings
{
  double tolerance = 0;
  unsigned int max_sweeps = 0;
  double relaxation = 1;
  std::string algorithm;

  /// An algorithm and what it is.
  struct Choice
  {
    std::string name, meaning;
  };

  /// Declares the parameters where the handler stands, in section `Contact`; the first algorithm is the
  /// default.
  static void declare_parameters(dealii::ParameterHandler &prm,
                                 const std::string &tolerance,
                                 const std::vector<Choice> &algorithms);

  /// @throw InputError when 'Relaxation' is set and another algorithm than gauss_seidel would ignore it.
  void parse_parameters(const dealii::ParameterHandler &prm);

  /// The parameters, "Contact/Tolerance" and so on: a run that goes on may change all of them.
  static std::vector<std::string> names();
};
} // namespace softgrain

#endif
