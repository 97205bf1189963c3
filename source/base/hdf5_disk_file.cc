// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/hdf5_disk_file.h>

#include <fcntl.h>
#include <hdf5.h>
#if H5_VERSION_GE(1, 14, 0)
#include <H5FDdevelop.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace softgrain
{
namespace
{
/// Calls a function of the system until it has done all, or fails. @return what it has done
template <class Transfer>
std::size_t transfer(const Transfer &some, const std::size_t size)
{
  std::size_t done = 0;
  while (done < size)
  {
    errno = 0;
    const ssize_t n = some(done);
    if (n > 0)
      done += n;
    else if (n == 0 || errno != EINTR)
      break;
  }
  return done;
}
} // namespace

struct Hdf5DiskFile::Disk
{
  int descriptor = -1;
  int reason = 0; ///< errno of the first refusal
  haddr_t end_of_allocation = 0, end_of_file = 0;

  void refuse()
  {
    if (reason == 0)
      reason = errno != 0 ? errno : EIO;
  }

  void write(const haddr_t at, const std::size_t size, const char *const from)
  {
    if (reason == 0 &&
        transfer([&](const std::size_t n) { return ::pwrite(descriptor, from + n, size - n, at + n); },
                 size) < size)
      refuse();
    end_of_file = std::max(end_of_file, at + size);
  }

  /// What the disk has; zeros behind its end.
  void read(const haddr_t at, const std::size_t size, char *const to) const
  {
    const std::size_t done =
        transfer([&](const std::size_t n) { return ::pread(descriptor, to + n, size - n, at + n); }, size);
    std::fill(to + done, to + size, 0);
  }

  void truncate()
  {
    if (reason == 0 && end_of_file != end_of_allocation && ::ftruncate(descriptor, end_of_allocation) != 0)
      refuse();
    end_of_file = end_of_allocation;
  }
};

namespace
{
using Disk = Hdf5DiskFile::Disk;

/// What HDF5 knows of a file; its own part comes first.
struct DriverFile
{
  H5FD_t of_hdf5;
  Disk *disk;
};

Disk &disk_of(const H5FD_t *const file)
{
  return *reinterpret_cast<const DriverFile *>(file)->disk;
}

H5FD_t *open_disk(const char *, unsigned int, const hid_t access, haddr_t)
{
  const void *const place = H5Pget_driver_info(access);
  if (place == nullptr)
    return nullptr;
  DriverFile *const file = new DriverFile();
  std::memcpy(&file->disk, place, sizeof(Disk *));
  return &file->of_hdf5;
}

herr_t close_disk(H5FD_t *const file)
{
  delete reinterpret_cast<DriverFile *>(file);
  return 0;
}

/// Answers as HDF5's driver for memory does, so that files are laid out as by that.
herr_t query_disk(const H5FD_t *, unsigned long *const features)
{
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
              H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t end_of_allocation(const H5FD_t *const file, H5FD_mem_t)
{
  return disk_of(file).end_of_allocation;
}

herr_t set_end_of_allocation(H5FD_t *const file, H5FD_mem_t, const haddr_t end)
{
  disk_of(file).end_of_allocation = end;
  return 0;
}

haddr_t end_of_file(const H5FD_t *const file, H5FD_mem_t)
{
  return disk_of(file).end_of_file;
}

herr_t
read_disk(H5FD_t *const file, H5FD_mem_t, hid_t, const haddr_t at, const std::size_t size, void *const to)
{
  disk_of(file).read(at, size, static_cast<char *>(to));
  return 0;
}

herr_t write_disk(
    H5FD_t *const file, H5FD_mem_t, hid_t, const haddr_t at, const std::size_t size, const void *const from)
{
  disk_of(file).write(at, size, static_cast<const char *>(from));
  return 0;
}

herr_t truncate_disk(H5FD_t *const file, hid_t, hbool_t)
{
  disk_of(file).truncate();
  return 0;
}

/// The driver, made known to HDF5.
hid_t driver()
{
  static const hid_t id = []()
  {
    static H5FD_class_t driver{};
#if H5_VERSION_GE(1, 14, 0)
    driver.version = H5FD_CLASS_VERSION;
    driver.value = static_cast<H5FD_class_value_t>(400); // 256 to 511 are for drivers that are nobody else's
#endif
    driver.name = "softgrain disk";
    driver.maxaddr = HADDR_MAX - 1;
    driver.fc_degree = H5F_CLOSE_STRONG;
    driver.fapl_size = sizeof(Disk *);
    driver.open = open_disk;
    driver.close = close_disk;
    driver.query = query_disk;
    driver.get_eoa = end_of_allocation;
    driver.set_eoa = set_end_of_allocation;
    driver.get_eof = end_of_file;
    driver.read = read_disk;
    driver.write = write_disk;
    driver.truncate = truncate_disk;
    // Room of numbers is kept apart from that of HDF5's records.
    const H5FD_mem_t types[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(types), std::end(types), driver.fl_map);
    return H5FDregister(&driver);
  }();
  return id;
}
} // namespace

Hdf5DiskFile::Hdf5DiskFile(const std::string &path) : path(path), disk(std::make_unique<Disk>())
{
  disk->descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (disk->descriptor < 0)
    disk->refuse();
  check();
}

Hdf5DiskFile::~Hdf5DiskFile()
{
  if (disk->descriptor >= 0)
    ::close(disk->descriptor);
}

namespace
{
/// Says how much of what describes data sets may wait in memory: by itself the library keeps that of ten
/// thousand small ones until the file is closed.
bool limit_memory(const hid_t access)
{
  constexpr std::size_t most = 1 << 20; // [bytes]
  H5AC_cache_config_t cache;
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  if (H5Pget_mdc_config(access, &cache) < 0)
    return false;
  cache.set_initial_size = true;
  cache.initial_size = cache.min_size = cache.max_size = most;
  return H5Pset_mdc_config(access, &cache) >= 0;
}
} // namespace

std::int64_t Hdf5DiskFile::create()
{
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  hid_t file = -1;
  const Disk *const place = disk.get();
  if (access >= 0 && limit_memory(access) && H5Pset_driver(access, driver(), &place) >= 0)
    file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  if (access >= 0)
    H5Pclose(access);
  return file;
}

void Hdf5DiskFile::check() const
{
  if (disk->reason != 0)
    throw ComputationError("cannot write " + path + ": " + std::strerror(disk->reason));
}

void Hdf5DiskFile::finish()
{
  // Some file systems tell only now what they could not write.
  if (disk->descriptor >= 0 && ::close(disk->descriptor) != 0)
    disk->refuse();
  disk->descriptor = -1;
  check();
}
} // namespace softgrain
