// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/hdf5_disk_file.h>
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/problem_io.h>

#include <hdf5.h>

#include <cstdio>
#include <utility>

namespace softgrain::contact
{
namespace
{
/// Closes an HDF5 handle when it goes out of scope; a negative one is a failure of the library.
class Handle
{
public:
  Handle(const hid_t id, herr_t (*close)(hid_t)) : id(id), close(close)
  {
    if (id < 0)
      throw ComputationError("HDF5 refuses");
  }
  Handle(const Handle &) = delete;
  Handle &operator=(const Handle &) = delete;
  ~Handle() { close(id); }

  operator hid_t() const { return id; }

private:
  hid_t id;
  herr_t (*close)(hid_t);
};

/// HDF5 prints its own stack of errors unless told not to; ours is one line.
class QuietErrors
{
public:
  QuietErrors()
  {
    H5Eget_auto2(H5E_DEFAULT, &function, &data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function, data); }

private:
  H5E_auto2_t function;
  void *data;
};

template <typename T>
hid_t memory_type();
template <>
hid_t memory_type<double>()
{
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t memory_type<unsigned int>()
{
  return H5T_NATIVE_UINT;
}

void require(const herr_t status)
{
  if (status < 0)
    throw ComputationError("HDF5 refuses");
}

template <typename T>
void write_array(const hid_t file, const std::string &name, const std::vector<T> &values)
{
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle set(
      H5Dcreate2(file, name.c_str(), memory_type<T>(), space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  if (size > 0)
    require(H5Dwrite(set, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

template <typename T>
std::vector<T> read_array(const hid_t file, const std::string &name)
{
  const Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(set), H5Sclose);
  const hssize_t size = H5Sget_simple_extent_npoints(space);
  if (size < 0)
    throw ComputationError("HDF5 refuses");
  std::vector<T> values(size);
  if (size > 0)
    require(H5Dread(set, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return values;
}

template <typename T>
void write_number(const hid_t file, const char *name, const T value)
{
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, name, memory_type<T>(), space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, memory_type<T>(), &value));
}

/// HDF5 writes as many values as the attribute has, whatever there is room for.
void require_one(const hid_t attribute)
{
  const Handle space(H5Aget_space(attribute), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) != 1)
    throw ComputationError("HDF5 refuses");
}

template <typename T>
T read_number(const hid_t file, const char *name)
{
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  require_one(attribute);
  T value;
  require(H5Aread(attribute, memory_type<T>(), &value));
  return value;
}

void write_text(const hid_t file, const char *name, const std::string &text)
{
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, text.size() + 1));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, type, text.c_str()));
}

std::string read_text(const hid_t file, const char *name)
{
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  require_one(attribute);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0)
    throw ComputationError("HDF5 refuses");
  std::string text(H5Tget_size(type), '\0');
  require(H5Aread(attribute, type, text.data()));
  return text.substr(0, text.find('\0'));
}

void write_settings(const hid_t file, const SolverSettings &settings)
{
  for (const auto &[name, algorithm] : algorithms())
    if (algorithm == settings.algorithm)
      write_text(file, "algorithm", name);
  write_number(file, "tolerance", settings.tolerance);
  write_number(file, "max_sweeps", settings.max_sweeps);
  write_number(file, "relaxation", settings.relaxation);
  write_number(file, "check_interval", settings.check_interval);
  write_number(file, "sweeps_before_newton", settings.sweeps_before_newton);
  write_number(file, "max_newton_components", settings.max_newton_components);
  write_number(file, "max_newton_iterations", settings.max_newton_iterations);
}

SolverSettings read_settings(const hid_t file)
{
  SolverSettings settings;
  const std::string name = read_text(file, "algorithm");
  const auto found = algorithms().find(name);
  if (found == algorithms().end())
    throw InputError("its algorithm '" + name + "' is not known");
  settings.algorithm = found->second;
  settings.tolerance = read_number<double>(file, "tolerance");
  settings.max_sweeps = read_number<unsigned int>(file, "max_sweeps");
  settings.relaxation = read_number<double>(file, "relaxation");
  settings.check_interval = read_number<unsigned int>(file, "check_interval");
  settings.sweeps_before_newton = read_number<unsigned int>(file, "sweeps_before_newton");
  settings.max_newton_components = read_number<unsigned int>(file, "max_newton_components");
  settings.max_newton_iterations = read_number<unsigned int>(file, "max_newton_iterations");
  return settings;
}

void write_operator(const hid_t file, const BlockDelassus &delassus)
{
  write_text(file, "operator", "blocks");
  std::vector<unsigned int> size, components;
  std::vector<double> values;
  for (unsigned int b = 0; b < delassus.n_blocks(); ++b)
  {
    const std::vector<unsigned int> rows = delassus.block_components(b);
    const Eigen::MatrixXd block = delassus.block(b);
    size.push_back(rows.size());
    components.insert(components.end(), rows.begin(), rows.end());
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int j = 0; j < rows.size(); ++j)
        values.push_back(block(i, j));
  }
  write_array(file, "block_size", size);
  write_array(file, "block_components", components);
  write_array(file, "block_values", values);
}

void write_operator(const hid_t file, const MassDelassus &delassus)
{
  write_text(file, "operator", "mass");
  write_array(file, "row_start", delassus.row_start());
  write_array(file, "dofs", delassus.dofs());
  write_array(file, "weights", delassus.weights());
  write_array(file, "inverse_mass", delassus.inverse_masses());
}

BlockDelassus read_blocks(const hid_t file, const unsigned int n_contacts, const unsigned int n_components)
{
  BlockDelassus delassus(n_contacts, n_components);
  const std::vector<unsigned int> size = read_array<unsigned int>(file, "block_size");
  const std::vector<unsigned int> components = read_array<unsigned int>(file, "block_components");
  const std::vector<double> values = read_array<double>(file, "block_values");
  std::size_t row = 0, value = 0;
  for (const unsigned int n : size)
  {
    if (row + n > components.size() || value + std::size_t(n) * n > values.size())
      throw InputError("the blocks are longer than their data");
    Eigen::MatrixXd block(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        block(i, j) = values[value++];
    delassus.add_block(std::vector<unsigned int>(components.begin() + row, components.begin() + row + n),
                       block);
    row += n;
  }
  return delassus;
}

SavedProblem read_all(const hid_t file)
{
  if (read_text(file, "format") != "softgrain contact problem" ||
      read_number<unsigned int>(file, "version") != 1)
    throw InputError("it holds something else or another version");
  SavedProblem saved;
  saved.description = read_text(file, "description");
  saved.settings = read_settings(file);
  saved.problem.n_components = read_number<unsigned int>(file, "n_components");
  saved.problem.free_velocity = read_array<double>(file, "free_velocity");
  saved.problem.friction = read_array<double>(file, "friction");
  if (H5Lexists(file, "cohesion", H5P_DEFAULT) > 0)
    saved.problem.cohesion = read_array<double>(file, "cohesion");
  saved.impulses = read_array<double>(file, "impulses");
  const std::string type = read_text(file, "operator");
  if (type == "blocks")
    saved.delassus =
        read_blocks(file, read_number<unsigned int>(file, "n_contacts"), saved.problem.n_components);
  else if (type == "mass")
    saved.delassus = MassDelassus(saved.problem.n_components, read_array<unsigned int>(file, "row_start"),
                                  read_array<unsigned int>(file, "dofs"), read_array<double>(file, "weights"),
                                  read_array<double>(file, "inverse_mass"));
  else
    throw InputError("its operator '" + type + "' is not known");
  return saved;
}

void write_all(const hid_t file, const SavedProblem &saved)
{
  write_text(file, "format", "softgrain contact problem");
  write_number(file, "version", 1u);
  write_text(file, "description", saved.description);
  write_number(file, "n_components", saved.problem.n_components);
  write_number(file, "n_contacts", saved.problem.n_contacts());
  write_settings(file, saved.settings);
  write_array(file, "free_velocity", saved.problem.free_velocity);
  write_array(file, "friction", saved.problem.friction);
  if (!saved.problem.cohesion.empty())
    write_array(file, "cohesion", saved.problem.cohesion);
  write_array(file, "impulses", saved.impulses);
  std::visit([file](const auto &delassus) { write_operator(file, delassus); }, saved.delassus);
}
} // namespace

void save_problem(const std::string &path, const SavedProblem &saved)
{
  const QuietErrors quiet;
  const std::string temporary = path + ".tmp";
  try
  {
    Hdf5DiskFile disk(temporary);
    {
      const Handle file(disk.create(), H5Fclose);
      write_all(file, saved);
    }
    disk.finish();
  }
  catch (const ComputationError &)
  {
    std::remove(temporary.c_str());
    throw ComputationError("cannot write the contact problem to " + path);
  }
  if (std::rename(temporary.c_str(), path.c_str()) != 0)
    throw ComputationError("cannot rename " + temporary + " to " + path);
}

void save_problem(const std::string &path,
                  const BlockDelassus &delassus,
                  const Problem &problem,
                  const SolverSettings &settings,
                  const std::vector<double> &impulses,
                  const std::string &description)
{
  save_problem(path, SavedProblem{description, problem, settings, delassus, impulses});
}

void save_problem(const std::string &path,
                  const MassDelassus &delassus,
                  const Problem &problem,
                  const SolverSettings &settings,
                  const std::vector<double> &impulses,
                  const std::string &description)
{
  save_problem(path, SavedProblem{description, problem, settings, delassus, impulses});
}

void save_problem(const std::string &path,
                  const DiagonalDelassus &delassus,
                  const Problem &problem,
                  const SolverSettings &settings,
                  const std::vector<double> &impulses,
                  const std::string &description)
{
  const unsigned int n = delassus.n_components();
  BlockDelassus blocks(delassus.n_contacts(), n);
  std::vector<unsigned int> components(n);
  Eigen::MatrixXd block(n, n);
  for (unsigned int i = 0; i < delassus.n_contacts(); ++i)
  {
    double values[9];
    delassus.diagonal_block(i, values);
    for (unsigned int c = 0; c < n; ++c)
    {
      components[c] = i * n + c;
      for (unsigned int d = 0; d < n; ++d)
        block(c, d) = values[c * n + d];
    }
    blocks.add_block(components, block);
  }
  save_problem(path, SavedProblem{description, problem, settings, std::move(blocks), impulses});
}

SavedProblem load_problem(const std::string &path)
{
  const QuietErrors quiet;
  try
  {
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    return read_all(file);
  }
  catch (const ComputationError &)
  {
    throw InputError("cannot read the contact problem " + path +
                     ": missing, cut short or no HDF5 file of this kind");
  }
  catch (const InputError &error)
  {
    throw InputError("cannot read the contact problem " + path + ": " + error.what());
  }
}

SolverReport replay(SavedProblem &saved, std::vector<double> &impulses, std::vector<double> &velocities)
{
  impulses = saved.impulses;
  return std::visit([&](auto &delassus)
                    { return solve(delassus, saved.problem, saved.settings, impulses, velocities); },
                    saved.delassus);
}

SolverReport replay(const std::string &path, std::vector<double> &impulses, std::vector<double> &velocities)
{
  SavedProblem saved = load_problem(path);
  return replay(saved, impulses, velocities);
}
} // namespace softgrain::contact
