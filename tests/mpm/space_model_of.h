// SPDX-License-Identifier: LGPL-2.1-or-later
// Models of scenes in space, and what they hold.
#ifndef softgrain_tests_mpm_space_model_of_h
#define softgrain_tests_mpm_space_model_of_h

#include "scene_of.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/model/space_model.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

inline std::unique_ptr<softgrain::Model<3>> model_of(const std::string &file,
                                                     std::vector<std::string> changes)
{
  changes.insert(changes.begin(), "Output directory=results");
  softgrain::Input input(file, changes);
  return input.create_model_in_space();
}

inline const softgrain::mpm::SpaceState &state_of(const softgrain::Model<3> &model)
{
  return dynamic_cast<const softgrain::mpm::SpaceModel &>(model).space();
}

/// Prints why a scene is refused.
inline void refused(const std::string &text, const std::vector<std::string> &changes)
{
  try
  {
    std::ofstream("scene.prm") << text;
    model_of("scene.prm", changes);
    std::cout << "not refused\n";
  }
  catch (const softgrain::InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}

#endif
