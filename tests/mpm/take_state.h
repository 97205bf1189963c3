// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_take_state_h
#define softgrain_tests_mpm_take_state_h

#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/output/checkpoint.h>

namespace softgrain
{
/// Takes the state of @p before over to @p after, by a checkpoint.
inline void take_state(const mpm::MpmModel &before, mpm::MpmModel &after)
{
  CheckpointWriter writer("state.h5");
  before.save(writer);
  writer.commit();
  CheckpointReader reader("state.h5");
  after.load(reader);
}
} // namespace softgrain

#endif
