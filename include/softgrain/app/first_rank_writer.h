// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_first_rank_writer_h
#define softgrain_app_first_rank_writer_h

#include <softgrain/model/state_file.h>

#include <exception>

namespace softgrain
{
/**
 * @brief What a model writes its state to where all processes take part: what comes from the first is
 * written, what comes from others is not.
 *
 * Errors wait for check(), so that the first one goes the same way as the others until all have come to the
 * end.
 */
class FirstRankWriter final : public StateWriter
{
public:
  /// @param file where it is written; null for others
  explicit FirstRankWriter(StateWriter *file) : file(file) {}

  void write(const std::string &name, const std::vector<double> &values) override { hand_on(name, values); }
  void write(const std::string &name, const std::vector<std::uint64_t> &values) override
  {
    hand_on(name, values);
  }
  void write(const std::string &name, const std::string &text) override { hand_on(name, text); }
  void write_rows(const std::string &name,
                  const std::size_t n_rows,
                  const std::size_t width,
                  const Fill &fill) override
  {
    std::size_t done = 0;
    bool filling = false;
    const Fill note = [&](const std::size_t begin, const std::size_t end, double *const rows)
    {
      filling = true;
      fill(begin, end, rows);
      filling = false;
      done = end;
    };
    try
    {
      if (file != nullptr && !failure)
        file->write_rows(name, n_rows, width, note);
    }
    catch (...)
    {
      if (filling) // by all
        throw;
      failure = std::current_exception();
    }
    // Others bring their numbers all the same.
    std::vector<double> rows;
    const auto pass = [&](const std::size_t begin, const std::size_t end)
    {
      rows.resize((end - begin) * width);
      fill(begin, end, rows.data());
    };
    for_pieces(n_rows, width, pass, done);
  }

  /// @throw the first error of writing
  void check() const
  {
    if (failure)
      std::rethrow_exception(failure);
  }

private:
  template <class Values>
  void hand_on(const std::string &name, const Values &values)
  {
    if (file == nullptr || failure)
      return;
    try
    {
      file->write(name, values);
    }
    catch (...)
    {
      failure = std::current_exception();
    }
  }

  StateWriter *file;
  std::exception_ptr failure;
};
} // namespace softgrain

#endif
