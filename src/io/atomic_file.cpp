// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kushi {
namespace {

std::string reason(int error) {
    return std::generic_category().message(error);
}

Problem cannotWrite(const std::string& path, const std::string& why) {
    return {"cannot write: " + why, path, 0, 0, true};
}

Problem cannotRead(const std::string& path, int error) {
    const bool usersFault = error == ENOENT || error == EACCES || error == ENOTDIR ||
                            error == EISDIR || error == ENAMETOOLONG || error == ELOOP;
    return {"cannot read: " + reason(error), path, 0, 0, !usersFault};
}

/// Owns a file descriptor.
class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }

    int get() const { return fd_; }
    bool open() const { return fd_ >= 0; }
    /// The error, or 0. Some file systems report a full disk only here.
    int close() {
        const int failed = ::close(std::exchange(fd_, -1));
        return failed != 0 && errno != EINTR ? errno : 0;
    }

private:
    int fd_;
};

/// The error, or 0.
int writeAll(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        if (written == 0) return EIO;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

/// A new file of its own name in a folder, removed again unless it is renamed.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& folder) : file_(create(folder, path_)) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (error_ == 0 && !renamed_) ::unlink(path_.c_str());
    }

    /// The error that kept it from being created, or 0.
    int error() const { return error_; }
    int fd() const { return file_.get(); }
    /// The error, or 0.
    int renameTo(const std::filesystem::path& target) {
        if (const int error = file_.close(); error != 0) return error;
        if (std::rename(path_.c_str(), target.c_str()) != 0) return errno;
        renamed_ = true;
        return 0;
    }

private:
    int create(const std::filesystem::path& folder, std::string& path) {
        constexpr int attempts = 10000;
        int fd = -1;
        for (int i = 0; i < attempts && fd < 0; ++i) {
            path = folder /
                   (".kushi-" + std::to_string(::getpid()) + '-' + std::to_string(i) + ".tmp");
            // Not mkstemp, whose files only their owner may read.
            fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (fd < 0 && errno != EEXIST) break;
        }
        if (fd < 0) error_ = errno;
        return fd;
    }

    std::string path_;
    int error_ = 0;
    bool renamed_ = false;
    Descriptor file_;
};

bool isStandardOutput(const struct stat& file) {
    struct stat output {};
    return ::fstat(STDOUT_FILENO, &output) == 0 && output.st_dev == file.st_dev &&
           output.st_ino == file.st_ino;
}

Status writeThrough(const std::string& path, bool standardOutput, std::string_view bytes) {
    Descriptor file(standardOutput ? ::dup(STDOUT_FILENO)
                                   : ::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.open()) return cannotWrite(path, reason(errno));
    if (const int error = writeAll(file.get(), bytes)) return cannotWrite(path, reason(error));
    if (const int error = file.close()) return cannotWrite(path, reason(error));
    return std::monostate{};
}

}  // namespace

Status writeFileAtomically(const std::string& path, std::string_view bytes) {
    std::filesystem::path target = path;
    struct stat old {};
    const bool exists = ::stat(path.c_str(), &old) == 0;
    if (exists) {
        if (S_ISDIR(old.st_mode)) return cannotWrite(path, "it is a folder");
        const bool standardOutput = isStandardOutput(old);
        if (!S_ISREG(old.st_mode) || standardOutput) {
            return writeThrough(path, standardOutput, bytes);
        }
        // A rename would replace a write-protected file without asking.
        if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
            return cannotWrite(path, reason(errno));
        }
        std::error_code unresolved;
        target = std::filesystem::canonical(path, unresolved);
        if (unresolved) return cannotWrite(path, unresolved.message());
    }

    TemporaryFile temporary(target.parent_path());
    if (temporary.error() != 0) return cannotWrite(path, reason(temporary.error()));
    if (const int error = writeAll(temporary.fd(), bytes)) return cannotWrite(path, reason(error));
    if (exists && ::fchmod(temporary.fd(), old.st_mode & 07777U) != 0) {
        return cannotWrite(path, reason(errno));
    }
    if (const int error = temporary.renameTo(target)) return cannotWrite(path, reason(error));
    return std::monostate{};
}

Result<std::string> readFile(const std::string& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.open()) return cannotRead(path, errno);
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) return cannotRead(path, errno);
    if (S_ISDIR(status.st_mode)) return cannotRead(path, EISDIR);

    // One byte more than a regular file has, so that its end shows without growing.
    std::string bytes;
    constexpr std::size_t step = 65536;
    bytes.resize(S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : step);
    std::size_t size = 0;
    while (true) {
        if (size == bytes.size()) bytes.resize(2 * size);
        const ssize_t got = ::read(file.get(), bytes.data() + size, bytes.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return cannotRead(path, errno);
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace kushi
