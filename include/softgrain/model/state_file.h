// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_model_state_file_h
#define softgrain_model_state_file_h

#include <cstdint>
#include <string>
#include <vector>

namespace softgrain
{
/// Where a model writes its state: named arrays, slashes make groups.
class StateWriter
{
public:
  virtual ~StateWriter() = default;

  virtual void write(const std::string &name, const std::vector<double> &values) = 0;
  virtual void write(const std::string &name, const std::vector<std::uint64_t> &values) = 0;
  virtual void write(const std::string &name, const std::string &text) = 0;
};

/// Where a model reads it back; a missing name is an InputError that names the file.
class StateReader
{
public:
  virtual ~StateReader() = default;

  virtual std::vector<double> read_doubles(const std::string &name) const = 0;
  virtual std::vector<std::uint64_t> read_integers(const std::string &name) const = 0;
  virtual std::string read_text(const std::string &name) const = 0;
  virtual bool contains(const std::string &name) const = 0;
};
} // namespace softgrain

#endif
