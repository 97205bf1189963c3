// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_run_log_h
#define softgrain_app_run_log_h

#include <fstream>
#include <ostream>
#include <streambuf>
#include <string>

namespace softgrain
{
/**
 * @brief What a run prints, on the terminal and in run.log of its output folder.
 *
 * A disk that is full costs the rest of run.log and nothing else: what must not be lost says so itself.
 */
class RunLog
{
public:
  explicit RunLog(std::ostream &terminal);

  /// Writes all further text to run.log of @p directory, too; what it holds already stays if @p append.
  void open(const std::string &directory, bool append);

  /// Stream to terminal and file alike.
  std::ostream &both() { return shared; }
  std::ostream &terminal() { return screen; }
  /// Stream to run.log only; it goes nowhere before open().
  std::ostream &file() { return log; }

private:
  /// Hands every character to two streams.
  class Fork : public std::streambuf
  {
  public:
    Fork(std::ostream &first, std::ostream &second) : first(first), second(second) {}

  protected:
    int_type overflow(int_type character) override;
    std::streamsize xsputn(const char *text, std::streamsize size) override;
    int sync() override;

  private:
    std::ostream &first, &second;
  };

  std::ostream &screen;
  std::ofstream log;
  Fork fork;
  std::ostream shared;
};

/// Name of the file in the output folder.
extern const char *const run_log_name;
} // namespace softgrain

#endif
