// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_continued_h
#define softgrain_tests_continued_h

// Runs that go on from a checkpoint.
#include <softgrain/model/model.h>
#include <softgrain/output/checkpoint.h>

#include <string>

namespace softgrain
{
inline void save_state(const AnyModel &model)
{
  CheckpointWriter writer("state.h5");
  model.save(writer);
  writer.commit();
}

/// Goes on from what save_state() has written last.
inline void load_state(AnyModel &model)
{
  CheckpointReader reader("state.h5");
  model.load(reader);
}

/// Takes the state of @p before over to @p after.
inline void take_state(const AnyModel &before, AnyModel &after)
{
  save_state(before);
  load_state(after);
}

/// What a run of @p n steps tells that is saved and continued twice, each time in a model that knows nothing
/// of the one before.
/// @param make  the model at the start of a run, as a pointer
/// @param steps makes the steps of a model from one number to another, and returns what they tell
template <class Make, class Steps>
std::string continued_twice(const unsigned int n, const Make &make, const Steps &steps)
{
  std::string told;
  const unsigned int cuts[] = {0, n / 3, 2 * n / 3 + 1, n};
  for (unsigned int part = 0; part < 3; ++part)
  {
    const auto model = make();
    if (part > 0)
      load_state(*model);
    told += steps(*model, cuts[part], cuts[part + 1]);
    save_state(*model);
  }
  return told;
}
} // namespace softgrain

#endif
