// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_model_memory_state_h
#define softgrain_model_memory_state_h

#include <softgrain/model/state_file.h>

#include <map>

namespace softgrain
{
/// A state that is kept in memory, to go back to it.
class MemoryState final : public StateWriter, public StateReader
{
public:
  void write(const std::string &name, const std::vector<double> &values) override;
  void write(const std::string &name, const std::vector<std::uint64_t> &values) override;
  void write(const std::string &name, const std::string &text) override;
  void write_rows(const std::string &name, std::size_t n_rows, std::size_t width, const Fill &fill) override;

  bool contains(const std::string &name) const override;
  [[noreturn]] void refuse(const std::string &name, const std::string &why) const override;

protected:
  /// @throw InputError when nothing of that name and type has been written
  std::size_t size(const std::string &name) const override;
  void rows(const std::string &name, std::size_t width, const Take &take) const override;
  std::vector<double> doubles(const std::string &name) const override;
  std::vector<std::uint64_t> integers(const std::string &name) const override;
  std::string text(const std::string &name) const override;

private:
  std::map<std::string, std::vector<double>> kept_doubles;
  std::map<std::string, std::vector<std::uint64_t>> kept_integers;
  std::map<std::string, std::string> kept_texts;
};
} // namespace softgrain

#endif
