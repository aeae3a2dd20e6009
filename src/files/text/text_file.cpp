#include "linkwright/files/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace linkwright {
namespace {

Error cannot_read(int error_number) {
  return {
      "unreadable_file",
      "",
      fmt::format("this file cannot be read: {}; check its name and that you may read it", std::strerror(error_number)),
      {{"reason", std::strerror(error_number)}}};
}

Error too_large(std::size_t max_bytes) {
  return {"file_too_large",
          "",
          fmt::format("this file is larger than {} MiB, the most that is read; a Linkwright file is far smaller",
                      max_bytes >> 20),
          {{"most", max_bytes >> 20}}};
}

Result<std::string> read_all(std::FILE* file, std::size_t max_bytes) {
  constexpr std::size_t piece = 1 << 16;
  std::string text;
  while (text.size() <= max_bytes) {
    const std::size_t size = text.size();
    text.resize(size + piece);
    errno = 0;
    const std::size_t count = std::fread(text.data() + size, 1, piece, file);
    text.resize(size + count);
    if (std::ferror(file)) return cannot_read(errno);
    if (count < piece) break;
  }
  if (text.size() > max_bytes) return too_large(max_bytes);
  return text;
}

constexpr std::size_t file_buffer_bytes = 1 << 20;
constexpr int usual_mode = 0666;  // less the umask

Error not_regular(std::string_view kind) {
  return {"not_a_regular_file",
          "",
          fmt::format("this output path is {}, not a regular file; it was left alone, name another file", kind),
          {{"kind", kind}}};
}

std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "of an unknown kind";
}

}  // namespace

Result<std::string> read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  if (path == "-") return read_all(stdin, max_bytes);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return cannot_read(errno);
  return read_all(file.get(), max_bytes);
}

AtomicFile::AtomicFile(const std::filesystem::path& path) : target_(path) {
  std::error_code error;
  if (std::filesystem::is_symlink(path, error)) {
    target_ = std::filesystem::canonical(path, error);
    if (error) {
      failure_ = not_regular("a symbolic link that leads nowhere");
      return;
    }
  }
  struct stat existing = {};
  if (::stat(target_.c_str(), &existing) != 0) {
    if (errno == ENOENT && target_.has_filename()) {
      open_temporary(-1);
    } else {
      fail("this output file cannot be written", errno);
    }
  } else if (!S_ISREG(existing.st_mode)) {
    failure_ = not_regular(kind_of(existing.st_mode));
  } else {
    open_temporary(static_cast<int>(existing.st_mode & 07777));
  }
}

AtomicFile::~AtomicFile() { abandon(); }

/// `mode`: permissions to take over, or −1.
void AtomicFile::open_temporary(int mode) {
  constexpr int max_tries = 100;
  for (int attempt = 0; attempt < max_tries && descriptor_ < 0; ++attempt) {
    temporary_ = target_.parent_path() / fmt::format(".{}.{}-{}.tmp", target_.filename().string(), ::getpid(), attempt);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, usual_mode);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) {
    temporary_.clear();  // not ours
    fail("this output file cannot be written", errno);
  } else if (mode >= 0 && ::fchmod(descriptor_, static_cast<mode_t>(mode)) != 0) {
    fail("the permissions of this output file cannot be kept", errno);
  }
}

void AtomicFile::fail(std::string_view what, int error_number) {
  if (!failure_) {
    const char* const reason = std::strerror(error_number);
    failure_ = Error{"unwritable_output",
                     "",
                     fmt::format("{}: {}; nothing was written", what, reason),
                     {{"what", what}, {"reason", reason}}};
  }
  abandon();
}

void AtomicFile::abandon() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
}

void AtomicFile::write(std::string_view text) {
  if (failure_) return;
  buffer_ += text;
  if (buffer_.size() >= file_buffer_bytes) flush_buffer();
}

void AtomicFile::flush_buffer() {
  std::string_view rest = buffer_;
  while (!rest.empty() && !failure_) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      fail("this output file cannot be written", errno);
    }
  }
  buffer_.clear();
}

std::optional<Error> AtomicFile::commit() {
  if (!failure_) flush_buffer();
  if (!failure_ && ::fsync(descriptor_) != 0 && errno != EINVAL) fail("this output file cannot be written", errno);
  if (!failure_) {
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail("this output file cannot be written", errno);
  }
  if (!failure_) {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("this output file cannot take its name", errno);
    temporary_.clear();
  }
  return failure_;
}

std::optional<Error> write_atomically(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  return file.commit();
}

}  // namespace linkwright
